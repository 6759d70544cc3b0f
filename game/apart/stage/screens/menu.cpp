// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/screens/menu.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr Real kBarLeft = Real(0.5); // m, from the centre
constexpr Real kBarRight = Real(3.0);
constexpr int kNotch = 10; // percent

int notchOf(const Gauge& gauge) {
    return gauge.words.empty() ? kNotch : 1;
}

std::string valueText(const Gauge& gauge) {
    if (gauge.words.empty()) {
        return fmt::format("{} %", gauge.percent);
    }
    return fmt::format("\u2039  {}  \u203a", gauge.words[static_cast<std::size_t>(gauge.percent)]);
}

} // namespace

Aabb Menu::place(std::size_t item) const {
    const std::size_t rows = (items_.size() + columns_ - 1) / columns_;
    const Real top = top_ - row_ * static_cast<Real>(item % rows);
    const Real fromMiddle =
        static_cast<Real>(item / rows) - Real(0.5) * static_cast<Real>(columns_ - 1);
    const Real center = fromMiddle * 2 * halfWidth_;
    return {{center - halfWidth_, top - row_ + Real(0.1)}, {center + halfWidth_, top}};
}

Aabb Menu::bar(std::size_t item) const {
    const Aabb box = place(item);
    return {{kBarLeft, box.lower.y + Real(0.25)}, {kBarRight, box.upper.y - Real(0.25)}};
}

std::optional<std::size_t> Menu::itemAt(Vec2 place) const {
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (this->place(i).contains(place)) {
            return i;
        }
    }
    return std::nullopt;
}

std::optional<MenuOutcome> Menu::turned(const MenuItem& item, int percent) const {
    const int value = std::clamp(percent, item.gauge->least, item.gauge->most);
    if (value == item.gauge->percent) {
        return std::nullopt;
    }
    return MenuOutcome{item.action, item.dial, value};
}

std::optional<MenuOutcome> Menu::take(Command command) {
    if (items_.empty()) {
        return std::nullopt;
    }
    const MenuItem& item = items_[chosen_];
    switch (command) {
    case Command::Up:
        chosen_ = (chosen_ + items_.size() - 1) % items_.size();
        return std::nullopt;
    case Command::Down:
        chosen_ = (chosen_ + 1) % items_.size();
        return std::nullopt;
    case Command::Left:
    case Command::Right:
        if (item.gauge) {
            const int notch = notchOf(*item.gauge);
            return turned(item, item.gauge->percent + (command == Command::Left ? -notch : notch));
        }
        return item.action == Action::Mode || item.action == Action::Page
                   ? std::optional(MenuOutcome{item.action})
                   : std::nullopt;
    case Command::Launch:
    case Command::Confirm:
        return item.gauge ? std::nullopt : std::optional(MenuOutcome{item.action, item.dial});
    default:
        return std::nullopt;
    }
}

std::optional<MenuOutcome> Menu::click(Vec2 place) const {
    const std::optional<std::size_t> found = itemAt(place);
    if (!found) {
        return std::nullopt;
    }
    const MenuItem& item = items_[*found];
    if (!item.gauge) {
        return MenuOutcome{item.action, item.dial};
    }
    const Aabb range = bar(*found);
    if (place.x < range.lower.x) {
        return turned(item, item.gauge->percent - notchOf(*item.gauge));
    }
    if (place.x > range.upper.x) {
        return turned(item, item.gauge->percent + notchOf(*item.gauge));
    }
    const Real share = (place.x - range.lower.x) / range.extent().x;
    const auto span = static_cast<Real>(item.gauge->most - item.gauge->least);
    const int notch = notchOf(*item.gauge);
    const int notches = static_cast<int>(std::round(share * span / static_cast<Real>(notch)));
    return turned(item, item.gauge->least + notch * notches);
}

std::optional<MenuOutcome> Menu::take(const Signals& signals) {
    if (signals.pointer) {
        chosen_ = itemAt(*signals.pointer).value_or(chosen_);
    }
    for (const Command command : signals.commands) {
        if (const std::optional<MenuOutcome> outcome = take(command)) {
            return outcome;
        }
    }
    return signals.clicked ? click(signals.pointerNow) : std::nullopt;
}

