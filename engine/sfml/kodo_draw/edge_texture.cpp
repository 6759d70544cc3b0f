// SPDX-License-Identifier: MIT
#include <kodo_draw/edge_texture.hpp>

#include <algorithm>
#include <cmath>

namespace kodo_draw {

namespace {

constexpr unsigned kWidth = 128; // texels
constexpr float kTexels = 16;    // of the ramp, for each pixel
constexpr unsigned kRows = 64;   // of strokes: the tent of thin ones, then one for each width
constexpr float kFirst = kThin + kFade; // pixels; half width with the fade, of the second row
constexpr float kStep = 0.25f;          // pixels, from row to row

/// Half width, with the fade, of the strokes of a row.
float halfOfRow(unsigned row) {
    return row < 2 ? 1 : kFirst + kStep * static_cast<float>(row - 2);
}

} // namespace

Pixel rampTexel(float pixels) {
    return {kTexels * pixels, 0.5f};
}

Pixel opaqueTexel() {
    return {kWidth - 0.5f, 0.5f};
}

StrokeProfile strokeProfile(float halfWidth) {
    const auto profile = [](unsigned row, float half, float opacity) {
        const float v = static_cast<float>(row) + 0.5f;
        return StrokeProfile{half, {0, v}, {0.5f * kWidth, v}, {kWidth, v}, opacity, false};
    };
    if (halfWidth < kThin) {
        return profile(1, std::max(2 * halfWidth, 2 * kFade), std::min(halfWidth / kFade, 1.0f));
    }
    const float half = halfWidth + kFade;
    const long row = std::lround((half - kFirst) / kStep) + 2;
    if (row <= static_cast<long>(kRows)) {
        return profile(static_cast<unsigned>(row), half, 1);
    }
    return {half, rampTexel(0), rampTexel(half), rampTexel(0), 1, true};
}

float opacityAt(Pixel texel) {
    const float u = std::clamp(texel.x, 0.0f, static_cast<float>(kWidth));
    const auto row = static_cast<unsigned>(std::max(texel.y, 0.0f));
    if (row == 0) {
        return std::min(u / kTexels, 1.0f);
    }
    const float fromMiddle = std::abs(2 * u / kWidth - 1);
    return std::min((1 - fromMiddle) * halfOfRow(row), 1.0f);
}

Size edgeTextureSize() {
    return {kWidth, kRows + 1};
}

std::vector<std::uint8_t> edgeOpacities() {
    std::vector<std::uint8_t> opacities;
    for (unsigned y = 0; y <= kRows; ++y) {
        for (unsigned x = 0; x < kWidth; ++x) {
            const Pixel middle{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            opacities.push_back(static_cast<std::uint8_t>(255 * opacityAt(middle) + 0.5f));
        }
    }
    return opacities;
}

} // namespace kodo_draw
