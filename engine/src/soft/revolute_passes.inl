// SPDX-License-Identifier: MIT
// Included by revolute_passes*.cpp, each of which is compiled for one instruction set. All
// functions have internal linkage and call no inline function from elsewhere; lanes.hpp gives the
// reason.
#include "joints/joint_rows.hpp"
#include "math/lane_rotations.hpp"

#include "lanes/velocity_lanes.hpp"
#include "soft/revolute_block.hpp"

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

/// K divided by its trace, so that squares of small and large masses neither underflow nor
/// overflow; see ScaledK.
struct ScaledMass {
    Lanes scale; // 1 / trace
    Lanes mass;
    Lanes ia; // inverse inertias
    Lanes ib;
    Lanes determinant;
};

KODO_LANES_INLINE ScaledMass scaledMass(const RevoluteBlock& block, int at) {
    const Couple armA = load(block.armA, at);
    const Couple armB = load(block.armB, at);
    const Lanes mass = load(block.mass + at);
    const Lanes ia = load(block.inertiaA + at);
    const Lanes ib = load(block.inertiaB + at);
    const Lanes trace = (mass + mass) + (ia * (armA.x * armA.x + armA.y * armA.y) +
                                         ib * (armB.x * armB.x + armB.y * armB.y));
    const Lanes scale = trace > Lanes{} ? all(1) / trace : Lanes{};
    const Lanes area = armA.x * armB.y - armA.y * armB.x;
    ScaledMass scaled{scale, scale * mass, scale * ia, scale * ib, Lanes{}};
    scaled.determinant =
        scaled.mass * (all(1) - scaled.mass) + (scaled.ia * area) * (scaled.ib * area);
    return scaled;
}

/// Stores K^-1; see PointConstraint::stopping(). Each joint has a body with a mass.
KODO_LANES_INLINE void storeMass(RevoluteBlock& block, int at) {
    const Couple armA = load(block.armA, at);
    const Couple armB = load(block.armB, at);
    const ScaledMass m = scaledMass(block, at);
    const Lanes by = m.determinant > Lanes{} ? m.scale / m.determinant : Lanes{};
    store(block.massXX + at, by * (m.mass + (m.ia * armA.x * armA.x + m.ib * armB.x * armB.x)));
    store(block.massXY + at, by * (m.ia * armA.x * armA.y + m.ib * armB.x * armB.y));
    store(block.massYY + at, by * (m.mass + (m.ia * armA.y * armA.y + m.ib * armB.y * armB.y)));
}

/// 1/I_a + 1/I_b, and what is left of it if the anchors stay together: PointConstraint::hinged().
/// `scale`: fraction of the reaction of the point that acts.
KODO_LANES_INLINE Lanes hingedMass(const RevoluteBlock& block, int at, Lanes scale) {
    const ScaledMass m = scaledMass(block, at);
    const Lanes x = load(block.armA.x + at) - load(block.armB.x + at);
    const Lanes y = load(block.armA.y + at) - load(block.armB.y + at);
    const Lanes ib = load(block.inertiaB + at);
    const Lanes sum = load(block.inertiaA + at) + ib;
    const Lanes hinged = m.mass * (m.mass * sum + m.ia * ib * (x * x + y * y));
    const Lanes inverse = m.determinant > Lanes{} ? all(1) / m.determinant : Lanes{};
    return (all(1) - scale) * sum + scale * (hinged * inverse);
}

/// Change of the torque impulse of a joint on a body, when its arm rotates.
KODO_LANES_INLINE Lanes torqueChange(const Couple& from, const Couple& to, const Couple& impulse) {
    return (to.x - from.x) * impulse.y - (to.y - from.y) * impulse.x;
}

