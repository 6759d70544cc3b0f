// SPDX-License-Identifier: MIT
#include "parts.hpp"

namespace destructoooor {

namespace {

constexpr std::string_view kStacking = "Stacking";
constexpr std::string_view kMassRatio = "Mass ratio";

Ids addTower(kodo::World& world, int count, Real x = 0) {
    Ids boxes;
    for (int i = 0; i < count; ++i) {
        boxes.push_back(addBox(world, {x, Real(i) + 0.5_r}, 1, 1));
    }
    return boxes;
}

Ids buildTower(kodo::World& world) {
    addGround(world);
    return addTower(world, 12);
}

bool towerStands(const kodo::World& world, const Ids& ids) {
    const Vec2 top = world[ids.back()].center();
    return isNear(top, {0, Real(ids.size()) - 0.5_r}, 0.05_r);
}

Ids buildPyramid(kodo::World& world) {
    addGround(world);
    constexpr int kRows = 16;
    Ids ids;
    for (int row = 0; row < kRows; ++row) {
        for (int i = 0; i < kRows - row; ++i) {
            const Real x = Real(i) - Real(kRows - 1 - row) / 2;
            ids.push_back(addBox(world, {x * 0.85_r, 0.4_r + 0.8_r * Real(row)}, 0.8_r, 0.8_r));
        }
    }
    return ids;
}

Ids buildWall(kodo::World& world) {
    addGround(world);
    Ids ids;
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 7 - row % 2; ++i) {
            const Real x = 2 * Real(i) - 6 + Real(row % 2);
            ids.push_back(addBox(world, {x, 0.4_r + 0.8_r * Real(row)}, 1.96_r, 0.8_r));
        }
    }
    return ids;
}

Ids buildOverhang(kodo::World& world) {
    addGround(world);
    addBox(world, {-3, 2.5_r}, 4, 5, {.type = kodo::BodyType::Static});
    // The n-th brick from the top overhangs the next one by 1 / 2n of its length; 96 % of it here.
    constexpr int kBricks = 6;
    constexpr Real kLength = 4;
    Ids ids;
    Real x = -1 - kLength / 2;
    for (int i = kBricks; i >= 1; --i) {
        x += 0.96_r * kLength / Real(2 * i);
        ids.push_back(addBox(world, {x, 5.3_r + 0.6_r * Real(kBricks - i)}, kLength, 0.6_r));
    }
    return ids;
}

Ids buildArch(kodo::World& world) {
    addGround(world);
    constexpr int kStones = 11;
    constexpr Real kInner = 4;
    constexpr Real kOuter = 5.4_r;
    Ids ids;
    for (int i = 0; i < kStones; ++i) {
        const auto at = [](int edge, Real radius) {
            const Real angle = Real(edge) * 3.14159265_r / Real(kStones);
            return radius * Vec2{std::cos(angle), std::sin(angle)};
        };
        const std::array<Vec2, 4> corners = {at(i, kInner), at(i, kOuter), at(i + 1, kOuter),
                                             at(i + 1, kInner)};
        const auto stone = kodo::convexHull(corners);
        ids.push_back(world.add({.shape = std::get<kodo::Polygon>(stone)}));
    }
    return ids;
}

bool arrivedNowhere(const kodo::World& world, const Ids& ids) {
    return std::all_of(ids.begin(), ids.end(), [&](BodyId id) {
        return isNear(world[id].position(), {}, 0.1_r) &&
               kodo::length(world[id].velocity()) < 0.05_r;
    });
}

Ids buildBalance(kodo::World& world) {
    addGround(world);
    world.add({.shape = kodo::Polygon{{{-0.8_r, 0}, {0.8_r, 0}, {0, 2}}},
               .type = kodo::BodyType::Static});
    const BodyId plank = addBox(world, {0, 2.15_r}, 12, 0.3_r);
    addBox(world, {-5, 2.8_r}, 1, 1);
    addBox(world, {2.5_r, 3.3_r}, 1, 2); // twice the mass at half the arm
    pin(world, addBox(world, {0, 1.9_r}, 0.2_r, 0.2_r, {.type = kodo::BodyType::Static}), plank,
        {0, 2});
    return {plank};
}

