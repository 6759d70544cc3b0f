// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/bindings.hpp>
#include <apart/stage/play/play.hpp>
#include <apart/stage/screens/help_scenes.hpp>

#include <vector>

namespace apart {

/// The pages that explain the game: small scenes that play themselves again and again, with lines
/// of text, and the powers. Each showing of a scene is the same.
class HelpPage {
public:
    explicit HelpPage(const Settings& settings);

    /// Call once per frame with the time since the previous one (s). The speed of the game applies;
    /// after a stall, time beyond a limit is dropped.
    void advance(double seconds);
    /// Shows the other page: the powers, or the scenes again.
    void turn() { powers_ = !powers_; }
    bool showsPowers() const { return powers_; }
    /// Covers the whole picture.
    void draw(Canvas& canvas, const Bindings& keys) const;

    /// The game of each scene, in the order of HelpTopic.
    const Game& game(HelpTopic topic) const { return play(topic).game(); }
    const Play& play(HelpTopic topic) const { return plays_[static_cast<std::size_t>(topic)]; }

private:
    void tick();
    Real share() const;
    void drawScene(Canvas& canvas, HelpTopic topic, const Aabb& box) const;

    Settings settings_;
    std::vector<Play> starts_; // the scenes at their start
    std::vector<Play> plays_;
    double owed_ = 0; // s
    bool powers_ = false;
};

} // namespace apart
