// SPDX-License-Identifier: MIT
#include <apart/stage/layout.hpp>
#include <apart/stage/popups.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

namespace {

constexpr int kLife = 90;            // ticks
constexpr int kYoung = 40;           // ticks
constexpr Real kJoins = Real(2.4);   // m
constexpr Real kRise = Real(1.2);    // m, over its life; equal for all, so that the distances stay
constexpr Real kLetter = Real(0.72); // width of a bold letter relative to its height
constexpr Real kBelow = Real(0.25);  // descent below the base line relative to the height
// Limits to which the points of a popup may grow.
constexpr std::size_t kMostDigits = 5; // with the sign
constexpr Real kTallest = Real(0.7);   // m

Real tall(const Popup& popup) {
    return popup.points > 0 ? std::max(popup.height, kTallest) : popup.height;
}

Real halfWidth(const Popup& popup) {
    const std::size_t letters =
        popup.points > 0 ? std::max(popup.text.size(), kMostDigits) : popup.text.size();
    return kLetter / 2 * tall(popup) * static_cast<Real>(letters);
}

/// Clamps a position to the field, including the rise.
Vec2 heldIn(const Popup& popup) {
    const Real reach = std::max(layout::kRight - halfWidth(popup), Real(0));
    return {std::clamp(popup.place.x, -reach, reach),
            std::clamp(popup.place.y, Real(0), layout::kTop - kRise - tall(popup))};
}

} // namespace

Vec2 Popup::placeNow() const {
    return place + Vec2{0, kRise * static_cast<Real>(age) / kLife};
}

Aabb Popup::box() const {
    const Vec2 now = placeNow();
    const Real half = halfWidth(*this);
    return {now - Vec2{half, kBelow * tall(*this)}, now + Vec2{half, tall(*this)}};
}

float Popup::left() const {
    return std::clamp(2 - 2 * static_cast<float>(age) / kLife, 0.0f, 1.0f);
}

bool Popups::joins(const Popup& popup) {
    for (Popup& other : popups_) {
        if (other.age >= kYoung || length(other.place - popup.place) >= kJoins) {
            continue;
        }
        if (popup.points > 0 && other.points > 0) {
            other.points += popup.points;
            other.height = std::max(other.height, popup.height);
            other.text = fmt::format("+{}", other.points);
            return true;
        }
        if (popup.points == 0 && other.text == popup.text) {
            return true;
        }
    }
    return false;
}

void Popups::add(Popup popup) {
    if (joins(popup)) {
        return;
    }
    if (popup.points > 0) {
        popup.text = fmt::format("+{}", popup.points);
    }
    popup.place = heldIn(popup);
    // Tries positions alternately above and below until nothing overlaps.
    const Vec2 wanted = popup.place;
    const Real step = (1 + kBelow) * tall(popup) / 2;
    const auto covered = [&] {
        return std::any_of(popups_.begin(), popups_.end(),
                           [&](const Popup& other) { return overlap(other.box(), popup.box()); });
    };
    constexpr int kTries = 40;
    for (int i = 1; i <= kTries && covered(); ++i) {
        const auto away = static_cast<Real>((i + 1) / 2);
        popup.place = wanted + Vec2{0, (i % 2 == 1 ? away : -away) * step};
        popup.place = heldIn(popup);
    }
    popups_.push_back(std::move(popup));
}

void Popups::tick() {
    for (Popup& popup : popups_) {
        ++popup.age;
    }
    std::erase_if(popups_, [](const Popup& popup) { return popup.age > kLife; });
}

} // namespace apart
