// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/juice.hpp>
#include <apart/stage/palette.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

constexpr Real kHardest = 24;             // N s: the ball turned back at its common speed
constexpr Real kMostShake = Real(0.3);    // m
constexpr Real kCalm = Real(0.94);        // of the trauma is left after a tick
constexpr Real kCool = Real(0.93);        // of the heat is left after a tick
constexpr float kDim = 0.95f;             // of a flash is left after a tick
constexpr std::uint32_t kFlashPause = 60; // ticks: never more than two flashes a second
constexpr std::size_t kTrailLength = 44;  // ticks
constexpr int kPopupTicks = 90;
constexpr int kPopupYoung = 40;         // ticks
constexpr Real kPopupReach = Real(2.4); // m

int countFor(Real weight, Real most) {
    return static_cast<int>(weight * most + Real(0.5));
}

} // namespace

Real weightOf(Real impulse) {
    return std::sqrt(std::clamp(impulse / kHardest, Real(0), Real(1)));
}

void Juice::tick(const Game& game) {
    now_ = game.ticks();
    age();
    for (const Event& event : game.events()) {
        std::visit([&](const auto& what) { hear(game, what); }, event);
    }
    followBalls(game);
    feedFlames(game);
}

void Juice::age() {
    sparks_.tick(kTickSeconds);
    trauma_ *= kCalm;
    flash_ *= kDim;
    for (Heat& heat : heats_) {
        heat.left *= kCool;
    }
    std::erase_if(heats_, [](const Heat& heat) { return heat.left < Real(0.02); });
    for (Popup& popup : popups_) {
        ++popup.age;
    }
    std::erase_if(popups_, [](const Popup& popup) { return popup.age > kPopupTicks; });
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

/// What has fired leaves flames behind.
void Juice::feedFlames(const Game& game) {
    for (const Part& part : game.parts()) {
        if (part.state == PartState::Launched) {
            const Vec2 tail = game.world()[part.body].center() - Vec2{0, Real(0.3)};
            burst({tail, {0, -1}, palette::of(Power::Launch), 3, 9, Real(0.35), Real(0.12)});
        }
    }
}

void Juice::burst(Burst burst) {
    burst.count = countFor(static_cast<Real>(burst.count), share(effects_.particles));
    sparks_.add(burst);
}

void Juice::pop(Popup popup) {
    for (Popup& other : popups_) {
        const bool near = length(other.place - popup.place) < kPopupReach;
        if (near && other.age < kPopupYoung && (other.points > 0) == (popup.points > 0)) {
            other.points += popup.points;
            other.height = std::max(other.height, popup.height);
            other.text = other.points > 0 ? "+" + std::to_string(other.points) : popup.text;
            return;
        }
    }
    if (popup.points > 0) {
        popup.text = "+" + std::to_string(popup.points);
    }
    popups_.push_back(std::move(popup));
}

void Juice::push(Real strength) {
    trauma_ = std::min(trauma_ + strength, Real(1));
}

void Juice::light(Color color, float strength) {
    if (lastFlash_ != 0 && now_ - lastFlash_ < kFlashPause) {
        return;
    }
    lastFlash_ = now_;
    flashColor_ = color;
    flash_ = strength * share(effects_.flash);
}

void Juice::heat(kodo::BodyId body) {
    for (Heat& known : heats_) {
        if (known.body == body) {
            known.left = 1;
            return;
        }
    }
    heats_.push_back({body, 1});
}

void Juice::hear(const Game&, const Struck& hit) {
    const Real weight = weightOf(hit.impulse);
    if (weight < Real(0.12)) {
        return; // rolling and resting
    }
    const Color color = hit.what == Role::Paddle ? palette::kPaddle
                        : hit.what == Role::Wall ? palette::kQuiet
                                                 : palette::of(hit.stuff);
    burst({hit.point, hit.normal, lighter(color, 0.3f), countFor(weight, 10), 3 + 6 * weight});
    heat(hit.other);
}

void Juice::hear(const Game& game, const Cracked& hit) {
    heat(hit.block);
    burst({hit.point, {}, palette::of(hit.stuff), countFor(weightOf(hit.impulse), 12), 5});
    if (game.world().contains(hit.block)) {
        cracks_.add(game.world()[hit.block], hit.point, 1 - hit.strengthLeft);
    }
}

void Juice::hear(const Game&, const Broke& hit) {
    const Real weight = weightOf(hit.impulse);
    cracks_.forget(hit.block);
    burst({hit.point,
           {},
           lighter(palette::of(hit.stuff), 0.35f),
           14 + countFor(weight, 26),
           5 + 7 * weight,
           Real(0.7),
           Real(0.09)});
    push(Real(0.16) + Real(0.2) * weight);
    const Color color = hit.combo >= 3 ? palette::kAccent : palette::kText;
    const Real size = Real(0.45) + Real(0.025) * static_cast<Real>(std::min(hit.combo, 10));
    pop({"", hit.center, color, size, hit.points});
}

void Juice::hear(const Game&, const Welded& weld) {
    burst({weld.point, {0, 1}, palette::of(Power::Weld), 40, 8, Real(0.6)});
    pop({"welded", weld.point + Vec2{0, Real(0.8)}, palette::of(Power::Weld), Real(0.55)});
}

void Juice::hear(const Game&, const Launched& launch) {
    burst({launch.point, {0, -1}, palette::of(Power::Launch), 40, 10, Real(0.5)});
    push(Real(0.3));
}

void Juice::hear(const Game&, const Spent& end) {
    burst({end.point, {}, palette::of(Power::Launch), 30, 9, Real(0.5)});
}

void Juice::hear(const Game&, const BallSplit& split) {
    burst({split.point, {}, palette::of(Power::Split), 50, 10, Real(0.8)});
    const std::string text =
        split.balls == 1 ? "1 ball more" : std::to_string(split.balls) + " balls more";
    pop({text, split.point + Vec2{0, Real(1.1)}, palette::of(Power::Split), Real(0.6)});
}

void Juice::hear(const Game&, const BallLost& lost) {
    burst({{lost.point.x, 0}, {0, 1}, palette::kDanger, 40, 11, Real(0.8)});
}

void Juice::hear(const Game&, const LifeLost&) {
    push(Real(0.7));
    light(palette::kDanger, 0.55f);
}

void Juice::hear(const Game& game, const Cleared&) {
    light(palette::kAccent, 0.5f);
    Dice dice(game.seed());
    for (int i = 0; i < 8; ++i) {
        const Vec2 place{dice.between(-10, 10), dice.between(7, 16)};
        burst({place,
               {},
               palette::kStuff[static_cast<std::size_t>(i) % palette::kStuff.size()],
               40,
               12,
               Real(1.4),
               Real(0.1)});
    }
}

Vec2 Juice::shake() const {
    const Real size = kMostShake * trauma_ * trauma_ * share(effects_.shake);
    const auto time = static_cast<Real>(now_ % 12000); // two sines that never meet look random
    return size * Vec2{std::sin(Real(0.9) * time), std::sin(Real(1.13) * time + 1)};
}

Real Juice::heatOf(kodo::BodyId body) const {
    for (const Heat& heat : heats_) {
        if (heat.body == body) {
            return heat.left;
        }
    }
    return 0;
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
