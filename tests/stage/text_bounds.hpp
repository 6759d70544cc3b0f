// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/letterforms.hpp>
#include <apart/stage/records/recording.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "letter_widths.hpp"

/// The room that texts take in a picture.
namespace apart {

/// Pixels. Each letter has a width of whole pixels, as hinting makes it.
inline int widthOf(std::string_view text, Typeface face, int pixels) {
    const auto& widths = kLetterWidths[face == Typeface::Plain ? 0 : 1];
    int sum = 0;
    for (const char sign : text) {
        const auto code = static_cast<unsigned char>(sign);
        if (code >= 0x80 && code < 0xC0) {
            continue; // a later byte of one letter
        }
        const int width = code >= 0x20 && code < 0x7F ? widths[code - 0x20u] : kOtherWidth;
        sum += static_cast<int>(std::lround(width * pixels / 1000.0));
    }
    return sum;
}

/// Size of a text as SfmlCanvas draws it (m): width, and height of its font.
inline Vec2 sizeOf(const Stroke& stroke, const RecordingCanvas& canvas, Real pixelsPerMetre) {
    const TextStyle& style = stroke.style;
    const auto laid =
        style.face == Typeface::Display ? layStones(stroke.text, Real(1)) : std::nullopt;
    if (laid) {
        const Real unit = Real(0.72) * style.height / kCapital;
        const Real width = unit * laid->width;
        const Real less = style.room > 0 ? std::min(style.room / width, Real(1)) : Real(1);
        return {less * width, less * style.height};
    }
    const Real scale = style.face == Typeface::Display ? Real(1) : canvas.textScale();
    auto pixels = static_cast<int>(std::lround(pixelsPerMetre * scale * style.height));
    const Real room = style.room > 0 ? pixelsPerMetre * style.room : Real(1e6);
    while (static_cast<Real>(widthOf(stroke.text, style.face, pixels)) > room && pixels > 4) {
        --pixels;
    }
    const auto width = static_cast<Real>(widthOf(stroke.text, style.face, pixels));
    return {width / pixelsPerMetre, static_cast<Real>(pixels) / pixelsPerMetre};
}

/// Bounds of the letters of a text.
inline Aabb boundsOf(const Stroke& stroke, const RecordingCanvas& canvas, Real pixelsPerMetre) {
    const Vec2 size = sizeOf(stroke, canvas, pixelsPerMetre);
    const Align align = stroke.style.align;
    const Real left = align == Align::Left ? 0 : align == Align::Middle ? size.x / 2 : size.x;
    const bool low = stroke.text.find_first_of("gjpqyQ,;()") != std::string::npos;
    const Vec2 start = stroke.place - Vec2{left, low ? Real(0.2) * size.y : 0};
    return {start, {start.x + size.x, stroke.place.y + Real(0.74) * size.y}};
}

} // namespace apart
