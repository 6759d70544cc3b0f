// SPDX-License-Identifier: MIT
#pragma once

#include <apart/front/mesh_canvas.hpp>
#include <apart/web/glyphs.hpp>

#include <array>
#include <cstdint>

namespace apart {

/// Canvas whose picture WebGL 2 draws into the canvas element of the page.
class WebCanvas final : public MeshCanvas {
public:
    explicit WebCanvas(kodo_draw::Size pixels) : MeshCanvas(pixels) {}

    /// Makes program and textures: needs a current context. Again after the context was lost.
    void makeResources();
    /// Draws the picture.
    void show(kodo_draw::Size pixels);

private:
    kodo_draw::Mesh& mesh() override { return mesh_; }
    float textWidth(Typeface face, std::string_view utf8, unsigned heightPixels) override;
    void addText(Typeface face, std::string_view utf8, unsigned heightPixels,
                 kodo_draw::Pixel start, kodo_draw::Rgba color) override;

    kodo_draw::Mesh mesh_;
    Glyphs glyphs_;
    std::uint32_t program_ = 0;
    std::uint32_t vertices_ = 0; // buffer
    std::uint32_t edges_ = 0;    // texture
    int pixelsPlace_ = -1;       // of the uniforms
    int texelsPlace_ = -1;
    int fillPlace_ = -1;
};

} // namespace apart
