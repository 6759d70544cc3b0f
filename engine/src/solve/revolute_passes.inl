// SPDX-License-Identifier: MIT
// Included by revolute_passes*.cpp, each of which is compiled for one instruction set. All
// functions have internal linkage and call no inline function from elsewhere; lanes.hpp gives the
// reason.
#include "joints/joint_rows.hpp"
#include "math/lane_rotations.hpp"
#include "solve/revolute_block.hpp"
#include "solve/velocity_lanes.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

KODO_LANES_INLINE Couple load(const RevoluteBlock::Both& from, int at) {
    return {load(from.x + at), load(from.y + at)};
}
KODO_LANES_INLINE void store(RevoluteBlock::Both& to, int at, const Couple& vectors) {
    store(to.x + at, vectors.x);
    store(to.y + at, vectors.y);
}

/// Stores K^-1, or its substitute for a singular K; see PointConstraint::stopping(). K is first
/// divided by its trace, so that squares of small and large masses neither underflow nor overflow.
KODO_LANES_INLINE void storeMass(RevoluteBlock& block, int at, Lanes xx, Lanes xy, Lanes yy) {
    const Lanes trace = xx + yy;
    const Lanes scale = trace > Lanes{} ? all(1) / trace : Lanes{};
    xx *= scale;
    xy *= scale;
    yy *= scale;
    const Lanes determinant = xx * yy - xy * xy;
    const auto regular = determinant > all(kSingularPoint) * (xx * yy);
    const Lanes by = regular ? scale / determinant : scale;
    store(block.massXX + at, by * (regular ? yy : xx));
    store(block.massXY + at, by * (regular ? -xy : xy));
    store(block.massYY + at, by * (regular ? xx : yy));
}

/// Change of the torque impulse of a joint on a body, when its arm rotates.
KODO_LANES_INLINE Lanes torqueChange(const Couple& from, const Couple& to, const Couple& impulse) {
    return (to.x - from.x) * impulse.y - (to.y - from.y) * impulse.x;
}

void rotateRevolutes(const RevolutePassArguments& pass) {
    for (std::size_t i = 0; i < pass.count; ++i) {
        RevoluteBlock& block = pass.blocks[i];
        for (int at = 0; at < RevoluteBlock::kPins; at += kLanes) {
            const Quad moveA = gather(secondHalf(pass.motion), block.a + at);
            const Quad moveB = gather(secondHalf(pass.motion), block.b + at);
            const Couple anchorA = turnedBy(cosSin(moveA.z), load(block.startA, at));
            const Couple armB = turnedBy(cosSin(moveB.z), load(block.startB, at));
            const Couple between = load(block.between, at);
            const Couple gap{(between.x + (moveB.x - moveA.x)) + (armB.x - anchorA.x),
                             (between.y + (moveB.y - moveA.y)) + (armB.y - anchorA.y)};
            const Couple armA{anchorA.x + gap.x, anchorA.y + gap.y};
            const Couple impulse = load(block.impulse, at);
            store(block.torqueA + at, torqueChange(load(block.armA, at), armA, impulse));
            store(block.torqueB + at, torqueChange(load(block.armB, at), armB, impulse));
            store(block.armA, at, armA);
            store(block.armB, at, armB);
            store(block.gap, at, gap);
            const Lanes mass = load(block.mass + at);
            const Lanes ia = load(block.inertiaA + at);
            const Lanes ib = load(block.inertiaB + at);
            storeMass(block, at, mass + (ia * armA.y * armA.y + ib * armB.y * armB.y),
                      -(ia * armA.x * armA.y + ib * armB.x * armB.y),
                      mass + (ia * armA.x * armA.x + ib * armB.x * armB.x));
        }
    }
}

/// Velocities and arms of the bodies of kLanes joints.
struct RevolutePair {
    Quad a; // x, y: velocity, z: angular velocity, w: 1/mass
    Quad b;
    Couple armA;
    Couple armB;
};

KODO_LANES_INLINE RevolutePair pairOf(const RevolutePassArguments& pass, const RevoluteBlock& block,
                                      int at) {
    return {gather(firstHalf(pass.motion), block.a + at),
            gather(firstHalf(pass.motion), block.b + at), load(block.armA, at),
            load(block.armB, at)};
}

/// Applies an impulse and stores the velocities.
KODO_LANES_INLINE void pushRevolutes(const RevolutePassArguments& pass, std::size_t i, int at,
                                     RevolutePair& pair, const Couple& p) {
    const RevoluteBlock& block = pass.blocks[i];
    pair.a.x -= pair.a.w * p.x;
    pair.a.y -= pair.a.w * p.y;
    pair.a.z -= load(block.inertiaA + at) * (pair.armA.x * p.y - pair.armA.y * p.x);
    pair.b.x += pair.b.w * p.x;
    pair.b.y += pair.b.w * p.y;
    pair.b.z += load(block.inertiaB + at) * (pair.armB.x * p.y - pair.armB.y * p.x);
    putBack(pass.motion, block.a + at, pair.a, pass.use[i].movesA, at);
    putBack(pass.motion, block.b + at, pair.b, pass.use[i].movesB, at);
}

