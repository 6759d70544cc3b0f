// SPDX-License-Identifier: MIT
#include <apart/web/pixel_share.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

constexpr std::array<double, 3> kShares = {1, 0.75, 0.5};
constexpr double kWindow = 1;         // s
constexpr double kGap = 1;            // s; a page that was hidden tells nothing
constexpr double kLate = 54;          // frames in a second
constexpr int kPatience = 2;          // windows
constexpr double kTrial = 5;          // s
constexpr double kLongestPause = 640; // s
constexpr double kGain = 1.15;        // what fewer pixels must bring, of frames in a second

} // namespace

double PixelShare::share() const {
    return kShares[step_];
}

void PixelShare::next(double seconds) {
    if (seconds > kGap) {
        seconds_ = frames_ = lateWindows_ = 0;
        return;
    }
    seconds_ += seconds;
    ++frames_;
    if (seconds_ >= kWindow) {
        judge(frames_ / seconds_);
        seconds_ = frames_ = 0;
    }
}

void PixelShare::judge(double rate) {
    calm_ += seconds_;
    if (inVain_ && calm_ < pause_) {
        return;
    }
    inVain_ = false;
    if (rate < kLate) {
        late(rate);
    } else {
        inTime();
    }
}

void PixelShare::late(double rate) {
    calm_ = 0;
    if (++lateWindows_ < kPatience && !tries_) {
        return;
    }
    lateWindows_ = 0;
    if (tries_) {
        wait();
    }
    if (step_ == 0) {
        fullRate_ = rate;
    }
    if (step_ + 1 < kShares.size()) {
        ++step_;
    } else if (rate < kGain * fullRate_) {
        step_ = 0;
        inVain_ = true;
        wait();
    }
}

void PixelShare::inTime() {
    lateWindows_ = 0;
    if (tries_ && calm_ >= kTrial) {
        tries_ = false;
        pause_ = kFirstPause;
    }
    if (step_ > 0 && calm_ >= pause_) {
        --step_;
        calm_ = 0;
        tries_ = true;
    }
}

/// The next trial comes later.
void PixelShare::wait() {
    tries_ = false;
    pause_ = std::min(2 * pause_, kLongestPause);
}

} // namespace apart
