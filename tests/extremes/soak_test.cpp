// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

// Under a sanitizer each of these runs has a tenth of its steps. The environment variable
// SOAK_STEPS sets the steps of all but the sleeping stack, as 1000000 for the long form.
int stepsOr(int everyday) {
    const char* const wanted = std::getenv("SOAK_STEPS");
    return wanted == nullptr ? support::draws(everyday) : std::atoi(wanted);
}

/// Compares the state at the end with soak_hashes.txt: the same bits in every build. The file has
/// all numbers of steps of everyday, under sanitizers, and of the long form. Others are printed.
void expectGoldenHash(const std::string& soak, int steps, const World& world) {
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, world.stateHash());
    const std::string key =
        soak + (support::kDouble ? " double " : " float ") + std::to_string(steps) + ' ';
    std::printf("%s%s\n", key.c_str(), text);
    std::ifstream file(KODO_SOAK_FILE);
    bool found = std::getenv("SOAK_STEPS") != nullptr && steps != 1000000;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with(key)) {
            EXPECT_EQ(line, key + text);
            found = true;
        }
    }
    EXPECT_TRUE(found) << "soak_hashes.txt has no line for this run";
}

// A sleeping stack does not change by one bit in 1e7 steps (46 hours).
TEST(Soak, ASleepingStackKeepsItsBits) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 5);
    support::run(world, 600);
    ASSERT_NE(world[boxes[4]].flags() & kAsleep, 0u);
    const World before = world;
    support::run(world, support::draws(10000000));
    for (const BodyId box : boxes) {
        EXPECT_EQ(world[box].position(), before[box].position());
        EXPECT_EQ(world[box].rotation(), before[box].rotation());
        EXPECT_EQ(world[box].velocity(), Vec2{});
    }
}

// An awake stack creeps by at most 1e-6 m in 1e5 steps. In float, positions at 5 m are rounded to
// 5e-7 m, and the boxes settle on rounded positions.
TEST(Soak, AnAwakeStackDoesNotCreep) {
    StepSettings settings;
    settings.leaveOut = Feature::Sleep;
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 5);
    support::run(world, 1000);
    std::vector<Vec2> before;
    for (const BodyId box : boxes) {
        before.push_back(world[box].position());
    }
    const int steps = stepsOr(100000);
    support::run(world, steps);
    expectGoldenHash("stack", steps, world);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(near(world[boxes[i]].position(), before[i], byPrecision(2e-5, 1e-6))) << i;
    }
}

// In 1e6 steps (4.6 hours) the spin of a rod keeps its bits, and its rotation stays a unit vector.
TEST(Soak, ASpinningRodKeepsItsSpin) {
    World world;
    BodyDef def = support::boxDef({}, 2, Real(0.1));
    def.angularVelocity = Real(7.3);
    const BodyId rod = world.add(def);
    const int steps = stepsOr(1000000);
    support::run(world, steps);
    expectGoldenHash("rod", steps, world);
    EXPECT_EQ(world[rod].angularVelocity(), Real(7.3));
    EXPECT_EQ(world[rod].position(), Vec2{});
    const Rot q = world[rod].rotation();
    EXPECT_TRUE(near(length(Vec2{q.c, q.s}), 1, 4 * support::kEpsilon));
}

