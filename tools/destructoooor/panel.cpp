// SPDX-License-Identifier: MIT
#include "panel.hpp"

#include <array>

namespace destructoooor {

namespace {

// Pixels.
constexpr float kMargin = 16;
constexpr float kTop = 20;     // of the first knob
constexpr float kPitch = 33;   // from knob to knob
constexpr float kTrack = 6;    // height of the track of a slider
constexpr float kGrip = 7;     // radius of the handle
constexpr unsigned kText = 14; // height of text

const kodo_sfml::Rgba kBack{22, 25, 32, 235};
const kodo_sfml::Rgba kLine{70, 78, 92};
const kodo_sfml::Rgba kFilled{86, 156, 214};
const kodo_sfml::Rgba kQuiet{170, 178, 190};
const kodo_sfml::Rgba kBright{255, 255, 255};

void fill(kodo_sfml::Painter& painter, kodo_sfml::Rect where, kodo_sfml::Rgba color) {
    const std::array<kodo_sfml::Rgba, 4> colors = {color, color, color, color};
    painter.rectangle(where, colors);
}

} // namespace

Panel::Panel() : knobs_(makeKnobs()) {}

kodo_sfml::Rect Panel::track(std::size_t knob) const {
    const float y = kTop + kPitch * static_cast<float>(knob) + 21;
    return {left() + kMargin, y, kWidth - 2 * kMargin, kTrack};
}

void Panel::setFrom(float x, Sandbox& sandbox) {
    const Knob& knob = knobs_[*held_];
    const kodo_sfml::Rect line = track(*held_);
    const double share = static_cast<double>((x - line.left) / line.width);
    knob.set(sandbox, snapped(knob, knob.low + share * (knob.high - knob.low)));
}

bool Panel::press(kodo_sfml::Pixel pixel, Sandbox& sandbox) {
    if (pixel.x < left()) {
        return false;
    }
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        const kodo_sfml::Rect line = track(i);
        if (pixel.y >= line.top - 20 && pixel.y < line.top - 20 + kPitch) {
            chosen_ = i;
            held_ = i;
            setFrom(pixel.x, sandbox);
        }
    }
    return true;
}

void Panel::drag(kodo_sfml::Pixel pixel, Sandbox& sandbox) {
    if (held_) {
        setFrom(pixel.x, sandbox);
    }
}

void Panel::choose(int way) {
    const auto count = static_cast<int>(knobs_.size());
    chosen_ = static_cast<std::size_t>((static_cast<int>(chosen_) + count + way) % count);
}

void Panel::turn(int way, Sandbox& sandbox) {
    const Knob& knob = knobs_[chosen_];
    knob.set(sandbox, snapped(knob, knob.value(sandbox) + way * knob.stride));
}

void Panel::draw(kodo_sfml::Painter& painter, const sf::Font& font, const Sandbox& sandbox,
                 std::span<const std::string> lines) const {
    fill(painter, {left(), 0, kWidth, static_cast<float>(pixels_.y)}, kBack);
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
        const Knob& knob = knobs_[i];
        const kodo_sfml::Rect line = track(i);
        const kodo_sfml::Rgba color = i == chosen_ ? kBright : kQuiet;
        const std::string value = valueText(knob, sandbox);
        painter.text(font, knob.label, kText, {line.left, line.top - 7}, color);
        const float width = kodo_sfml::textWidth(font, value, kText);
        painter.text(font, value, kText, {line.left + line.width - width, line.top - 7}, color);
        const auto share =
            static_cast<float>((knob.value(sandbox) - knob.low) / (knob.high - knob.low));
        fill(painter, line, kLine);
        fill(painter, {line.left, line.top, share * line.width, line.height}, kFilled);
        painter.disc({line.left + share * line.width, line.top + kTrack / 2}, kGrip, color, color);
    }
    float y = kTop + kPitch * static_cast<float>(knobs_.size()) + 14;
    for (const std::string& text : lines) {
        y += static_cast<float>(kText) + 5;
        painter.text(font, text, kText, {left() + kMargin, y}, kQuiet);
    }
}

} // namespace destructoooor