Ids buildPit(kodo::World& world) {
    addGround(world);
    addWall(world, {6, 0}, {6, 12});
    addWall(world, {-6, 12}, {-6, 0});
    addMixed(world, 90, 9);
    return {};
}

/// A heavy box on ten light ones.
template <int kRatio>
Ids buildHeavyOnLight(kodo::World& world) {
    addGround(world);
    Ids ids = addTower(world, 10);
    ids.push_back(addBox(world, {0, 10.5_r}, 1, 1, {.density = kRatio}));
    return ids;
}

Ids buildHeavyLands(kodo::World& world) {
    addGround(world);
    Ids ids;
    for (int i = 0; i < 5; ++i) {
        ids.push_back(addBox(world, {Real(i) * 1.5_r - 3, 0.5_r}, 1, 1));
    }
    ids.push_back(addBox(world, {0, 6}, 9, 1, {.density = 20}));
    return ids;
}

Ids buildPress(kodo::World& world) {
    addGround(world);
    const BodyId egg = addBall(world, {0, 0.5_r}, 0.5_r, {.density = 1});
    addWall(world, {2, 0}, {2, 6});
    addWall(world, {-2, 6}, {-2, 0});
    addBox(world, {0, 2}, 3.9_r, 2, {.density = 25});
    return {egg};
}

const Scene kStackingScenes[] = {
    {kStacking, "Tower", "Does a tower of twelve boxes stand?",
     "It stands; the top box moves less than 5 cm.", buildTower, 10, towerStands},
    {kStacking, "Pyramid", "Do 136 boxes in sixteen rows stay as they were put?",
     "The top box stays where it is, and all fall asleep.", buildPyramid, 10,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids.back()].center(), {0, 12.4_r}, 0.05_r) &&
                world[ids.back()].isAsleep();
     }},
    {kStacking, "Wall", "Does a wall of 65 bricks stand with a running bond?",
     "It stands. Throw a ball at it.", buildWall, 10,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids.back()].center().y, 7.6_r, 0.05_r);
     }},
    {kStacking, "Overhang", "How far can bricks lean out over an edge?",
     "1/2 + 1/4 + 1/6 + ... of a length: the top brick hangs over by more than its length.",
     buildOverhang, 10,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids.back()].center().y, 8.3_r, 0.05_r);
     }},
    {kStacking, "Arch", "Does an arch of eleven stones carry itself, without mortar?",
     "It stands by friction alone. Take out the keystone.", buildArch, 10, arrivedNowhere},
    {kStacking, "Balance", "Does half the weight at twice the arm balance?",
     "The plank stays level.", buildBalance, 6,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].rotation().s, 0, 0.03_r);
     }},
    {kStacking, "Pit", "Do ninety bodies of three shapes come to rest?",
     "Nothing leaves the pit, and overlap stays below a centimetre.", buildPit, 12,
     [](const kodo::World& world, const Ids&) {
         return allWithin(world, {{-6, 0}, {6, 14}}) && deepestOverlap(world) < 0.01_r;
     }},
    {kMassRatio, "Hundredfold on ten", "Does a box of 100 kg rest on ten of 1 kg?",
     "The tower stands as if all were equal.", buildHeavyOnLight<100>, 10, towerStands},
    {kMassRatio, "Thousandfold on ten", "Does a box of 1,000 kg rest on ten of 1 kg?",
     "It stands too. Try the profile 'fast': there it sinks.", buildHeavyOnLight<1000>, 10,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids.back()].center(), {0, 10.5_r}, 0.3_r);
     }},
    {kMassRatio, "A beam lands on five", "What happens when 180 kg land on five boxes of 1 kg?",
     "The boxes hold; the beam comes to rest on them.", buildHeavyLands, 8,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids.back()].center().y, 1.5_r, 0.1_r);
     }},
    {kMassRatio, "Press", "Is a ball squeezed out from under 250 times its mass?", "It holds.",
     buildPress, 6,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].center(), {0, 0.5_r}, 1.6_r) &&
                world[ids[0]].center().y > 0.45_r;
     }},
};

} // namespace

std::span<const Scene> stackingScenes() {
    return kStackingScenes;
}

} // namespace destructoooor
