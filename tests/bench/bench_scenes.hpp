// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "ruler.hpp"

namespace bench {

/// A running scene: the engine and the definitions of all its bodies.
class Stage {
public:
    Stage(Engine& engine, const scenes::SceneDef& scene);

    Engine& engine() { return engine_; }
    const Engine& engine() const { return engine_; }
    void add(const scenes::BodyDef& body);
    void remove(std::size_t body);
    /// The bodies not removed yet.
    std::vector<Placed> bodies() const;
    std::size_t placeOfNext() const { return defs_.size(); }

private:
    Engine& engine_;
    std::vector<std::shared_ptr<const scenes::BodyDef>> defs_; // null: removed
};

/// A measure of accuracy besides overlap and displacement; 0 is exact.
struct Error {
    std::string name;
    std::string unit; // empty: relative
    std::function<double(const Stage&, const Depths&)> measure;
};

/// A scene of the benchmark. Created for each run, since `act` may hold state.
struct Scene {
    scenes::SceneDef def;
    int warmUp = 0;    // steps before the measurement
    bool rest = false; // enable sleep; only for scenes about sleep
    /// Called every `every` steps of 1/60 s, outside the measured time unless `actIsTimed`.
    int every = 0;
    bool actIsTimed = false;
    bool stepIsTimed = true;
    bool worstStep = false; // also measure the longest step
    bool stands = false;    // all bodies should keep their places
    bool events = false;    // the engine lists begins, ends and hits of contacts
    std::function<void(Stage&, int steps)> act{};
    /// Called before each measured time of a scene whose steps are not timed.
    std::function<void(Stage&)> prepare{};
    std::optional<Region> region{};
    std::optional<Error> error{};
};

/// A named scene with its default size and number of steps.
struct Recipe {
    std::string name;
    std::string about;
    std::string sizeMeans; // empty: fixed size
    int size;
    int steps;
    std::function<Scene(int size, std::uint64_t seed)> make;
};

std::span<const Recipe> recipes();
/// All scenes of the sandbox, by its names. Their `make` throws WrongUse where a scene is more than
/// bodies and revolute joints. bench_sandbox.cpp
std::vector<Recipe> sandboxRecipes();
/// Of either list. Throws WrongUse for an unknown name.
Recipe recipeOf(const std::string& name);

inline constexpr double kDt = 1.0 / 60; // s

// bench_piles.cpp
Scene pyramid(int size, std::uint64_t seed);
Scene circles(int size, std::uint64_t seed);
Scene debris(int size, std::uint64_t seed);
Scene stack(int size, std::uint64_t seed);
Scene massRatio(int size, std::uint64_t seed);
Scene asleep(int size, std::uint64_t seed);
Scene shots(int size, std::uint64_t seed);
Scene unlike(int size, std::uint64_t seed);
// bench_machines.cpp
Scene tumbler(int size, std::uint64_t seed);
Scene breakout(int size, std::uint64_t seed);
Scene rain(int size, std::uint64_t seed);
Scene joints(int size, std::uint64_t seed);
Scene spinner(int size, std::uint64_t seed);
Scene empty(int size, std::uint64_t seed);
Scene smallRoom(int size, std::uint64_t seed);
// bench_local.cpp
Scene tiles(int size, std::uint64_t seed);
Scene rays(int size, std::uint64_t seed);
Scene flying(int size, std::uint64_t seed);
Scene churn(int size, std::uint64_t seed);
// bench_changes.cpp
Scene columns(int size, std::uint64_t seed);
Scene pushed(int size, std::uint64_t seed);
Scene removals(int size, std::uint64_t seed);
Scene particles(int size, std::uint64_t seed);
Scene events(int size, std::uint64_t seed);
Scene contacts(int size, std::uint64_t seed);
// bench_loads.cpp
Scene heavyPair(int size, std::uint64_t seed);
Scene slab(int size, std::uint64_t seed);
Scene plank(int size, std::uint64_t seed);
Scene pairs(int size, std::uint64_t seed);
Scene balls(int size, std::uint64_t seed);
// bench_jointed.cpp
Scene ragdolls(int size, std::uint64_t seed);
Scene chains(int size, std::uint64_t seed);
Scene shortChains(int size, std::uint64_t seed);
Scene bridge(int size, std::uint64_t seed);
Scene bridgeCars(int size, std::uint64_t seed);
Scene hub(int size, std::uint64_t seed);
Scene arm(int size, std::uint64_t seed);
Scene crane(int size, std::uint64_t seed);
Scene wheel(int size, std::uint64_t seed);
Scene cars(int size, std::uint64_t seed);
// bench_bursts.cpp
Scene ring(int size, std::uint64_t seed);
Scene shards(int size, std::uint64_t seed);
Scene sparks(int size, std::uint64_t seed);
Scene smash(int size, std::uint64_t seed);
Scene crowdPoint(int size, std::uint64_t seed);
// bench_worst.cpp
Scene stream(int size, std::uint64_t seed);
Scene cleared(int size, std::uint64_t seed);
Scene woken(int size, std::uint64_t seed);
Scene explosion(int size, std::uint64_t seed);
Scene fracture(int size, std::uint64_t seed);
Scene loaded(int size, std::uint64_t seed);
// bench_laws.cpp
Scene forces(int size, std::uint64_t seed);
Scene slide(int size, std::uint64_t seed);
Scene bounce(int size, std::uint64_t seed);
Scene pendulum(int size, std::uint64_t seed);

/// A static box.
scenes::BodyDef wall(double width, double height, scenes::Vec2 center,
                     scenes::Material material = {});
/// Static boxes of 1 m thickness around a disc.
std::vector<scenes::BodyDef> ringOfWalls(double radius);
/// Adds static shelves, about as many as there are places on each, with `pitch` (m) between places
/// and between shelves. Returns the places.
std::vector<scenes::Vec2> addShelves(scenes::SceneDef& scene, int places, scenes::Vec2 pitch);
/// A convex polygon of 3 to 7 corners at a distance of `radius` (m) from the centre.
scenes::Polygon shard(scenes::Dice& dice, double radius);
/// Width factor of a scene that keeps its aspect ratio with `size` bodies instead of `usual`.
double stretch(int size, int usual);

/// The mean overlap of all pairs, in mm.
Error meanDepth();
/// Maximum distance (mm) of the two anchors of a revolute joint. The initial rotation of its bodies
/// is 0.
Error widestJoint(const scenes::SceneDef& scene);
/// Deviation of the root mean square speed of these bodies from `speed` (m/s).
Error speedLost(std::vector<std::size_t> bodies, double speed);

} // namespace bench
