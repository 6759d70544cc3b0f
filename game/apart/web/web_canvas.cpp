// SPDX-License-Identifier: MIT
#include <apart/web/web_canvas.hpp>

#include <GLES3/gl3.h>
#include <kodo_draw/edge_texture.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace apart {

using kodo_draw::Blend;
using kodo_draw::Fill;
using kodo_draw::MeshRun;
using kodo_draw::MeshVertex;
using kodo_draw::Pixel;

namespace {

constexpr const char* kVertexShader = R"(#version 300 es
uniform vec2 pixels;
uniform vec2 texels;
layout(location = 0) in vec2 place;
layout(location = 1) in vec4 color;
layout(location = 2) in vec2 texel;
out vec4 tint;
out vec2 where;
void main() {
    gl_Position = vec4(2.0 * place.x / pixels.x - 1.0, 1.0 - 2.0 * place.y / pixels.y, 0.0, 1.0);
    tint = color;
    where = texel / texels;
})";

// Both textures hold opacities. The colours of shapes are premultiplied, those of letters are not.
constexpr const char* kCopyShader = R"(#version 300 es
precision mediump float;
uniform sampler2D kept;
out vec4 result;
void main() {
    result = texelFetch(kept, ivec2(gl_FragCoord.xy), 0);
})";

constexpr const char* kPlainShader = R"(#version 300 es
precision mediump float;
in vec4 tint;
out vec4 result;
void main() {
    result = tint;
})";

constexpr const char* kTexturedShader = R"(#version 300 es
precision mediump float;
uniform int fill; // a value of Fill
uniform sampler2D opacities;
in vec4 tint;
in vec2 where;
out vec4 result;
void main() {
    float opacity = texture(opacities, where).r;
    result = (fill == 2 ? vec4(tint.rgb * tint.a, tint.a) : tint) * opacity;
})";

std::uint32_t shader(GLenum kind, const char* text) {
    const GLuint made = glCreateShader(kind);
    glShaderSource(made, 1, &text, nullptr);
    glCompileShader(made);
    GLint good = 0;
    glGetShaderiv(made, GL_COMPILE_STATUS, &good);
    if (good == 0) {
        std::string log(1024, '\0');
        glGetShaderInfoLog(made, static_cast<GLsizei>(log.size()), nullptr, log.data());
        std::fprintf(stderr, "apart: a shader is refused: %s\n", log.c_str());
    }
    return made;
}

/// The letters of UTF-8 text; a damaged one is a question mark.
template <typename Take>
void forLetters(std::string_view utf8, Take take) {
    for (std::size_t i = 0; i < utf8.size();) {
        const auto first = static_cast<unsigned char>(utf8[i]);
        const std::size_t size = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
        char32_t letter = size == 1 ? first : first & (0xFFu >> (size + 1));
        for (std::size_t k = 1; k < size && i + k < utf8.size(); ++k) {
            letter = (letter << 6) | (static_cast<unsigned char>(utf8[i + k]) & 0x3Fu);
        }
        take(letter < 0x110000 ? letter : U'?');
        i += size;
    }
}

void setAttribute(GLuint index, GLint parts, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, parts, type, type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE,
                          sizeof(MeshVertex), reinterpret_cast<const void*>(offset));
}

} // namespace

WebCanvas::Program WebCanvas::makeProgram(const char* fragmentShader) {
    const GLuint name = glCreateProgram();
    glAttachShader(name, shader(GL_VERTEX_SHADER, kVertexShader));
    glAttachShader(name, shader(GL_FRAGMENT_SHADER, fragmentShader));
    glLinkProgram(name);
    return {name, glGetUniformLocation(name, "pixels"), glGetUniformLocation(name, "texels"),
            glGetUniformLocation(name, "fill")};
}

void WebCanvas::makeResources() {
    copy_ = makeProgram(kCopyShader);
    plain_ = makeProgram(kPlainShader);
    textured_ = makeProgram(kTexturedShader);
    glGenFramebuffers(1, &kept_);
    glGenTextures(1, &keptPixels_);
    keptSize_ = {};
    glGenBuffers(1, &vertices_);
    glGenTextures(1, &edges_);
    glBindTexture(GL_TEXTURE_2D, edges_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const kodo_draw::Size size = kodo_draw::edgeTextureSize();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, static_cast<GLsizei>(size.x),
                 static_cast<GLsizei>(size.y), 0, GL_RED, GL_UNSIGNED_BYTE,
                 kodo_draw::edgeOpacities().data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glyphs_.makeTexture();
}

void WebCanvas::setKeptSize(kodo_draw::Size pixels) {
    keptSize_ = pixels;
    still_.forget();
    glBindTexture(GL_TEXTURE_2D, keptPixels_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(pixels.x),
                 static_cast<GLsizei>(pixels.y), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, kept_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, keptPixels_, 0);
}

void WebCanvas::upload(std::span<const MeshVertex> vertices) {
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(),
                 GL_STREAM_DRAW);
    setAttribute(0, 2, GL_FLOAT, offsetof(MeshVertex, place));
    setAttribute(1, 4, GL_UNSIGNED_BYTE, offsetof(MeshVertex, color));
    setAttribute(2, 2, GL_FLOAT, offsetof(MeshVertex, texel));
}

