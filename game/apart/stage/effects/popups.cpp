// SPDX-License-Identifier: MIT
#include <apart/stage/effects/popups.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace apart {

namespace {

constexpr int kLife = 90;            // ticks
constexpr int kYoung = 40;           // ticks
constexpr Real kJoins = Real(2.4);   // m
constexpr Real kRise = Real(1.2);    // m, over its life; equal for all, so that the distances stay
constexpr Real kBusy = 20;           // m of way that one busy area outweighs
constexpr Real kSolid = 1;           // m of way that one solid area outweighs
constexpr Real kSolidTitle = 20;     // the same for large letters, which cover more of it
constexpr Real kUnder = 5;           // m of way that one block close above large letters outweighs
constexpr Real kSinks = 2;           // m, through which what stands may sink while they are seen
constexpr Real kLetter = Real(0.72); // width of a bold letter relative to its height
constexpr Real kBelow = Real(0.25);  // descent below the base line relative to the height
// Limits to which the points of a popup may grow.
constexpr std::size_t kMostDigits = 5; // with the sign
constexpr Real kTallest = Real(0.7);   // m

Real tall(const Popup& popup) {
    const Real height = popup.points > 0 ? std::max(popup.height, kTallest) : popup.height;
    return height < kTitlePopup ? popup.textScale * height : height;
}

Real halfWidth(const Popup& popup) {
    const std::size_t letters =
        popup.points > 0 ? std::max(popup.text.size(), kMostDigits) : popup.text.size();
    return kLetter / 2 * tall(popup) * static_cast<Real>(letters);
}

bool covered(std::span<const Popup> popups, const Aabb& box) {
    return std::any_of(popups.begin(), popups.end(),
                       [&](const Popup& other) { return overlap(other.box(), box); });
}

std::ptrdiff_t countIn(std::span<const Aabb> busy, const Aabb& box) {
    return std::count_if(busy.begin(), busy.end(),
                         [&](const Aabb& place) { return overlap(place, box); });
}

/// Bounds of a new popup now and while it is well visible.
Aabb wholeWay(const Popup& popup) {
    Aabb box = popup.box();
    box.upper.y += kRise / 2;
    return box;
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

Vec2 Popup::placeIn(const Aabb& shown) const {
    const Vec2 now = placeNow();
    const Aabb whole = box();
    const Vec2 over{std::max(whole.upper.x - shown.upper.x, Real(0)),
                    std::max(whole.upper.y - shown.upper.y, Real(0))};
    const Vec2 under{std::max(shown.lower.x - whole.lower.x, Real(0)),
                     std::max(shown.lower.y - whole.lower.y, Real(0))};
    return now - over + under;
}

float Popup::left() const {
    return std::clamp(2 - 2 * static_cast<float>(age) / kLife, 0.0f, 1.0f);
}

/// Clamps a position to the room, including the rise.
Vec2 Popups::heldIn(const Popup& popup) const {
    const Real middle = room_.center().x;
    const Real reach = std::max(room_.extent().x / 2 - halfWidth(popup), Real(0));
    const Real highest = std::max(room_.upper.y - kRise - tall(popup), room_.lower.y);
    return {std::clamp(popup.place.x, middle - reach, middle + reach),
            std::clamp(popup.place.y, room_.lower.y, highest)};
}

bool Popups::joins(const Popup& popup) {
    for (Popup& other : popups_) {
        if (other.age >= kYoung || length(other.origin - popup.place) >= kJoins) {
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

/// The nearest place without another popup and, if there is one, without anything busy. Places are
/// tried column by column, alternately above and below.
Vec2 Popups::freePlace(Popup popup, std::span<const Aabb> busy, std::span<const Aabb> solid) const {
    constexpr int kTries = 40; // up and down
    constexpr int kSteps = 21; // left and right
    const Vec2 wanted = heldIn(popup);
    const bool large = popup.height >= kTitlePopup || popup.praise;
    const Real weight = large ? kSolidTitle : kSolid;
    const Vec2 step{Real(0.9), (1 + kBelow) * tall(popup) / 2};
    const auto along = [](int i) {
        return (i % 2 == 1 ? Real(1) : Real(-1)) * static_cast<Real>((i + 1) / 2);
    };
    Vec2 best = wanted;
    Real bestCost = std::numeric_limits<Real>::max();
    for (int column = 0; column < (busy.empty() && solid.empty() ? 1 : kSteps); ++column) {
        for (int row = 0; row <= kTries; ++row) {
            popup.place = wanted + Vec2{along(column) * step.x, along(row) * step.y};
            popup.place = heldIn(popup);
            const Real way = length(popup.place - wanted);
            if (way >= bestCost || covered(popups_, popup.box())) {
                continue;
            }
            const Aabb whole = wholeWay(popup);
            const Aabb under{whole.lower, whole.upper + Vec2{0, large ? kSinks : Real(0)}};
            const std::ptrdiff_t crossed = countIn(solid, whole);
            const Real cost = way + kBusy * static_cast<Real>(countIn(busy, whole)) +
                              weight * static_cast<Real>(crossed) +
                              kUnder * static_cast<Real>(countIn(solid, under) - crossed);
            if (cost < bestCost) {
                bestCost = cost;
                best = popup.place;
            }
        }
    }
    return best;
}

void Popups::add(Popup popup, std::span<const Aabb> busy, std::span<const Aabb> solid) {
    if (joins(popup)) {
        return;
    }
    if (popup.points > 0) {
        popup.text = fmt::format("+{}", popup.points);
    }
    if (popup.praise) {
        const auto isLess = [&](const Popup& other) {
            return other.praise && other.height <= popup.height;
        };
        std::erase_if(popups_, isLess);
        if (std::any_of(popups_.begin(), popups_.end(),
                        [](const Popup& other) { return other.praise; })) {
            return;
        }
    }
    popup.origin = popup.place;
    popup.textScale = textScale_;
    popup.place = freePlace(popup, busy, solid);
    popups_.push_back(std::move(popup));
}

void Popups::setTextScale(Real scale) {
    textScale_ = scale;
    for (Popup& popup : popups_) {
        popup.textScale = scale;
    }
}

void Popups::tick() {
    for (Popup& popup : popups_) {
        ++popup.age;
    }
    std::erase_if(popups_, [](const Popup& popup) { return popup.age > kLife; });
}

} // namespace apart
