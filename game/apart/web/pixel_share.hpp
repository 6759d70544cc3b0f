// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace apart {

/// Which share of the screen's pixels a side the picture has: 1, 0.75 or 0.5. Without a graphics
/// card each pixel costs time, so where frames are late for some seconds the picture gets fewer.
/// Later it tries more again; whenever this fails, the next trial waits twice as long. Where fewer
/// pixels do not help, as with a screen of 30 pictures in a second, it takes all.
class PixelShare {
public:
    /// A frame came so long after the one before (s).
    void next(double seconds);
    double share() const;

private:
    static constexpr double kFirstPause = 10; // s

    void judge(double rate);
    void late(double rate);
    void inTime();
    void wait();

    std::size_t step_ = 0; // of the shares
    double seconds_ = 0;   // of the present window of frames
    int frames_ = 0;       // of it
    int lateWindows_ = 0;  // in a row
    double calm_ = 0;      // s, of frames in time at this share; or since fewer pixels were in vain
    double pause_ = kFirstPause; // s, for which that lasts before another trial
    double fullRate_ = 0;        // frames in a second with all pixels, when they were too many
    bool tries_ = false;         // more pixels, for the first seconds
    bool inVain_ = false;        // were fewer pixels
};

} // namespace apart
