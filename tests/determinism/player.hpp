// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>
#include <kodo/state_hash.hpp>
#include <scenes/crowds.hpp>
#include <scenes/in_kodo.hpp>
#include <scenes/nets.hpp>
#include <scenes/piles.hpp>
#include <scenes/slides.hpp>

#include <ostream>
#include <span>

namespace determinism {
inline namespace KODO_PRECISION {

inline constexpr int kTicks = 600;
inline constexpr int kHashEvery = 60; // ticks between the hashes that golden.txt keeps
inline constexpr kodo::Real kDt = kodo::Real(1) / 60;
inline constexpr const char* kPrecision = sizeof(kodo::Real) == 4 ? "float" : "double";

/// A scene, with or without changes while it runs.
struct Recipe {
    const char* name;
    scenes::SceneDef (*scene)();
    bool churn; // compounds are added, welded where they touch, pushed and removed
};

/// Name in the messages of tests.
inline void PrintTo(const Recipe& recipe, std::ostream* out) {
    *out << recipe.name;
}

inline scenes::SceneDef emptyBin() {
    scenes::SceneDef scene = scenes::pile(0);
    scene.name = "churn";
    return scene;
}

inline std::span<const Recipe> recipes() {
    static constexpr Recipe kRecipes[] = {
        {"stack", [] { return scenes::stack(10); }, false},
        {"pyramid", [] { return scenes::pyramid(10); }, false},
        {"dominoes", [] { return scenes::dominoRow(12); }, false},
        {"pile", [] { return scenes::pile(60); }, false},
        {"gas", [] { return scenes::elasticGas(); }, false},
        {"incline", [] { return scenes::incline(); }, false},
        {"bullets", [] { return scenes::fastBalls(); }, false},
        {"churn", emptyBin, true},
        {"nets", [] { return scenes::nets(); }, false},
    };
    return kRecipes;
}

/// Plays a recipe tick by tick. A copy continues as the original does.
class Player {
public:
    explicit Player(const Recipe& recipe)
        : scene_(scenes::inKodo(recipe.scene())), churn_(recipe.churn) {}

    void tick() {
        if (churn_) {
            change();
        }
        scene_.world.step(kDt);
        ++ticks_;
        for (const kodo::CollisionRecord& record : scene_.world.collisions()) {
            add(record);
        }
    }

    kodo::World& world() { return scene_.world; }
    const kodo::World& world() const { return scene_.world; }
    int ticks() const { return ticks_; }

    /// Hash of the state of the World and of every collision record so far.
    std::uint64_t hash() const {
        kodo::StateHash hash = records_;
        hash.add(scene_.world.stateHash());
        return hash.value();
    }

private:
    void add(const kodo::CollisionRecord& record) {
        for (const std::uint32_t value :
             {record.a.index, record.a.generation, record.b.index, record.b.generation,
              std::uint32_t{record.partA}, std::uint32_t{record.partB}}) {
            records_.add(value);
        }
        records_.add(static_cast<std::uint8_t>(record.phase));
        records_.add(record.pointCount);
        for (const kodo::Real value :
             {record.point.x, record.point.y, record.normal.x, record.normal.y, record.separation,
              record.approachSpeed, record.maxImpulse, record.totalImpulse}) {
            records_.add(value);
        }
        for (const kodo::RecordPoint& point : record.points) {
            for (const kodo::Real value :
                 {point.position.x, point.position.y, point.separation, point.maxImpulse}) {
                records_.add(value);
            }
        }
    }

    void change() {
        if (ticks_ % 8 == 0) {
            addCompound();
        }
        if (ticks_ % 20 == 10) {
            weldWhatTouches();
        }
        if (ticks_ % 30 == 15) {
            const kodo::BodyId id = anyLoose();
            const kodo::Real mass = scene_.world[id].mass();
            scene_.world[id].applyImpulse({mass, 6 * mass});
        }
        if (ticks_ % 35 == 34) {
            scene_.world.remove(anyLoose());
        }
    }

    void addCompound() {
        scenes::BodyDef def;
        const double width = dice_.between(0.4, 0.9);
        def.parts = {scenes::Box{width, 0.3}, scenes::Circle{0.2, {width / 2, 0.1}}};
        if (dice_.below(2) == 0) {
            def.parts.push_back(scenes::randomPolygon(dice_, 5, 0.6, 0.8));
        }
        def.position = {dice_.between(-2.5, 2.5), dice_.between(6, 7)};
        def.rotation = scenes::turnedBy(dice_.between(-1, 1));
        def.spin = dice_.between(-3, 3);
        def.density = dice_.between(0.5, 2);
        def.material = {dice_.between(0, 1), dice_.between(0, 0.5)};
        scene_.world.add(scenes::toKodo(def));
    }

    void weldWhatTouches() {
        for (const kodo::CollisionRecord& record : scene_.world.collisions()) {
            const auto loose = [&](kodo::BodyId id) {
                return scene_.world.contains(id) &&
                       scene_.world[id].type() == kodo::BodyType::Dynamic &&
                       scene_.world[id].partCount() < 12;
            };
            if (loose(record.a) && loose(record.b)) {
                scene_.world.weld(record.a, record.b);
                return;
            }
        }
    }

    kodo::BodyId anyLoose() {
        const std::vector<kodo::BodyId> bodies = scene_.world.bodies();
        kodo::BodyId id;
        do {
            id = bodies[dice_.below(bodies.size())];
        } while (scene_.world[id].type() != kodo::BodyType::Dynamic);
        return id;
    }

    scenes::KodoScene scene_;
    bool churn_;
    scenes::Dice dice_{7};
    int ticks_ = 0;
    kodo::StateHash records_;
};

/// Hashes after every kHashEvery ticks.
inline std::vector<std::uint64_t> hashesOf(const Recipe& recipe) {
    std::vector<std::uint64_t> hashes;
    Player player(recipe);
    while (player.ticks() < kTicks) {
        player.tick();
        if (player.ticks() % kHashEvery == 0) {
            hashes.push_back(player.hash());
        }
    }
    return hashes;
}

} // namespace KODO_PRECISION
} // namespace determinism
