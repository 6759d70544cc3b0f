// SPDX-License-Identifier: MIT
#include <kodo_sfml/display.hpp>

#include <SFML/System/Err.hpp>
#include <SFML/Window/Context.hpp>

#ifdef __linux__
#include <dlfcn.h>
#endif
#include <algorithm>
#include <array>
#include <streambuf>
#include <string_view>

namespace kodo_sfml {

bool displayAvailable() {
#ifdef __linux__
    // SFML has loaded libX11 into the process. Symbols by name need no X11 headers.
    using OpenDisplay = void* (*)(const char*);
    const auto open = reinterpret_cast<OpenDisplay>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
    // Stays open until the program ends: a server that is reset when its last client leaves, as
    // Xvfb is, could otherwise refuse the window that is opened next.
    static void* display = nullptr;
    if (display == nullptr && open != nullptr) {
        display = open(nullptr);
    }
    return display != nullptr;
#else
    return true;
#endif
}

namespace {

/// True if the name of a renderer of OpenGL is one of Mesa's or Windows's software renderers.
bool drawsInSoftware(std::string_view renderer) {
    constexpr std::array<std::string_view, 5> kNames = {"llvmpipe", "softpipe", "swrast",
                                                        "Software", "GDI Generic"};
    return std::any_of(kNames.begin(), kNames.end(), [&](std::string_view name) {
        return renderer.find(name) != std::string_view::npos;
    });
}

class Nowhere : public std::streambuf {
protected:
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
};

} // namespace

bool softwareRendering() {
    const sf::Context context;
    using GetString = const unsigned char* (*)(unsigned);
    const auto getString = reinterpret_cast<GetString>(sf::Context::getFunction("glGetString"));
    constexpr unsigned kRenderer = 0x1F01; // GL_RENDERER
    const unsigned char* name = getString != nullptr ? getString(kRenderer) : nullptr;
    return name == nullptr || drawsInSoftware(reinterpret_cast<const char*>(name));
}

QuietSfml::QuietSfml() {
    static Nowhere nowhere;
    before_ = sf::err().rdbuf(&nowhere);
}

QuietSfml::~QuietSfml() {
    sf::err().rdbuf(static_cast<std::streambuf*>(before_));
}

} // namespace kodo_sfml
