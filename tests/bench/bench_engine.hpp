// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

/// State of a body, common to all engines: the frame of its parts, not its centre of mass.
struct BodyState {
    scenes::Vec2 position; // m
    scenes::Rot rotation;
    scenes::Vec2 velocity; // m/s, of the centre of mass
    double spin = 0;       // rad/s
};

/// The profile of Kodo's defaults.
inline constexpr const char* kBalanced = "balanced";

/// Options for stepping an engine. Options unknown to an engine cause WrongUse.
struct StepOptions {
    std::optional<std::string> profile{}; // of Kodo, see profileNames(); kBalanced unless given
    std::optional<int> substeps{};
    std::vector<std::string> set{};      // values of Kodo's StepSettings, such as
                                         // "contactHertz=120"; Box2D 3 has three
    std::vector<std::string> leaveOut{}; // features of Kodo, see featureNames()
    std::string continuous = "all";      // of Kodo, mode of all bodies, see continuousModeNames()
    std::optional<int> passes{};         // velocity iterations of Box2D
    std::optional<int> positionPasses{}; // position iterations of Box2D
    int threads = 1;
    bool stages = false; // measure the time of each stage, at a small cost
    bool rest = false;   // enable sleep; set by the scene
    bool events = false; // list begins, ends and hits of contacts; set by the scene
};

/// Invalid options, with a message for the user.
struct WrongUse : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Total time of one stage over all steps.
struct StageTime {
    std::string name;
    double seconds = 0;
};

/// Memory per contact, in bytes.
struct ContactBytes {
    std::size_t all = 0; // including its row
    std::size_t row = 0; // read and written by the solver passes
};

/// What it takes to keep a state of the whole scene. Where an engine has no such call, it is empty.
struct SnapshotWork {
    std::function<std::size_t()> write; // the state to bytes; returns their number
    std::function<std::size_t()> copy;  // a second World in memory; returns bytes of the heap
};

/// A scene in an engine. Bodies are identified by their index in the scene; added bodies follow.
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
    /// Teleports a body: keeps rotation and angular velocity, sets the velocity to 0.
    virtual void place(std::size_t body, scenes::Vec2 position) = 0;
    /// Sets the velocity (m/s) of the centre of mass; wakes the body unless it is 0.
    virtual void push(std::size_t body, scenes::Vec2 velocity) = 0;
    /// Reads all touching pairs of the last step. Returns the sum of their normal impulses (N s).
    virtual double readContacts() const = 0;
    /// Reads what the engine lists for a game: begins, ends and hits; all touching pairs if it has
    /// no such list. Needs StepOptions::events. Returns a sum, so that no compiler removes the
    /// loop.
    virtual double readEvents() const { return readContacts(); }
    /// Normal impulse (N s) between two bodies in the last step, summed over all points.
    virtual double impulse(std::size_t a, std::size_t b) const = 0;
    /// Fraction of the first hit of a ray; 1 if there is none.
    virtual double rayCast(scenes::Vec2 from, scenes::Vec2 to) const = 0;
    virtual std::size_t bodyCount() const = 0;
    /// Total mass (kg) of the dynamic bodies.
    virtual double mass() const = 0;
    virtual std::uint64_t stateHash() const = 0;
    /// Cost of the broad phase so far in ps, by operation counts instead of a clock. Empty if the
    /// engine provides none.
    virtual std::optional<std::uint64_t> pairWork() const { return std::nullopt; }
    /// Sizes of the engine's own types. Empty if the engine provides none.
    virtual std::optional<ContactBytes> contactBytes() const { return std::nullopt; }
    virtual SnapshotWork snapshotWork() const { return {}; }
    /// Continues from its own bytes, as after a load. Nothing where an engine has no such call.
    virtual void reload() {}
    /// Stages since the creation of the scene. Empty if the engine provides none.
    virtual std::vector<StageTime> stages() const { return {}; }
};

/// kodo (float), kodo64 (double), box2d (2.4.1) and box2d3.
const std::vector<std::string>& engineNames();
/// The engines of this build: box2d3 is optional.
std::vector<std::string> builtEngines();
const std::vector<std::string>& profileNames();
const std::vector<std::string>& featureNames();
/// In the order of ContinuousMode.
const std::vector<std::string>& continuousModeNames();

std::unique_ptr<Engine> makeEngine(const std::string& name, const scenes::SceneDef& scene,
                                   const StepOptions& options);

// Factories behind makeEngine(). Kodo's is compiled twice, against both libraries.
namespace f32 {
std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene, const StepOptions& options);
}
namespace f64 {
std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene, const StepOptions& options);
}
/// Differences to Kodo are removed by scenes/in_box2d.hpp. The default is 8 velocity and 3 position
/// iterations.
std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, const StepOptions& options);
/// Box2D 3 with its defaults and 4 substeps. Throws WrongUse if the build does not have it.
std::unique_ptr<Engine> makeBox2d3(const scenes::SceneDef& scene, const StepOptions& options);
bool hasBox2d3();

} // namespace bench
