// SPDX-License-Identifier: MIT
#include "parts.hpp"

namespace destructoooor {

namespace {

constexpr std::string_view kChaos = "Chaos";
constexpr std::string_view kSameBits = "Same bits";
constexpr std::string_view kThesis = "Thesis";

Ids buildGalton(kodo::World& world) {
    addGround(world);
    for (int row = 0; row < 7; ++row) {
        for (int i = 0; i <= row; ++i) {
            addBall(world, {2 * Real(i) - Real(row), 12 - Real(row)}, 0.2_r,
                    {.type = kodo::BodyType::Static});
        }
    }
    for (int i = 0; i < 10; ++i) {
        addBox(world, {2 * Real(i) - 9, 2}, 0.2_r, 4, {.type = kodo::BodyType::Static});
    }
    addWall(world, {9, 0}, {9, 14}, 0.5_r);
    addWall(world, {-9, 14}, {-9, 0}, 0.5_r);
    return {};
}

void pour(kodo::World& world, const Ids&, std::uint64_t tick) {
    constexpr std::uint64_t kBalls = 60;
    if (tick % 10 == 0 && tick / 10 < kBalls) {
        const Real side = 0.02_r * (Real(tick / 10 * 7 % 11) - 5);
        addBall(world, {side, 14}, 0.25_r, {.material = {0.2_r, 0.2_r, 0.3_r, 0}});
    }
}

Ids buildTwins(kodo::World& world) {
    Ids ends;
    for (int k = 0; k < 2; ++k) {
        const Vec2 top{12 * Real(k) - 6, 8};
        BodyId last = addBox(world, top, 0.4_r, 0.4_r, {.type = kodo::BodyType::Static});
        for (int i = 0; i < 2; ++i) {
            // The second pair starts with a speed that is 1e-4 rad/s larger.
            const BodyId link = addBox(world, top + Vec2{2.5_r * Real(i) + 1.25_r, 0}, 2.5_r, 0.3_r,
                                       {.angularVelocity = Real(k) * 1e-4_r});
            meetNothing(world, link);
            pin(world, last, link, top + Vec2{2.5_r * Real(i), 0});
            last = link;
        }
        ends.push_back(last);
    }
    return ends;
}

Ids buildDrop(kodo::World& world) {
    addGround(world);
    for (int i = 0; i < 50; ++i) {
        addBox(world, {Real(i % 10) * 1.3_r - 6, 4 + Real(i / 10) * 1.5_r}, 0.8_r, 0.8_r,
               {.rotation = kodo::Rot::fromAngle(Real(i))});
    }
    return {};
}

bool copiesAgree(const kodo::World& world, const Ids&) {
    kodo::World copy = world;
    kodo::World restored = kodo::fromBytes(kodo::toBytes(world));
    for (int i = 0; i < 60; ++i) {
        copy.step(kStepSeconds);
        restored.step(kStepSeconds);
    }
    return copy.stateHash() == restored.stateHash();
}

Ids buildBelief(kodo::World& world) {
    // A shot at a pile, and the ghost of it: a copy that was asked two seconds ahead.
    addGround(world);
    for (int i = 0; i < 15; ++i) {
        addBox(world, {3 + Real(i % 3), 0.5_r + Real(i / 3)}, 1, 1);
    }
    const BodyId ball = addBall(world, {-10, 3}, 0.5_r, {.velocity = {14, 6}, .density = 5});
    kodo::World future = world;
    for (int i = 0; i < 120; ++i) {
        future.step(kStepSeconds);
    }
    const Vec2 end = future[ball].center();
    const BodyId mark =
        addBall(world, end, 0.55_r, {.type = kodo::BodyType::Static, .flags = kodo::kSensor});
    return {ball, mark};
}

Ids buildThesisTower(kodo::World& world) {
    addGround(world);
    Ids ids;
    for (int i = 0; i < 12; ++i) {
        ids.push_back(addBox(world, {0, Real(i) + 0.5_r}, 1, 1));
    }
    return ids;
}

Ids buildHeights(kodo::World& world) {
    addGround(world);
    Ids lowest;
    for (int height = 3; height <= 12; height += 3) {
        const Real x = Real(height) * 1.5_r - 11.25_r;
        lowest.push_back(addBox(world, {x, 0.5_r}, 1, 1));
        for (int i = 1; i < height; ++i) {
            addBox(world, {x, Real(i) + 0.5_r}, 1, 1);
        }
    }
    return lowest;
}

/// Largest overlap (m) in the stack of a box.
Real overlapOfStack(const kodo::World& world, BodyId box) {
    const Real x = world[box].center().x;
    Real deepest = 0;
    for (const kodo::CollisionRecord& record : world.collisions()) {
        if (record.phase != kodo::TouchPhase::End && isNear(record.point.x, x, 1)) {
            deepest = std::max(deepest, -record.separation);
        }
    }
    return deepest;
}

Ids buildThesisPyramid(kodo::World& world) {
    addGround(world);
    Ids ids;
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 10 - row; ++i) {
            ids.push_back(
                addBox(world, {(Real(i) - Real(9 - row) / 2) * 1.1_r, 0.5_r + Real(row)}, 1, 1));
        }
    }
    return ids;
}

