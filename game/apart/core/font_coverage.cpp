// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/font_coverage.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>

namespace apart {

namespace {

constexpr std::size_t kLargestFont = std::size_t{16} << 20; // bytes
constexpr std::uint32_t kLastCode = 0x10ffff;

/// Big-endian numbers of a file; those beyond its end are 0.
class BigEndian {
public:
    explicit BigEndian(std::string_view bytes) : bytes_(bytes) {}

    std::uint32_t number(std::size_t place, std::size_t size) const {
        std::uint32_t value = 0;
        for (std::size_t i = place; i < place + size; ++i) {
            value = value << 8 | (i < bytes_.size() ? static_cast<std::uint8_t>(bytes_[i]) : 0u);
        }
        return value;
    }
    std::uint32_t two(std::size_t place) const { return number(place, 2); }
    std::uint32_t four(std::size_t place) const { return number(place, 4); }
    std::size_t size() const { return bytes_.size(); }

private:
    std::string_view bytes_;
};

/// Place of the table cmap; 0: there is none.
std::size_t placeOfMap(const BigEndian& font) {
    constexpr std::uint32_t kCmap = 0x636d6170;
    for (std::size_t i = 0; i < font.two(4); ++i) {
        const std::size_t entry = 12 + 16 * i;
        if (font.four(entry) == kCmap) {
            return font.four(entry + 8);
        }
    }
    return 0;
}

/// The groups of a map of format 12, by rising code: first code, last code, glyph of the first.
std::vector<std::pair<std::uint32_t, std::uint32_t>> groupsOf(const BigEndian& font,
                                                              std::size_t map) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> groups;
    const std::size_t count = font.four(map + 12);
    for (std::size_t i = 0; i < count && map + 28 + 12 * i <= font.size(); ++i) {
        const std::uint32_t first = font.four(map + 16 + 12 * i);
        const std::uint32_t last = font.four(map + 20 + 12 * i);
        const bool rises = groups.empty() || first > groups.back().second;
        if (rises && first <= last && last <= kLastCode) {
            groups.emplace_back(first, last);
        }
    }
    return groups;
}

std::string codeText(std::uint32_t code) {
    std::string digits = toHex(code).substr(10); // 6 digits
    digits.erase(0, std::min<std::size_t>(digits.find_first_not_of('0'), 2));
    for (char& digit : digits) {
        digit = digit >= 'a' ? static_cast<char>(digit - 'a' + 'A') : digit;
    }
    return "U+" + digits;
}

} // namespace

bool FontCoverage::covers(std::uint32_t code) const {
    const auto next = std::upper_bound(
        ranges_.begin(), ranges_.end(), code,
        [](std::uint32_t wanted, const auto& range) { return wanted < range.first; });
    return next != ranges_.begin() && code <= std::prev(next)->second;
}

Read<FontCoverage> readFontCoverage(const std::filesystem::path& file) {
    const Read<std::string> bytes = readTextFile(file, kLargestFont);
    if (const auto* problem = std::get_if<FileProblem>(&bytes)) {
        return *problem;
    }
    const BigEndian font(std::get<std::string>(bytes));
    const std::size_t table = placeOfMap(font);
    for (std::size_t i = 0; table > 0 && i < font.two(table + 2); ++i) {
        const std::size_t map = table + font.four(table + 8 + 8 * i);
        if (font.two(map) == 12) {
            return FontCoverage(groupsOf(font, map));
        }
    }
    return FileProblem{file.string(), 0, "is no TrueType font with a character map of format 12"};
}

std::vector<std::string> lackingCharacters(const Level& level) {
    std::vector<FontCoverage> faces;
    for (const char* name : {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"}) {
        Read<FontCoverage> read = readFontCoverage(assetsFolder() / "fonts" / name);
        if (auto* face = std::get_if<FontCoverage>(&read)) {
            faces.push_back(std::move(*face));
        }
    }
    std::vector<std::string> sentences;
    for (const auto& [key, text] :
         {std::pair<std::string_view, std::string_view>{"title", level.title},
          {"idea", level.idea},
          {"keep", level.keepName}}) {
        std::vector<std::uint32_t> lacking;
        for (const std::uint32_t code : codePoints(text)) {
            const bool drawn = std::all_of(faces.begin(), faces.end(),
                                           [&](const auto& face) { return face.covers(code); });
            if (!drawn && std::find(lacking.begin(), lacking.end(), code) == lacking.end()) {
                lacking.push_back(code);
            }
        }
        if (lacking.empty()) {
            continue;
        }
        constexpr std::size_t kNamed = 3;
        std::string list;
        for (std::size_t i = 0; i < std::min(lacking.size(), kNamed); ++i) {
            list += (i > 0 ? ", " : "") + codeText(lacking[i]);
        }
        if (lacking.size() > kNamed) {
            list += " and " + std::to_string(lacking.size() - kNamed) + " more";
        }
        sentences.push_back(std::string(key) + " has characters that the typeface lacks: " + list);
    }
    return sentences;
}

} // namespace apart
