// SPDX-License-Identifier: MIT
// What bodies do depends on their own island alone: whatever is added, moved or removed elsewhere
// does not change a bit of their motion.
#include <kodo/kodo.hpp>
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

namespace kodo {
namespace {

using support::RandomNumbers;
using support::Solver;

Shape anyShape(RandomNumbers& random, Real size) {
    switch (random.below(3)) {
    case 0:
        return Circle{size};
    case 1:
        return Box{2 * size, size};
    default:
        return Polygon{{{-size, -size}, {size, -size}, {0, size}}};
    }
}

JointEnds endsAt(const World& world, BodyId a, BodyId b, Vec2 point) {
    return {a, b, toLocal(world[a].transform(), point), toLocal(world[b].transform(), point)};
}

/// A closed box of static bodies; each island has its own.
void addPit(World& world, Vec2 at, Real halfWidth) {
    for (const Real y : {Real(-0.5), Real(8.5)}) {
        world.add({.shape = Box{2 * halfWidth + 1, 1},
                   .position = at + Vec2{0, y},
                   .type = BodyType::Static});
    }
    for (const Real side : {-halfWidth, halfWidth}) {
        world.add(
            {.shape = Box{Real(0.5), 8}, .position = at + Vec2{side, 4}, .type = BodyType::Static});
    }
}

BodyId addAny(World& world, RandomNumbers& random, Vec2 at) {
    const Real bounce[] = {0, 0, Real(0.3), Real(0.9)};
    BodyDef def;
    def.shape = anyShape(random, random.between(0.15, 0.4));
    def.position = at + Vec2{random.between(-2, 2), random.between(0.5, 5)};
    def.rotation = random.rotation();
    def.velocity = random.point(2);
    def.material.restitution = bounce[random.below(4)];
    def.density = random.below(8) == 0 ? Real(40) : Real(1);
    def.material.rollingResistance = random.below(5) == 0 ? Real(0.02) : Real(0);
    return world.add(def);
}

/// The observed island: a pit with a random heap, joints, a sensor, sometimes a moving platform and
/// a crowd on one point.
std::vector<BodyId> addObserved(World& world, RandomNumbers& random) {
    const Vec2 at{};
    addPit(world, at, 3);
    std::vector<BodyId> ids;
    const std::size_t count = 4 + random.below(random.below(6) == 0 ? 90 : 14);
    for (std::size_t i = 0; i < count; ++i) {
        ids.push_back(addAny(world, random, at));
    }
    const std::size_t onOnePoint = random.below(3) == 0 ? random.below(40) : 0;
    const Shape same = anyShape(random, random.between(0.15, 0.4));
    for (std::size_t i = 0; i < onOnePoint; ++i) {
        ids.push_back(world.add({.shape = same, .position = at + Vec2{1, 3}}));
    }
    for (std::size_t i = 0; i + 1 < ids.size() && i < random.below(4); ++i) {
        const Vec2 middle = (world[ids[i]].position() + world[ids[i + 1]].position()) / 2;
        world.add(RevoluteJoint{.ends = endsAt(world, ids[i], ids[i + 1], middle)});
    }
    if (random.below(2) == 0) {
        world.add({.shape = Box{1, 1},
                   .position = at + Vec2{0, 2},
                   .type = BodyType::Static,
                   .flags = kSensor});
    }
    if (random.below(3) == 0) {
        const BodyId platform = world.add({.shape = Box{1, Real(0.2)},
                                           .position = at + Vec2{-2, Real(0.4)},
                                           .velocity = {Real(0.3), 0},
                                           .type = BodyType::Kinematic});
        ids.push_back(platform);
    }
    return ids;
}

/// What is added outside the observed island.
enum class Elsewhere {
    Heap,
    Ball,
    HeavyLoad,
    Crowd,
    Chain,
    Sleeper,
    Platform,
    Rotor,
    Fast,
    Spinner,
    kCount
};

/// Bodies of one kind in a pit of their own.
class Disturbance {
public:
    Disturbance(World& world, RandomNumbers& random, Elsewhere kind, Vec2 at)
        : world_(world), random_(random), kind_(kind), at_(at) {
        addPit(world, at, 4);
        build();
    }
    /// In every seventh step: removes, moves, accelerates or adds a body.
    void act(int step) {
        if (step % 7 == 3 && !ids_.empty()) {
            const std::size_t which = random_.below(ids_.size());
            const BodyId id = ids_[which];
            switch (random_.below(4)) {
            case 0:
                world_.remove(id);
                ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(which));
                return;
            case 1:
                return world_[id].setVelocity(random_.point(6));
            case 2:
                return world_[id].setPosition(at_ +
                                              Vec2{random_.between(-2, 2), random_.between(1, 4)});
            default:
                ids_.push_back(addAny(world_, random_, at_));
            }
        }
    }

private:
    void build() {
        const auto box = [&](Vec2 where, Real size, Real density, Real bounce = 0) {
            BodyDef def = support::boxDef(at_ + where, size, size);
            def.density = density;
            def.material.restitution = bounce;
            ids_.push_back(world_.add(def));
            return ids_.back();
        };
        switch (kind_) {
        case Elsewhere::Heap:
            for (int i = 0; i < 12; ++i) {
                ids_.push_back(addAny(world_, random_, at_));
            }
            break;
        case Elsewhere::Ball:
            ids_.push_back(world_.add({.shape = Circle{Real(0.3)},
                                       .position = at_ + Vec2{0, 2},
                                       .velocity = {7, 3},
                                       .material = {.restitution = 1}}));
            break;
        case Elsewhere::HeavyLoad:
            box({0, Real(0.5)}, 1, 1);
            box({0, Real(1.5)}, 1, 1);
            box({0, Real(2.5)}, 1, random_.below(2) == 0 ? Real(300) : Real(3000));
            break;
        case Elsewhere::Crowd:
            for (int i = 0; i < 14; ++i) {
                box({Real(0.01) * static_cast<Real>(i), 1}, Real(0.5), 1);
            }
            break;
        case Elsewhere::Chain: {
            BodyId before = world_.add({.shape = Circle{Real(0.1)},
                                        .position = at_ + Vec2{0, 6},
                                        .type = BodyType::Static});
            for (int i = 1; i < 8; ++i) {
                const Vec2 where{Real(0.4) * static_cast<Real>(i), 6};
                const BodyId link = box(where, Real(0.2), i == 7 ? Real(200) : Real(1));
                world_.add(RevoluteJoint{
                    .ends = endsAt(world_, before, link, at_ + where - Vec2{Real(0.2), 0})});
                before = link;
            }
            ids_.clear(); // act() changes none of them
            break;
        }
        case Elsewhere::Sleeper:
            for (int i = 0; i < 3; ++i) {
                box({0, Real(0.5) + static_cast<Real>(i)}, 1, 1);
            }
            break;
        case Elsewhere::Platform:
            box({0, 1}, Real(0.5), 1);
            world_.add({.shape = Box{2, Real(0.3)},
                        .position = at_ + Vec2{0, Real(0.5)},
                        .velocity = {0, Real(0.8)},
                        .type = BodyType::Kinematic});
            break;
        case Elsewhere::Rotor:
            world_.add({.shape = Box{5, Real(0.2)},
                        .position = at_ + Vec2{0, 2},
                        .angularVelocity = 3,
                        .type = BodyType::Kinematic});
            for (int i = 0; i < 5; ++i) {
                box({static_cast<Real>(i) - 2, 5}, Real(0.4), 1, Real(0.5));
            }
            break;
        case Elsewhere::Spinner: // its corners move by km in a step
            world_.add({.shape = Box{Real(0.5), Real(0.2)},
                        .position = at_ + Vec2{0, 4},
                        .angularVelocity = Real(9e6),
                        .type = BodyType::Kinematic});
            break;
        case Elsewhere::Fast:
        case Elsewhere::kCount:
            for (int i = 0; i < 6; ++i) {
                ids_.push_back(world_.add({.shape = Circle{Real(0.1)},
                                           .position = at_ + Vec2{0, 1 + static_cast<Real>(i)},
                                           .velocity = {static_cast<Real>(200 - 60 * i), 30}}));
            }
        }
    }

