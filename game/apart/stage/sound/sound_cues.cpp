// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/effects/juice.hpp>
#include <apart/stage/sound/sound_cues.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr std::uint32_t kPause = 4;                    // ticks, minimum between two notes of one
                                                       // voice
constexpr float kSoftest = 0.08f;                      // below this volume a note is dropped
constexpr std::array<int, 5> kScale = {0, 2, 4, 7, 9}; // semitones

Voice voiceOf(Stuff stuff) {
    constexpr std::array<Voice, 5> kVoices = {Voice::Glass, Voice::Wood, Voice::Brick, Voice::Stone,
                                              Voice::Steel};
    return kVoices[static_cast<std::size_t>(stuff)];
}

float panOf(kodo::Vec2 point) {
    return std::clamp(0.7f * point.x / layout::kRight, -0.7f, 0.7f);
}

Note noteFor(const Struck& hit) {
    const float volume = weightOf(hit.impulse);
    switch (hit.what) {
    case Role::Wall:
        return {Voice::Wall, 1, 0.55f * volume, panOf(hit.point)};
    case Role::Paddle:
        return {Voice::Paddle, 1, 0.8f * volume, panOf(hit.point)};
    case Role::Block:
    case Role::Shard:
        return {voiceOf(hit.stuff), 1, 0.6f * volume, panOf(hit.point)};
    case Role::Ball:
        return {Voice::Wall, 2.2f, 0.6f * volume, panOf(hit.point)};
    case Role::Part:
        return {Voice::Wood, 1.5f, 0.5f * volume, panOf(hit.point)};
    case Role::Obstruction:
        return {Voice::Steel, 0.75f, 0.4f * volume, panOf(hit.point)};
    }
    return {Voice::Wall, 1, 0, 0};
}
Note noteFor(const Cracked& hit) {
    return {voiceOf(hit.stuff), 1, 0.8f * weightOf(hit.impulse), panOf(hit.point)};
}
Note noteFor(const Broke& hit) {
    return {voiceOf(hit.stuff), comboPitch(hit.combo), 0.5f + 0.5f * weightOf(hit.impulse),
            panOf(hit.point)};
}
Note noteFor(const Welded& weld) {
    return {Voice::Weld, 1, 0.8f, panOf(weld.point)};
}
Note noteFor(const Stuck& stick) {
    return {Voice::Stick, 1, 0.6f, panOf(stick.point)};
}
Note noteFor(const Launched& launch) {
    return {Voice::Fire, 1, 0.8f, panOf(launch.point)};
}
Note noteFor(const BallSplit& split) {
    return {Voice::Split, 1, 0.8f, panOf(split.point)};
}
Note noteFor(const Served& serve) {
    return {Voice::Serve, 1, 0.7f, panOf(serve.point)};
}
Note noteFor(const BallLost& lost) {
    return {Voice::BallLost, lost.ballsLeft > 0 ? 1.5f : 1, lost.ballsLeft > 0 ? 0.4f : 0.9f,
            panOf(lost.point)};
}
Note noteFor(const KnockedOff& off) {
    return {Voice::Wood, 0.7f, 0.8f, panOf(off.point)};
}
Note noteFor(const ShardBroke& hit) {
    return {voiceOf(hit.stuff), 1.6f, 0.4f * weightOf(hit.impulse), panOf(hit.point)};
}
Note noteFor(const LetGo& let) {
    if (let.why == LetGo::Why::Toppled) { // lower for stuffs that are heavier
        constexpr std::array<float, 5> kPitch = {1.5f, 1.25f, 1.0f, 0.8f, 0.65f};
        return {Voice::Rumble, kPitch[static_cast<std::size_t>(let.stuff)], 0.7f, panOf(let.point)};
    }
    return {Voice::Rumble, let.why == LetGo::Why::BrokeOff ? 0.8f : 1, 0.5f, panOf(let.point)};
}
Note noteFor(const Collapsed& collapse) {
    const float size = std::min(static_cast<float>(collapse.blocks) / 12, 1.0f);
    return {Voice::Boss, 1.6f - 0.6f * size, 0.3f + 0.4f * size, panOf(collapse.point)};
}
Note noteFor(const Snapped& snap) {
    return {Voice::Wood, 1.8f, 0.7f, panOf(snap.point)};
}
Note noteFor(const Splashed& splash) {
    return {Voice::Splash, massPitch(splash.mass),
            0.7f * weightOf(splash.mass * std::abs(splash.speed)), panOf(splash.point)};
}
Note noteFor(const Breached& breach) {
    return {Voice::Gush, 1, 0.9f, panOf(breach.point)};
}
Note noteFor(const Landed& landed) {
    const float weight = weightOf(landed.impulse);
    return {voiceOf(landed.stuff), 0.5f - 0.1f * weight, 0.45f + 0.55f * weight,
            panOf(landed.point)};
}
Note noteFor(const BossDown& down) {
    return {Voice::Boss, 1, 1, panOf(down.point)};
}
Note noteFor(const Bumped& bump) {
    return {Voice::Bumper, 1, 0.7f, panOf(bump.point)};
}
Note noteFor(const PowerBegan& power) {
    const bool bad = moodOf(power.power) == Mood::Bad;
    return {bad ? Voice::Bad : Voice::Good, moodOf(power.power) == Mood::Mixed ? 0.84f : 1, 0.8f,
            panOf(power.point)};
}
Note noteFor(const PowerEnded&) {
    return {Voice::Over, 1, 0.5f, 0};
}
Note noteFor(const Leapt& leap) {
    return {Voice::Bumper, 0.6f, 0.6f, panOf(leap.point)};
}
Note noteFor(const ForceChanged& change) {
    return {change.force == Force::Push ? Voice::Push : Voice::Pull, 1,
            change.force == Force::None ? 0.0f : 0.45f, 0};
}
Note noteFor(const ShardCaught& shard) {
    return {Voice::Gulp, 1 + 0.8f * shard.meter, 0.35f, panOf(shard.point)};
}
Note noteFor(const PatienceChanged& change) {
    const auto stage = static_cast<float>(change.patience);
    return {Voice::Rumble, 0.6f + 0.15f * stage, change.patience == Patience::Calm ? 0.0f : 0.4f,
            0};
}
Note noteFor(const Lost&) {
    return {Voice::GameOver, 1, 1, 0};
}
template <typename Other>
Note noteFor(const Other&) { // silent, or voiced elsewhere: Cleared by the fanfare
    return {Voice::Wall, 1, 0, 0};
}

} // namespace

