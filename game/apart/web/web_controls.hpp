// SPDX-License-Identifier: MIT
#pragma once

#include <apart/front/held_keys.hpp>
#include <apart/web/web_canvas.hpp>

#include <emscripten/html5.h>

#include <array>
#include <optional>
#include <string_view>

namespace apart {

/// Keyboard, mouse, touch screen and gamepad of a page.
///
/// Touch: a finger that moves, moves the paddle; a tap serves; a finger that rests aims until it is
/// lifted; a second finger pulls, a third one pushes instead. In menus a finger is a mouse.
class WebControls final : public Controls {
public:
    explicit WebControls(const MeshCanvas& canvas);

    void setBindings(const Bindings& bindings) { keys_.setBindings(bindings); }
    Signals poll() override;
    void capture(bool on) override;
    /// Pixels of the picture for each pixel of the page.
    void setDensity(double density) { density_ = static_cast<float>(density); }
    /// The width (pixels) of a page that shows the picture turned clockwise by a quarter; 0: as it
    /// is.
    void setTurned(double width) { turned_ = static_cast<float>(width); }
    /// A command of a button of the page.
    void give(Command command) { signals_.commands.push_back(command); }
    /// The page was left: nothing is held any more, and the game pauses.
    void loseFocus();
    /// True if a key, a button or a finger went down since the last call: only then a browser
    /// allows sound.
    bool takePress();

private:
    struct Finger {
        long id = 0;
        kodo_draw::Pixel start; // as onPicture()
        kodo_draw::Pixel last;
        double since = 0; // ms
        bool moved = false;
        bool aims = false; // holds the serve
    };

    bool onKey(int type, const EmscriptenKeyboardEvent& event);
    bool onMouse(int type, const EmscriptenMouseEvent& event);
    bool onWheel(const EmscriptenWheelEvent& event);
    bool onTouch(int type, const EmscriptenTouchEvent& event);
    void pollPad();
    /// Pixels of the page, from the upper left corner of the picture.
    kodo_draw::Pixel onPicture(long x, long y) const;
    Vec2 fieldPoint(kodo_draw::Pixel page) const;
    void movePointer(kodo_draw::Pixel page);
    void pressLong();
    void tap(const Finger& finger);

    const MeshCanvas& canvas_;
    HeldKeys keys_;
    Signals signals_;               // since the last poll()
    std::array<bool, 2> buttons_{}; // left, right
    std::optional<Finger> finger_;
    int fingers_ = 0; // on the screen
    bool dragging_ = false;
    bool captured_ = false;
    bool pressed_ = false;
    Vec2 pointer_;                         // m
    std::optional<kodo_draw::Pixel> page_; // where the pointer was last, in pixels of the page
    float density_ = 1;                    // pixels of the picture for one of the page
    float turned_ = 0;                     // pixels
};

/// The key of kKeyNames for the `code` of a keyboard event, or kNoKey.
int keyOfCode(std::string_view code);

} // namespace apart
