// SPDX-License-Identifier: MIT
// Revolute joints of nets and other loops, which are solved in blocks of lanes.
#include <support/scenes.hpp>

#include <joints/rig.hpp>

#include <algorithm>
#include <variant>
#include <vector>

namespace kodo {
namespace {

using joints::Rig;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;

/// A disc that hangs on many parallel threads. Each thread is a ball with revolute joints to the
/// post and the disc, so any two threads close a loop.
struct Mobile : Rig {
    BodyId disc;
    std::vector<JointId> ends; // between a ball and the disc

    explicit Mobile(int threads) {
        disc = world.add(support::ballDef({0, -2}, 1));
        for (int i = 0; i < threads; ++i) {
            const BodyId ball = addBob({0, Real(-0.5)});
            world[ball].setFlags(world[ball].flags() | kDisabled);
            world.add(RevoluteJoint{.ends = {.a = post, .b = ball, .anchorB = {0, Real(0.5)}}});
            ends.push_back(world.add(RevoluteJoint{
                .ends = {.a = ball, .b = disc, .anchorA = {0, Real(-0.5)}, .anchorB = {0, 1}}}));
        }
    }
};

// F1: on a body with more joints than colours, every joint is solved. Together they hold its weight
// within 1e-3 after damping. No gap exceeds that of soft joints.
TEST(Net, ABodyMayHaveAHundredRevoluteJoints) {
    Mobile mobile(100);
    mobile.settle(600);
    Vec2 sum;
    for (const JointId end : mobile.ends) {
        sum += mobile.world.jointForce(end);
    }
    EXPECT_TRUE(nearShare(sum.y, mobile.weightOf(mobile.disc), 1e-3));
    EXPECT_TRUE(near(mobile.world[mobile.disc].position(), Vec2{0, -2}, 0.01));
}

/// A net of balls that hangs from its two upper corners.
struct Net : Rig {
    static constexpr int kSide = 8;
    std::vector<BodyId> balls;
    std::vector<JointId> corners;

