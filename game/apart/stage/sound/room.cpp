// SPDX-License-Identifier: MIT
#include <apart/stage/sound/room.hpp>

namespace apart {

namespace {

struct RoomLook {
    float feedback;
    float damping;
    float wet;
};

/// Open air in the morning, a pit of rock, tents, water, a workshop, a dome, and stone halls.
constexpr std::array<RoomLook, kThemeNames.size()> kRooms = {{
    {0.62f, 0.45f, 0.16f},
    {0.80f, 0.30f, 0.30f},
    {0.55f, 0.60f, 0.14f},
    {0.74f, 0.55f, 0.22f},
    {0.48f, 0.20f, 0.18f},
    {0.88f, 0.35f, 0.34f},
    {0.84f, 0.40f, 0.32f},
}};

// Samples at 44100 Hz; without common factors, so that echoes do not coincide.
constexpr std::array<std::size_t, 4> kCombs = {1116, 1277, 1422, 1617};
constexpr std::array<std::size_t, 2> kAllpasses = {556, 225};
constexpr std::size_t kEarShift = 23;
constexpr float kAllpassGain = 0.5f;
constexpr float kInput = 0.25f; // four combs are added

} // namespace

Room::Room(Theme theme) {
    const RoomLook& look = kRooms[static_cast<std::size_t>(theme)];
    feedback_ = look.feedback;
    damping_ = look.damping;
    wet_ = look.wet;
    for (std::size_t ear = 0; ear < ears_.size(); ++ear) {
        for (std::size_t i = 0; i < kCombs.size(); ++i) {
            ears_[ear].combs[i].line.assign(kCombs[i] + ear * kEarShift, 0.0f);
        }
        for (std::size_t i = 0; i < kAllpasses.size(); ++i) {
            ears_[ear].allpasses[i].line.assign(kAllpasses[i] + ear * kEarShift, 0.0f);
        }
    }
}

float Room::throughEar(Ear& ear, float dry) const {
    float sum = 0;
    for (Delay& comb : ear.combs) {
        float& cell = comb.line[comb.at];
        sum += cell;
        comb.dull += (1 - damping_) * (cell - comb.dull);
        cell = kInput * dry + feedback_ * comb.dull;
        comb.at = comb.at + 1 == comb.line.size() ? 0 : comb.at + 1;
    }
    for (Delay& allpass : ear.allpasses) {
        float& cell = allpass.line[allpass.at];
        const float late = cell;
        cell = sum + kAllpassGain * late;
        sum = late - kAllpassGain * cell;
        allpass.at = allpass.at + 1 == allpass.line.size() ? 0 : allpass.at + 1;
    }
    return sum;
}

Frame Room::next(float dry) {
    // A tiny constant keeps the states out of the range of slow denormal numbers.
    const float in = dry + 1e-12f;
    return {wet_ * throughEar(ears_[0], in), wet_ * throughEar(ears_[1], in)};
}

} // namespace apart
