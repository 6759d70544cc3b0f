// SPDX-License-Identifier: MIT
#pragma once

#include <apart/front/mesh_canvas.hpp>
#include <apart/web/glyphs.hpp>
#include <apart/web/still_part.hpp>

#include <array>
#include <cstdint>
#include <span>

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

    struct Program {
        std::uint32_t name = 0;
        int pixels = -1; // places of uniforms
        int texels = -1;
        int fill = -1;
    };

    static Program makeProgram(const char* fragmentShader);
    void upload(std::span<const kodo_draw::MeshVertex> vertices);
    void restoreTouched();
    /// Draws vertices into the present framebuffer, from one on and before another one.
    void draw(std::size_t begin, std::size_t end);
    void drawRun(const kodo_draw::MeshRun& run, std::size_t begin, std::size_t end);
    void setKeptSize(kodo_draw::Size pixels);

    kodo_draw::Mesh mesh_;
    Glyphs glyphs_;
    StillPart still_;
    TouchedTiles touched_;         // of the canvas, since it had the kept picture
    kodo_draw::Size size_;         // pixels
    kodo_draw::Size keptSize_;     // of the kept picture
    std::uint32_t kept_ = 0;       // its framebuffer
    std::uint32_t keptPixels_ = 0; // its texture
    Program copy_;                 // of the kept picture
    Program plain_;
    Program textured_;
    std::uint32_t vertices_ = 0; // buffer
    std::uint32_t edges_ = 0;    // texture
};

} // namespace apart