Ids buildHeavyTop(kodo::World& world) {
    addGround(world);
    Ids ids;
    for (int i = 0; i < 5; ++i) {
        ids.push_back(addBox(world, {0, Real(i) + 0.5_r}, 1, 1));
    }
    ids.push_back(addBox(world, {0, 6}, 2, 2, {.density = 50}));
    return ids;
}

bool standsAt(const kodo::World& world, BodyId id, Vec2 place) {
    return isNear(world[id].center(), place, 0.25_r);
}

const Scene kPrincipleScenes[] = {
    {kChaos,
     "Galton's board",
     "How do sixty balls spread?",
     "Like a bell: most in the middle, none lost.",
     buildGalton,
     25,
     [](const kodo::World& world, const Ids&) {
         return allWithin(world, {{-9, 0}, {9, 14}});
     },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     kodo::balanced(),
     pour},
    {kChaos, "Almost twins", "How long do two double pendulums agree that differ by 1e-4 rad/s?",
     "Some seconds; then they go their own ways.", buildTwins, 25,
     [](const kodo::World& world, const Ids& ids) {
         const Vec2 way = world[ids[1]].center() - world[ids[0]].center() - Vec2{12, 0};
         return kodo::length(way) > 0.5_r;
     }},
    {kSameBits, "A copy goes on alike",
     "Does a copy, or one made of bytes, continue with the same bits?",
     "It does. Rewind and play again: nothing changes.", buildDrop, 2, copiesAgree},
    {kSameBits, "Foreseen", "Where will the ball be in two seconds?",
     "In the ring: a copy of the World was asked before.", buildBelief, 2,
     [](const kodo::World& world, const Ids& ids) {
         return world[ids[0]].center() == world[ids[1]].center();
     }},
    {kThesis,
     "Shock propagation off",
     "What does the solver of 2006 do to a tower with few passes?",
     "It is squeezed: overlap is seen with bare eyes. Then turn shockPasses up.",
     buildThesisTower,
     3,
     [](const kodo::World& world, const Ids&) { return deepestOverlap(world) > 0.01_r; },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     thesisWith(5, 2, 0)},
    {kThesis,
     "Shock propagation on",
     "Do two shock passes carry the tower that few passes squeeze?",
     "The same tower stands, with a fraction of the overlap.",
     buildThesisTower,
     3,
     [](const kodo::World& world, const Ids& ids) {
         return deepestOverlap(world) < 0.01_r && standsAt(world, ids.back(), {0, 11.5_r});
     },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     thesisWith(5, 2, 2)},
    {kThesis,
     "Four heights",
     "Do eight iterations leave more overlap in a higher stack?",
     "Yes: with each three boxes more it grows by half at least.",
     buildHeights,
     2,
     [](const kodo::World& world, const Ids& ids) {
         Real before = 0;
         return std::all_of(ids.begin(), ids.end(), [&](BodyId id) {
             const Real lower = std::exchange(before, overlapOfStack(world, id));
             return before > Real(1.5) * lower;
         });
     },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     thesisWith(8, 8, 0)},
    {kThesis,
     "Few iterations",
     "What do two iterations do to a pyramid?",
     "Overlap grows with its height. Turn contactPasses up.",
     buildThesisPyramid,
     2,
     [](const kodo::World& world, const Ids&) { return deepestOverlap(world) > 0.01_r; },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     thesisWith(2, 2, 0)},
    {kThesis,
     "Many iterations",
     "What do sixty iterations do to the same pyramid?",
     "Less overlap, for thirty times the visits.",
     buildThesisPyramid,
     2,
     [](const kodo::World& world, const Ids&) { return deepestOverlap(world) < 0.05_r; },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     thesisWith(40, 60, 0)},
    {kThesis,
     "Heavy on light",
     "Does shock propagation carry a box of 200 kg on five of 1 kg?",
     "Yes: each level becomes a floor for the next.",
     buildHeavyTop,
     5,
     [](const kodo::World& world, const Ids& ids) {
         return standsAt(world, ids.back(), {0, 6});
     },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     thesisWith(5, 10, 4)},
};

} // namespace

std::span<const Scene> principleScenes() {
    return kPrincipleScenes;
}

} // namespace destructoooor
