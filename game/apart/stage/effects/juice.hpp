// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/controls/player_settings.hpp>
#include <apart/stage/effects/cracks.hpp>
#include <apart/stage/effects/debris.hpp>
#include <apart/stage/effects/flashes.hpp>
#include <apart/stage/effects/popups.hpp>
#include <apart/stage/effects/ripples.hpp>
#include <apart/stage/effects/sparks.hpp>

#include <cstdint>
#include <vector>

namespace apart {

/// Visual response to the last impact on a body or block.
struct ImpactResponse {
    Real heat = 0; // 1 at the impact, decays to 0
    Vec2 push;     // damped oscillation along the impact, length 0..1
};

/// Visual effects that outlast a tick. Driven by game events, without influence on the game. The
/// same game gives the same picture.
class Juice {
public:
    /// `words`: the part of the field for words (m).
    Juice(std::uint32_t seed, const Settings& settings, const Aabb& words = layout::kWords)
        : sparks_(seed), debris_(seed), popups_(words) {
        setSettings(settings);
    }

    void setSettings(const Settings& settings) {
        settings_ = settings;
        flashes_.setSettings(settings);
        popups_.setTextScale(share(settings.text));
    }
    void firework(Vec2 place, Color color);
    /// Call after each tick of the game.
    void tick(const Game& game);
    /// The effects of events, without ageing. tick() calls it with the events of the game.
    void take(const Game& game, std::span<const Event> events);
    /// Ratio of the time of the game to real time, for the limit of flashes per second of real
    /// time.
    void setPace(double pace) { flashes_.setPace(pace); }

    const Settings& settings() const { return settings_; }
    const Sparks& sparks() const { return sparks_; }
    const Debris& debris() const { return debris_; }
    const Palette& tints() const { return paletteOf(settings_.colors); }
    const Ripples& ripples() const { return ripples_; }
    const Cracks& cracks() const { return cracks_; }
    std::span<const Popup> popups() const { return popups_.all(); }
    /// Current offset of the picture (m).
    Vec2 shake() const;
    const Flashes& flashes() const { return flashes_; }
    /// Response of a body to its last impact.
    ImpactResponse responseOf(kodo::BodyId body) const;
    /// Response of a single block. The blocks of a boss share a body.
    ImpactResponse responseOfBlock(std::uint32_t key) const;
    /// Past positions of a ball, oldest first.
    std::span<const Vec2> trailOf(kodo::BodyId ball) const;

private:
    struct Heat {
        std::uint64_t name; // nameOf() or nameOfBlock()
        Real left;          // 1 at the impact, decays to 0
        Vec2 push;          // direction times weight, length 0..1
        int age = 0;        // ticks
    };
    struct Trail {
        kodo::BodyId ball;
        std::vector<Vec2> places;
    };

    // Effects of each event (juice_events.cpp).
    void onEvent(const Game& game, const Struck& hit);
    void onEvent(const Game& game, const Cracked& hit);
    void onEvent(const Game& game, const Broke& hit);
    void onEvent(const Game& game, const Welded& weld);
    void onEvent(const Game& game, const KnockedOff& off);
    void onEvent(const Game& game, const Launched& launch);
    void onEvent(const Game& game, const Spent& end);
    void onEvent(const Game& game, const BallSplit& split);
    void onEvent(const Game& game, const BallLost& lost);
    void onEvent(const Game& game, const LifeLost& lost);
    void onEvent(const Game& game, const Cleared& end);
    void onEvent(const Game& game, const ShardBroke& hit);
    void onEvent(const Game& game, const LetGo& let);
    void onEvent(const Game& game, const Landed& landed);
    void onEvent(const Game& game, const Collapsed& collapse);
    void onEvent(const Game& game, const Snapped& snap);
    void onEvent(const Game& game, const PatienceChanged& change);
    void onEvent(const Game& game, const BossDown& down);
    void onEvent(const Game& game, const Bumped& bump);
    void onEvent(const Game& game, const PowerBegan& power);
    void onEvent(const Game& game, const BallChanged& change);
    void onEvent(const Game& game, const Leapt& leap);
    void onEvent(const Game& game, const ShardCaught& shard);
    void onEvent(const Game& game, const Breached& breach);
    template <typename Other>
    void onEvent(const Game&, const Other&) {} // events without effects

    void burst(Burst burst);
    void push(Real strength);
    void say(const Game& game, Popup popup);
    void heat(std::uint64_t name, Vec2 push);
    ImpactResponse responseOf(std::uint64_t name) const;
    void age();
    void followBalls(const Game& game);

    Settings settings_;
    Sparks sparks_;
    Debris debris_;
    Flashes flashes_;
    Cracks cracks_;
    Ripples ripples_;
    Popups popups_;
    std::vector<Heat> heats_;
    std::vector<Trail> trails_;
    Real trauma_ = 0; // 0..1; the amplitude of the shake is proportional to its square
    std::uint32_t now_ = 0;
    std::vector<Aabb> busy_;     // places where something breaks
    std::vector<Aabb> solid_;    // places of all other blocks
    std::uint32_t busyTick_ = 0; // of `busy_`
};

// Keys of responses, disjoint for bodies and blocks.
constexpr std::uint64_t nameOf(kodo::BodyId body) {
    return std::uint64_t{body.generation} << 32 | body.index;
}
constexpr std::uint64_t nameOfBlock(std::uint32_t key) {
    return std::uint64_t{1} << 63 | key;
}

/// Places where something breaks or falls now (m).
std::vector<Aabb> breakingPlaces(const Game& game);

/// Intensity of an impact, 0..1: the square root of its share of the strongest impulse.
Real weightOf(Real impulse);

} // namespace apart