    explicit Net(Vec2 gravity = support::kEarth) : Rig(gravity) {
        for (int i = 0; i < kSide * kSide; ++i) {
            const Vec2 place{static_cast<Real>(i % kSide), static_cast<Real>(-(i / kSide))};
            balls.push_back(addBob(place));
            world[balls.back()].setFlags(kNeverSleep);
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
        return world.add(RevoluteJoint{.ends = {.a = a,
                                                .b = b,
                                                .anchorA = place - world[a].position(),
                                                .anchorB = place - world[b].position()}});
    }
};

// F1: the support force of a swinging net satisfies dp/dt = F - m g in each step, to the rounding
// of p over dt.
TEST(Net, SupportForceIsItsWeightPlusItsChangeOfMomentum) {
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

/// Largest distance between the two anchors of any joint, m.
Real largestGap(const World& world) {
    Real largest = 0;
    for (const JointId id : world.joints()) {
        const JointEnds& ends = std::get<RevoluteJoint>(world.joint(id)).ends;
        const Vec2 a = world[ends.a].position() + world[ends.a].rotation() * ends.anchorA;
        const Vec2 b = world[ends.b].position() + world[ends.b].rotation() * ends.anchorB;
        largest = std::max(largest, length(b - a));
    }
    return largest;
}

// A soft joint under the force F opens by F / (m_e (2 pi f)^2), where f is at most jointHertz and a
// quarter of the substep rate: 30, 60 and 240 Hz in the profiles. The net swings, so phases differ
// between the profiles; each is at least twice as stiff as the one before.
TEST(Net, ProfilesKeepItCloserInTheirOrder) {
    std::vector<Real> gaps;
    for (const StepSettings& settings : {fast(), balanced(), accurate()}) {
        Net net;
        net.world.setSettings(settings);
        Real largest = 0;
        for (int step = 0; step < 200; ++step) {
            net.world.step(kDt);
            largest = std::max(largest, largestGap(net.world));
        }
        gaps.push_back(largest);
    }
    EXPECT_LT(gaps[1], gaps[0] / 2);
    EXPECT_LT(gaps[2], gaps[1] / 4);
    EXPECT_LT(gaps[2], Real(0.005)) << gaps[0] << ' ' << gaps[1];
}

// F1: joint impulses are internal, so a net in free space conserves momentum to the rounding of 100
// steps. Both impulses of a joint act at one point, so this holds for angular momentum, too.
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
    EXPECT_TRUE(nearShare(after.spin, before.spin, byPrecision(1e-4, 1e-6)));
    EXPECT_LE(after.kinetic, before.kinetic);
}

// F1: a joint that gains or loses a motor moves to other storage and keeps its impulse. A weak
// motor toggled in every step hardly changes the swing. A joint replaced in every step, without
// warm start, changes it by far more.
TEST(Net, AJointKeepsItsImpulseWhenItGainsOrLosesAMotor) {
    const auto lastBallAfter = [](auto change) {
        Net net;
        for (int step = 0; step < 40; ++step) {
            change(net, step);
            net.world.step(kDt);
        }
        return net.world[net.balls.back()].position();
    };
    const Vec2 left = lastBallAfter([](Net&, int) {});
    const Vec2 driven = lastBallAfter([](Net& net, int step) {
        RevoluteJoint pin = std::get<RevoluteJoint>(net.world.joint(net.corners[0]));
        pin.motorTorque = step % 2 == 0 ? Real(1e-6) : 0;
        net.world.setJoint(net.corners[0], pin);
    });
    const Vec2 forgetful = lastBallAfter([](Net& net, int) {
        const JointDef pin = net.world.joint(net.corners[0]);
        net.world.remove(net.corners[0]);
        net.corners[0] = net.world.add(pin);
    });
    EXPECT_LT(10 * length(driven - left), length(forgetful - left));
}

// F1: a ladder of hinged balls moves with the same bits alone and beside other ladders, whose
// joints share its blocks. The order of blocks within an island must not depend on other islands.
TEST(Net, MovesWithTheSameBitsBesideOtherNets) {
    const auto addLadder = [](World& world, Real x, int rungs) {
        std::vector<BodyId> balls;
        const auto tie = [&](std::size_t a, std::size_t b) {
            const Vec2 middle =
                Real(0.5) * (world[balls[a]].position() + world[balls[b]].position());
            world.add(RevoluteJoint{.ends = {.a = balls[a],
                                             .b = balls[b],
                                             .anchorA = middle - world[balls[a]].position(),
                                             .anchorB = middle - world[balls[b]].position()}});
        };
        for (std::size_t i = 0; i < static_cast<std::size_t>(2 * rungs); ++i) {
            const Vec2 place{x + static_cast<Real>(i % 2), -static_cast<Real>(i / 2)};
            balls.push_back(world.add(support::ballDef(place, Real(0.25))));
            if (i % 2 == 1) {
                tie(i - 1, i);
            }
            if (i >= 2) {
                tie(i - 2, i);
            }
        }
        world[balls[0]].applyImpulse({3, 1});
        return balls;
    };
    World alone({.gravity = support::kEarth});
    const std::vector<BodyId> first = addLadder(alone, 0, 5);
    World crowd({.gravity = support::kEarth});
    for (int k = 1; k < 6; ++k) {
        addLadder(crowd, static_cast<Real>(20 * k), k + 1);
    }
    const std::vector<BodyId> second = addLadder(crowd, 0, 5);
    for (int step = 0; step < 100; ++step) {
        alone.step(kDt);
        crowd.step(kDt);
        for (std::size_t i = 0; i < first.size(); ++i) {
            ASSERT_EQ(alone[first[i]].position(), crowd[second[i]].position()) << step;
            ASSERT_EQ(alone[first[i]].velocity(), crowd[second[i]].velocity()) << step;
        }
    }
}

} // namespace
} // namespace kodo
