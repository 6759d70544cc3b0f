// SPDX-License-Identifier: MIT
// Response: a compound over a wall (fig. 4.3), the impulse (fig. 4.7), friction (4.3.3), separation
// (fig. 4.8).
#include <support/depth.hpp>
#include <support/scenes.hpp>

#include <cmath>

#include "experiment.hpp"

namespace thesis {

namespace {

using kodo::BodyId;
using kodo::Box;
using kodo::Real;
using kodo::Vec2;
using kodo::World;
using support::kDt;
using support::kEarth;

void addFork(std::vector<Experiment>& book) {
    Experiment one{"fork"};
    for (const Profile& profile : profiles()) {
        kodo::StepSettings settings = profile.settings;
        settings.leaveOut = {};
        World world({.gravity = kEarth, .settings = settings});
        world.add(
            {.shape = Box{Real(0.96), 4}, .position = {0, -2}, .type = kodo::BodyType::Static});
        const kodo::Compound shape{{Box{2, Real(0.5), {0, Real(0.25)}},
                                    Box{Real(0.5), 2, {Real(-0.75), -1}},
                                    Box{Real(0.5), 2, {Real(0.75), -1}}}};
        const BodyId fork = world.add({.shape = shape,
                                       .position = {0, Real(0.5)},
                                       .velocity = {Real(0.5), 0},
                                       .material = kodo::withFriction(Real(0.3))});
        support::run(world, 300);
        one.add("the fork sleeps after 5 s", profile.name, world[fork].isAsleep() ? 1 : 0)
            .near(1, 0, "1: yes; opposite normals are two manifolds, not one average");
        one.add("its height above the wall", profile.name,
                static_cast<double>(world[fork].position().y), "m")
            .near(0, 0.01, "two slops of 4 mm, and rounding");
        one.add("its tilt", profile.name, static_cast<double>(world[fork].rotation().s), "rad")
            .near(0, 0.02, "the gaps of 2 cm beside the wall let it turn by 0.02");
        if (one.pictures.empty()) {
            one.pictures.push_back(
                {std::string("The fork, ") + profile.name + ", after 5 s",
                 kodo::svg(world, {.contacts = true}, kodo::Aabb{{-2, -3}, {2, 1}})});
        }
    }
    book.push_back(one);
}

void addImpulse(std::vector<Experiment>& book) {
    Experiment one{"impulse"};
    for (const Profile& profile : profiles()) {
        for (const Real e : {Real(0), Real(0.5), Real(1)}) {
            World world({.settings = profile.settings});
            const Real arm = Real(1.25);
            const BodyId rod =
                world.add({.shape = Box{4, Real(0.5)}, .material = support::slippery(e)});
            kodo::BodyDef def = support::ballDef({arm, -1}, Real(0.25), support::slippery(1));
            def.velocity = {0, 3};
            const BodyId ball = world.add(def);
            const auto a = static_cast<double>(world[ball].mass());
            const auto m = static_cast<double>(world[rod].mass());
            const auto inertia = static_cast<double>(world[rod].inertia());
            const double exact =
                (1 + static_cast<double>(e)) * 3 / (1 / a + 1 / m + 1.25 * 1.25 / inertia);
            double told = 0;
            for (int i = 0; i < 60; ++i) {
                world.step(kDt);
                for (const kodo::CollisionRecord& record : world.collisions()) {
                    told = std::max(told, static_cast<double>(record.totalImpulse));
                }
            }
            const std::string with = "e = " + std::to_string(e).substr(0, 3) + " and 1";
            one.add("impulse of the record, " + with, profile.name, told, "N s")
                .near(exact, 2e-3 * exact, "eq. 4.9 with the smaller e; 0.2 % for float and h w");
            one.add("spin of the rod, " + with, profile.name,
                    static_cast<double>(world[rod].angularVelocity()), "rad/s")
                .near(exact * 1.25 / inertia, 5e-3 * exact * 1.25 / inertia, "J r / I");
            if (one.pictures.size() < 2 && e > Real(0.9)) {
                one.pictures.push_back({std::string(profile.name) + ", e = 1, after 1 s",
                                        kodo::svg(world, {.velocities = true})});
            }
        }
    }
    book.push_back(one);
}

/// m, way of a box that starts at 5 m/s on a floor with friction 0.5.
double slide(const kodo::StepSettings& settings, Real restitution) {
    World world({.gravity = {0, -10}, .settings = settings});
    const kodo::Material material = kodo::withFriction(Real(0.5), restitution);
    support::addFloor(world, material);
    const BodyId box = world.add({.shape = Box{2, Real(0.5)},
                                  .position = {0, Real(0.25)},
                                  .velocity = {5, 0},
                                  .material = material});
    support::run(world, 120);
    return static_cast<double>(world[box].position().x);
}

void addFriction(std::vector<Experiment>& book) {
    Experiment one{"friction"};
    const double exact = 25 / (2 * 0.5 * 10);
    const std::string law = "v^2 / (2 mu g), less or more by half the way of a step and 1 %";
    const double tolerance = 5.0 / 120 + 0.01 * exact;
    for (const Real restitution : {Real(0), Real(0.8)}) {
        const std::string what =
            std::string("slide of a box, restitution ") + (restitution > 0 ? "0.8" : "0");
        for (const int count : {4, 10, 40}) {
            one.add(what, "thesis2006(), " + std::to_string(count) + " passes",
                    slide(passes(count, count, 4), restitution), "m")
                .near(exact, tolerance, law);
        }
        one.add(what, "balanced()", slide(profiles()[1].settings, restitution), "m")
            .near(exact, tolerance, law);
    }
    for (const Profile& profile : profiles()) {
        World world({.gravity = {0, -10}, .settings = profile.settings});
        kodo::Material material = kodo::withFriction(1);
        material.rollingResistance = Real(0.05);
        support::addFloor(world, material);
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.5)},
                                       .position = {0, Real(0.5)},
                                       .velocity = {2, 0},
                                       .angularVelocity = -4,
                                       .material = material});
        support::run(world, 600);
        one.add("speed of a rolling ball after 10 s", profile.name,
                static_cast<double>(length(world[ball].velocity())), "m/s")
            .atMost(1e-3, "rolling resistance halts it");
    }
    book.push_back(one);
}