    World& world_;
    RandomNumbers& random_;
    Elsewhere kind_;
    Vec2 at_;
    std::vector<BodyId> ids_;
};

struct Motion {
    Vec2 position;
    Rot rotation;
    Vec2 velocity;
    Real angularVelocity;
    bool asleep;
    bool operator==(const Motion&) const = default;
};

Motion motionOf(const World& world, BodyId id) {
    const BodyView body = world[id];
    return {body.position(), body.rotation(), body.velocity(), body.angularVelocity(),
            body.isAsleep()};
}

struct Case {
    std::uint64_t seed;
    Elsewhere kind;
    bool before; // the disturbance is added before the observed bodies
    Vec2 at;     // of the disturbance
    StepSettings settings;
    bool oneFloor = false; // both stand on one static body
    bool region = false;   // one whose edge cuts the disturbance
};

std::vector<std::vector<Motion>> watch(const Case& c, bool disturbed, int steps) {
    WorldDef def{.gravity = support::kEarth, .settings = c.settings};
    World world(def);
    if (c.region) {
        world.setRegion(
            Aabb{{std::min(c.at.x, Real(-20)), -5000}, {std::max(c.at.x, Real(20)), 5000}});
    }
    if (c.oneFloor) {
        support::addFloor(world);
    }
    RandomNumbers own(c.seed);
    RandomNumbers other(c.seed + 7777);
    std::optional<Disturbance> disturbance;
    if (disturbed && c.before) {
        disturbance.emplace(world, other, c.kind, c.at);
    }
    const std::vector<BodyId> ids = addObserved(world, own);
    if (disturbed && !c.before) {
        disturbance.emplace(world, other, c.kind, c.at);
    }
    std::vector<std::vector<Motion>> all;
    for (int step = 0; step < steps; ++step) {
        if (disturbance && step > 40) {
            disturbance->act(step);
        }
        world.step(support::kDt);
        std::vector<Motion>& now = all.emplace_back();
        for (const BodyId id : ids) {
            now.push_back(motionOf(world, id));
        }
    }
    return all;
}

void expectLocal(const Case& c) {
    constexpr int kSteps = 300;
    const auto alone = watch(c, false, kSteps);
    const auto beside = watch(c, true, kSteps);
    const auto escaped = [](const Motion& motion) { return length(motion.position) > 12; };
    for (std::size_t step = 0; step < alone.size(); ++step) {
        if (std::any_of(alone[step].begin(), alone[step].end(), escaped)) {
            return; // it may reach the other pit
        }
        for (std::size_t i = 0; i < alone[step].size(); ++i) {
            ASSERT_EQ(alone[step][i], beside[step][i])
                << "seed " << c.seed << ", disturbance " << static_cast<int>(c.kind) << ", step "
                << step << ", body " << i << ", added " << (c.before ? "before" : "after")
                << ", moved by " << length(alone[step][i].position - beside[step][i].position)
                << " m";
        }
    }
}

class LocalOutcome : public ::testing::TestWithParam<std::tuple<Solver, Elsewhere>> {};

TEST_P(LocalOutcome, IsTheSameWhateverHappensElsewhere) {
    const auto [solver, kind] = GetParam();
    const Vec2 places[] = {{20, 0}, {1000, 0}, {-300, -40}};
    for (int draw = 0; draw < support::draws(20); ++draw) {
        const auto seed = static_cast<std::uint64_t>(draw);
        Case c{seed, kind, draw % 2 == 0, places[draw % 3], support::settingsOf(solver)};
        c.oneFloor = draw % 4 == 0;
        c.region = draw % 5 == 0;
        expectLocal(c);
        if (HasFatalFailure()) {
            return;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, LocalOutcome,
    ::testing::Combine(::testing::ValuesIn(support::kSolvers),
                       ::testing::Values(Elsewhere::Heap, Elsewhere::Ball, Elsewhere::HeavyLoad,
                                         Elsewhere::Crowd, Elsewhere::Chain, Elsewhere::Sleeper,
                                         Elsewhere::Platform, Elsewhere::Rotor, Elsewhere::Fast,
                                         Elsewhere::Spinner)));

} // namespace
} // namespace kodo
