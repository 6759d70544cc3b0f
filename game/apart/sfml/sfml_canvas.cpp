// SPDX-License-Identifier: MIT
#include <apart/sfml/sfml_canvas.hpp>

#include <stdexcept>
#include <string>

namespace apart {

SfmlCanvas::SfmlCanvas(const std::filesystem::path& fonts, kodo_draw::Size pixels)
    : MeshCanvas(pixels) {
    const std::array<const char*, 2> files = {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"};
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string path = (fonts / files[i]).string();
        if (!fonts_[i].loadFromFile(path)) {
            throw std::runtime_error("The font " + path + " cannot be read.");
        }
    }
}

float SfmlCanvas::textWidth(Typeface face, std::string_view utf8, unsigned heightPixels) {
    return kodo_sfml::textWidth(fontOf(face), utf8, heightPixels);
}

void SfmlCanvas::addText(Typeface face, std::string_view utf8, unsigned heightPixels,
                         kodo_draw::Pixel start, kodo_draw::Rgba color) {
    painter_.text(fontOf(face), utf8, heightPixels, start, color);
}

} // namespace apart
