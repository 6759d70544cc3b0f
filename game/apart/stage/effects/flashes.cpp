// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/effects/flashes.hpp>

#include <algorithm>

namespace apart {

namespace {

constexpr float kDim = 0.95f;         // decay of the flash per tick
constexpr double kFlashPause = 0.5;   // s: at most two flashes per second
constexpr Real kCalmHeat = Real(0.2); // of a full one, with reduced flashing

} // namespace

void Flashes::setSettings(const Settings& settings) {
    strength_ = share(settings.flash);
    calm_ = settings.calm > 0;
}

void Flashes::tick() {
    pause_ -= 1 / (kTicksPerSecond * std::max(pace_, 1.0));
    field_ *= kDim;
    for (Glint& glint : glints_) {
        ++glint.age;
    }
    std::erase_if(glints_, [](const Glint& glint) { return glint.age >= Glint::kTicks; });
}

void Flashes::light(Color color, float strength) {
    if (calm_ || pause_ > 0) {
        return;
    }
    pause_ = kFlashPause;
    color_ = color;
    field_ = strength * strength_;
}

Real Flashes::heat() const {
    return calm_ ? kCalmHeat : Real(1);
}

} // namespace apart