void WebCanvas::restoreTouched() {
    const std::vector<MeshVertex> quads = touched_.quads();
    touched_.clear();
    if (quads.empty()) {
        return;
    }
    upload(quads);
    glUseProgram(copy_.name);
    glUniform2f(copy_.pixels, static_cast<float>(size_.x), static_cast<float>(size_.y));
    glBindTexture(GL_TEXTURE_2D, keptPixels_);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(quads.size()));
    glBindTexture(GL_TEXTURE_2D, edges_); // no program reads what it draws into
}

void WebCanvas::drawRun(const MeshRun& run, std::size_t begin, std::size_t end) {
    const bool letters = run.fill == Fill::Image;
    const Program& program = run.fill == Fill::Plain ? plain_ : textured_;
    glUseProgram(program.name);
    glUniform2f(program.pixels, static_cast<float>(size_.x), static_cast<float>(size_.y));
    if (run.fill != Fill::Plain) {
        const kodo_draw::Size size = letters ? kodo_draw::Size{Glyphs::kWidth, Glyphs::kWidth}
                                             : kodo_draw::edgeTextureSize();
        glBindTexture(GL_TEXTURE_2D, letters ? glyphs_.texture() : edges_);
        glUniform2f(program.texels, static_cast<float>(size.x), static_cast<float>(size.y));
        glUniform1i(program.fill, static_cast<int>(run.fill));
    }
    if (run.blend == Blend::Replace) {
        glDisable(GL_BLEND);
    } else {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, letters && run.blend == Blend::Add ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
    }
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(begin), static_cast<GLsizei>(end - begin));
}

void WebCanvas::draw(std::size_t begin, std::size_t end) {
    if (begin == 0) {
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    const auto runs = mesh_.runs();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::size_t last = i + 1 < runs.size() ? runs[i + 1].first : end;
        const std::size_t from = std::max(begin, runs[i].first);
        const std::size_t to = std::min(end, last);
        if (from < to) {
            drawRun(runs[i], from, to);
        }
    }
}

void WebCanvas::show(kodo_draw::Size pixels) {
    size_ = pixels;
    if (keptSize_ != pixels) {
        setKeptSize(pixels);
    }
    glViewport(0, 0, static_cast<GLsizei>(pixels.x), static_cast<GLsizei>(pixels.y));
    const auto vertices = mesh_.vertices();
    const StillPart::Plan plan = still_.next(vertices, mesh_.runs(), pixels);
    if (plan.kept == 0 || plan.keep > 0) {
        touched_.touchAll(pixels);
    }
    if (plan.keep > 0) {
        upload(vertices);
        glBindFramebuffer(GL_FRAMEBUFFER, kept_);
        draw(0, plan.keep);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (plan.kept > 0) {
        restoreTouched();
        touched_.touch(vertices.subspan(plan.kept));
    }
    upload(vertices);
    draw(plan.kept, vertices.size());
    glyphs_.tidy();
}

float WebCanvas::textWidth(Typeface face, std::string_view utf8, unsigned heightPixels) {
    float width = 0;
    forLetters(utf8,
               [&](char32_t letter) { width += glyphs_.at(face, letter, heightPixels).advance; });
    return width;
}

void WebCanvas::addText(Typeface face, std::string_view utf8, unsigned heightPixels, Pixel start,
                        kodo_draw::Rgba color) {
    Pixel pen{std::round(start.x), std::round(start.y)};
    forLetters(utf8, [&](char32_t letter) {
        const Glyph& glyph = glyphs_.at(face, letter, heightPixels);
        if (glyph.part.width > 0) {
            mesh_.image(&glyphs_, glyph.part,
                        {pen.x + glyph.offset.x, pen.y + glyph.offset.y, glyph.part.width,
                         glyph.part.height},
                        color);
        }
        pen.x += glyph.advance;
    });
}

} // namespace apart
