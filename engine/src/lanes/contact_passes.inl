// SPDX-License-Identifier: MIT
// Included by contact_passes*.cpp, each of which is compiled for one instruction set. All functions
// have internal linkage and call no inline function from elsewhere; lanes.hpp gives the reason.
#include "lanes/contact_advance.inl"
#include "lanes/contact_friction.inl"
#include "lanes/contact_lanes.inl"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Rotation of both bodies by an impulse along a line.
struct Turning {
    Lanes leverA; // m, lever of the line
    Lanes leverB;
    Lanes a; // rad/s per N s: lever / inertia
    Lanes b;
};

KODO_LANES_INLINE Turning turning(const Pair& pair, const Real* leverA, const Real* leverB) {
    const Lanes ofA = load(leverA);
    const Lanes ofB = load(leverB);
    return {ofA, ofB, pair.inertiaA * ofA, pair.inertiaB * ofB};
}
/// Speed along one line per impulse along the other (m/s per N s), by rotation alone. Symmetric in
/// the two lines.
KODO_LANES_INLINE Lanes turnCoupling(const Turning& other, const Turning& line) {
    return line.a * other.leverA + line.b * other.leverB;
}
/// Relative speed along the line (m/s) by angular velocities (rad/s). Angles (rad) give a
/// displacement (m).
KODO_LANES_INLINE Lanes speedOfTurns(const Turning& line, Lanes turnA, Lanes turnB) {
    return line.leverB * turnB - line.leverA * turnA;
}
/// Applies angular impulses (N m s).
KODO_LANES_INLINE void spin(Pair& pair, Lanes ofA, Lanes ofB) {
    pair.a.z -= pair.inertiaA * ofA;
    pair.b.z += pair.inertiaB * ofB;
}
/// Applies the angular part of an impulse (N s) along the line.
KODO_LANES_INLINE void spin(Pair& pair, const Turning& line, Lanes impulse) {
    pair.a.z -= line.a * impulse;
    pair.b.z += line.b * impulse;
}

enum class Task {
    Solve, // biased: separates overlaps
    Relax, // without bias, with friction; adds up the sums of the step
};

/// Values shared by all contacts of a block.
struct Rules {
    Real biasRate;
    Real massScale;
    const PassSettings& settings;
    const BlockUse& use;
};

/// Bodies, and how an impulse at a point turns them.
struct Turned {
    const Pair& pair;
    const Turning& line;
};

/// State of one point of each contact before the impulses of this visit.
struct Approach {
    Lanes gap;       // m; < 0: overlap
    Lanes speed;     // m/s, along the normal; < 0: approach
    Lanes pushSpeed; // m/s, largest separating speed
};

/// What the impulse of a point loses besides, where it separates (N s). The warm start repeats the
/// blow of a heavy body, and the effective mass m of a light one below would end that in many
/// passes alone. With the mass m_h of the heavier body, it ends in one:
///
///   (m_h - m) (v_n - thrown),  v_n > thrown
///
/// In a crowd, where contacts share the push speed, it is 0.
KODO_LANES_INLINE Lanes staleImpulse(const Turned& turned, const Approach& approach, Lanes mass,
                                     const PassSettings& settings) {
    const auto& [pair, line] = turned;
    const Lanes givesA = pair.a.w + line.a * line.leverA; // 1/kg
    const Lanes givesB = pair.b.w + line.b * line.leverB;
    const Lanes less = smaller(givesA, givesB);
    const Lanes least = less > Lanes{} ? less : larger(givesA, givesB); // not of a locked body
    const Lanes heavier = least > Lanes{} ? larger(all(1) / least - mass, Lanes{}) : Lanes{};
    const Lanes excess = larger(approach.speed - all(settings.thrown), Lanes{});
    return approach.pushSpeed < all(settings.pushSpeed) ? Lanes{} : heavier * excess;
}

// Share of the push speed from which a biased point pushes its bodies apart.
constexpr Real kPushes = Real(1) / 32;

