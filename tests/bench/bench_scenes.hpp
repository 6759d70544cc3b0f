// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "ruler.hpp"

namespace bench {

/// A scene as it runs: the engine, and the definitions of all bodies that it has.
class Stage {
public:
    Stage(Engine& engine, const scenes::SceneDef& scene);

    Engine& engine() { return engine_; }
    const Engine& engine() const { return engine_; }
    void add(const scenes::BodyDef& body);
    void remove(std::size_t body);
    /// Those that are still there.
    std::vector<Placed> bodies() const;
    std::size_t placeOfNext() const { return defs_.size(); }

private:
    Engine& engine_;
    std::vector<std::shared_ptr<const scenes::BodyDef>> defs_; // null: removed
};

/// What a scene is judged by besides depth and drift: 0 is right.
struct Error {
    std::string name;
    std::string unit; // empty: a share
    std::function<double(const Stage&, const Depths&)> measure;
};

/// A scene of the benchmark. Made anew for each run, since `act` may remember things.
struct Scene {
    scenes::SceneDef def;
    int warmUp = 0;    // steps before the clock starts
    bool rest = false; // may calm bodies be put to rest? Only where the scene is about that
    /// Called after each `every` steps of 1/60 s, while the clock stands unless `actIsTimed`.
    int every = 0;
    bool actIsTimed = false;
    std::function<void(Stage&, int steps)> act{};
    std::optional<Region> region{};
    std::optional<Error> error{};
};

/// A scene by its name, and its size and length unless told otherwise.
struct Recipe {
    const char* name;
    const char* about;
    const char* sizeMeans; // empty: it has only one size
    int size;
    int steps;
    Scene (*make)(int size, std::uint64_t seed);
};

std::span<const Recipe> recipes();
/// Throws WrongUse for a name that is not there.
const Recipe& recipeOf(const std::string& name);

inline constexpr double kDt = 1.0 / 60; // s

// bench_piles.cpp
Scene pyramid(int size, std::uint64_t seed);
Scene circles(int size, std::uint64_t seed);
Scene debris(int size, std::uint64_t seed);
Scene stack(int size, std::uint64_t seed);
Scene massRatio(int size, std::uint64_t seed);
Scene resting(int size, std::uint64_t seed);
Scene shots(int size, std::uint64_t seed);
// bench_machines.cpp
Scene tumbler(int size, std::uint64_t seed);
Scene breakout(int size, std::uint64_t seed);
Scene rain(int size, std::uint64_t seed);
Scene joints(int size, std::uint64_t seed);
Scene spinner(int size, std::uint64_t seed);
Scene empty(int size, std::uint64_t seed);
Scene smallRoom(int size, std::uint64_t seed);
// bench_laws.cpp
Scene forces(int size, std::uint64_t seed);
Scene slide(int size, std::uint64_t seed);
Scene bounce(int size, std::uint64_t seed);
Scene pendulum(int size, std::uint64_t seed);

/// A locked box.
scenes::BodyDef wall(double width, double height, scenes::Vec2 center,
                     scenes::Material material = {});
/// A convex polygon of 3 to 7 corners, `radius` (m) from the middle.
scenes::Polygon shard(scenes::Dice& dice, double radius);
/// How much wider a scene must be to keep its form when it has `size` bodies instead of `usual`.
double stretch(int size, int usual);

/// The mean overlap of all pairs, mm.
Error meanDepth();
/// By how much the speeds of these bodies, as a root of the mean square, differ from `speed` (m/s).
Error speedLost(std::vector<std::size_t> bodies, double speed);

} // namespace bench
