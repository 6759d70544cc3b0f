// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <cstdlib>
#include <new>

namespace {

std::size_t allocations = 0; // one thread only

void* allocate(std::size_t size) {
    ++allocations;
    void* memory = std::malloc(size);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

} // namespace

// The forms that the library's others call.
void* operator new(std::size_t size) {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace kodo {
namespace {

/// A heap in a bin that a platform stirs, a bridge of pins and one joint of each other kind, in
/// wind and water, under an attractor.
struct Scene {
    World world;
    BodyId platform;
    std::vector<BodyId> loose;

    explicit Scene(const StepSettings& settings)
        : world({.gravity = support::kEarth, .settings = settings}) {
        support::addHeap(world, 21, 60);
        for (const BodyId id : world.bodies()) {
            if ((world[id].flags() & kLocked) == 0) {
                loose.push_back(id);
            }
        }
        platform =
            world.add({.shape = Box{2, Real(0.2)}, .position = {0, Real(0.2)}, .flags = kLocked});
        addBridge();
        addOneOfEachJoint();
        addFields();
    }

    void addBridge() {
        BodyId last =
            world.add({.shape = Circle{Real(0.1)}, .position = {-4, 20}, .flags = kLocked});
        for (int i = 0; i < 8; ++i) {
            const BodyId link =
                world.add(support::boxDef({static_cast<Real>(i) - Real(3.5), 20}, 1, Real(0.2)));
            world.add(Pin{.ends = {last, link, {i == 0 ? Real(0) : Real(0.5), 0}, {Real(-0.5), 0}},
                          .limits = Range{-1, 1}});
            last = link;
        }
        world.add(Mouse{.body = last, .target = {4, 20}, .force = 500});
    }

    void addOneOfEachJoint() {
        const auto pair = [&](Real x) {
            const BodyId a = world.add({.shape = Box{1, 1}, .position = {x, 25}, .flags = kLocked});
            const BodyId b = world.add(support::boxDef({x, 23}, 1, 1));
            return JointEnds{a, b, {0, -1}, {0, 1}};
        };
        world.add(Weld{.ends = pair(0)});
        world.add(Spring{.ends = pair(3), .hertz = 2, .damping = Real(0.1), .limits = Range{0, 3}});
        world.add(
            Slider{.ends = pair(6), .limits = Range{-1, 1}, .motorSpeed = 1, .motorForce = 9});
        world.add(Motor{.ends = pair(9), .force = 100, .torque = 10});
        world.add(Pin{.ends = pair(12), .motorSpeed = 2, .motorTorque = 100});
    }

    void addFields() {
        world.addField({std::make_shared<Drag>(DragLaw{Real(0.1), Real(0.1)}), {}});
        world.addField({std::make_shared<Buoyancy>(Buoyancy::Fluid{Real(0.3), Real(0.1)},
                                                   Vec2{0, 1}, support::kEarth),
                        {}});
        world.addField(
            {std::make_shared<Attractor>(Attractor::Law::InverseSquare, Vec2{0, 3}, Real(0.1), 1),
             {}});
    }

    /// Steps while the platform goes up and down, faster or slower.
    void stir(int steps, Real height) {
        for (int i = 0; i < steps; ++i) {
            const int phase = i % 60;
            const Real share = static_cast<Real>(phase < 30 ? phase : 60 - phase) / 30;
            world[platform].moveTo({0, Real(0.2) + height * share}, support::kDt);
            world.step(support::kDt);
        }
    }
};

StepSettings settingsOf(Strategy strategy, bool rests) {
    StepSettings settings;
    if (strategy == Strategy::Propagation) {
        settings = thesis2006();
        settings.shockPasses = 2;
    }
    settings.leaveOut = rests ? std::uint8_t{0} : static_cast<std::uint8_t>(Feature::Resting);
    return settings;
}

constexpr Strategy kStrategies[] = {Strategy::SoftStep, Strategy::Propagation};

TEST(Allocation, TheCounterCounts) {
    const std::size_t before = allocations;
    ::operator delete(::operator new(8));
    EXPECT_EQ(allocations, before + 1);
}

// After a warm-up that was wilder than what follows, no step allocates: with contacts that come and
// go, every joint, fields, records, sweeps.
TEST(Allocation, AStepOfAStirredPileAllocatesNothing) {
    for (const Strategy strategy : kStrategies) {
        SCOPED_TRACE(static_cast<int>(strategy));
        Scene scene(settingsOf(strategy, false));
        scene.stir(1500, 3);
        scene.stir(1800, Real(0.5)); // calmer, but more of it touches
        const std::size_t before = allocations;
        scene.stir(300, Real(0.5));
        EXPECT_EQ(allocations, before);
        EXPECT_GT(scene.world.collisions().size(), 50u);
    }
}

// Nor does one of a pile that rests, with the platform still, and the joints at work.
TEST(Allocation, AStepOfARestingPileAllocatesNothing) {
    for (const Strategy strategy : kStrategies) {
        SCOPED_TRACE(static_cast<int>(strategy));
        Scene scene(settingsOf(strategy, true));
        scene.stir(300, 1);
        scene.world[scene.platform].setVelocity({});
        support::run(scene.world, 2400);
        const std::size_t before = allocations;
        support::run(scene.world, 300);
        EXPECT_EQ(allocations, before);
    }
}

// Going to rest and waking, again and again, needs no new memory once it was done.
TEST(Allocation, GoingToRestAndWakingAllocatesNothing) {
    for (const Strategy strategy : kStrategies) {
        SCOPED_TRACE(static_cast<int>(strategy));
        StepSettings settings = settingsOf(strategy, true);
        World world({.gravity = support::kEarth, .settings = settings});
        support::addFloor(world);
        const std::vector<BodyId> boxes = support::addStack(world, 6);
        const auto cycle = [&] {
            world[boxes[0]].setVelocity({0, Real(0.001)});
            support::run(world, 120);
            ASSERT_NE(world[boxes[0]].flags() & kResting, 0u);
        };
        support::run(world, 120);
        cycle();
        cycle();
        const std::size_t before = allocations;
        cycle();
        cycle();
        EXPECT_EQ(allocations, before);
    }
}

} // namespace
} // namespace kodo