/// Unclamped impulse of one point of each contact:
///
///   lambda = mass_scale (lambda_sum - m (v_n + bias))
///
/// This is the equation of Softness, since its two scales add up to 1. The returned mass is
/// mass_scale m.
///
/// A gap s > 0 has mass_scale 1 and bias s/h, so it may close within the substep but not become an
/// overlap. An overlap s < 0 has bias max(bias_rate s, -push_speed) in the biased pass. Without
/// bias it has mass_scale 1 and bias 0. The speed is used last, since the previous block may just
/// have stored it.
template <Task task>
KODO_LANES_INLINE Unclamped unclampedAt(const ContactBlock::Point& point, int at,
                                        const Approach& approach, const Turned& turned,
                                        const Rules& rules) {
    const Lanes impulse = load(point.impulse + at);
    const Lanes mass = load(point.mass + at);
    const Lanes close = approach.gap * all(rules.settings.invH);
    if constexpr (task == Task::Solve) {
        // The larger term is s/h for a gap and bias_rate s for an overlap, since bias_rate < 1/h.
        const Lanes bias =
            larger(larger(all(rules.biasRate) * approach.gap, close), -approach.pushSpeed);
        const Lanes scale = approach.gap > Lanes{} ? all(1) : all(rules.massScale);
        const Lanes scaled = scale * mass;
        const bool stale = anyAbove(approach.speed, rules.settings.thrown);
        const Lanes wanted = (scale * impulse - scaled * bias) - scaled * approach.speed;
        return {stale ? wanted - staleImpulse(turned, approach, mass, rules.settings) : wanted,
                scaled, bias < all(-kPushes * rules.settings.pushSpeed)};
    } else {
        return {(impulse - mass * larger(close, Lanes{})) - mass * approach.speed, mass,
                mass == mass};
    }
}

/// The relax pass adds up the impulses of the step (N s): `sum` along the normal, and friction.
template <Task task>
KODO_LANES_INLINE void addTotal(ContactBlock& block, int at, Lanes sum, Real kept) {
    if constexpr (task == Task::Relax) {
        store(block.total[0] + at, kept * load(block.total[0] + at) + sum);
        store(block.total[1] + at, load(block.total[1] + at) + load(block.friction + at));
    }
}

/// Clamps the impulse of a point to >= 0 and stores it. Returns the change (N s).
template <Task task>
KODO_LANES_INLINE Lanes pushPoint(ContactBlock::Point& point, int at, Lanes unclamped, Real kept) {
    const Lanes impulse = load(point.impulse + at);
    const Lanes next = larger(unclamped, Lanes{});
    store(point.impulse + at, next);
    if constexpr (task == Task::Relax) {
        store(point.largest + at, larger(kept * load(point.largest + at), next));
    }
    return next - impulse;
}

KODO_LANES_INLINE void solveRolling(const SurfaceBlock* surface, ContactBlock& block, int at,
                                    Pair& pair, Lanes pressed) {
    if (surface == nullptr) {
        return;
    }
    const Lanes impulse = load(block.rolling + at);
    const Lanes limit = load(surface->rollingLever + at) * pressed;
    const Lanes wanted = impulse - load(surface->rollingMass + at) * (pair.b.z - pair.a.z);
    const Lanes next = within<Lanes>(limit, wanted);
    store(block.rolling + at, next);
    spin(pair, next - impulse, next - impulse);
}

/// The velocities of kLanes contacts. `inertias`: 1/inertia of bodies a and b.
KODO_LANES_INLINE Pair gatherPair(const ContactBlock& block, int at, BodyVelocity* motion,
                                  const Couple& inertias) {
    return {gather(firstHalf(motion), block.a + at), gather(firstHalf(motion), block.b + at),
            inertias.x, inertias.y};
}

KODO_LANES_INLINE void putBackPair(const Pair& pair, const ContactBlock& block, int at,
                                   BodyVelocity* motion, const BlockUse& use) {
    putBack(motion, block.a + at, pair.a, use.movesA, at);
    putBack(motion, block.b + at, pair.b, use.movesB, at);
}

