// SPDX-License-Identifier: MIT
#include <apart/stage/controls/bindings.hpp>

#include <algorithm>

namespace apart {

namespace {

constexpr std::string_view kReserved[] = {"escape", "enter", "F3", "F11"};

struct Usual {
    std::string_view first;
    std::string_view second; // empty: none
    int button;
};
// In the order of most drivers.
constexpr std::string_view kButtonNames[] = {"button A", "button B",      "button X",
                                             "button Y", "left shoulder", "right shoulder",
                                             "back",     "start"};
// By Act.
constexpr std::array<Usual, kActs> kUsual = {{
    {"left", "A", kNoKey},
    {"right", "D", kNoKey},
    {"down", "S", 4},
    {"up", "W", 5},
    {"space", "", 0},
    {"P", "pause", 7},
    {"R", "", 6},
    {"M", "", 3},
}};

int keyOf(std::string_view name) {
    return keyNamed(name).value_or(kNoKey);
}

} // namespace

std::optional<int> keyNamed(std::string_view name) {
    const auto found = std::find(kKeyNames.begin(), kKeyNames.end(), name);
    return found == kKeyNames.end() ? std::nullopt
                                    : std::optional(static_cast<int>(found - kKeyNames.begin()));
}

std::string keyText(int key) {
    const bool known = key >= 0 && key < static_cast<int>(kKeyNames.size());
    return known ? std::string(kKeyNames[static_cast<std::size_t>(key)]) : "-";
}

std::string buttonText(int button) {
    const auto index = static_cast<std::size_t>(button);
    return button < 0                        ? "-"
           : index < std::size(kButtonNames) ? std::string(kButtonNames[index])
                                             : "button " + std::to_string(button + 1);
}

bool isReserved(int key) {
    const std::string name = keyText(key);
    return std::find(std::begin(kReserved), std::end(kReserved), name) != std::end(kReserved);
}

bool hasButton(Act act) {
    return act != Act::Left && act != Act::Right;
}

Bindings::Bindings() : rows{} {
    for (std::size_t i = 0; i < kActs; ++i) {
        rows[i] = {keyOf(kUsual[i].first), keyOf(kUsual[i].second), kUsual[i].button};
    }
}

std::optional<Act> Bindings::actOf(Press press) const {
    if (press.code < 0) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < kActs; ++i) {
        for (std::size_t column = 0; column < kColumns; ++column) {
            if (press.pad == (column == kPadColumn) && rows[i][column] == press.code) {
                return static_cast<Act>(i);
            }
        }
    }
    return std::nullopt;
}

std::string Bindings::text(Act act, std::size_t column) const {
    return column == kPadColumn ? buttonText(at(act, column)) : keyText(at(act, column));
}

std::string Bindings::prompt(Act act) const {
    std::string text;
    for (std::size_t column = 0; column < kColumns; ++column) {
        if (at(act, column) >= 0 && (column != kPadColumn || text.empty())) {
            text += (text.empty() ? "" : " or ") + this->text(act, column);
        }
    }
    return text.empty() ? "no key" : text;
}

std::string Bindings::firstKey(Act act) const {
    const std::string all = prompt(act);
    return all.substr(0, all.find(" or "));
}

std::string Bindings::anyPrompt(Act act) const {
    switch (act) {
    case Act::Pull:
        return fingers ? "a second finger" : "left button, " + prompt(act);
    case Act::Push:
        return fingers ? "a third finger" : "right button, " + prompt(act);
    case Act::Serve:
        return fingers ? "tap" : prompt(act) + " or click";
    default:
        return prompt(act);
    }
}

std::string Bindings::bind(Act act, std::size_t column, int code) {
    const bool pad = column == kPadColumn;
    if (!pad && code >= 0 && isReserved(code)) {
        return keyText(code) + " always has its own meaning";
    }
    if (pad && code >= 0 && !hasButton(act)) {
        return "the stick moves the paddle";
    }
    if (const std::optional<Act> other = actOf({pad, code}); other && code >= 0) {
        if (*other != act || at(act, column) != code) {
            return (pad ? buttonText(code) : keyText(code)) +
                   " is in use: " + std::string(kActNames[static_cast<std::size_t>(*other)]);
        }
    }
    rows[static_cast<std::size_t>(act)][column] = code;
    return "";
}

} // namespace apart