void rotateRevolutes(const RevolutePassArguments& pass) {
    for (std::size_t i = 0; i < pass.count; ++i) {
        RevoluteBlock& block = pass.blocks[i];
        for (int at = 0; at < RevoluteBlock::kJoints; at += kLanes) {
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
            if (const std::uint32_t k = pass.use[i].angles; k != RevoluteUse::kNoAngles) {
                RevoluteAngles& angles = pass.angles[k];
                store(angles.angle + at, load(angles.start + at) + (moveB.z - moveA.z));
            }
            storeMass(block, at);
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

/// Applies an angular impulse, without storing the velocities.
KODO_LANES_INLINE void twistRevolutes(const RevoluteBlock& block, int at, RevolutePair& pair,
                                      Lanes impulse) {
    pair.a.z -= load(block.inertiaA + at) * impulse;
    pair.b.z += load(block.inertiaB + at) * impulse;
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
        for (int at = 0; at < RevoluteBlock::kJoints; at += kLanes) {
            RevolutePair pair = pairOf(pass, block, at);
            store(block.torqueA + at, Lanes{});
            store(block.torqueB + at, Lanes{});
            if (const std::uint32_t k = pass.use[i].angles; k != RevoluteUse::kNoAngles) {
                const RevoluteAngles& angles = pass.angles[k];
                twistRevolutes(block, at, pair,
                               (load(angles.motor + at) + load(angles.below + at)) -
                                   load(angles.above + at));
            }
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

/// Impulse of a limit after its solution; the same rules as JointKinds::limit(). A positive `room`
/// (rad) may be closed within the substep. `speed` (rad/s): of the room, once the point is solved.
/// `pushed` (N m s): by the motor, into the limit.
template <RevoluteTask task>
KODO_LANES_INLINE Lanes limitImpulse(const RevolutePassArguments& pass, Lanes impulse, Lanes pushed,
                                     Lanes room, Lanes speed, Lanes mass) {
    const auto apart = room > Lanes{};
    const Lanes stopping = larger(Lanes{}, impulse - mass * speed); // without softness
    Lanes kept = all(1);
    if constexpr (task == RevoluteTask::Solve) {
        const Softness& soft = pass.soft;
        speed += room * (apart ? all(1 / pass.h) : all(soft.biasRate));
        mass *= apart ? all(1) : all(soft.massScale);
        kept = apart ? all(1) : all(1 - soft.impulseScale);
    } else {
        speed += apart ? room * all(1 / pass.h) : Lanes{};
    }
    const Lanes borne = smaller(stopping, larger(Lanes{}, pushed));
    return larger(Lanes{}, (borne + kept * (impulse - borne)) - mass * speed);
}

/// Solves motors and limits, and returns the change of their impulses. `speed` (rad/s): of b
/// relative to a, once the point is solved; `give`: its change per impulse. See CoupledPoint.
template <RevoluteTask task>
KODO_LANES_INLINE Lanes solveAngles(const RevolutePassArguments& pass, std::size_t i, int at,
                                    Lanes speed, Lanes give) {
    RevoluteAngles& angles = pass.angles[pass.use[i].angles];
    const Lanes mass = give > Lanes{} ? all(1) / give : Lanes{};
    const Lanes most = all(pass.h) * load(angles.torque + at);
    const Lanes motor = load(angles.motor + at);
    const Lanes driven =
        smaller(most, larger(-most, motor - mass * (speed - load(angles.speed + at))));
    speed += give * (driven - motor);
    const Lanes angle = load(angles.angle + at);
    const Lanes below = load(angles.below + at);
    const Lanes raised =
        limitImpulse<task>(pass, below, -driven, angle - load(angles.lower + at), speed, mass);
    speed += give * (raised - below);
    const Lanes above = load(angles.above + at);
    const Lanes lowered =
        limitImpulse<task>(pass, above, driven, load(angles.upper + at) - angle, -speed, mass);
    store(angles.motor + at, driven);
    store(angles.below + at, raised);
    store(angles.above + at, lowered);
    if constexpr (task == RevoluteTask::Relax) {
        store(angles.total + at, load(angles.total + at) + ((driven + raised) - lowered));
    }
    return ((driven - motor) + (raised - below)) - (lowered - above);
}

/// K^-1 of kLanes joints.
struct PointMass {
    Lanes xx;
    Lanes xy;
    Lanes yy;

    KODO_LANES_INLINE Couple times(const Couple& v) const {
        return {xx * v.x + xy * v.y, xy * v.x + yy * v.y};
    }
};

/// Solves motors and limits before the point. `change`: impulse that the point would apply; `scale`
/// of its softness. Afterwards it is the impulse that the point applies then.
template <RevoluteTask task>
KODO_LANES_INLINE void solveBeside(const RevolutePassArguments& pass, std::size_t i, int at,
                                   RevolutePair& pair, const PointMass& mass, Couple& change) {
    const RevoluteBlock& block = pass.blocks[i];
    const Lanes ia = load(block.inertiaA + at);
    const Lanes ib = load(block.inertiaB + at);
    const Lanes scale = all(task == RevoluteTask::Solve ? pass.soft.massScale : Real(1));
    const Couple& armA = pair.armA;
    const Couple& armB = pair.armB;
    const Couple u{-(ia * armA.y + ib * armB.y), ia * armA.x + ib * armB.x};
    const Couple reaction = mass.times(u);
    const Couple taken{scale * reaction.x, scale * reaction.y};
    const Lanes give = hingedMass(block, at, scale);
    const Lanes speed = (pair.b.z - pair.a.z) + (u.x * change.x + u.y * change.y);
    const Lanes twist = solveAngles<task>(pass, i, at, speed, give);
    twistRevolutes(block, at, pair, twist);
    change.x -= twist * taken.x;
    change.y -= twist * taken.y;
}

/// Bodies start a substep with the velocity change of the substep before. It contains the impulses
/// of the joints on the arms of then, so Solve first adds the change of their torques. Without it
/// the restoring torque of a tight chain lags by a substep, which adds energy to vibrations.
template <RevoluteTask task, bool angular>
KODO_LANES_INLINE void solveBlock(const RevolutePassArguments& pass, std::size_t i) {
    const Softness& soft = pass.soft;
    RevoluteBlock& block = pass.blocks[i];
    for (int at = 0; at < RevoluteBlock::kJoints; at += kLanes) {
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
        const PointMass mass{load(block.massXX + at), load(block.massXY + at),
                             load(block.massYY + at)};
        const Couple impulse = load(block.impulse, at);
        const Couple answer = mass.times(speed);
        Couple next{kept * impulse.x + scale * answer.x, kept * impulse.y + scale * answer.y};
        Couple change{next.x - impulse.x, next.y - impulse.y};
        if constexpr (angular) {
            solveBeside<task>(pass, i, at, pair, mass, change);
            next = {impulse.x + change.x, impulse.y + change.y};
        }
        store(block.impulse, at, next);
        if constexpr (task == RevoluteTask::Relax) {
            const Couple total = load(block.total, at);
            store(block.total, at, {total.x + next.x, total.y + next.y});
        }
        pushRevolutes(pass, i, at, pair, change);
    }
}

template <RevoluteTask task>
void solveRevolutes(const RevolutePassArguments& pass) {
    for (std::size_t i = 0; i < pass.count; ++i) {
        if (pass.use[i].angles == RevoluteUse::kNoAngles) {
            solveBlock<task, false>(pass, i);
        } else {
            solveBlock<task, true>(pass, i);
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