/// Solves kLanes contacts from the velocities before this visit. An impulse d1 at the first point
/// lowers the unclamped impulse at the second by m2 k12 d1. It lowers the impulse that stops all
/// sliding by mt k1t d1:
///
///   k12 = 1/mA + 1/mB + leverA1 leverA2 / IA + leverB1 leverB2 / IB,
///   k1t = leverA1 leverAt / IA + leverB1 leverBt / IB
///
/// t is the tangent; k1t has no 1/m since tangent and normal are perpendicular. k2t is the same for
/// the second point. So the result is that of sequential impulses, with a short dependency chain.
/// The function is not split: the compiler would keep a struct of these values in memory.
template <Task task, int points, bool rare>
KODO_LANES_INLINE void solveLanes(ContactBlock& block, const SurfaceBlock* surface, int at,
                                  BodyVelocity* motion, const Rules& rules) {
    const Lanes nx = load(block.normalX + at);
    const Lanes ny = load(block.normalY + at);
    const Quad moveA = gather(secondHalf(motion), block.a + at);
    const Quad moveB = gather(secondHalf(motion), block.b + at);
    Pair pair = gatherPair(block, at, motion, {moveA.w, moveB.w});
    ContactBlock::Point& point1 = block.points[0];
    ContactBlock::Point& point2 = block.points[points - 1]; // the first again if there is one
    const Turning line1 = turning(pair, point1.leverA + at, point1.leverB + at);
    const Turning line2 = turning(pair, point2.leverA + at, point2.leverB + at);
    const Turning tangent = turning(pair, block.tangentLeverA + at, block.tangentLeverB + at);
    const Lanes dx = pair.b.x - pair.a.x;
    const Lanes dy = pair.b.y - pair.a.y;
    const auto wantedAt = [&](const ContactBlock::Point& point, const Turning& line) {
        const Lanes gap = load(point.separation + at) +
                          (nx * (moveB.x - moveA.x) + ny * (moveB.y - moveA.y)) +
                          speedOfTurns(line, moveA.z, moveB.z);
        const Lanes speed = (nx * dx + ny * dy) + speedOfTurns(line, pair.a.z, pair.b.z);
        const Approach approach{gap, speed, load(block.pushSpeed + at)};
        return unclampedAt<task>(point, at, approach, {pair, line}, rules);
    };
    const Unclamped first = wantedAt(point1, line1);
    const Unclamped second = wantedAt(point2, line2);
    const Lanes response12 = (pair.a.w + pair.b.w) + turnCoupling(line2, line1);
    const Lanes tangentMass = load(block.tangentMass + at);
    Lanes sliding = (nx * dy - ny * dx) + speedOfTurns(tangent, pair.a.z, pair.b.z);
    if (rare && surface != nullptr) {
        sliding += load(surface->speed + at);
    }
    Lanes stopping = load(block.friction + at) - tangentMass * sliding;
    const Lanes coupling1t = tangentMass * turnCoupling(line1, tangent);
    const Lanes coupling2t = tangentMass * turnCoupling(line2, tangent);
    const Together wanted = together<points == 2, rare>(
        block, at, first, second, {response12, coupling1t, coupling2t, tangentMass, stopping});
    Lanes change = pushPoint<task>(point1, at, wanted.first, rules.settings.kept);
    Lanes sum = load(point1.impulse + at);
    spin(pair, line1, change);
    stopping -= coupling1t * change;
    if constexpr (points == 2) {
        const Lanes alone = second.impulse - second.mass * response12 * change;
        const Lanes next = rare ? (wanted.sticks ? wanted.second : alone) : alone;
        const Lanes more = pushPoint<task>(point2, at, next, rules.settings.kept);
        sum += load(point2.impulse + at);
        spin(pair, line2, more);
        stopping -= coupling2t * more;
        change += more;
    }
    push(pair, nx, ny, change);
    if (task == Task::Relax && rules.settings.friction) {
        const Lanes rubbed = applyFriction<rare>(block, at, stopping, sum, rules.settings.left);
        push(pair, -ny, nx, rubbed);
        spin(pair, tangent, rubbed);
    }
    solveRolling(surface, block, at, pair, sum);
    addTotal<task>(block, at, sum, rules.settings.kept);
    putBackPair(pair, block, at, motion, rules.use);
}

