// SPDX-License-Identifier: MIT
// A8: overlaps are pushed apart without a velocity that stays.
#include <kodo/world.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <cmath>

namespace kodo {
namespace {

struct Pair {
    Shape first;
    Shape second;
    BodyType type; // of the first
    Real aside;    // m, of the second, across the overlap
    Real friction;
};

std::vector<Pair> pairs() {
    const Polygon house{{{Real(-0.5), Real(-0.5)},
                         {Real(0.5), Real(-0.5)},
                         {Real(0.5), Real(0.5)},
                         {0, Real(0.9)},
                         {Real(-0.5), Real(0.5)}}};
    std::vector<Pair> all;
    for (const BodyType type : {BodyType::Static, BodyType::Dynamic}) {
        for (const Real friction : {Real(0), Real(0.6)}) {
            all.push_back({Box{1, 1}, Box{1, 1}, type, 0, friction});
            all.push_back({Box{1, 1}, Box{1, Real(0.5)}, type, 0, friction});
            all.push_back({Box{1, 1}, house, type, 0, friction});
            all.push_back({Circle{Real(0.5)}, Circle{Real(0.5)}, type, 0, friction});
            all.push_back({Circle{Real(0.5)}, Box{1, 1}, type, 0, friction});
        }
        all.push_back({Box{1, 1}, Box{1, 1}, BodyType::Static, Real(0.1), 0});
        all.push_back({Box{1, 1}, Box{1, 1}, BodyType::Static, Real(0.4), 0});
    }
    return all;
}

// Right after parting, the pair is at rest. The limit is 1 mm/s, of a push of up to 3 m/s. Boxes
// whose contact is beside their centres turn while they part, and stand still afterwards too.
TEST(Parting, LeavesNoVelocity) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 120, 240}) {
            for (const Real depth : {Real(0.01), Real(0.03), Real(0.1), Real(0.2), Real(0.3)}) {
                int number = 0;
                for (const Pair& pair : pairs()) {
                    World world({.settings = support::settingsOf(solver)});
                    const Material material = withFriction(pair.friction);
                    world.add({.shape = pair.first, .material = material, .type = pair.type});
                    const BodyId body = world.add({.shape = pair.second,
                                                   .position = {1 - depth, pair.aside},
                                                   .material = material});
                    support::run(world, 5 * rate, Real(1) / static_cast<Real>(rate));
                    const auto what = testing::Message()
                                      << "solver " << static_cast<int>(solver) << ", rate " << rate
                                      << ", depth " << depth << ", pair " << number;
                    EXPECT_LT(length(world[body].velocity()), Real(1e-3)) << what;
                    EXPECT_LT(std::abs(world[body].angularVelocity()), Real(2e-3)) << what;
                    ++number;
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
