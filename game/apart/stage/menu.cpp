// SPDX-License-Identifier: MIT
#include <apart/stage/menu.hpp>
#include <apart/stage/palette.hpp>

#include <array>

namespace apart {

namespace {

constexpr Real kRow = Real(0.98);      // m, from item to item
constexpr Real kHalfWidth = Real(4.4); // m
constexpr int kNotch = 10;             // percent

} // namespace

Aabb Menu::place(std::size_t item) const {
    const Real top = top_ - kRow * static_cast<Real>(item);
    return {{-kHalfWidth, top - kRow + Real(0.1)}, {kHalfWidth, top}};
}

std::optional<std::size_t> Menu::itemAt(Vec2 place) const {
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (this->place(i).contains(place)) {
            return i;
        }
    }
    return std::nullopt;
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
        if (item.percent) {
            return MenuOutcome{item.action, command == Command::Left ? -kNotch : kNotch};
        }
        return std::nullopt;
    case Command::Launch:
    case Command::Confirm:
        if (!item.percent) {
            return MenuOutcome{item.action};
        }
        return std::nullopt;
    default:
        return std::nullopt;
    }
}

std::optional<MenuOutcome> Menu::click(Vec2 place) const {
    const std::optional<std::size_t> item = itemAt(place);
    if (!item) {
        return std::nullopt;
    }
    if (items_[*item].percent) {
        return MenuOutcome{items_[*item].action, place.x < kHalfWidth / 2 ? -kNotch : kNotch};
    }
    return MenuOutcome{items_[*item].action};
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

void Menu::setPercent(Action action, int percent) {
    for (MenuItem& item : items_) {
        if (item.action == action) {
            item.percent = percent;
        }
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
        const Real y = box.lower.y + Real(0.27);
        if (!items_[i].percent) {
            canvas.text(items_[i].label, {0, y},
                        {Real(0.56), color, Typeface::Bold, Align::Middle});
            continue;
        }
        canvas.text(items_[i].label, {box.lower.x + Real(0.4), y}, {Real(0.52), color});
        const std::string value = "\u2039  " + std::to_string(*items_[i].percent) + " %  \u203a";
        canvas.text(value, {box.upper.x - Real(0.4), y},
                    {Real(0.52), color, Typeface::Plain, Align::Right});
    }
}

} // namespace apart
