// SPDX-License-Identifier: MIT
#include <apart/web/web_controls.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

namespace apart {

using kodo_draw::Pixel;

namespace {

constexpr const char* kElement = "#canvas";
constexpr float kTapWay = 12;      // pixels of the page; a finger that moves farther does not tap
constexpr double kLongPress = 300; // ms

/// Codes whose names differ from kKeyNames by more than case.
constexpr std::array<std::pair<std::string_view, std::string_view>, 27> kCodes = {{
    {"Escape", "escape"},
    {"ControlLeft", "left ctrl"},
    {"ControlRight", "right ctrl"},
    {"ShiftLeft", "left shift"},
    {"ShiftRight", "right shift"},
    {"AltLeft", "left alt"},
    {"AltRight", "right alt"},
    {"MetaLeft", "left super"},
    {"MetaRight", "right super"},
    {"ContextMenu", "menu"},
    {"BracketLeft", "["},
    {"BracketRight", "]"},
    {"Semicolon", "semicolon"},
    {"Comma", "comma"},
    {"Period", "period"},
    {"Quote", "quote"},
    {"Slash", "slash"},
    {"Backslash", "backslash"},
    {"Backquote", "tilde"},
    {"Equal", "equal"},
    {"Minus", "hyphen"},
    {"PageUp", "page up"},
    {"PageDown", "page down"},
    {"NumpadAdd", "add"},
    {"NumpadSubtract", "subtract"},
    {"NumpadMultiply", "multiply"},
    {"NumpadDivide", "divide"},
}};

std::string lowered(std::string_view text) {
    std::string low(text);
    std::transform(low.begin(), low.end(), low.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return low;
}

/// Index of the left and the right button of a mouse, or nothing.
std::optional<std::size_t> sideOf(unsigned short button) {
    return button == 0   ? std::optional<std::size_t>(0)
           : button == 2 ? std::optional<std::size_t>(1)
                         : std::nullopt;
}

} // namespace

int keyOfCode(std::string_view code) {
    const auto named = [](std::string_view name) { return keyNamed(name).value_or(kNoKey); };
    for (const auto& [from, to] : kCodes) {
        if (from == code) {
            return named(to);
        }
    }
    if (code.starts_with("Key") && code.size() == 4) {
        return named(code.substr(3));
    }
    if (code.starts_with("Digit")) {
        return named(code.substr(5));
    }
    if (code.starts_with("Arrow")) {
        return named(lowered(code.substr(5)));
    }
    if (code.starts_with("Numpad")) {
        return code == "NumpadEnter" ? named("enter") : named("pad " + lowered(code.substr(6)));
    }
    const int key = named(code); // F1 and on
    return key != kNoKey ? key : named(lowered(code));
}

WebControls::WebControls(const MeshCanvas& canvas) : canvas_(canvas) {
    const auto key = [](int type, const EmscriptenKeyboardEvent* event, void* self) -> EM_BOOL {
        return static_cast<WebControls*>(self)->onKey(type, *event) ? EM_TRUE : EM_FALSE;
    };
    emscripten_set_keydown_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, key);
    emscripten_set_keyup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, key);
    const auto mouse = [](int type, const EmscriptenMouseEvent* event, void* self) -> EM_BOOL {
        return static_cast<WebControls*>(self)->onMouse(type, *event) ? EM_TRUE : EM_FALSE;
    };
    emscripten_set_mousedown_callback(kElement, this, EM_FALSE, mouse);
    emscripten_set_mouseup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, mouse);
    emscripten_set_mousemove_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, mouse);
    emscripten_set_wheel_callback(
        kElement, this, EM_FALSE,
        [](int, const EmscriptenWheelEvent* event, void* self) -> EM_BOOL {
            return static_cast<WebControls*>(self)->onWheel(*event) ? EM_TRUE : EM_FALSE;
        });
    const auto touch = [](int type, const EmscriptenTouchEvent* event, void* self) -> EM_BOOL {
        return static_cast<WebControls*>(self)->onTouch(type, *event) ? EM_TRUE : EM_FALSE;
    };
    emscripten_set_touchstart_callback(kElement, this, EM_FALSE, touch);
    emscripten_set_touchmove_callback(kElement, this, EM_FALSE, touch);
    emscripten_set_touchend_callback(kElement, this, EM_FALSE, touch);
    emscripten_set_touchcancel_callback(kElement, this, EM_FALSE, touch);
    emscripten_set_blur_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE,
                                 [](int, const EmscriptenFocusEvent*, void* self) -> EM_BOOL {
                                     static_cast<WebControls*>(self)->loseFocus();
                                     return EM_FALSE;
                                 });
    // The browser releases a locked mouse when the player presses escape; the game pauses then.
    emscripten_set_pointerlockchange_callback(
        EMSCRIPTEN_EVENT_TARGET_DOCUMENT, this, EM_FALSE,
        [](int, const EmscriptenPointerlockChangeEvent* event, void* self) -> EM_BOOL {
            auto& controls = *static_cast<WebControls*>(self);
            if (!event->isActive && controls.captured_) {
                controls.give(Command::Back);
            }
            return EM_FALSE;
        });
}

