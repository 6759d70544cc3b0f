// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/effects/juice.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr int kGreatFall = 7; // blocks of a collapse; it lights up the field

int countFor(Real weight, Real most) {
    return static_cast<int>(weight * most + Real(0.5));
}

Color colorOf(const Struck& hit, const Palette& tints) {
    switch (hit.what) {
    case Role::Paddle:
        return palette::kPaddle;
    case Role::Block:
    case Role::Shard:
        return tints.of(hit.stuff);
    default:
        return palette::kQuiet;
    }
}

/// Praise at milestones of a combo.
std::string_view praiseOf(int combo) {
    switch (combo) {
    case 5:
        return "combo of five";
    case 8:
        return "combo of eight!";
    case 12:
        return "a dozen!";
    case 20:
        return "twenty in a row!";
    default:
        return {};
    }
}

/// "nine in one fall!"
std::string fallText(int blocks) {
    constexpr std::array<std::string_view, 10> kWords = {
        "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"};
    const auto index = static_cast<std::size_t>(blocks - kLeastCollapse);
    const std::string count =
        index < kWords.size() ? std::string(kWords[index]) : std::to_string(blocks);
    return count + " in one fall" + (blocks >= kGreatFall ? "!" : "");
}

/// What a wait brings soon. A block that stands or hangs has no mount.
std::string soonText(const Block& next) {
    const bool mounted = next.support == Support::Mounted || next.support == Support::Boss;
    return mounted ? "the mounts give way soon" : "blocks fall by themselves soon";
}

Burst blastOf(Vec2 point, Color color, int count, Real speed) {
    return {point, {}, color, count, speed, Real(0.6), Real(0.09)};
}

} // namespace

void Juice::firework(Vec2 place, Color color) {
    burst({place, {}, color, 70, 14, Real(1.6), Real(0.15)});
    burst({place, {}, lighter(color, 0.5f), 24, 7, Real(1.1), Real(0.1)});
}

void Juice::onEvent(const Game&, const Struck& hit) {
    const Real weight = weightOf(hit.impulse);
    if (weight < Real(0.12)) {
        return; // rolling and resting contacts
    }
    burst({hit.point, hit.normal, lighter(colorOf(hit, tints()), 0.3f), countFor(weight, 10),
           3 + 6 * weight});
    heat(nameOf(hit.other), -weight * hit.normal);
    heat(nameOf(hit.ball), weight * hit.normal);
}

void Juice::onEvent(const Game& game, const Cracked& hit) {
    heat(nameOfBlock(hit.key), {});
    burst({hit.point, {}, tints().of(hit.stuff), countFor(weightOf(hit.impulse), 12), 5});
    for (const Block& block : game.blocks()) {
        if (block.key == hit.key) {
            const kodo::BodyView body = game.world()[block.body];
            cracks_.add(hit.key, body.part(block.part).convex, toLocal(body.massFrame(), hit.point),
                        1 - hit.strengthLeft);
        }
    }
}

void Juice::onEvent(const Game& game, const Broke& hit) {
    const Real weight = weightOf(hit.impulse);
    cracks_.forget(hit.key);
    burst({hit.point,
           {},
           lighter(tints().of(hit.stuff), 0.35f),
           14 + countFor(weight, 26),
           5 + 7 * weight,
           Real(0.7),
           Real(0.09)});
    Color dust = tints().of(hit.stuff);
    dust.a = 255;
    debris_.add({hit.point,
                 {},
                 dust,
                 6 + countFor(weight, 12),
                 2 + countFor(weight, 3),
                 4 + 9 * weight,
                 Real(0.8) + Real(0.5) * weight},
                share(settings_.particles));
    flashes_.glint(hit.point, weight);
    if (hit.points == 0) {
        return; // rubble
    }
    push(Real(0.16) + Real(0.2) * weight);
    const Color color = hit.combo >= 3 ? palette::kAccent : palette::kText;
    const Real size = Real(0.45) + Real(0.025) * static_cast<Real>(std::min(hit.combo, 10));
    say(game, {"", hit.center, color, size, hit.points});
    if (const std::string_view praise = praiseOf(hit.combo); !praise.empty()) {
        say(game, {std::string(praise), hit.center + Vec2{0, Real(-1.2)}, palette::kAccent,
                   Real(0.8), 0, true});
    }
}

void Juice::onEvent(const Game& game, const Welded& weld) {
    burst({weld.point, {0, 1}, tints().of(Power::Weld), 40, 8, Real(0.6)});
    say(game, {"welded", weld.point + Vec2{0, Real(0.8)}, tints().of(Power::Weld), Real(0.55)});
}

void Juice::onEvent(const Game& game, const KnockedOff& off) {
    burst(blastOf(off.point, tints().of(Power::Weld), 24, 8));
    push(Real(0.25));
    say(game, {"knocked off", off.point + Vec2{0, Real(0.8)}, palette::kQuiet, Real(0.5)});
}

void Juice::onEvent(const Game&, const Launched& launch) {
    burst({launch.point, {0, -1}, tints().of(Power::Launch), 40, 10, Real(0.5)});
    push(Real(0.3));
}

void Juice::onEvent(const Game&, const Spent& end) {
    burst(blastOf(end.point, tints().of(Power::Launch), 30, 9));
}

void Juice::onEvent(const Game& game, const BallSplit& split) {
    burst({split.point, {}, tints().of(Power::Split), 50, 10, Real(0.8)});
    const std::string text =
        split.balls == 1 ? "1 ball more" : std::to_string(split.balls) + " balls more";
    say(game, {text, split.point + Vec2{0, Real(1.1)}, tints().of(Power::Split), Real(0.6)});
}

