// SPDX-License-Identifier: MIT
#include <kodo_sfml/display.hpp>

#include <SFML/System/Err.hpp>

#ifdef __linux__
#include <dlfcn.h>
#endif
#include <streambuf>

namespace kodo_sfml {

bool displayAvailable() {
#ifdef __linux__
    // SFML has loaded libX11 into the process. Symbols by name need no X11 headers.
    using OpenDisplay = void* (*)(const char*);
    using CloseDisplay = int (*)(void*);
    const auto open = reinterpret_cast<OpenDisplay>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
    const auto close = reinterpret_cast<CloseDisplay>(dlsym(RTLD_DEFAULT, "XCloseDisplay"));
    if (open == nullptr || close == nullptr) {
        return false;
    }
    void* display = open(nullptr);
    if (display == nullptr) {
        return false;
    }
    close(display);
#endif
    return true;
}

namespace {

class Nowhere : public std::streambuf {
protected:
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
};

} // namespace

QuietSfml::QuietSfml() {
    static Nowhere nowhere;
    before_ = sf::err().rdbuf(&nowhere);
}

QuietSfml::~QuietSfml() {
    sf::err().rdbuf(static_cast<std::streambuf*>(before_));
}

} // namespace kodo_sfml
