// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas.hpp>
#include <apart/stage/cracks.hpp>
#include <apart/stage/effects.hpp>
#include <apart/stage/sparks.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace apart {

/// A number or a word that rises and fades.
struct Popup {
    std::string text;
    Vec2 place; // m, where it began
    Color color{};
    Real height = 0; // m, of the letters
    int points = 0;  // that it tells of, if any
    int age = 0;     // ticks
};

/// Everything that is only to be seen and lasts longer than a tick. It hears the events of the game
/// and never speaks back; the same game gives the same picture.
class Juice {
public:
    Juice(std::uint32_t seed, const EffectSettings& effects) : effects_(effects), sparks_(seed) {}

    void setEffects(const EffectSettings& effects) { effects_ = effects; }
    /// After each tick of the game.
    void tick(const Game& game);

    const EffectSettings& effects() const { return effects_; }
    const Sparks& sparks() const { return sparks_; }
    const Cracks& cracks() const { return cracks_; }
    std::span<const Popup> popups() const { return popups_; }
    /// m; where the picture is pushed to just now.
    Vec2 shake() const;
    /// 0..1, how much of the flash colour covers the field.
    float flash() const { return flash_; }
    Color flashColor() const { return flashColor_; }
    /// 0..1, how lately this body was struck.
    Real heatOf(kodo::BodyId body) const;
    /// Where this ball was, oldest first.
    std::span<const Vec2> trailOf(kodo::BodyId ball) const;

private:
    struct Heat {
        kodo::BodyId body;
        Real left; // 1 at the blow, 0 forgotten
    };
    struct Trail {
        kodo::BodyId ball;
        std::vector<Vec2> places;
    };

    void hear(const Game& game, const Struck& hit);
    void hear(const Game& game, const Cracked& hit);
    void hear(const Game& game, const Broke& hit);
    void hear(const Game& game, const Welded& weld);
    void hear(const Game& game, const Launched& launch);
    void hear(const Game& game, const Spent& end);
    void hear(const Game& game, const BallSplit& split);
    void hear(const Game& game, const BallLost& lost);
    void hear(const Game& game, const LifeLost& lost);
    void hear(const Game& game, const Cleared& end);
    template <typename Other>
    void hear(const Game&, const Other&) {} // what needs no light

    void burst(Burst burst);
    /// One of the same kind that has just come up nearby takes the points instead, so that a chain
    /// of breaks stays readable.
    void pop(Popup popup);
    void push(Real strength);
    void light(Color color, float strength);
    void heat(kodo::BodyId body);
    void age();
    void followBalls(const Game& game);
    void feedFlames(const Game& game);

    EffectSettings effects_;
    Sparks sparks_;
    Cracks cracks_;
    std::vector<Popup> popups_;
    std::vector<Heat> heats_;
    std::vector<Trail> trails_;
    Real trauma_ = 0; // 0..1; the shake grows with its square
    float flash_ = 0;
    Color flashColor_{};
    std::uint32_t now_ = 0;
    std::uint32_t lastFlash_ = 0;
};

/// How loud, bright or wild a blow is, 0..1: the root of its share of the hardest one.
Real weightOf(Real impulse);

} // namespace apart
