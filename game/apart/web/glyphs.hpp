// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>

#include <kodo_draw/values.hpp>

#include <cstdint>
#include <map>
#include <tuple>

namespace apart {

/// One letter of a typeface in one height.
struct Glyph {
    float advance = 0;       // pixels, to the next letter
    kodo_draw::Pixel offset; // from the pen on the base line to the upper left corner
    kodo_draw::Rect part;    // texels; no area: nothing to draw
};

/// Letters that the browser has drawn, in one texture of opacities. They are drawn when they are
/// first used.
class Glyphs {
public:
    static constexpr unsigned kWidth = 2048; // texels, of each side

    /// Needs a current context; forgets all letters.
    void makeTexture();
    std::uint32_t texture() const { return texture_; }
    const Glyph& at(Typeface face, char32_t letter, unsigned heightPixels);
    /// Call between two pictures: forgets all letters if little room is left.
    void tidy();

private:
    Glyph draw(Typeface face, char32_t letter, unsigned heightPixels);

    std::map<std::tuple<Typeface, unsigned, char32_t>, Glyph> glyphs_;
    std::uint32_t texture_ = 0;
    unsigned x_ = 0; // texels; where the next letter begins
    unsigned y_ = 0;
    unsigned rowHeight_ = 0;
};

} // namespace apart
