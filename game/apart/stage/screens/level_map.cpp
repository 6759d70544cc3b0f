// SPDX-License-Identifier: MIT
#include <apart/stage/screens/level_map.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace apart {

namespace {

constexpr std::size_t kMostBands = 7; // of the usual height
constexpr std::size_t kInSight = 12;  // levels of a band
constexpr Vec2 kNowhere{1000, 1000};
constexpr Real kFingerReach = 1; // m; a finger that misses a circle by less hits the nearest one
constexpr double kRestSeconds = 0.4;

// Shares of the height of a band.
constexpr Real kWayUp = Real(0.58);
constexpr Real kZigzag = Real(0.07);
constexpr Real kRadius = Real(0.21);
constexpr Real kBossRadius = Real(0.35);

} // namespace

LevelMap::LevelMap(LevelList levels, const Campaign& campaign) : campaign_(campaign) {
    setLevels(std::move(levels));
}

void LevelMap::setLevels(LevelList levels) {
    levels_ = std::move(levels);
    stops_.assign(levels_.size(), {});
    bands_.clear();
    const std::size_t own = campaign_.own;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const bool newTheme = i > 0 && i < own && levels_[i]->theme != levels_[i - 1]->theme;
        if (i == 0 || i == own || newTheme) {
            bands_.push_back({i, 0, i >= own, i});
        }
        ++bands_.back().count;
    }
    choose(chosen_);
}

void LevelMap::update(const Records& records) {
    Campaign campaign = campaign_;
    campaign.open = campaign.open || records.profile().settings.openLevels > 0;
    stops_ = stopsOf(levels_, campaign, records.profile(), records.marks());
}

std::size_t LevelMap::nextLevel(const Records& records) {
    update(records);
    return nextToPlay(levels_, stops_, records.profile(), records.marks());
}

bool LevelMap::isLastBoss(std::size_t level) const {
    const auto isBoss = [](const Stop& stop) { return stop.boss; };
    const auto after = stops_.begin() + static_cast<std::ptrdiff_t>(level) + 1;
    return stops_[level].boss && std::none_of(after, stops_.end(), isBoss);
}

std::size_t LevelMap::bandOf(std::size_t level) const {
    std::size_t band = 0;
    while (band + 1 < bands_.size() && bands_[band + 1].first <= level) {
        ++band;
    }
    return band;
}

Aabb LevelMap::boxOf(std::size_t band) const {
    const Real height = kLands.extent().y / static_cast<Real>(std::max(bands_.size(), kMostBands));
    const Real bottom = kLands.lower.y + height * static_cast<Real>(band);
    return {{kLands.lower.x, bottom}, {kLands.upper.x, bottom + height}};
}

bool LevelMap::isOpen(std::size_t band) const {
    const auto first = stops_.begin() + static_cast<std::ptrdiff_t>(bands_[band].first);
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(bands_[band].count),
                       [](const Stop& stop) { return stop.open(); });
}

std::size_t LevelMap::countShown(const Band& band) const {
    return std::min(band.count, kInSight);
}

Real LevelMap::radiusOf(std::size_t level) const {
    return boxOf(0).extent().y * (stops_[level].boss ? kBossRadius : kRadius);
}

std::optional<Vec2> LevelMap::placeOf(std::size_t level) const {
    const std::size_t index = bandOf(level);
    const Band& band = bands_[index];
    const std::size_t count = countShown(band);
    if (level < band.shown || level >= band.shown + count) {
        return std::nullopt;
    }
    const Aabb box = boxOf(index);
    const std::size_t i = level - band.shown;
    const Real room = box.extent().x - 2 * kMargin;
    const Real along = count == 1 ? Real(0.5) : static_cast<Real>(i) / static_cast<Real>(count - 1);
    const Real x = index % 2 == 0 ? along : 1 - along;
    const Real zigzag = stops_[level].boss ? 0 : i % 2 == 0 ? -kZigzag : kZigzag;
    return box.lower + Vec2{kMargin + room * x, (kWayUp + zigzag) * box.extent().y};
}

