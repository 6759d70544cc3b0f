// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas.hpp>
#include <apart/stage/ear.hpp>
#include <apart/stage/field_painter.hpp>
#include <apart/stage/juice.hpp>
#include <apart/stage/pose_blend.hpp>

#include <memory>

namespace apart {

/// One game with everything that makes it seen and heard.
class Play {
public:
    Play(std::shared_ptr<const Level> level, std::uint32_t seed, const EffectSettings& effects)
        : game_(std::move(level), seed), juice_(seed, effects) {}

    void tick(const Input& input, Speaker& speaker);
    /// At that share of the way from the last tick but one to the last.
    void draw(Canvas& canvas, Real share) const;

    const Game& game() const { return game_; }
    const Juice& juice() const { return juice_; }
    void setEffects(const EffectSettings& effects) { juice_.setEffects(effects); }

private:
    Game game_;
    Juice juice_;
    PoseBlend poses_;
    Ear ear_;
};

} // namespace apart