void Juice::onEvent(const Game&, const BallLost& lost) {
    burst({{lost.point.x, 0}, {0, 1}, palette::kDanger, 40, 11, Real(0.8)});
}

void Juice::onEvent(const Game&, const LifeLost&) {
    push(Real(0.7));
    flashes_.light(palette::kDanger, 0.55f);
}

void Juice::onEvent(const Game&, const Cleared&) {
    flashes_.light(palette::kAccent, 0.4f);
}

void Juice::onEvent(const Game&, const ShardBroke& hit) {
    burst(blastOf(hit.point, tints().of(hit.stuff), 3 + countFor(weightOf(hit.impulse), 8), 5));
}

void Juice::onEvent(const Game& game, const LetGo& let) {
    burst(blastOf(let.point, tints().of(let.stuff), 16, 4));
    push(let.why == LetGo::Why::BrokeOff ? Real(0.3) : Real(0.16));
    if (let.why == LetGo::Why::Toppled) {
        debris_.add({let.point, {}, faded(tints().of(let.stuff), 1), 2, 2, 3, Real(1.1)},
                    share(settings_.particles));
    }
    if (let.why == LetGo::Why::Torn) {
        say(game, {"torn off", let.point, palette::kAccent, Real(0.5)});
    }
}

void Juice::onEvent(const Game& game, const Landed& landed) {
    const Vec2 seen{landed.point.x, std::max(landed.point.y, Real(1.2))};
    say(game, {"", seen, palette::kText, Real(0.45), landed.points});
    const Real weight = weightOf(landed.impulse);
    push(Real(0.12) * weight);
    debris_.add({landed.point,
                 {0, 1},
                 faded(tints().of(landed.stuff), 1),
                 3 + countFor(weight, 4),
                 1 + countFor(weight, 4),
                 3 + 3 * weight,
                 Real(1.1) + Real(0.5) * weight},
                share(settings_.particles));
}

void Juice::onEvent(const Game& game, const Collapsed& collapse) {
    const Real size = Real(0.6) + Real(0.06) * static_cast<Real>(std::min(collapse.blocks, 12));
    const Vec2 seen{collapse.point.x, std::max(collapse.point.y, Real(3))};
    say(game, {fallText(collapse.blocks), seen, palette::kAccent, size, 0, true});
    push(Real(0.04) * static_cast<Real>(std::min(collapse.blocks, 12)));
    if (collapse.blocks >= kGreatFall) {
        flashes_.light(palette::kAccent, 0.25f);
    }
}

void Juice::onEvent(const Game& game, const Snapped& snap) {
    burst(blastOf(snap.point, palette::kMachine, 14, 7));
    push(Real(0.15));
    say(game, {"snap", snap.point, palette::kQuiet, Real(0.45)});
}

void Juice::onEvent(const Game& game, const Breached& breach) {
    push(Real(0.5));
    debris_.add({breach.point, {0, -1}, palette::kFoam, 16, 0, 9}, share(settings_.particles));
    say(game, {"the water runs out", breach.point + Vec2{0, Real(1.2)}, palette::kFoam, Real(0.7)});
}

void Juice::onEvent(const Game& game, const PatienceChanged& change) {
    if (!game.state().armed()) {
        return; // with a hollow ball all mounts hold
    }
    const Block* next = game.state().nextToFall();
    if (next == nullptr) {
        return;
    }
    if (change.patience == Patience::Glowing) {
        const kodo::BodyView body = game.world()[next->body];
        const Vec2 middle = body.massFrame() * body.part(next->part).convex.middle;
        say(game, {"pull now", middle - Vec2{0, Real(2.1)}, palette::kAccent, Real(0.45)});
    }
    if (change.patience == Patience::Shaking) {
        say(game, {soonText(*next), {0, 5}, palette::kAccent, Real(0.6)});
    }
}

void Juice::onEvent(const Game& game, const BossDown& down) {
    push(1);
    flashes_.light(palette::kAccent, 0.5f);
    firework(down.point, palette::kDanger);
    firework(down.point + Vec2{2, 1}, palette::kAccent);
    firework(down.point + Vec2{-2, 1}, palette::kText);
    say(game, {"boss down!", down.point + Vec2{0, Real(1.5)}, palette::kAccent, Real(1.1)});
}

void Juice::onEvent(const Game&, const Bumped& bump) {
    heat(nameOf(bump.bumper), -bump.normal);
    burst({bump.point, bump.normal, palette::kBumper, 14, 9, Real(0.4)});
    push(Real(0.12));
}

void Juice::onEvent(const Game& game, const PowerBegan& power) {
    const Color color = tints().of(power.power);
    burst(blastOf(power.point, color, 40, 9));
    say(game,
        {std::string(wordsOf(power.power)), power.point + Vec2{0, Real(0.9)}, color, Real(0.55)});
}

void Juice::onEvent(const Game& game, const BallChanged& change) {
    for (Trail& trail : trails_) {
        if (trail.ball == change.before) {
            trail.ball = change.now;
        }
    }
    if (game.world().contains(change.now)) {
        burst(blastOf(game.world()[change.now].center(), palette::kBall, 20, 6));
    }
}

void Juice::onEvent(const Game&, const Leapt& leap) {
    burst({leap.point, {0, -1}, tints().of(Power::Spring), 30, 9, Real(0.4)});
}

void Juice::onEvent(const Game&, const ShardCaught& shard) {
    burst({shard.point, {0, 1}, tints().of(shard.stuff), 6, 5, Real(0.35)});
}

} // namespace apart
