// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/effects/block_bounds.hpp>
#include <apart/stage/effects/juice.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

constexpr Real kHardest = 24;            // N s: a ball reversed at its usual speed
constexpr Real kMostShake = Real(0.3);   // m
constexpr Real kCalm = Real(0.94);       // decay of the trauma per tick
constexpr Real kCool = Real(0.93);       // decay of the heat per tick
constexpr Real kSwing = Real(0.3);       // rad per tick, oscillation after an impact
constexpr std::size_t kTrailLength = 44; // ticks

/// Bounds of a body now and for the next third of a second.
Aabb sweptBounds(const kodo::BodyView& body) {
    constexpr Real kAhead = Real(0.33); // s
    const Aabb now = body.bounds();
    const Vec2 way = kAhead * body.velocity();
    return unite(now, {now.lower + way, now.upper + way});
}

Rubble dropsOf(Vec2 point, Vec2 heading, int count, Real speed) {
    return {point, heading, palette::kFoam, count, 0, speed, Real(0.7)};
}

} // namespace

std::vector<Aabb> breakingPlaces(const Game& game) {
    constexpr std::uint32_t kFresh = 60;  // ticks
    constexpr Real kToppling = Real(0.3); // m/s
    constexpr Real kSingleFall = 3;       // m, of a block that comes off alone, in a popup's life
    std::vector<Aabb> places;
    for (const Shard& shard : game.shards()) {
        if (game.ticks() - shard.bornTick < kFresh) {
            places.push_back(sweptBounds(game.world()[shard.body]));
        }
    }
    for (const Block& block : game.blocks()) {
        const kodo::BodyView body = game.world()[block.body];
        const bool loose = block.support == Support::Fallen || block.support == Support::Loose;
        const bool fresh = loose && game.ticks() - block.looseTick < 2 * kFresh;
        const bool topples = block.support == Support::Standing && !body.isAsleep() &&
                             length(body.velocity()) > kToppling;
        if (fresh || topples) {
            places.push_back(sweptBounds(body));
            if (block.support == Support::Loose) {
                places.back().lower.y -= kSingleFall;
            }
        }
    }
    return places;
}

Real weightOf(Real impulse) {
    return std::sqrt(std::clamp(impulse / kHardest, Real(0), Real(1)));
}

void Juice::tick(const Game& game) {
    now_ = game.ticks();
    age();
    take(game, game.events());
    const Counts& counts = game.counts();
    if (counts.isDown() && counts.downTick == now_) {
        say(game, {"it is down", {0, Real(16.4)}, palette::kAccent, Real(0.8)});
    }
    followBalls(game);
    for (const Part& part : game.parts()) {
        if (part.state == PartState::Launched) {
            const Vec2 tail = game.world()[part.body].center() - Vec2{0, Real(0.3)};
            burst({tail, {0, -1}, tints().of(Power::Launch), 3, 9, Real(0.35), Real(0.12)});
        }
    }
    ripples_.tick(game);
    for (const Water& water : game.waters()) {
        if (game.ticks() % 6 == 0 && water.open && water.region.upper.y > water.floor()) {
            debris_.add(dropsOf(water.breach, {0, -1}, 1, 6), share(settings_.particles));
        }
    }
}

void Juice::take(const Game& game, std::span<const Event> events) {
    for (const Event& event : events) {
        if (const auto* splash = std::get_if<Splashed>(&event)) {
            const Real weight = weightOf(splash->mass * std::abs(splash->speed));
            ripples_.strike(game, splash->point, splash->speed, splash->mass);
            debris_.add(
                dropsOf(splash->point, {0, 1}, 2 + static_cast<int>(8 * weight), 3 + 5 * weight),
                share(settings_.particles));
        }
        std::visit([&](const auto& what) { onEvent(game, what); }, event);
    }
}

void Juice::age() {
    sparks_.tick(kTickSeconds);
    debris_.tick(kTickSeconds);
    flashes_.tick();
    trauma_ *= kCalm;
    for (Heat& heat : heats_) {
        heat.left *= kCool;
        ++heat.age;
    }
    std::erase_if(heats_, [](const Heat& heat) { return heat.left < Real(0.02); });
    popups_.tick();
}

void Juice::followBalls(const Game& game) {
    std::erase_if(trails_, [&](const Trail& trail) { return !game.world().contains(trail.ball); });
    for (const Ball& ball : game.balls()) {
        auto trail = std::find_if(trails_.begin(), trails_.end(),
                                  [&](const Trail& t) { return t.ball == ball.body; });
        if (trail == trails_.end()) {
            trails_.push_back({ball.body, {}});
            trail = trails_.end() - 1;
        }
        if (trail->places.size() == kTrailLength) {
            trail->places.erase(trail->places.begin());
        }
        trail->places.push_back(game.world()[ball.body].center());
    }
}

void Juice::burst(Burst burst) {
    const float count = static_cast<float>(burst.count) * share(settings_.particles);
    burst.count = static_cast<int>(count + 0.5f);
    sparks_.add(burst);
}

void Juice::push(Real strength) {
    trauma_ = std::min(trauma_ + strength, Real(1));
}

/// Adds a popup beside all that breaks or falls, and beside what stands if that is near.
void Juice::say(const Game& game, Popup popup) {
    if (busyTick_ != now_ + 1) {
        busyTick_ = now_ + 1;
        busy_ = breakingPlaces(game);
        solid_.clear();
        for (const Block& block : game.blocks()) {
            solid_.push_back(boundsOf(game, block));
        }
    }
    popups_.add(std::move(popup), busy_, solid_);
}

void Juice::heat(std::uint64_t name, Vec2 push) {
    for (Heat& known : heats_) {
        if (known.name == name) {
            known = {name, 1, push};
            return;
        }
    }
    heats_.push_back({name, 1, push});
}

ImpactResponse Juice::responseOf(std::uint64_t name) const {
    for (const Heat& heat : heats_) {
        if (heat.name == name) {
            const Real swing = std::cos(kSwing * static_cast<Real>(heat.age));
            return {flashes_.heat() * heat.left,
                    heat.left * swing * share(settings_.squash) * heat.push};
        }
    }
    return {};
}

ImpactResponse Juice::responseOf(kodo::BodyId body) const {
    return responseOf(nameOf(body));
}

ImpactResponse Juice::responseOfBlock(std::uint32_t key) const {
    return responseOf(nameOfBlock(key));
}

Vec2 Juice::shake() const {
    const Real size = kMostShake * trauma_ * trauma_ * share(settings_.shake);
    const auto time = static_cast<Real>(now_ % 12000); // incommensurate frequencies look random
    return size * Vec2{std::sin(Real(0.9) * time), std::sin(Real(1.13) * time + 1)};
}

std::span<const Vec2> Juice::trailOf(kodo::BodyId ball) const {
    for (const Trail& trail : trails_) {
        if (trail.ball == ball) {
            return trail.places;
        }
    }
    return {};
}

} // namespace apart