Signals WebControls::poll() {
    pollPad();
    pressLong();
    Signals signals = std::exchange(signals_, {});
    keys_.addHeld(buttons_, signals);
    signals.pullHeld |= captured_ && fingers_ == 2;
    signals.pushHeld |= captured_ && fingers_ > 2;
    signals.serveHeld |= finger_ && finger_->aims;
    signals.pointerNow = pointer_;
    signals.dragging = dragging_ && !captured_;
    return signals;
}

void WebControls::capture(bool on) {
    if (on == captured_) {
        return;
    }
    captured_ = on;
    keys_.setInGame(on);
    buttons_ = {};
    if (finger_) {
        finger_->moved = true; // it taps on no other screen than that on which it was put down
    }
    if (!on) {
        emscripten_exit_pointerlock();
    }
}

bool WebControls::takePress() {
    return std::exchange(pressed_, false);
}

bool WebControls::onKey(int type, const EmscriptenKeyboardEvent& event) {
    const int key = keyOfCode(event.code);
    if (key == kNoKey || std::strcmp(event.code, "Tab") == 0 || event.ctrlKey || event.metaKey ||
        (event.altKey && type != EMSCRIPTEN_EVENT_KEYUP)) {
        return false; // the browser's own; Tab leads to the buttons of the page
    }
    if (type == EMSCRIPTEN_EVENT_KEYUP) {
        keys_.release(key);
        return true;
    }
    if (!event.repeat) {
        pressed_ = true;
        keys_.press(key, signals_);
    }
    return std::strncmp(event.code, "F", 1) != 0 || std::strlen(event.code) > 3; // not F5, F11, F12
}

Pixel WebControls::onPicture(long x, long y) const {
    const Pixel page{static_cast<float>(x), static_cast<float>(y)};
    return turned_ > 0 ? Pixel{page.y, turned_ - page.x} : page;
}

Vec2 WebControls::fieldPoint(Pixel page) const {
    return canvas_.camera().toWorld(density_ * page);
}

/// Only a pointer that moves points at something. A browser also tells where it rests when the page
/// or its size changes, and when a button is let go that has opened a menu below it.
void WebControls::movePointer(Pixel page) {
    pointer_ = fieldPoint(page);
    const Pixel before = std::exchange(page_, page).value_or(page);
    if (!captured_ && (page.x != before.x || page.y != before.y)) {
        signals_.pointer = pointer_;
    }
}

bool WebControls::onMouse(int type, const EmscriptenMouseEvent& event) {
    const Pixel page = onPicture(event.clientX, event.clientY);
    movePointer(page);
    if (type == EMSCRIPTEN_EVENT_MOUSEMOVE) {
        if (captured_) {
            const Pixel before{page.x - static_cast<float>(event.movementX), page.y};
            signals_.moved += pointer_.x - fieldPoint(before).x;
        }
        return false;
    }
    const std::optional<std::size_t> side = sideOf(event.button);
    if (!side) {
        return false;
    }
    const bool down = type == EMSCRIPTEN_EVENT_MOUSEDOWN;
    buttons_[*side] = down && captured_;
    if (*side == 0) {
        signals_.clicked = signals_.clicked || down;
        dragging_ = down;
    }
    if (down) {
        pressed_ = true;
        if (captured_) {
            emscripten_request_pointerlock(kElement, EM_FALSE);
        }
    }
    return down;
}

bool WebControls::onWheel(const EmscriptenWheelEvent& event) {
    if (event.deltaY == 0) {
        return false; // sideways
    }
    signals_.commands.push_back(event.deltaY < 0 ? Command::Up : Command::Down);
    return true;
}

