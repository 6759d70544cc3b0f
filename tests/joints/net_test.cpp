// SPDX-License-Identifier: MIT
// Pins of nets and other loops, which are solved side by side.
#include <support/scenes.hpp>

#include <joints/rig.hpp>

#include <algorithm>
#include <vector>

namespace kodo {
namespace {

using joints::Rig;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;

/// A disc that hangs on many short threads side by side: each is a ball, pinned to the post and to
/// the disc, so that any two of them close a loop.
struct Mobile : Rig {
    BodyId disc;
    std::vector<JointId> ends; // between a ball and the disc

    explicit Mobile(int threads) {
        disc = world.add(support::ballDef({0, -2}, 1));
        for (int i = 0; i < threads; ++i) {
            const BodyId ball = addBob({0, Real(-0.5)});
            world[ball].setFlags(world[ball].flags() | kDisabled);
            world.add(Pin{.ends = {.a = post, .b = ball, .anchorB = {0, Real(0.5)}}});
            ends.push_back(world.add(Pin{
                .ends = {.a = ball, .b = disc, .anchorA = {0, Real(-0.5)}, .anchorB = {0, 1}}}));
        }
    }
};

// F1: of a body with more pins than there are colours each one is solved, too: together they hold
// its weight, to a thousandth once the air has taken the swing, and none gives by more than springs
// do.
TEST(Net, ABodyMayHaveAHundredPins) {
    Mobile mobile(100);
    mobile.settle(600);
    Vec2 sum;
    for (const JointId end : mobile.ends) {
        sum += mobile.world.jointForce(end);
    }
    EXPECT_TRUE(nearShare(sum.y, mobile.weightOf(mobile.disc), 1e-3));
    EXPECT_TRUE(near(mobile.world[mobile.disc].position(), Vec2{0, -2}, 0.01));
}

/// A net of balls, hung by the corners.
struct Net : Rig {
    static constexpr int kSide = 8;
    std::vector<BodyId> balls;
    std::vector<JointId> corners;

    explicit Net(Vec2 gravity = support::kEarth) : Rig(gravity) {
        for (int i = 0; i < kSide * kSide; ++i) {
            const Vec2 place{static_cast<Real>(i % kSide), static_cast<Real>(-(i / kSide))};
            balls.push_back(addBob(place));
            world[balls.back()].setFlags(kNeverRest);
            if (i % kSide > 0) {
                tie(balls[balls.size() - 2], balls.back(), place - Vec2{Real(0.5), 0});
            }
            if (i >= kSide) {
                tie(balls[balls.size() - 1 - kSide], balls.back(), place + Vec2{0, Real(0.5)});
            }
        }
        for (const int i : {0, kSide - 1}) {
            corners.push_back(tie(post, balls[static_cast<std::size_t>(i)],
                                  Vec2{static_cast<Real>(i), Real(0.5)}));
        }
    }
    JointId tie(BodyId a, BodyId b, Vec2 place) {
        return world.add(Pin{.ends = {.a = a,
                                      .b = b,
                                      .anchorA = place - world[a].position(),
                                      .anchorB = place - world[b].position()}});
    }
};

// F1: what holds a net that swings gives all of its weight and all that its momentum gains, in each
// step: dp/dt = F - m g. To the rounding of p over that of a step.
TEST(Net, IsHeldByItsWeightAndWhatItsMomentumGains) {
    Net net;
    const auto weight =
        static_cast<long double>(net.weightOf(net.balls[0]) * Net::kSide * Net::kSide);
    long double least = weight;
    for (int step = 0; step < 200; ++step) {
        const auto before = support::totalsOf(net.world).momentum;
        net.world.step(kDt);
        const auto gained = support::totalsOf(net.world).momentum - before;
        Vec2 sum;
        for (const JointId corner : net.corners) {
            sum += net.world.jointForce(corner);
        }
        const auto dt = static_cast<long double>(kDt);
        const Real most = byPrecision(0.05, 1e-9);
        ASSERT_TRUE(near(sum.x, gained.x / dt, most)) << "step " << step;
        ASSERT_TRUE(near(sum.y, gained.y / dt + weight, most)) << "step " << step;
        least = std::min(least, gained.y / dt);
    }
    EXPECT_LT(least, -weight / 2); // it does swing
}

// F1: pins act between two bodies, so a net in free space keeps its momentum, whatever it does, to
// the rounding of a hundred steps. Of its angular momentum it keeps as much as the gaps allow: the
// two ends of a spring that is drawn out are not pulled at one point.
TEST(Net, KeepsMomentumInFreeSpace) {
    Net net(Vec2{});
    for (const JointId corner : net.corners) {
        net.world.remove(corner);
    }
    net.world[net.balls[0]].applyImpulse({30, 10});
    net.world[net.balls[27]].applyImpulse({-5, 25});
    const support::Totals before = support::totalsOf(net.world);
    support::run(net.world, 100);
    const support::Totals after = support::totalsOf(net.world);
    const Real most = byPrecision(1e-2, 1e-10);
    EXPECT_TRUE(near(after.momentum.x, before.momentum.x, most));
    EXPECT_TRUE(near(after.momentum.y, before.momentum.y, most));
    EXPECT_TRUE(nearShare(after.spin, before.spin, 0.02));
    EXPECT_LE(after.kinetic, before.kinetic);
}

// F1: a pin that gets a motor, or loses it, is solved elsewhere, and goes on with what it has
// learned: while the net swings, a corner whose motor does next to nothing, in every other step,
// leaves it as it is without. One that has to learn anew each time is off by far more.
TEST(Net, APinMayChangeItsKind) {
    const auto swing = [](auto change) {
        Net net;
        for (int step = 0; step < 40; ++step) {
            change(net, step);
            net.world.step(kDt);
        }
        return net.world[net.balls.back()].position();
    };
    const Vec2 left = swing([](Net&, int) {});
    const Vec2 driven = swing([](Net& net, int step) {
        Pin pin = std::get<Pin>(net.world.joint(net.corners[0]));
        pin.motorTorque = step % 2 == 0 ? Real(1e-6) : 0;
        net.world.setJoint(net.corners[0], pin);
    });
    const Vec2 forgetful = swing([](Net& net, int) {
        const JointDef pin = net.world.joint(net.corners[0]);
        net.world.remove(net.corners[0]);
        net.corners[0] = net.world.add(pin);
    });
    EXPECT_LT(10 * length(driven - left), length(forgetful - left));
}

} // namespace
} // namespace kodo
