// SPDX-License-Identifier: MIT
// Resting (5.2) and the body slightly off its balance (fig. 5.3).
#include <kodo/step_stats.hpp>
#include <support/scenes.hpp>
#include <support/tipping.hpp>

#include <cmath>

#include "experiment.hpp"

namespace thesis {

namespace {

using kodo::BodyId;
using kodo::Real;
using kodo::Rot;
using kodo::Vec2;
using kodo::World;
using support::kDt;
using support::kEarth;

constexpr double kWidth = 0.4; // m, of the tipping box
constexpr double kHeight = 2;  // m

/// 1/s^2, of the box that turns about its corner, with I = m r^2 / 3; see support::fallTime().
double tippingRate() {
    const double square = (kWidth * kWidth + kHeight * kHeight) / 4; // r^2
    return 10 * std::sqrt(square) / (4 * square / 3);
}

struct Tipping {
    double time = 0;    // s, to kFallen
    bool early = false; // it slept before it lay
    bool lies = false;
    std::string svg{};
};

Tipping tip(const kodo::StepSettings& settings, double off) {
    World world({.gravity = kEarth, .settings = settings});
    support::addFloor(world, kodo::withFriction(2));
    const double balance = std::atan2(kWidth, kHeight);
    kodo::BodyDef def = support::boxDef({}, static_cast<Real>(kWidth), static_cast<Real>(kHeight),
                                        kodo::withFriction(2));
    def.rotation = Rot::fromAngle(static_cast<Real>(balance + off));
    const Vec2 corner =
        def.rotation * Vec2{static_cast<Real>(-kWidth / 2), static_cast<Real>(-kHeight / 2)};
    def.position = {3, -corner.y};
    const BodyId box = world.add(def);
    Tipping result;
    for (int step = 1; step <= 600; ++step) {
        world.step(kDt);
        const double turned = std::atan2(static_cast<double>(world[box].rotation().s),
                                         static_cast<double>(world[box].rotation().c)) -
                              balance;
        if (result.time == 0 && turned > support::kFallen) {
            result.time = step / 60.0;
        }
        const bool upright = world[box].rotation().c > Real(0.1);
        result.early = result.early || (world[box].isAsleep() && upright);
        if (step == 45) {
            result.svg = kodo::svg(world, {.contacts = true}, kodo::Aabb{{0, -1}, {5, 3}});
        }
    }
    result.lies = std::fabs(world[box].rotation().c) < Real(0.01) && world[box].isAsleep();
    return result;
}

void addTipping(std::vector<Experiment>& book) {
    Experiment one{"tipping"};
    for (const Profile& profile : profiles()) {
        kodo::StepSettings settings = profile.settings;
        settings.leaveOut = {};
        for (const double off : {0.03, 0.01, 1e-3, 3e-4}) {
            const Tipping tipping = tip(settings, off);
            char angle[16];
            std::snprintf(angle, sizeof angle, "%g", off);
            const std::string by = std::string("off its balance by ") + angle + " rad: ";
            one.add(by + "sleeps before it lies", profile.name, tipping.early ? 1 : 0)
                .atMost(0, "0: no; it moves, however slowly");
            one.add(by + "lies flat and sleeps in the end", profile.name, tipping.lies ? 1 : 0)
                .near(1, 0, "1: yes");
            const double exact = support::fallTime(off, tippingRate());
            one.add(by + "time until it is half a radian off", profile.name, tipping.time, "s")
                .near(exact, 0.03 * exact + 1.0 / 60,
                      "a pendulum upside down about the corner; 3 % and a step");
            if (off > 0.02) {
                one.pictures.push_back({std::string(profile.name) + ", after 0.75 s", tipping.svg});
            }
        }
    }
    book.push_back(one);
}

void addResting(std::vector<Experiment>& book, Extent extent) {
    Experiment one{"resting"};
    for (const Profile& profile : profiles()) {
        kodo::StepSettings settings = profile.settings;
        settings.leaveOut = {};
        World world({.gravity = kEarth, .settings = settings});
        support::addFloor(world);
        const int piles = extent.of(200, 20);
        std::vector<BodyId> lowest;
        for (int i = 0; i < piles; ++i) {
            lowest.push_back(support::addStack(world, 5, Real(3 * i) - 300).front());
        }
        world.step(kDt);
        const auto awake = static_cast<double>(kodo::stepStats(world).bodies);
        support::run(world, 180);
        one.add("bodies worked on in a step, of " + std::to_string(5 * piles) + " in stacks",
                std::string(profile.name) + ", first step", awake)
            .near(5.0 * piles, 0, "all");
        one.add("bodies worked on in a step after 3 s", profile.name,
                static_cast<double>(kodo::stepStats(world).bodies))
            .atMost(0, "a step leaves sleeping bodies out");
        world.remove(lowest.front());
        world.step(kDt);
        one.add("awake after the lowest box of one stack is taken", profile.name,
                static_cast<double>(kodo::stepStats(world).bodies))
            .near(4, 0, "what leaned on it, and no other stack");
    }
    book.push_back(one);
}

} // namespace

void addRest(std::vector<Experiment>& book, Extent extent) {
    addResting(book, extent);
    addTipping(book);
}

} // namespace thesis
