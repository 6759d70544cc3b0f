// SPDX-License-Identifier: MIT
#include <apart/stage/sound/mixer.hpp>
#include <apart/stage/sound/synth.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

// Gains that give -16 LUFS in a game with the settings at their start.
constexpr float kEffects = 0.56f;
constexpr float kMusic = 0.605f;
constexpr float kRumble = 1.68f;
constexpr float kSend = 0.5f;                          // share of the music that goes into the room
constexpr float kGlide = 1 / (0.25f * kSampleHertz);   // per sample, of rumble and volume of music
constexpr float kRelease = 1 / (0.12f * kSampleHertz); // per sample, of the limiter
constexpr float kDuck = 0.8f;                          // share of the music that makes way
constexpr float kDuckFast = 1 / (0.08f * kSampleHertz);  // per sample, down
constexpr float kDuckSlow = 1 / (1.0f * kSampleHertz);   // per sample, up
constexpr float kMeanGlide = 1 / (20.0f * kSampleHertz); // per sample, of the mean of the rumble
constexpr float kUsualRumble = 0.22f;                    // that mean in most games
constexpr float kDeep = 0.018f;                          // of the low-pass filters of the rumble
constexpr float kRough = 0.25f;                          // of that of the roar

/// What may be cut off for what: a higher number is more important.
int priorityOf(Voice voice) {
    switch (voice) {
    case Voice::Cleared:
    case Voice::GameOver:
    case Voice::BallLost:
    case Voice::Boss:
        return 3;
    case Voice::Wall:
    case Voice::Gulp:
    case Voice::Choose:
        return 0;
    case Voice::Glass:
    case Voice::Wood:
    case Voice::Brick:
    case Voice::Stone:
    case Voice::Steel:
        return 1;
    default:
        return 2;
    }
}

} // namespace

void Mixer::play(const Note& note) {
    constexpr std::size_t kMost = 64; // if nothing renders
    const std::lock_guard lock(mutex_);
    if (notes_.size() < kMost) {
        notes_.push_back(note);
    }
}

void Mixer::follow(const SoundScene& scene) {
    const std::lock_guard lock(mutex_);
    wanted_ = scene;
}

const Mixer::Sound& Mixer::soundOf(Voice voice, std::uint8_t variant) {
    Sound& sound = bank_[static_cast<std::size_t>(voice) * kVariants + variant % kVariants];
    if (sound.empty()) {
        sound = synthesise(voice, variant % kVariants);
    }
    return sound;
}

/// Synthesises one more sound in advance.
void Mixer::prepareNext() {
    if (prepared_ < bank_.size()) {
        soundOf(static_cast<Voice>(prepared_ / kVariants),
                static_cast<std::uint8_t>(prepared_ % kVariants));
        ++prepared_;
    }
}

void Mixer::takeNotes() {
    taken_.clear();
    {
        const std::lock_guard lock(mutex_);
        taken_.swap(notes_);
        scene_ = wanted_;
    }
    for (const Note& note : taken_) {
        begin(note);
    }
    if (theme_ != scene_.theme) {
        theme_ = scene_.theme;
        room_.emplace(*theme_);
        music_.emplace(*theme_);
        musicNow_ = 0; // fades in
    }
}

/// Takes a free channel, or that of the least important voice: of equal ones, the oldest.
void Mixer::begin(const Note& note) {
    const auto worth = [](const Channel& channel) {
        if (channel.sound == nullptr) {
            return -1.0;
        }
        const double left = 1 - channel.at / static_cast<double>(channel.sound->size());
        return priorityOf(channel.note.voice) + 0.99 * std::max(left, 0.0);
    };
    auto least = channels_.begin();
    for (auto channel = channels_.begin(); channel != channels_.end(); ++channel) {
        least = worth(*channel) < worth(*least) ? channel : least;
    }
    if (worth(*least) < priorityOf(note.voice) + 1) {
        *least = {&soundOf(note.voice, note.variant), 0, note};
    }
}