float comboPitch(int combo) {
    const int step = std::clamp(combo - 1, 0, 10);
    const int semitones = 12 * (step / 5) + kScale[static_cast<std::size_t>(step % 5)];
    return std::exp2(static_cast<float>(semitones) / 12);
}

Note noteOf(const Event& event) {
    return std::visit([](const auto& what) { return noteFor(what); }, event);
}

float massPitch(float mass) {
    constexpr float kUsual = 0.6f; // kg, a brick of the grid
    return std::clamp(std::cbrt(kUsual / std::max(mass, 1e-3f)), 0.5f, 1.5f);
}

SoundScene sceneOf(const Game& game) {
    constexpr float kRoar = 20;    // kg m/s, of the loudest rumble
    constexpr float kRow = 8;      // blocks of the highest combo
    constexpr kodo::Real kLow = 4; // m, height from which on a falling ball is in danger
    SoundScene scene;
    scene.theme = game.level().theme;
    scene.won = game.result() == Result::Won;
    const int row = std::max<int>(game.counts().combo, game.collapse().blocks);
    scene.combo = std::clamp(static_cast<float>(row) / kRow, 0.0f, 1.0f);
    float momentum = 0;
    for (const Block& block : game.blocks()) {
        const kodo::BodyView body = game.world()[block.body];
        const bool falls = block.support == Support::Fallen || block.support == Support::Loose;
        if (falls && !body.isAsleep()) {
            momentum += body.mass() * length(body.velocity());
        }
    }
    scene.rumble = std::clamp(momentum / kRoar, 0.0f, 1.0f);
    const bool last = game.lives() <= 1;
    scene.danger = last ? 0.6f : 0.0f;
    for (const Ball& ball : game.balls()) {
        const kodo::BodyView body = game.world()[ball.body];
        if (!ball.riding && body.center().y < kLow && body.velocity().y < 0) {
            scene.danger = last ? 1.0f : 0.5f;
        }
    }
    return scene;
}

void SoundCues::weigh(const Game& game) {
    weights_.clear();
    for (const Block& block : game.blocks()) {
        weights_.push_back({block.body, game.world()[block.body].mass()});
    }
    for (const Shard& shard : game.shards()) {
        weights_.push_back({shard.body, game.world()[shard.body].mass()});
    }
    std::sort(weights_.begin(), weights_.end(),
              [](const Weight& a, const Weight& b) { return a.body.index < b.body.index; });
}

/// 1 for events without a struck block or shard.
float SoundCues::massPitchOf(const Event& event) const {
    kodo::BodyId body;
    if (const auto* struck = std::get_if<Struck>(&event)) {
        body = struck->other;
    } else if (const auto* cracked = std::get_if<Cracked>(&event)) {
        body = cracked->block;
    } else if (const auto* broke = std::get_if<Broke>(&event)) {
        body = broke->block;
    } else if (const auto* shard = std::get_if<ShardBroke>(&event)) {
        body = shard->shard;
    } else if (const auto* let = std::get_if<LetGo>(&event)) {
        body = let->block;
    }
    const auto found = std::lower_bound(
        weights_.begin(), weights_.end(), body,
        [](const Weight& weight, kodo::BodyId id) { return weight.body.index < id.index; });
    return found != weights_.end() && found->body == body ? massPitch(found->mass) : 1.0f;
}

void SoundCues::play(std::span<const Event> events, std::uint32_t tick, float volume,
                     Speaker& speaker) {
    const auto play = [&](Note note) {
        note.volume *= volume * dice_.between(0.88f, 1.0f);
        note.pitch *= dice_.between(0.985f, 1.015f);
        note.variant = static_cast<std::uint8_t>(dice_.next() % kVariants);
        std::uint32_t& last = lastTick_[static_cast<std::size_t>(note.voice)];
        if (note.volume < kSoftest || (last != 0 && tick + 1 - last < kPause)) {
            return;
        }
        last = tick + 1;
        speaker.play(note);
    };
    for (const Event& event : events) {
        Note note = noteOf(event);
        const float pitch = massPitchOf(event);
        note.pitch *= pitch;
        play(note);
        if (const auto* broke = std::get_if<Broke>(&event)) {
            play({Voice::Break, pitch, 0.6f * (0.4f + 0.6f * weightOf(broke->impulse)),
                  panOf(broke->point)});
        }
    }
}

} // namespace apart