void addSeparation(std::vector<Experiment>& book) {
    Experiment one{"separation"};
    for (const Profile& profile : profiles()) {
        for (const bool locked : {false, true}) {
            World world({.settings = profile.settings});
            const BodyId left = world.add({.shape = Box{1, 1}, .position = {Real(-0.4), 0}});
            const BodyId right =
                world.add({.shape = Box{1, 1},
                           .position = {Real(0.4), 0},
                           .flags = locked ? kodo::kLockMove | kodo::kLockRotate : 0});
            double energy = 0;
            for (int i = 0; i < 120; ++i) {
                world.step(kDt);
            }
            for (const BodyId id : {left, right}) {
                energy += 0.5 * static_cast<double>(world[id].mass()) *
                          static_cast<double>(lengthSquared(world[id].velocity()));
            }
            const std::string pair = locked ? ", one locked" : "";
            const auto slop = static_cast<double>(world.tolerances().slop);
            one.add("overlap left of 20 cm" + pair, profile.name,
                    static_cast<double>(support::maxOverlap(world)), "m")
                .near(slop / 2, slop,
                      "some overlap stays, so that the contact is found again: "
                      "up to 1.5 slops of 3.9 mm");
            one.add("energy after the separation" + pair, profile.name, energy, "J")
                .atMost(1e-4, "separation gives way, not speed");
            if (locked) {
                one.add("way of the locked body", profile.name,
                        std::fabs(static_cast<double>(world[right].position().x) - 0.4), "m")
                    .atMost(1e-6, "LOCK_MOVE: only the other one moves");
            } else {
                one.add("difference of their ways", profile.name,
                        std::fabs(static_cast<double>(world[right].position().x +
                                                      world[left].position().x)),
                        "m")
                    .atMost(1e-5, "equal masses move alike");
            }
        }
    }
    book.push_back(one);
}

} // namespace

void addCollisions(std::vector<Experiment>& book, Extent) {
    addFork(book);
    addImpulse(book);
    addFriction(book);
    addSeparation(book);
}

} // namespace thesis