void Menu::setPercent(std::size_t dial, int percent) {
    for (MenuItem& item : items_) {
        if (item.gauge && item.dial == dial) {
            item.gauge->percent = percent;
        }
    }
}

void Menu::setLabel(Action action, std::string label) {
    for (MenuItem& item : items_) {
        if (item.action == action) {
            item.label = label;
        }
    }
}

void Menu::choose(Action action) {
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (items_[i].action == action) {
            chosen_ = i;
            return;
        }
    }
}

void Menu::drawDial(Canvas& canvas, std::size_t item, Color color) const {
    const Gauge& gauge = *items_[item].gauge;
    const Aabb box = place(item);
    const Real y = box.lower.y + Real(0.27);
    canvas.text(items_[item].label, {box.lower.x + Real(0.5), y},
                {Real(0.5), color, Typeface::Plain, Align::Left, halfWidth_ - Real(0.3)});
    const Real room = gauge.words.empty() ? halfWidth_ - kBarRight - Real(0.6) : Real(4.6);
    canvas.text(valueText(gauge), {box.upper.x - Real(0.4), y},
                {Real(0.5), color, Typeface::Plain, Align::Right, room});
    if (!gauge.words.empty()) {
        return;
    }
    const Aabb range = bar(item);
    const Real share = static_cast<Real>(gauge.percent - gauge.least) /
                       static_cast<Real>(gauge.most - gauge.least);
    const Real end = range.lower.x + share * range.extent().x;
    const Real middle = range.center().y;
    const Real half = Real(0.07);
    canvas.rectangle({{range.lower.x, middle - half}, {range.upper.x, middle + half}},
                     {255, 255, 255, 40}, {255, 255, 255, 40});
    canvas.rectangle({{range.lower.x, middle - half}, {end, middle + half}}, color, color);
    canvas.disc({end, middle}, Real(0.2), lighter(color, 0.3f), color);
}

/// The label takes a bit less than half of the width; the columns share the rest. The last one ends
/// at the right.
void Menu::drawRow(Canvas& canvas, std::size_t item, Color color) const {
    constexpr Real kMargin = Real(0.5); // m, also between columns
    const Aabb box = place(item);
    const Real y = box.lower.y + Real(0.27);
    const std::vector<std::string>& columns = items_[item].columns;
    const Real first = Real(0.45) * box.extent().x;
    const Real step = (box.extent().x - first - kMargin) / static_cast<Real>(columns.size());
    canvas.text(items_[item].label, {box.lower.x + kMargin, y},
                {Real(0.52), color, Typeface::Bold, Align::Left, first - Real(1.5) * kMargin});
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool last = i + 1 == columns.size();
        const Real left = box.lower.x + first + static_cast<Real>(i) * step;
        canvas.text(columns[i], {last ? left + step : left, y},
                    {Real(0.52), color, Typeface::Plain, last ? Align::Right : Align::Left,
                     step - kMargin});
    }
}

void Menu::draw(Canvas& canvas) const {
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const Aabb box = place(i);
        const bool chosen = i == chosen_;
        if (chosen) {
            const std::array<Vec2, 4> corners = {box.lower, Vec2{box.upper.x, box.lower.y},
                                                 box.upper, Vec2{box.lower.x, box.upper.y}};
            canvas.polygon(corners, faded(palette::kAccent, 0.16f));
            canvas.outline(corners, Real(0.05), palette::kAccent);
        }
        const Color color = chosen ? palette::kAccent : palette::kText;
        if (items_[i].gauge) {
            drawDial(canvas, i, color);
        } else if (!items_[i].columns.empty()) {
            drawRow(canvas, i, color);
        } else {
            canvas.text(items_[i].label,
                        {box.center().x, box.lower.y + Real(0.27) + (row_ - kRow) / 2},
                        {columns_ > 1 ? Real(0.7) : Real(0.56), color, Typeface::Bold,
                         Align::Middle, 2 * halfWidth_ - Real(0.6)});
        }
    }
}

} // namespace apart