template <Task task, int points, bool rare = false>
KODO_LANES_INLINE void solveBlock(ContactBlock& block, const SurfaceBlock* surface,
                                  BodyVelocity* motion, const Rules& rules) {
    for (int at = 0; at < ContactBlock::kContacts; at += kLanes) {
        solveLanes<task, points, rare>(block, surface, at, motion, rules);
    }
}

/// solveBlock() in the relax pass for a block with rareFriction. Not inlined, as it is rare.
template <Task task>
__attribute__((noinline)) void solveRare(ContactBlock& block, const SurfaceBlock* surface,
                                         BodyVelocity* motion, const Rules& rules) {
    if (rules.use.twoPoints) {
        solveBlock<task, 2, true>(block, surface, motion, rules);
    } else {
        solveBlock<task, 1, true>(block, surface, motion, rules);
    }
}

template <Task task>
void solveBlocks(const ContactPassArguments& pass) {
    const PassSettings& settings = pass.settings;
    for (std::size_t k = 0; k < pass.count; ++k) {
        prefetchBlock(
            pass, k, task == Task::Solve ? &ContactBlock::pushSpeed : &ContactBlock::tangentLeverA);
        const std::size_t i = pass.order[k];
        const BlockUse& use = pass.use[i];
        const Softness& soft = use.onLocked ? settings.onLocked : settings.soft;
        const Rules rules{soft.biasRate, soft.massScale, settings, use};
        const SurfaceBlock* const surface = use.surface < 0 ? nullptr : pass.surfaces + use.surface;
        ContactBlock& block = pass.blocks[i];
        if (task == Task::Relax && use.rareFriction) {
            solveRare<Task::Relax>(block, surface, pass.motion, rules);
        } else if (use.twoPoints) {
            solveBlock<task, 2>(block, surface, pass.motion, rules);
        } else {
            solveBlock<task, 1>(block, surface, pass.motion, rules);
        }
    }
}

void warmStartBlocks(const ContactPassArguments& pass) {
    for (std::size_t k = 0; k < pass.count; ++k) {
        prefetchBlock(pass, k, &ContactBlock::tangentLeverA);
        const std::size_t i = pass.order[k];
        ContactBlock& block = pass.blocks[i];
        const BlockUse& use = pass.use[i];
        for (int at = 0; at < ContactBlock::kContacts; at += kLanes) {
            Pair pair = gatherPair(block, at, pass.motion,
                                   {gather(secondHalf(pass.motion), block.a + at).w,
                                    gather(secondHalf(pass.motion), block.b + at).w});
            const Lanes nx = load(block.normalX + at);
            const Lanes ny = load(block.normalY + at);
            const Lanes friction = load(block.friction + at);
            const Lanes first = load(block.points[0].impulse + at);
            const Lanes second = load(block.points[1].impulse + at);
            const Lanes roll = use.surface < 0 ? Lanes{} : load(block.rolling + at);
            const Lanes sum = first + second;
            const auto momentBy = [&](const auto& lever1, const auto& lever2, const auto& tangent) {
                return load(lever1 + at) * first + load(lever2 + at) * second +
                       load(tangent + at) * friction + roll;
            };
            push(pair, sum * nx - friction * ny, sum * ny + friction * nx, all(1));
            spin(pair,
                 momentBy(block.points[0].leverA, block.points[1].leverA, block.tangentLeverA),
                 momentBy(block.points[0].leverB, block.points[1].leverB, block.tangentLeverB));
            putBackPair(pair, block, at, pass.motion, use);
        }
    }
}

/// The passes of this instruction set.
[[maybe_unused]] constexpr ContactPasses passesNamed(const char* name) {
    return {name, warmStartBlocks, solveBlocks<Task::Solve>, solveBlocks<Task::Relax>,
            advanceBlocks};
}

} // namespace
} // namespace KODO_PRECISION
} // namespace kodo