Aabb LevelMap::tile(std::size_t level) const {
    const Vec2 place = placeOf(level).value_or(kNowhere);
    return Aabb{place, place}.grown(radiusOf(level));
}

Aabb LevelMap::backPlace() const {
    return {{Real(-14.6), 0}, {Real(-10.6), Real(1.4)}};
}

Aabb LevelMap::editPlace() const {
    return {{Real(-9.2), 0}, {Real(-7.2), Real(1.4)}};
}

Aabb LevelMap::newPlace() const {
    return {{Real(-7.1), 0}, {Real(-5.1), Real(1.4)}};
}

bool LevelMap::wants(const Signals& signals, const Aabb& place, const char* key) {
    const Press press{false, keyNamed(key).value_or(kNoKey)};
    return (signals.clicked && place.contains(signals.pointerNow)) ||
           std::count(signals.presses.begin(), signals.presses.end(), press) > 0;
}

void LevelMap::choose(std::size_t level) {
    chosen_ = std::min(level, levels_.size() - 1);
    hover_ = {};
    Band& band = bands_[bandOf(chosen_)];
    const std::size_t count = countShown(band);
    band.shown = std::min(band.shown, chosen_);
    band.shown = std::max(band.shown + count, chosen_ + 1) - count;
}

/// To the nearest level of the band above or below.
void LevelMap::moveAcross(bool up) {
    const std::size_t band = bandOf(chosen_);
    if (up ? band + 1 == bands_.size() : band == 0) {
        return;
    }
    const Band& other = bands_[up ? band + 1 : band - 1];
    const Real x = placeOf(chosen_).value_or(Vec2{}).x;
    const auto distance = [&](std::size_t level) {
        return std::abs(placeOf(level).value_or(kNowhere).x - x);
    };
    std::size_t nearest = other.shown;
    for (std::size_t i = other.shown; i < other.shown + countShown(other); ++i) {
        nearest = distance(i) < distance(nearest) ? i : nearest;
    }
    choose(nearest);
}

/// Left and right follow the way, also where it turns into the next band.
void LevelMap::move(Command command) {
    const bool forth = (command == Command::Right) == (bandOf(chosen_) % 2 == 0);
    if (command == Command::Up || command == Command::Down) {
        moveAcross(command == Command::Up);
    } else if (command == Command::Left || command == Command::Right) {
        choose(forth ? chosen_ + 1 : chosen_ - std::min<std::size_t>(chosen_, 1));
    }
}

std::optional<std::size_t> LevelMap::under(Vec2 place) const {
    const auto distance = [&](std::size_t level) {
        return length(placeOf(level).value_or(kNowhere) - place);
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        nearest = distance(i) < distance(nearest) ? i : nearest;
    }
    return kLands.contains(place) && distance(nearest) < kFingerReach ? std::optional(nearest)
                                                                      : std::nullopt;
}

void LevelMap::point(const Signals& signals, double now) {
    if (signals.pointer) {
        pointer_ = *signals.pointer;
        hover_ = {under(pointer_), now};
    } else if (hover_.level && now - hover_.since >= kRestSeconds) {
        choose(*hover_.level);
    }
}

std::optional<std::size_t> LevelMap::take(const Signals& signals) {
    const auto ifOpen = [&](std::size_t level) {
        return stops_[level].open() ? std::optional(level) : std::nullopt;
    };
    if (!signals.commands.empty()) {
        choose(shown());
    }
    for (const Command command : signals.commands) {
        if (command == Command::Launch || command == Command::Confirm) {
            return ifOpen(chosen_);
        }
        move(command);
    }
    const std::optional<std::size_t> hit =
        signals.clicked ? under(signals.pointerNow) : std::nullopt;
    if (!hit) {
        return std::nullopt;
    }
    choose(*hit);
    return ifOpen(*hit);
}

} // namespace apart