/// A finger that rests in a game for a while holds the serve.
void WebControls::pressLong() {
    const bool rests = captured_ && finger_ && !finger_->moved && !finger_->aims;
    if (rests && emscripten_get_now() - finger_->since > kLongPress) {
        finger_->aims = true;
        signals_.commands.push_back(Command::Launch);
    }
}

void WebControls::tap(const Finger& finger) {
    if (captured_) {
        signals_.commands.push_back(Command::Launch);
    } else {
        movePointer(finger.last);
        signals_.clicked = true;
    }
}

bool WebControls::onTouch(int type, const EmscriptenTouchEvent& event) {
    pressed_ = pressed_ || type == EMSCRIPTEN_EVENT_TOUCHSTART;
    fingers_ = 0;
    for (int i = 0; i < event.numTouches; ++i) {
        const EmscriptenTouchPoint& point = event.touches[i];
        const Pixel page = onPicture(point.clientX, point.clientY);
        const bool ends =
            (type == EMSCRIPTEN_EVENT_TOUCHEND || type == EMSCRIPTEN_EVENT_TOUCHCANCEL) &&
            point.isChanged;
        fingers_ += ends ? 0 : 1;
        if (!finger_ && !ends) {
            finger_ = Finger{point.identifier, page, page, emscripten_get_now()};
            movePointer(page);
            dragging_ = true;
        }
        if (!finger_ || finger_->id != point.identifier) {
            continue;
        }
        const Pixel way = page - finger_->start;
        finger_->moved = finger_->moved || way.x * way.x + way.y * way.y > kTapWay * kTapWay;
        if (captured_) {
            signals_.moved += fieldPoint(page).x - fieldPoint(finger_->last).x;
        } else if (finger_->moved) {
            movePointer(page);
        }
        finger_->last = page;
        if (ends) {
            const bool tapped = !finger_->moved && !finger_->aims;
            if (tapped && type == EMSCRIPTEN_EVENT_TOUCHEND) {
                tap(*finger_);
            }
            finger_.reset();
            dragging_ = false;
        }
    }
    return true;
}

void WebControls::loseFocus() {
    signals_.focusLost = true;
    keys_.releaseAll();
    buttons_ = {};
    fingers_ = 0;
    finger_.reset();
    dragging_ = false;
}

/// State of the gamepad of an index; nothing is held if it cannot be read.
static Pad padAt(int index) {
    EmscriptenGamepadEvent pad;
    if (emscripten_get_gamepad_status(index, &pad) != EMSCRIPTEN_RESULT_SUCCESS ||
        pad.numAxes < 1) {
        return {};
    }
    // The standard mapping has the triggers before back and start; a trigger acts as its shoulder.
    constexpr std::array<unsigned, 10> kStandard = {0, 1, 2, 3, 4, 5, 4, 5, 6, 7};
    std::uint32_t held = 0;
    for (std::size_t i = 0; i < kStandard.size() && i < static_cast<std::size_t>(pad.numButtons);
         ++i) {
        held |= pad.digitalButton[i] ? 1u << kStandard[i] : 0u;
    }
    const auto axis = [&](int low, int high) {
        const auto down = [&](int i) { return i < pad.numButtons && pad.digitalButton[i]; };
        return static_cast<float>((down(high) ? 1 : 0) - (down(low) ? 1 : 0));
    };
    return {.stickX = static_cast<float>(pad.axis[0]),
            .stickY = pad.numAxes > 1 ? static_cast<float>(pad.axis[1]) : 0.0f,
            .padX = axis(14, 15),
            .padY = axis(12, 13),
            .held = held};
}

/// The first gamepad is that of the first player; all others are as one.
void WebControls::pollPad() {
    if (emscripten_sample_gamepad_data() != EMSCRIPTEN_RESULT_SUCCESS) {
        return;
    }
    std::array<Pad, kSeats> pads;
    for (int i = 0; i < emscripten_get_num_gamepads(); ++i) {
        Pad& pad = pads[i == 0 ? 0 : kSeats - 1];
        pad = pad.joined(padAt(i));
    }
    const std::size_t before = signals_.presses.size();
    keys_.take(pads, signals_);
    pressed_ = pressed_ || signals_.presses.size() > before;
}

} // namespace apart
