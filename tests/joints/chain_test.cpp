// SPDX-License-Identifier: MIT
#include <joints/rig.hpp>

#include <algorithm>

namespace kodo {
namespace {

using joints::Rig;
using support::boxDef;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

/// Planks of 0.5 m that are pinned end to end from the post, in a straight line.
struct Row : Rig {
    std::vector<BodyId> planks;
    std::vector<JointId> pins;

    Row(int count, Vec2 direction) {
        BodyId last = post;
        Vec2 anchor{};
        for (int i = 0; i < count; ++i) {
            BodyDef def = boxDef({}, Real(0.5), Real(0.125));
            def.rotation = {direction.x, direction.y};
            def.position = (static_cast<Real>(i) / 2 + Real(0.25)) * direction;
            const BodyId plank = world.add(def);
            pins.push_back(world.add(Pin{
                .ends = {.a = last, .b = plank, .anchorA = anchor, .anchorB = {Real(-0.25), 0}}}));
            planks.push_back(plank);
            last = plank;
            anchor = {Real(0.25), 0};
        }
    }
    /// The widest gap of all joints now.
    Real widestGap() const {
        Real widest = 0;
        for (const JointId id : pins) {
            widest =
                std::max(widest, length(joints::gapOf(world, std::get<Pin>(world.joint(id)).ends)));
        }
        return widest;
    }
};

// F1: a chain of 100 hangs still. A pin of 60 Hz gives by its load over its stiffness, and the
// topmost carries a hundred planks; all in all the 50 m become longer by less than 1 %.
TEST(Chain, OfAHundredHangsStraight) {
    Row chain(100, {0, -1});
    run(chain.world, 600);
    const double weight = 100 * chain.weightOf(chain.planks[0]);
    EXPECT_TRUE(nearShare(chain.world.jointForce(chain.pins[0]).y, weight, 0.01));
    const Vec2 end = joints::placeOf(chain.world, chain.planks.back(), {Real(0.25), 0});
    EXPECT_TRUE(near(end.x, 0, Real(1e-3)));
    EXPECT_LE(end.y, Real(-50) + Real(0.01));
    EXPECT_GT(end.y, Real(-50) * Real(1.01));
}

// F1: let go from level, a chain of 100 swings down and whips, and no joint is ever torn.
TEST(Chain, OfAHundredSwings) {
    Row chain(100, {1, 0});
    const double weight = chain.weightOf(chain.planks[0]);
    const auto energy = [&] {
        double sum = static_cast<double>(support::totalsOf(chain.world).kinetic);
        for (const BodyId id : chain.planks) {
            sum += weight * static_cast<double>(chain.world[id].center().y);
        }
        return sum;
    };
    const double drop = weight * 100 * 25; // J, to hang straight
    Real widest = 0;
    for (int step = 0; step < 900; ++step) {
        chain.world.step(kDt);
        widest = std::max(widest, chain.widestGap());
        ASSERT_LT(energy(), 0.02 * drop) << "step " << step; // gains nothing
    }
    EXPECT_LT(widest, Real(0.1));
}

/// A bridge of 20 planks between two posts 10 m apart, with a load on its middle.
struct Bridge : Row {
    BodyId far;
    JointId last;
    BodyId load;

    explicit Bridge(Real density) : Row(20, {1, 0}) {
        far = world.add({.shape = Box{1, 1}, .position = {10, 0}, .flags = kLocked | kDisabled});
        last = world.add(Pin{.ends = {.a = planks.back(), .b = far, .anchorA = {Real(0.25), 0}}});
        BodyDef def = boxDef({5, Real(0.6)}, 1, 1);
        def.density = density;
        load = world.add(def);
    }
};

// F1: a bridge carries a load of up to 16 times the mass of a plank. Its ends hold planks and load
// together, each half of it; the load lies on it, and no joint is torn.
TEST(Chain, ABridgeCarriesItsLoad) {
    for (const Real density : {Real(0.125), Real(1)}) {
        Bridge bridge(density);
        run(bridge.world, 1800);
        const double weight = 20 * bridge.weightOf(bridge.planks[0]) + bridge.weightOf(bridge.load);
        const Vec2 left = bridge.world.jointForce(bridge.pins[0]);
        const Vec2 right = -bridge.world.jointForce(bridge.last);
        EXPECT_TRUE(nearShare(left.y + right.y, weight, 0.01)) << density;
        EXPECT_TRUE(nearShare(left.y, weight / 2, 0.05)) << density;
        EXPECT_TRUE(near(left.x + right.x, 0, weight * 0.01)) << density; // they pull alike
        EXPECT_LT(bridge.widestGap(), Real(0.01)) << density;
        EXPECT_TRUE(near(bridge.world[bridge.load].position().x, 5, Real(0.2)));
        EXPECT_LT(length(bridge.world[bridge.load].velocity()), Real(0.01));
        EXPECT_GT(bridge.world[bridge.load].position().y, -2);
    }
}

} // namespace
} // namespace kodo
