// SPDX-License-Identifier: MIT
// Included by contact_passes*.cpp, one for each kind of machine. Internal linkage throughout and
// no call to an inline function of elsewhere, for the reason that lanes.hpp gives.
#include <kodo/solve/contact_block.hpp>
#include <kodo/solve/motion_lanes.hpp>

namespace kodo::inline KODO_PRECISION {
namespace {

/// The first of the Carried of a row.
KODO_LANES_INLINE Real* numbers(Carried* carried) {
    return carried->separation.data();
}
static_assert(sizeof(Carried) == 4 * sizeof(Real));

/// kLanes contacts of a block with their two bodies each.
struct Pair {
    Quad a; // x, y: velocity, z: angular velocity, w: 1/mass
    Quad b;
    Lanes inertiaA; // 1/inertia
    Lanes inertiaB;
};

/// Adds an impulse p, but for its moment.
KODO_LANES_INLINE void push(Pair& pair, Lanes px, Lanes py) {
    pair.a.x -= pair.a.w * px;
    pair.a.y -= pair.a.w * py;
    pair.b.x += pair.b.w * px;
    pair.b.y += pair.b.w * py;
}

/// Of impulses about the centres of the two, N m s.
struct Moments {
    Lanes a;
    Lanes b;
};

/// Adds the moments of impulses.
KODO_LANES_INLINE void spin(Pair& pair, const Moments& moments) {
    pair.a.z -= pair.inertiaA * moments.a;
    pair.b.z += pair.inertiaB * moments.b;
}

enum class Task {
    Push,   // pushes overlaps apart
    Settle, // takes the speed of that out again, along the normal alone
    Relax,  // likewise, with friction and rolling resistance; the last, so it sums up
};

/// What all contacts of a block share.
struct Rules {
    Real biasRate;
    Real massScale;
    const PassSettings& settings;
};

/// kLanes contacts of a block, from `at` on.
struct Lot {
    int at;
    Lanes pushSpeed; // m/s at most, to part them
};

/// How far one point of each contact is apart by now, and its levers. `moved` is the move of the
/// centres against each other.
struct Gap {
    Lanes s;
    Lanes leverA;
    Lanes leverB;
};

KODO_LANES_INLINE Gap gapOf(const ContactBlock::Point& point, int at, Lanes moved,
                            const Quad& moveA, const Quad& moveB) {
    const Lanes leverA = load(point.leverA + at);
    const Lanes leverB = load(point.leverB + at);
    return {load(point.separation + at) + moved + (leverB * moveB.z - leverA * moveA.z), leverA,
            leverB};
}

/// One point of each contact, whose relative speed along the normal is `speed`. Gives the change of
///
///   lambda = mass_scale (lambda_sum - m (v_n + bias)) >= 0,
///
/// which is that of Softness, since its two scales add up to 1. A gap of s has a mass_scale of 1
/// and the bias s/h, by which it may close within the substep and no more; an overlap, s < 0, has
/// max(bias_rate s, -push_speed) where it is pushed apart, and else 1 and none. The speed is known
/// last, so all else is done before.
template <Task task>
KODO_LANES_INLINE Lanes solvePoint(ContactBlock::Point& point, const Lot& lot, Lanes speed,
                                   const Gap& gap, const Rules& rules) {
    const int at = lot.at;
    const Lanes impulse = load(point.impulse + at);
    const Lanes mass = load(point.mass + at);
    const Lanes close = gap.s * all(rules.settings.invH);
    Lanes next;
    if constexpr (task == Task::Push) {
        // bias_rate < 1/h, so of these two that of a gap is the larger, and else that of an overlap
        const Lanes bias = larger(larger(all(rules.biasRate) * gap.s, close), -lot.pushSpeed);
        const Lanes scale = gap.s > Lanes{} ? all(1) : all(rules.massScale);
        next = larger((scale * impulse - (scale * mass) * bias) - (scale * mass) * speed, Lanes{});
    } else {
        next = larger((impulse - mass * larger(close, Lanes{})) - mass * speed, Lanes{});
    }
    store(point.impulse + at, next);
    if constexpr (task == Task::Relax) {
        store(point.largest + at, larger(rules.settings.kept * load(point.largest + at), next));
    }
    return next - impulse;
}

/// Both points share one friction: |friction| <= mu (sum of normal impulses), static while that
/// holds it, kinetic from there on. `along` is the relative speed of the centres along the tangent,
/// `moments` what is yet to spin the two. Gives the change, and adds its moments to those.
KODO_LANES_INLINE Lanes solveFriction(ContactBlock& block, int at, const Pair& pair, Lanes along,
                                      Lanes pressed, Moments& moments) {
    const Lanes leverA = load(block.tangentLeverA + at);
    const Lanes leverB = load(block.tangentLeverB + at);
    const Lanes friction = load(block.friction + at);
    const Lanes speed =
        (along + (leverB * pair.b.z - leverA * pair.a.z)) +
        ((leverB * pair.inertiaB) * moments.b + (leverA * pair.inertiaA) * moments.a);
    const Lanes stick = friction - load(block.tangentMass + at) * speed;
    const Lanes hold = load(block.staticFriction + at) * pressed;
    const Lanes slip = load(block.kineticFriction + at) * pressed;
    const auto slides = (larger(stick, -stick) > hold);
    const Lanes next = slides ? larger(smaller(stick, slip), -slip) : stick;
    const Lanes change = next - friction;
    store(block.friction + at, next);
    moments.a += leverA * change;
    moments.b += leverB * change;
    return change;
}

KODO_LANES_INLINE void solveRolling(RollingBlock& block, int at, Pair& pair, Lanes pressed) {
    const Lanes impulse = load(block.impulse + at);
    const Lanes limit = load(block.lever + at) * pressed;
    const Lanes wanted = impulse - load(block.mass + at) * (pair.b.z - pair.a.z);
    const Lanes next = larger(smaller(wanted, limit), -limit);
    store(block.impulse + at, next);
    spin(pair, {next - impulse, next - impulse});
}

/// Blocks are so large that most of them lie in a far cache, and come in no order that the machine
/// could foresee: so they are fetched that many ahead (4 or 8 are as good).
constexpr std::size_t kBlocksAhead = 6;

KODO_LANES_INLINE void prefetchLines(const void* from, const void* end) {
    for (const char* at = static_cast<const char*>(from); at < end; at += 64) { // bytes a line
        __builtin_prefetch(at);
    }
}

/// Of a block to come what a pass reads: its points, and from `tail` on, if that is not null.
template <typename Arguments>
KODO_LANES_INLINE void prefetchBlock(const Arguments& pass, std::size_t k,
                                     ContactBlock::Each ContactBlock::*tail) {
    if (k + kBlocksAhead < pass.count) {
        const std::size_t i = pass.order[k + kBlocksAhead];
        const ContactBlock& next = pass.blocks[i];
        prefetchLines(&next, next.points + (pass.use[i].twoPoints ? 2 : 1));
        if (tail != nullptr) {
            prefetchLines(&(next.*tail), &next + 1);
        }
    }
}

template <Task task, int points>
KODO_LANES_INLINE void solveLanes(ContactBlock& block, RollingBlock* rolling, int at,
                                  Motion* motion, const Rules& rules, const BlockUse& use) {
    const PassSettings& settings = rules.settings;
    const Lanes nx = load(block.normalX + at);
    const Lanes ny = load(block.normalY + at);
    const Quad moveA = gather(secondHalf(motion), block.a + at);
    const Quad moveB = gather(secondHalf(motion), block.b + at);
    const Lanes moved = nx * (moveB.x - moveA.x) + ny * (moveB.y - moveA.y);
    const Gap gap1 = gapOf(block.points[0], at, moved, moveA, moveB);
    Gap gap2{};
    if constexpr (points == 2) {
        gap2 = gapOf(block.points[1], at, moved, moveA, moveB);
    }
    Pair pair{gather(firstHalf(motion), block.a + at), gather(firstHalf(motion), block.b + at),
              moveA.w, moveB.w};
    const Lanes dx = pair.b.x - pair.a.x;
    const Lanes dy = pair.b.y - pair.a.y;
    const Lanes along = nx * dx + ny * dy;
    const Lot lot{at, load(block.pushSpeed + at)};
    const auto speedAt = [&](const Gap& gap) {
        return along + (gap.leverB * pair.b.z - gap.leverA * pair.a.z);
    };
    Lanes change = solvePoint<task>(block.points[0], lot, speedAt(gap1), gap1, rules);
    Lanes sum = load(block.points[0].impulse + at);
    Moments moments{gap1.leverA * change, gap1.leverB * change};
    if constexpr (points == 2) {
        // What the first push does at the second point, by how they are coupled: that is known
        // before the push, so that as little as possible waits for it.
        const Lanes coupling =
            (pair.a.w + pair.b.w) + (pair.inertiaA * (gap1.leverA * gap2.leverA) +
                                     pair.inertiaB * (gap1.leverB * gap2.leverB));
        const Lanes second =
            solvePoint<task>(block.points[1], lot, speedAt(gap2) + coupling * change, gap2, rules);
        moments.a += gap2.leverA * second;
        moments.b += gap2.leverB * second;
        change += second;
        sum += load(block.points[1].impulse + at);
    }
    Lanes px = change * nx;
    Lanes py = change * ny;
    if (task == Task::Relax && settings.friction) {
        // what is pushed along the normal leaves the speed of the centres along the tangent
        const Lanes rub = solveFriction(block, at, pair, nx * dy - ny * dx, sum, moments);
        px -= rub * ny;
        py += rub * nx;
    }
    push(pair, px, py);
    spin(pair, moments);
    if (task != Task::Settle && rolling != nullptr) {
        solveRolling(*rolling, at, pair, sum);
    }
    if constexpr (task == Task::Relax) {
        store(block.total + at, settings.kept * load(block.total + at) + sum);
    }
    putBack(motion, block.a + at, pair.a, use.movesA, at);
    putBack(motion, block.b + at, pair.b, use.movesB, at);
}

template <Task task>
void solveBlocks(const ContactPassArguments& pass) {
    const PassSettings& settings = pass.settings;
    for (std::size_t k = 0; k < pass.count; ++k) {
        prefetchBlock(pass, k,
                      task == Task::Push ? &ContactBlock::pushSpeed : &ContactBlock::tangentLeverA);
        const std::size_t i = pass.order[k];
        const BlockUse& use = pass.use[i];
        const Softness& soft = use.onLocked ? settings.onLocked : settings.soft;
        const Rules rules{soft.biasRate, soft.massScale, settings};
        RollingBlock* const rolling = use.rolling < 0 ? nullptr : pass.rolling + use.rolling;
        for (int at = 0; at < ContactBlock::kContacts; at += kLanes) {
            if (use.twoPoints) {
                solveLanes<task, 2>(pass.blocks[i], rolling, at, pass.motion, rules, use);
            } else {
                solveLanes<task, 1>(pass.blocks[i], rolling, at, pass.motion, rules, use);
            }
        }
    }
}

void warmStartBlocks(const ContactPassArguments& pass) {
    for (std::size_t k = 0; k < pass.count; ++k) {
        prefetchBlock(pass, k, &ContactBlock::tangentLeverA);
        const std::size_t i = pass.order[k];
        ContactBlock& block = pass.blocks[i];
        const RollingBlock* const rolling =
            pass.use[i].rolling < 0 ? nullptr : pass.rolling + pass.use[i].rolling;
        for (int at = 0; at < ContactBlock::kContacts; at += kLanes) {
            Pair pair{gather(firstHalf(pass.motion), block.a + at),
                      gather(firstHalf(pass.motion), block.b + at),
                      gather(secondHalf(pass.motion), block.a + at).w,
                      gather(secondHalf(pass.motion), block.b + at).w};
            const Lanes nx = load(block.normalX + at);
            const Lanes ny = load(block.normalY + at);
            const Lanes friction = load(block.friction + at);
            const Lanes first = load(block.points[0].impulse + at);
            const Lanes second = load(block.points[1].impulse + at);
            const Lanes roll = rolling == nullptr ? Lanes{} : load(rolling->impulse + at);
            const Lanes sum = first + second;
            const auto momentBy = [&](const auto& lever1, const auto& lever2, const auto& tangent) {
                return load(lever1 + at) * first + load(lever2 + at) * second +
                       load(tangent + at) * friction + roll;
            };
            push(pair, sum * nx - friction * ny, sum * ny + friction * nx);
            spin(pair,
                 {momentBy(block.points[0].leverA, block.points[1].leverA, block.tangentLeverA),
                  momentBy(block.points[0].leverB, block.points[1].leverB, block.tangentLeverB)});
            putBack(pass.motion, block.a + at, pair.a, pass.use[i].movesA, at);
            putBack(pass.motion, block.b + at, pair.b, pass.use[i].movesB, at);
        }
    }
}

/// How far turns have taken the outlines of bodies, at most: see Convex::swing.
KODO_LANES_INLINE Lanes swingOf(const Extent* extent, const std::uint32_t* places, Lanes turn) {
    Lanes swing{};
    for (int i = 0; i < kLanes; ++i) {
        swing[i] = extent[bodyOfPlace(places[i])].swing;
    }
    return larger(turn, -turn) * swing;
}

/// What carry() in contact_update.cpp does with one contact, to the bit.
template <int points>
KODO_LANES_INLINE void carryLanes(const CarryArguments& pass, ContactBlock& block, Carried* carried,
                                  int at) {
    static constexpr std::uint32_t kRows[] = {0, 4, 8, 12, 16, 20, 24, 28};
    Motion* const motion = pass.motion;
    const Lanes nx = load(block.normalX + at);
    const Lanes ny = load(block.normalY + at);
    const Quad moveA = gather(secondHalf(motion), block.a + at);
    const Quad moveB = gather(secondHalf(motion), block.b + at);
    const Quad speedA = gather(firstHalf(motion), block.a + at);
    const Quad speedB = gather(firstHalf(motion), block.b + at);
    const Lanes dx = moveB.x - moveA.x;
    const Lanes dy = moveB.y - moveA.y;
    const Lanes moved = nx * dx + ny * dy;
    const Lanes speed = nx * (speedB.x - speedA.x) + ny * (speedB.y - speedA.y);
    Quad now = gather(numbers(carried + at), kRows); // x, y: separation, z: approach, w: drift
    now.z = Lanes{};
    now.w += larger(dx, -dx) + larger(dy, -dy) + swingOf(pass.extent, block.a + at, moveA.z) +
             swingOf(pass.extent, block.b + at, moveB.z);
    const auto carry = [&](ContactBlock::Point& point, Lanes& separation) {
        const Lanes leverA = load(point.leverA + at);
        const Lanes leverB = load(point.leverB + at);
        separation += moved + (leverB * moveB.z - leverA * moveA.z);
        store(point.separation + at, separation);
        now.z = larger(-(speed + (leverB * speedB.z - leverA * speedA.z)), now.z); // no -0
    };
    carry(block.points[0], now.x);
    if constexpr (points == 2) {
        carry(block.points[1], now.y);
    }
    scatter(numbers(carried + at), kRows, now);
}

void carryBlocks(const CarryArguments& pass) {
    for (std::size_t k = 0; k < pass.count; ++k) {
        prefetchBlock(pass, k, nullptr);
        const std::size_t i = pass.order[k];
        Carried* const carried = pass.carried + i * ContactBlock::kContacts;
        for (int at = 0; at < ContactBlock::kContacts; at += kLanes) {
            if (pass.use[i].twoPoints) {
                carryLanes<2>(pass, pass.blocks[i], carried, at);
            } else {
                carryLanes<1>(pass, pass.blocks[i], carried, at);
            }
        }
    }
}

/// Those of this kind of machine.
[[maybe_unused]] constexpr ContactPasses passesNamed(const char* name) {
    return {name,
            warmStartBlocks,
            solveBlocks<Task::Push>,
            solveBlocks<Task::Settle>,
            solveBlocks<Task::Relax>,
            carryBlocks};
}

} // namespace
} // namespace kodo::inline KODO_PRECISION
