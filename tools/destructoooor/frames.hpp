// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workbench.hpp"

namespace destructoooor {

inline constexpr kodo_sfml::Rgba kBackground{30, 33, 40};
inline constexpr kodo_sfml::Size kPixels{1280, 720}; // of a window, at first

/// Durations of one frame (s), part by part.
struct FrameTime {
    double step = 0;    // of the World, with measures and history
    double picture = 0; // triangles of the scene
    double panels = 0;
    double screen = 0;     // OpenGL, and the display; without a graphics card, all pixels
    double processors = 0; // processor time of all threads

    double own() const { return step + picture + panels; }
    double total() const { return own() + screen; }
};

/// Medians and percentiles of frames, in three lines.
std::string textOf(const std::vector<FrameTime>& frames);

/// A room with a pile of circles, boxes and triangles, that falls into it.
kodo::World pileOf(std::size_t bodies);

/// Makes and shows so many frames of a step each, as fast as possible, and prints their times: of
/// what the bench has, or of a pile of so many bodies, if any, first awake, then asleep.
void measureFrames(Workbench& bench, std::size_t frames, std::size_t bodies,
                   const std::string& font);

} // namespace destructoooor
