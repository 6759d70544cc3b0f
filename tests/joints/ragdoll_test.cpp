// SPDX-License-Identifier: MIT
// Ragdolls of eleven boxes with limits, dropped on the ground.
#include <kodo/kodo.hpp>
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <gtest/gtest.h>
#include <joints/rig.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kodo {
namespace {

using support::RandomNumbers;

constexpr Flags kGround = 1; // user flag

struct Limb {
    Vec2 center; // m, above the soles
    Real width;
    Real height;
};

struct Hinge {
    std::size_t a; // indices of limbs
    std::size_t b;
    Vec2 point;
    Range limits; // rad
};

const Limb kLimbs[] = {
    {{0, Real(1.65)}, Real(0.2), Real(0.26)},
    {{0, Real(1.35)}, Real(0.35), Real(0.32)},
    {{0, Real(1.05)}, Real(0.3), Real(0.26)},
    {{Real(-0.25), Real(1.3)}, Real(0.1), Real(0.32)},
    {{Real(-0.25), 1}, Real(0.08), Real(0.3)},
    {{Real(0.25), Real(1.3)}, Real(0.1), Real(0.32)},
    {{Real(0.25), 1}, Real(0.08), Real(0.3)},
    {{Real(-0.1), Real(0.74)}, Real(0.14), Real(0.42)},
    {{Real(-0.1), Real(0.28)}, Real(0.12), Real(0.5)},
    {{Real(0.1), Real(0.74)}, Real(0.14), Real(0.42)},
    {{Real(0.1), Real(0.28)}, Real(0.12), Real(0.5)},
};
const Hinge kHinges[] = {
    {1, 0, {0, Real(1.52)}, {Real(-0.5), Real(0.5)}},
    {1, 2, {0, Real(1.18)}, {Real(-0.4), Real(0.4)}},
    {1, 3, {Real(-0.25), Real(1.45)}, {-1, 2}},
    {3, 4, {Real(-0.25), Real(1.15)}, {0, Real(2.2)}},
    {1, 5, {Real(0.25), Real(1.45)}, {-1, 2}},
    {5, 6, {Real(0.25), Real(1.15)}, {0, Real(2.2)}},
    {2, 7, {Real(-0.1), Real(0.94)}, {Real(-0.7), Real(1.5)}},
    {7, 8, {Real(-0.1), Real(0.53)}, {-2, 0}},
    {2, 9, {Real(0.1), Real(0.94)}, {Real(-0.7), Real(1.5)}},
    {9, 10, {Real(0.1), Real(0.53)}, {-2, 0}},
};

/// A ragdoll above a floor, the limbs of which collide with the floor alone.
class Fall {
public:
    Fall(RandomNumbers& random, Real height, const StepSettings& settings)
        : world_({.gravity = support::kEarth, .settings = settings}) {
        const BodyId floor = support::addFloor(world_);
        world_[floor].setFlags(kGround);
        const Transform place{{0, height}, random.rotation()};
        const Vec2 middle{0, Real(0.9)};
        for (const Limb& limb : kLimbs) {
            limbs_.push_back(world_.add({.shape = Box{limb.width, limb.height},
                                         .position = place * (limb.center - middle),
                                         .rotation = place.rotation,
                                         .flags = kMatchAny,
                                         .required = kGround}));
        }
        for (const Hinge& hinge : kHinges) {
            hinges_.push_back(
                world_.add(RevoluteJoint{.ends = {.a = limbs_[hinge.a],
                                                  .b = limbs_[hinge.b],
                                                  .anchorA = hinge.point - kLimbs[hinge.a].center,
                                                  .anchorB = hinge.point - kLimbs[hinge.b].center},
                                         .limits = hinge.limits}));
        }
    }
    void run(Real seconds, Real dt) {
        for (Real time = 0; time < seconds; time += dt) {
            world_.step(dt);
            measure();
        }
    }
    Real widestGap() const { return widestGap_; }
    Real overshoot() const { return overshoot_; }
    void forget() { widestGap_ = overshoot_ = 0; }

private:
    void measure() {
        for (std::size_t i = 0; i < hinges_.size(); ++i) {
            const auto joint = std::get<RevoluteJoint>(world_.joint(hinges_[i]));
            widestGap_ = std::max(widestGap_, length(joints::gapOf(world_, joint.ends)));
            const auto [a, b, point, limits] = kHinges[i];
            const Rot turned = world_[limbs_[b]].rotation();
            const Vec2 axis = unrotate(world_[limbs_[a]].rotation(), {turned.c, turned.s});
            const Real angle = std::atan2(axis.y, axis.x);
            overshoot_ = std::max({overshoot_, angle - limits.upper, limits.lower - angle});
        }
    }

    World world_;
    std::vector<BodyId> limbs_;
    std::vector<JointId> hinges_;
    Real widestGap_ = 0; // m
    Real overshoot_ = 0; // rad, beyond a limit
};

// The ground stops a limb at once, and its joints stop the others within a step or two. Of 40 falls
// each, 76 mm opened at 60 Hz and 68 mm at 120 Hz, 93 mm and 77 mm with propagation, and limits
// were exceeded by up to 0.12 rad. The medians are 33 and 25 mm; if joints passed on stops at the
// ground from 16 slops on, as others, they would be 58 and 33 mm. After three seconds no joint is
// open.
TEST(Ragdoll, LandsWithoutComingApart) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {60, 120}) {
            std::vector<Real> gaps;
            for (int draw = 0; draw < support::draws(24); ++draw) {
                SCOPED_TRACE(testing::Message() << "solver " << static_cast<int>(solver) << ", "
                                                << rate << " Hz, draw " << draw);
                const Real heights[] = {Real(1.5), 3, 5};
                RandomNumbers random(static_cast<std::uint64_t>(draw));
                Fall fall(random, heights[draw % 3], support::settingsOf(solver));
                fall.run(3, Real(1) / static_cast<Real>(rate));
                gaps.push_back(fall.widestGap());
                EXPECT_LT(fall.widestGap(), Real(0.1));
                EXPECT_LT(fall.overshoot(), Real(0.15));
                fall.forget();
                fall.run(1, Real(1) / static_cast<Real>(rate));
                EXPECT_LT(fall.widestGap(), Real(0.01));
            }
            if (solver == support::Solver::Soft && gaps.size() >= 24) { // fewer with sanitizers
                std::sort(gaps.begin(), gaps.end());
                EXPECT_LT(gaps[gaps.size() / 2], rate == 60 ? Real(0.045) : Real(0.03));
            }
        }
    }
}

} // namespace
} // namespace kodo
