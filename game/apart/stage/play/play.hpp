// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/editor/trial.hpp>
#include <apart/core/game.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/pose_blend.hpp>
#include <apart/stage/effects/juice.hpp>
#include <apart/stage/painters/field_painter.hpp>
#include <apart/stage/sound/fanfare.hpp>
#include <apart/stage/sound/sound_cues.hpp>

#include <memory>

namespace apart {

/// A game with its picture and sound.
class Play {
public:
    /// `words`: the part of the field for words of the game (m).
    Play(std::shared_ptr<const Level> level, std::uint32_t seed, Mode mode,
         const Settings& settings, const Aabb& words = layout::kWords)
        : level_(level), game_(std::move(level), seed, mode), juice_(seed, settings, words) {}

    void tick(const Input& input, Speaker& speaker);
    /// Draws the state between the previous tick (share 0) and the latest one (share 1).
    /// `shown`: the part of the field in the picture (m); words stay inside. Behind a menu there
    /// are no `words`: they would be read through it.
    void draw(Canvas& canvas, Real share, const Aabb& shown = layout::kShown,
              bool words = true) const;

    /// The ball flies down from a place (m) instead of being served.
    void dropBall(Vec2 place) { Trial::dropBall(game_, place); }

    const Game& game() const { return game_; }
    const std::shared_ptr<const Level>& sharedLevel() const { return level_; }
    const Juice& juice() const { return juice_; }
    void setPace(double pace) { juice_.setPace(pace); }
    void setSettings(const Settings& settings) { juice_.setSettings(settings); }
    /// One tick of the fanfare.
    void celebrate(Fanfare& fanfare, Speaker& speaker) {
        fanfare.tick(juice_, share(juice_.settings().sound), game().level().theme, speaker);
    }

private:
    std::shared_ptr<const Level> level_;
    Game game_;
    Juice juice_;
    PoseBlend poses_;
    SoundCues soundCues_;
};

} // namespace apart
