// SPDX-License-Identifier: MIT
#include <apart/web/glyphs.hpp>

#include <GLES3/gl3.h>
#include <emscripten/emscripten.h>

#include <array>
#include <vector>

namespace apart {

namespace {

constexpr unsigned kLargest = 256; // texels; side of the largest letter
constexpr unsigned kGap = 1;       // texels, between letters

// See page.js. `metrics` gets advance, offset x, offset y, width and height (pixels), `opacities`
// width * height bytes.
EM_JS(void, drawLetter,
      (int bold, int height, int letter, float* metrics, unsigned char* opacities, int largest),
      { Module.drawLetter(bold, height, letter, metrics, opacities, largest); });

} // namespace

void Glyphs::makeTexture() {
    glyphs_.clear();
    x_ = y_ = rowHeight_ = 0;
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kWidth, kWidth, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

const Glyph& Glyphs::at(Typeface face, char32_t letter, unsigned heightPixels) {
    const auto key = std::tuple(face, heightPixels, letter);
    const auto found = glyphs_.find(key);
    return found != glyphs_.end()
               ? found->second
               : glyphs_.emplace(key, draw(face, letter, heightPixels)).first->second;
}

Glyph Glyphs::draw(Typeface face, char32_t letter, unsigned heightPixels) {
    std::array<float, 5> metrics{};
    std::vector<unsigned char> opacities(kLargest * kLargest);
    drawLetter(face == Typeface::Plain ? 0 : 1, static_cast<int>(heightPixels),
               static_cast<int>(letter), metrics.data(), opacities.data(),
               static_cast<int>(kLargest));
    const auto width = static_cast<unsigned>(metrics[3]);
    const auto rows = static_cast<unsigned>(metrics[4]);
    Glyph glyph{metrics[0], {metrics[1], metrics[2]}, {}};
    if (x_ + width > kWidth) {
        x_ = 0;
        y_ += rowHeight_ + kGap;
        rowHeight_ = 0;
    }
    if (width == 0 || y_ + rows > kWidth) {
        return glyph; // full: not drawn until tidy()
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(x_), static_cast<GLint>(y_),
                    static_cast<GLsizei>(width), static_cast<GLsizei>(rows), GL_RED,
                    GL_UNSIGNED_BYTE, opacities.data());
    glyph.part = {static_cast<float>(x_), static_cast<float>(y_), metrics[3], metrics[4]};
    x_ += width + kGap;
    rowHeight_ = rowHeight_ > rows ? rowHeight_ : rows;
    return glyph;
}

void Glyphs::tidy() {
    if (y_ > 3 * kWidth / 4) {
        glDeleteTextures(1, &texture_);
        makeTexture();
    }
}

} // namespace apart