void warmStartRevolutes(const RevolutePassArguments& pass) {
    for (std::size_t i = 0; i < pass.count; ++i) {
        RevoluteBlock& block = pass.blocks[i];
        for (int at = 0; at < RevoluteBlock::kPins; at += kLanes) {
            RevolutePair pair = pairOf(pass, block, at);
            store(block.torqueA + at, Lanes{});
            store(block.torqueB + at, Lanes{});
            pushRevolutes(pass, i, at, pair, load(block.impulse, at));
        }
    }
}

/// Vector (m) from the end of the tangent path of an anchor to the end of its arc; see
/// JointKinds::anchors().
KODO_LANES_INLINE Couple bendOf(Lanes spin, const Couple& arm, Real h) {
    const Lanes turn = smaller(all(1), larger(all(-1), all(h) * spin));
    const Lanes square = turn * turn;
    const Lanes along = square * all(Real(1) / 24) - all(Real(0.5));
    const Lanes across = turn * all(Real(1) / 6);
    return {square * (along * arm.x + across * arm.y), square * (along * arm.y - across * arm.x)};
}

/// A vector after the rotation of the substep.
KODO_LANES_INLINE Couple rotatedBy(Lanes spin, const Couple& v, Real h) {
    const Lanes turn = smaller(all(1), larger(all(-1), all(h) * spin));
    const Couple bend = bendOf(spin, v, h);
    return {v.x - turn * v.y + bend.x, v.y + turn * v.x + bend.y};
}

enum class RevoluteTask { Solve, Relax };

/// Bodies start a substep with the velocity change of the substep before. It contains the impulses
/// of the joints on the arms of then, so Solve first adds the change of their torques. Without it
/// the restoring torque of a tight chain lags by a substep, which adds energy to vibrations.

template <RevoluteTask task>
void solveRevolutes(const RevolutePassArguments& pass) {
    const Softness& soft = pass.soft;
    for (std::size_t i = 0; i < pass.count; ++i) {
        RevoluteBlock& block = pass.blocks[i];
        for (int at = 0; at < RevoluteBlock::kPins; at += kLanes) {
            RevolutePair pair = pairOf(pass, block, at);
            auto& [a, b, armA, armB] = pair;
            if constexpr (task == RevoluteTask::Solve) {
                a.z -= load(block.inertiaA + at) * load(block.torqueA + at);
                b.z += load(block.inertiaB + at) * load(block.torqueB + at);
                store(block.torqueA + at, Lanes{});
                store(block.torqueB + at, Lanes{});
            }
            Couple speed{(b.x - a.x) - (b.z * armB.y - a.z * armA.y),
                         (b.y - a.y) + (b.z * armB.x - a.z * armA.x)};
            Lanes scale = all(-1);
            Lanes kept = all(1);
            if constexpr (task == RevoluteTask::Solve) {
                const Couple gap = rotatedBy(a.z, load(block.gap, at), pass.h);
                const Couple bendA = bendOf(a.z, armA, pass.h);
                const Couple bendB = bendOf(b.z, armB, pass.h);
                speed.x += all(soft.biasRate) * gap.x + (bendB.x - bendA.x) * all(1 / pass.h);
                speed.y += all(soft.biasRate) * gap.y + (bendB.y - bendA.y) * all(1 / pass.h);
                scale = all(-soft.massScale);
                kept = all(1 - soft.impulseScale);
            }
            const Lanes xy = load(block.massXY + at);
            const Couple impulse = load(block.impulse, at);
            const Couple next{
                kept * impulse.x + scale * (load(block.massXX + at) * speed.x + xy * speed.y),
                kept * impulse.y + scale * (xy * speed.x + load(block.massYY + at) * speed.y)};
            store(block.impulse, at, next);
            if constexpr (task == RevoluteTask::Relax) {
                const Couple total = load(block.total, at);
                store(block.total, at, {total.x + next.x, total.y + next.y});
            }
            pushRevolutes(pass, i, at, pair, {next.x - impulse.x, next.y - impulse.y});
        }
    }
}

/// The passes of this instruction set.
constexpr RevolutePasses revolutePassesNamed(const char* name) {
    return {name, rotateRevolutes, warmStartRevolutes, solveRevolutes<RevoluteTask::Solve>,
            solveRevolutes<RevoluteTask::Relax>};
}

} // namespace
} // namespace KODO_PRECISION
} // namespace kodo