Frame Mixer::voices(float& send) {
    Frame sum;
    for (Channel& channel : channels_) {
        if (channel.sound == nullptr) {
            continue;
        }
        const Sound& sound = *channel.sound;
        const auto index = static_cast<std::size_t>(channel.at);
        if (index + 1 >= sound.size()) {
            channel.sound = nullptr;
            continue;
        }
        const auto share = static_cast<float>(channel.at - static_cast<double>(index));
        const float sample = sound[index] + share * (sound[index + 1] - sound[index]);
        const float loud = channel.note.volume * sample;
        sum.left += loud * (0.7f - 0.5f * channel.note.pan);
        sum.right += loud * (0.7f + 0.5f * channel.note.pan);
        send += loud;
        channel.at += static_cast<double>(channel.note.pitch);
    }
    return sum;
}

/// What all that falls sounds like together: a low noise, a roar above it, and the cracks of
/// single pieces. It is softer where much falls, and louder after a calm.
Frame Mixer::rumble() {
    constexpr float kCracks = 150 / kSampleHertz;                            // per sample, at most
    static const float kCrackFades = std::exp(-1 / (0.012f * kSampleHertz)); // per sample
    rumbleNow_ += kGlide * (scene_.rumble * scene_.volume - rumbleNow_);
    rumbleMean_ += kMeanGlide * (rumbleNow_ - rumbleMean_);
    if (rumbleNow_ < 1e-4f) {
        return {};
    }
    const float noise = dice_.between(-1, 1);
    growl_[0] += kDeep * (noise - growl_[0]);
    growl_[1] += kDeep * (growl_[0] - growl_[1]);
    roar_ += kRough * (noise - roar_);
    crack_ *= kCrackFades;
    if (dice_.between(0, 1) < kCracks * rumbleNow_) {
        crack_ = dice_.between(0.2f, 1);
        crackSide_ = dice_.between(-0.4f, 0.4f);
    }
    const float loud = rumbleNow_ * kUsualRumble / std::max(rumbleMean_, kUsualRumble / 2);
    const float low = 4 * loud * growl_[1];
    const float rough = loud * (0.45f + 0.9f * crack_) * (roar_ - growl_[0]);
    return {low + rough * (1 - crackSide_), low + rough * (1 + crackSide_)};
}

/// The music makes way for what falls, and comes back slowly.
void Mixer::duck() {
    const float wanted = std::min(2 * scene_.rumble * scene_.volume, 1.0f);
    duckNow_ += (wanted > duckNow_ ? kDuckFast : kDuckSlow) * (wanted - duckNow_);
}

/// Lowers the gain at once where the ceiling would be exceeded, and raises it slowly.
Frame Mixer::limited(Frame sum) {
    const float peak = std::max(std::abs(sum.left), std::abs(sum.right));
    gain_ += kRelease * (1 - gain_);
    if (peak * gain_ > kCeiling) {
        gain_ = kCeiling / peak;
    }
    return {gain_ * sum.left, gain_ * sum.right};
}

void Mixer::render(std::span<float> samples) {
    takeNotes();
    prepareNext();
    const Tension tension{scene_.combo, scene_.danger, scene_.muffled, scene_.won};
    for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
        float send = 0;
        const Frame effects = voices(send);
        const Frame growl = rumble();
        musicNow_ += kGlide * (scene_.music - musicNow_);
        const Frame tune = musicNow_ > 1e-4f ? music_->next(tension) : Frame{};
        duck();
        const float music = kMusic * musicNow_ * (1 - kDuck * duckNow_);
        const Frame echo = room_->next(kEffects * send + kSend * music * (tune.left + tune.right));
        const Frame out = limited(
            {kEffects * effects.left + kRumble * growl.left + music * tune.left + echo.left,
             kEffects * effects.right + kRumble * growl.right + music * tune.right + echo.right});
        samples[i] = out.left;
        samples[i + 1] = out.right;
    }
}

std::size_t Mixer::sounding() const {
    return static_cast<std::size_t>(
        std::count_if(channels_.begin(), channels_.end(),
                      [](const Channel& channel) { return channel.sound != nullptr; }));
}

} // namespace apart
