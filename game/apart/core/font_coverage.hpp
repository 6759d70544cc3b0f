// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/core/text_file.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace apart {

/// The characters that a font can draw.
class FontCoverage {
public:
    /// `ranges`: first and last code point, by rising code.
    explicit FontCoverage(std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges)
        : ranges_(std::move(ranges)) {}

    bool covers(std::uint32_t code) const;

private:
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges_;
};

/// Reads the character map of a TrueType file (table cmap, format 12).
Read<FontCoverage> readFontCoverage(const std::filesystem::path& file);

/// A sentence for each text of a level with characters that a typeface of the game lacks: they are
/// drawn as boxes. None if the fonts cannot be read.
std::vector<std::string> lackingCharacters(const Level& level);

} // namespace apart
