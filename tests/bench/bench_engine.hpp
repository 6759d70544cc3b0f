// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

/// Where a body is, as every engine tells it: the frame of its parts, not its centre of mass.
struct BodyState {
    scenes::Vec2 position; // m
    scenes::Rot rotation;
    scenes::Vec2 velocity; // m/s, of the centre of mass
    double spin = 0;       // rad/s
};

/// How an engine is to step. What an engine does not know it refuses, with a WrongUse.
struct StepOptions {
    std::string profile = "default"; // see profileNames()
    std::optional<int> substeps{};
    std::vector<std::string> set{};      // numbers of Kodo's StepSettings, as "contactHertz=120"
    std::vector<std::string> leaveOut{}; // features of Kodo, see featureNames()
    std::optional<int> passes{};         // velocity iterations of Box2D
    std::optional<int> positionPasses{}; // position iterations of Box2D
    std::string pairs = "auto";          // how Kodo looks for pairs: see pairSearchNames()
    int threads = 1;
    bool stages = false; // tell how long each stage takes, which itself takes a little
    bool rest = false;   // may calm bodies be put to rest? The scene says so, not the user
};

/// A sentence for the one who asked for what cannot be.
struct WrongUse : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// How long a part of all steps took.
struct StageTime {
    std::string name;
    double seconds = 0;
};

/// What a contact takes.
struct ContactBytes {
    std::size_t all = 0; // with its row
    std::size_t row = 0; // all that the passes of the solver read and write of it
};

/// A scene in some engine. Bodies are named by their place in the scene, and those added later by
/// the places behind it.
class Engine {
public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    virtual void step(double dt) = 0;
    virtual BodyState state(std::size_t body) const = 0;
    virtual void add(const scenes::BodyDef& body) = 0;
    virtual void remove(std::size_t body) = 0;
    /// A jump: it keeps its rotation and spin, and has no velocity.
    virtual void place(std::size_t body, scenes::Vec2 position) = 0;
    /// N s along the normal between two bodies in the last step, all points.
    virtual double impulse(std::size_t a, std::size_t b) const = 0;
    virtual std::size_t bodyCount() const = 0;
    /// kg, of all bodies that are not locked.
    virtual double mass() const = 0;
    virtual std::uint64_t stateHash() const = 0;
    /// ps that the search for pairs has taken so far, counted and not timed; nothing where an
    /// engine does not tell.
    virtual std::optional<std::uint64_t> pairWork() const { return std::nullopt; }
    /// Of its own types; nothing where an engine does not tell.
    virtual std::optional<ContactBytes> contactBytes() const { return std::nullopt; }
    /// Stages since the scene was made; none where an engine does not tell them.
    virtual std::vector<StageTime> stages() const { return {}; }
};

/// kodo (float), kodo64 (double) and box2d (2.4.1).
const std::vector<std::string>& engineNames();
const std::vector<std::string>& profileNames();
const std::vector<std::string>& featureNames();
const std::vector<std::string>& pairSearchNames();

std::unique_ptr<Engine> makeEngine(const std::string& name, const scenes::SceneDef& scene,
                                   const StepOptions& options);

// The makers behind it. Kodo's is compiled twice, each time against another library.
namespace f32 {
std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene, const StepOptions& options);
}
namespace f64 {
std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene, const StepOptions& options);
}
/// The differences undone are those of scenes/in_box2d.hpp. 8 velocity and 3 position iterations
/// unless the options say other numbers.
std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, const StepOptions& options);

} // namespace bench