// A ball without losses bounces between four walls and three pegs. It keeps its speed and stays
// inside for 1e6 steps. Each of more than 5e4 impacts rounds its speed by some epsilons, up or
// down. A bias of a tenth of an epsilon per impact would show.
TEST(Soak, ABallBetweenWallsKeepsItsSpeed) {
    World world;
    const Material bouncing = support::slippery(1);
    const auto addSolid = [&](const Shape& shape, Vec2 position) {
        world.add(
            {.shape = shape, .position = position, .material = bouncing, .type = BodyType::Static});
    };
    addSolid(Box{12, 1}, {0, 5});
    addSolid(Box{12, 1}, {0, -5});
    addSolid(Box{1, 12}, {5, 0});
    addSolid(Box{1, 12}, {-5, 0});
    for (const Vec2 place : {Vec2{0, 2}, Vec2{2, -1}, Vec2{-2, -1}}) {
        addSolid(Circle{Real(0.5)}, place);
    }
    BodyDef def = support::ballDef({}, Real(0.25), bouncing);
    def.velocity = {Real(5.1), Real(7.3)};
    const BodyId ball = world.add(def);
    const Real speed = length(def.velocity);
    std::size_t hits = 0;
    const int steps = stepsOr(1000000);
    for (int i = 0; i < steps; ++i) {
        world.step(support::kDt);
        hits += world.collisions().empty() ? 0 : 1;
        ASSERT_TRUE(std::abs(world[ball].position().x) < Real(4.5) &&
                    std::abs(world[ball].position().y) < Real(4.5))
            << "step " << i;
    }
    expectGoldenHash("ball", steps, world);
    EXPECT_GT(hits, static_cast<std::size_t>(steps / 20));
    EXPECT_TRUE(nearShare(length(world[ball].velocity()), speed, 5000 * support::kEpsilon));
}

/// A pile of twelve bodies in which the oldest one is replaced every ten steps.
class ChurningPile {
public:
    ChurningPile() : world_({.gravity = support::kEarth}) {
        support::addFloor(world_);
        for (const Real side : {Real(-1), Real(1)}) {
            world_.add(
                {.shape = Box{Real(0.5), 8}, .position = {2 * side, 4}, .type = BodyType::Static});
        }
        for (std::size_t i = 0; i < 12; ++i) {
            bodies_.push_back(addBody());
        }
    }

    void step() {
        if (++steps_ % 10 == 0) {
            world_.remove(bodies_.front());
            bodies_.erase(bodies_.begin());
            bodies_.push_back(addBody());
        }
        world_.step(support::kDt);
    }
    const World& world() const { return world_; }
    ChurningPile restored() const {
        ChurningPile other = *this;
        other.world_ = fromBytes(toBytes(world_));
        return other;
    }

private:
    BodyId addBody() {
        const Real size = random_.between(0.2, 0.4);
        const Real x = random_.between(-1, 1);
        BodyDef def = random_.below(2) == 0 ? support::ballDef({x, 6}, size)
                                            : support::boxDef({x, 6}, 2 * size, size);
        def.rotation = random_.rotation();
        return world_.add(def);
    }

    World world_;
    std::vector<BodyId> bodies_;
    support::RandomNumbers random_{5};
    int steps_ = 0;
};

// A pile with churn stays inside its walls, and its snapshot does not grow: nothing of removed
// bodies is kept. A World restored from bytes halfway has the same bits at the end.
TEST(Soak, APileWithChurnKeepsItsSize) {
    const int steps = stepsOr(5000);
    ChurningPile pile;
    std::optional<ChurningPile> restored;
    std::size_t early = 0;
    for (int step = 0; step < steps; ++step) {
        if (step == steps / 2) {
            restored = pile.restored();
        }
        pile.step();
        if (restored) {
            restored->step();
        }
        if (step % 500 == 499) {
            const std::size_t size = toBytes(pile.world()).size();
            early = step < 1000 ? std::max(early, size) : early;
            ASSERT_LT(size, 2 * early + 2000) << "step " << step;
            ASSERT_EQ(pile.world().bodyCount(), 15u);
            for (const BodyId id : pile.world().bodies()) {
                const Vec2 at = pile.world()[id].position();
                ASSERT_TRUE(std::abs(at.x) <= 2 && at.y > -1 && at.y < 20) << "step " << step;
            }
        }
    }
    EXPECT_EQ(restored->world().stateHash(), pile.world().stateHash());
    expectGoldenHash("pile", steps, pile.world());
}

} // namespace
} // namespace kodo
