// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "catalogue/tours.hpp"
#include "hands.hpp"
#include "history.hpp"
#include "measures.hpp"

namespace destructoooor {

/// A World that can be operated, without a window: scenes, hands, dials, a past that one can go
/// back to, and a second World with other settings beside it. Every parameter of the simulation can
/// change between steps [Thesis06, Appendix A].
class Sandbox {
public:
    Sandbox(); // with the first scene

    /// Builds a scene with its own settings; dials go back to where they were at first.
    void open(std::size_t scene);
    /// Opens the scene of a stop of a tour, with the settings of the stop. A scene leaves the tour.
    void visit(std::size_t tour, std::size_t stop);
    /// The stop, the scene or what has been loaded again, from its start.
    void restart();
    /// Present stop: an index of tours() and one of its stops.
    struct Place {
        std::size_t tour;
        std::size_t stop;
    };
    std::optional<Place> place() const { return place_; }
    const Stop* stop() const {
        return place_ ? &tours()[place_->tour].stops[place_->stop] : nullptr;
    }
    std::size_t sceneIndex() const { return scene_; }
    const Scene& scene() const { return catalogue()[scene_]; }

    void step();
    std::uint64_t tick() const { return world_.stepCount(); }
    /// Goes to an earlier tick, or to a later one that has been reached before. A step from there
    /// begins another branch: what came after it is forgotten.
    void rewind(std::uint64_t tick);
    std::uint64_t firstTick() const { return history_.first(); }
    std::uint64_t lastTick() const { return lastTick_; }
    /// Seconds after which an untouched scene or stop is judged.
    Real judgedAfter() const { return place_ ? stop()->seconds : scene().seconds; }
    /// Once this time has come: is it as expected?
    std::optional<bool> verdict() const { return verdict_; }

    /// Runs a change of the World, and of the second one. Throws what it throws.
    void change(const std::function<void(kodo::World&)>& work);
    /// The mouse holds the body at a point, moves it, and lets go.
    void grab(Vec2 point);
    void pull(Vec2 point);
    void letGo();
    void drop(Thing what, Vec2 place, Real size);

    const kodo::World& world() const { return world_; }
    const kodo::StepSettings& settings() const { return world_.settings(); }
    void setSettings(const kodo::StepSettings& settings); // throws BadDefinition

    // Dials of the whole World. Numbers are m/s^2 downwards, m/s, and m.
    Real gravity() const { return gravity_; }
    void setGravity(Real gravity);
    Real wind() const { return wind_; }
    void setWind(Real wind);
    Real waterLevel() const { return waterLevel_; } // below kNoWater: none
    void setWaterLevel(Real level);
    Real friction() const { return friction_; } // of all bodies, once it was set
    Real restitution() const { return restitution_; }
    void setMaterial(Real friction, Real restitution);
    static constexpr Real kNoWater = -2;

    /// A second World that goes on from here with other settings, for comparison.
    void compareWith(const kodo::StepSettings& settings);
    void stopComparing() { twin_.reset(); }
    const kodo::World* twin() const { return twin_ ? &*twin_ : nullptr; }
    /// Largest distance (m) between the same body in both; 0 without a second World.
    Real difference() const;

    const Measures& measures() const { return measures_; }

    /// Goes on with a World of kodo::toBytes(), without judging it. Throws BadSnapshot.
    void take(std::span<const std::byte> bytes);
    /// The World as a scene file, and one from its text. Throws std::runtime_error with a sentence
    /// for each mistake, with its line; the present World then stays.
    std::string text() const;
    void takeText(std::string_view text, const std::string& file);
    /// What text() lacks, as words; empty: nothing.
    std::string notHeld() const;
    /// A scene file if the name ends in .toml, else all bytes of the World. Throws
    /// std::runtime_error with a sentence.
    void save(const std::string& file) const;
    void load(const std::string& file);
    /// What a window shows at first (m): that of the scene, or what has been loaded.
    kodo::Aabb view() const;
    /// Of a loaded scene file; empty: the World is one of a scene or of bytes.
    const std::string& fileTitle() const { return fileTitle_; }
    bool isLoaded() const { return adopted_; }

private:
    void begin(std::size_t scene, const kodo::StepSettings& settings);
    bool asExpected() const;
    void adopt(kodo::World world);
    void noteFields();
    void stepOnce(kodo::World& world);
    void removeLost(kodo::World& world) const;
    void updateFields();
    void touched();

    std::size_t scene_ = 0;
    std::optional<Place> place_;
    kodo::World world_;
    kodo::Aabb kept_{}; // m; a body that leaves it is removed
    Ids ids_;
    decltype(Scene::act) act_ = nullptr; // of the scene; null after adopt()
    bool adopted_ = false;               // the World was loaded
    std::string fileTitle_;              // of a loaded scene file
    double fileSeconds_ = 0;             // likewise
    std::optional<kodo::World> twin_;
    History history_;
    Measures measures_;
    std::uint64_t lastTick_ = 0;
    bool untouched_ = true;
    std::optional<bool> verdict_;
    std::optional<kodo::JointId> held_;
    std::vector<kodo::FieldEntry> sceneFields_; // without gravity
    Real gravity_ = 10;
    Real wind_ = 0;
    Real waterLevel_ = kNoWater;
    Real friction_ = Real(0.6);
    Real restitution_ = 0;
    std::uint64_t drops_ = 0; // seed of the next random polygon
};

/// Settings as a line of C++.
std::string codeOf(const kodo::StepSettings& settings);

} // namespace destructoooor
