// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/screens/key_screen.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

constexpr Real kKeysTop = Real(12.4); // m, top of the first row
constexpr Real kKeysStep = Real(0.98);
constexpr Real kNameRight = Real(-4.6);
constexpr Real kFirstLeft = Real(-3.9);
constexpr Real kKeysColumn = Real(3.9);

constexpr std::array<std::string_view, kActs> kLabels = {
    "left", "right", "pull", "push", "serve", "pause", "start again", "sound on and off"};
constexpr std::array<std::string_view, Bindings::kColumns> kHeads = {"key", "other key", "gamepad"};

constexpr const char* kResetQuestion = "once more to reset the keys and buttons";

bool erases(Press press) {
    return !press.pad && (press.code == keyNamed("delete") || press.code == keyNamed("backspace"));
}

} // namespace

Aabb KeyScreen::cell(std::size_t row, std::size_t column) const {
    const Real gap = row >= kActs ? Real(0.35) : Real(0);
    const Real top = kKeysTop - kKeysStep * static_cast<Real>(row) - gap;
    if (row >= kActs) {
        return {{Real(-4.2), top - kKeysStep + Real(0.1)}, {Real(4.2), top}};
    }
    const Real left = kFirstLeft + kKeysColumn * static_cast<Real>(column);
    return {{left, top - kKeysStep + Real(0.1)}, {left + kKeysColumn - Real(0.3), top}};
}

void KeyScreen::takePress(Press press, Bindings& bindings) {
    const bool pad = column_ == Bindings::kPadColumn;
    if (!press.pad && press.code == keyNamed("escape")) {
        waiting_ = false;
    } else if (press.pad == pad) {
        waiting_ = false;
        notice_ = bindings.bind(static_cast<Act>(row_), column_, press.code);
    }
}

void KeyScreen::point(Vec2 place) {
    for (std::size_t row = 0; row < kRows; ++row) {
        for (std::size_t column = 0; column < Bindings::kColumns; ++column) {
            if (cell(row, column).contains(place)) {
                row_ = row;
                column_ = row < kActs ? column : column_;
            }
        }
    }
}

void KeyScreen::move(Command command) {
    if (command == Command::Up) {
        row_ = (row_ + kRows - 1) % kRows;
    } else if (command == Command::Down) {
        row_ = (row_ + 1) % kRows;
    } else if (command == Command::Left && column_ > 0) {
        --column_;
    } else if (command == Command::Right && column_ + 1 < Bindings::kColumns) {
        ++column_;
    }
}

/// True for the last row, which leaves the screen.
bool KeyScreen::confirm(Bindings& bindings) {
    const bool asked = notice_ == kResetQuestion;
    notice_.clear();
    if (row_ == kResetRow && !asked && bindings != Bindings{}) {
        notice_ = kResetQuestion;
    } else if (row_ == kResetRow) {
        bindings.rows = Bindings{}.rows;
    } else if (row_ < kActs) {
        waiting_ = column_ != Bindings::kPadColumn || hasButton(static_cast<Act>(row_));
        notice_ = waiting_ ? "" : "the stick moves the paddle";
    }
    return row_ == kBackRow;
}

bool KeyScreen::take(const Signals& signals, Bindings& bindings) {
    if (waiting_) {
        for (const Press press : signals.presses) {
            if (waiting_) {
                takePress(press, bindings);
            }
        }
        waiting_ = waiting_ && !signals.clicked;
        return false;
    }
    if (signals.pointer) {
        point(*signals.pointer);
    }
    for (const Press press : signals.presses) {
        if (erases(press) && row_ < kActs) {
            notice_ = bindings.bind(static_cast<Act>(row_), column_, kNoKey);
        }
    }
    for (const Command command : signals.commands) {
        if (command == Command::Back) {
            return true;
        }
        if (command == Command::Launch || command == Command::Confirm) {
            return confirm(bindings);
        }
        move(command);
    }
    if (row_ != kResetRow && notice_ == kResetQuestion) {
        notice_.clear(); // another row is chosen
    }
    const auto clicks = [&](std::size_t row, std::size_t column) {
        return cell(row, column).contains(signals.pointerNow);
    };
    return signals.clicked && clicks(row_, column_) && confirm(bindings);
}

void KeyScreen::draw(Canvas& canvas, const Bindings& bindings) const {
    canvas.text("Keys and buttons", {0, Real(15.0)},
                {Real(1.4), palette::kText, Typeface::Display, Align::Middle});
    for (std::size_t column = 0; column < Bindings::kColumns; ++column) {
        canvas.text(
            kHeads[column], {cell(0, column).center().x, kKeysTop + Real(0.3)},
            {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Middle, kKeysColumn - Real(0.4)});
    }
    const auto frame = [&](const Aabb& box) {
        const std::array<Vec2, 4> corners = {box.lower, Vec2{box.upper.x, box.lower.y}, box.upper,
                                             Vec2{box.lower.x, box.upper.y}};
        canvas.polygon(corners, faded(palette::kAccent, 0.16f));
        canvas.outline(corners, Real(0.05), palette::kAccent);
    };
    const auto paint = [&](std::size_t row, std::size_t column, const std::string& text) {
        const Aabb box = cell(row, column);
        const bool chosen = row == row_ && (row >= kActs || column == column_);
        if (chosen) {
            frame(box);
        }
        canvas.text(text, {box.center().x, box.lower.y + Real(0.27)},
                    {Real(0.5), chosen ? palette::kAccent : palette::kText, Typeface::Bold,
                     Align::Middle, box.extent().x - Real(0.2)});
    };
    for (std::size_t row = 0; row < kActs; ++row) {
        const auto act = static_cast<Act>(row);
        canvas.text(kLabels[row], {kNameRight, cell(row, 0).lower.y + Real(0.27)},
                    {Real(0.5), palette::kQuiet, Typeface::Plain, Align::Right, Real(9)});
        for (std::size_t column = 0; column < Bindings::kColumns; ++column) {
            const bool here = waiting_ && row == row_ && column == column_;
            const bool stick = column == Bindings::kPadColumn && !hasButton(act);
            paint(row, column,
                  here    ? "press it ..."
                  : stick ? "stick"
                          : bindings.text(act, column));
        }
    }
    paint(kResetRow, 0, "As they were at first");
    paint(kBackRow, 0, "Back");
    const std::string hint = waiting_ ? (column_ == Bindings::kPadColumn
                                             ? "press a button of the gamepad; escape: leave it"
                                             : "press a key; escape: leave it as it is")
                                      : "enter or click: change      delete: no key";
    canvas.text(notice_.empty() ? hint : notice_, {0, Real(1.1)},
                {Real(0.46), notice_.empty() ? palette::kQuiet : palette::kDanger, Typeface::Plain,
                 Align::Middle, Real(24)});
}

} // namespace apart
