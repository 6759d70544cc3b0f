// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace apart {

/// One letter of the display face: cut stones, laid with joints between them. Lengths in units of
/// the face; capitals are kCapital units high. The base line is y = 0, the left edge x = 0.
struct Letterform {
    std::vector<std::vector<kodo::Vec2>> stones; // convex, counter-clockwise
    kodo::Real width = 0;
};

inline constexpr kodo::Real kCapital = 20;
inline constexpr kodo::Real kSmallCapital = kodo::Real(0.8); // size of a small letter's capital

/// The form of a capital letter, digit or sign; nullptr if the face has none.
const Letterform* letterformOf(char sign);

/// A stone of a text, in units of a text that starts at the origin.
struct LaidStone {
    std::vector<kodo::Vec2> corners;
    std::size_t letter = 0; // index into the text
};
struct LaidText {
    std::vector<LaidStone> stones;
    kodo::Real width = 0;
};

/// Lays a text in one line: small letters become small capitals. `joint` is the width of the joints
/// between stones. nullopt if the face lacks a sign of the text.
std::optional<LaidText> layStones(std::string_view text, kodo::Real joint);

} // namespace apart
