// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Random worlds, judged in each step. A failing world shrinks to a small one, which is a text.
namespace worlds {

/// A change before one of the steps. Bodies are named by their index in the recipe.
struct Event {
    enum class Kind {
        Remove, // of a body
        Weld,   // of `other` onto `body`
        Drive,  // sets both velocities of a body
    };
    int step = 0;
    Kind kind = Kind::Remove;
    std::size_t body = 0;
    std::size_t other = 0;
    kodo::Vec2 velocity{}; // m/s
    kodo::Real spin = 0;   // rad/s
};

/// What runs beside the world and must have the same bits.
enum class Twin { None, Copy, Bytes, Queries, Threads };
inline constexpr int kTwins = 5;

/// A world and what happens to it, as plain data. Ids in joints are indices of bodies.
struct Recipe {
    kodo::WorldDef world{};
    kodo::Real drag = 0; // N s/m per m of width, in air at rest
    kodo::Real dt = kodo::Real(1) / 60;
    int steps = 100;
    int tiles = 1; // copies of all bodies and joints, kTileWidth apart on x
    Twin twin = Twin::None;
    int twinStep = 0;   // of the copy or of the bytes
    bool rests = false; // what sleeps at the end must also stand still without sleep
    std::vector<kodo::BodyDef> bodies{};
    std::vector<kodo::JointDef> joints{};
    std::vector<Event> events{};
};

inline constexpr kodo::Real kTileWidth = 100; // m

/// A random recipe. Equal seeds give equal recipes, in each precision.
Recipe randomRecipe(std::uint64_t seed);

/// What a recipe has that is hard on an engine, as words: "joints", "thin" (particles or segments
/// that move), "thesis" (the solver of the thesis), "driven" (kinematic bodies), or "plain".
std::string kindOf(const Recipe& recipe);

/// Moves anchors b onto anchors a, and takes the present angles as references, so that no joint is
/// open at the start. Lengths and limits of distances include the present ones.
void closeJoints(Recipe& recipe);

/// A text, one line for each body, joint and event. fromText() gives the same recipe again, or
/// nothing for another text. Texts of float and double differ in digits alone.
std::string toText(const Recipe& recipe);
std::optional<Recipe> fromText(const std::string& text);

/// What a judge objects to.
struct Finding {
    std::string judge; // "energy", "momentum", "through", ...
    int step = 0;
    std::string text; // numbers
};

/// Runs a recipe. The first finding ends the run.
std::optional<Finding> judge(const Recipe& recipe);

/// Judges a recipe: judge(), one of its judges alone, or others.
using Judge = std::function<std::optional<Finding>(const Recipe&)>;
/// The smallest recipe found for which the same judge still objects, after at most `tries` runs.
Recipe shrink(const Recipe& recipe, const Finding& finding, const Judge& judge, int tries = 2000);

} // namespace worlds
