// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/letterforms.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

using kodo::Real;
using kodo::Vec2;

constexpr Real kBetween = Real(2.6); // units between two letters
constexpr Real kSpace = 9;           // units

/// Corners are pairs of digits x y in base 36; a bar separates two stones.
struct Cut {
    char sign;
    const char* stones;
};
constexpr std::array kCuts = {
    Cut{'A', "00 60 ad ak 7k|e0 k0 dk ak ad|74 d4 c8 88"},
    Cut{'B', "00 60 6k 0k|60 d0 b4 64|68 b8 da bc 6c|6g bg dk 6k|d0 h4 h7 da b8 b4|"
             "da hd hg dk bg bc"},
    Cut{'C', "04 40 64 6g 4k 0g|40 e0 g4 64|6g gg ek 4k|b4 g4 g7 b7|bd gd gg bg"},
    Cut{'D', "00 60 6k 0k|60 e0 c4 64|6g cg ek 6k|i4 ig ek cg c4 e0"},
    Cut{'E', "00 60 6k 0k|60 f0 f4 64|68 d8 dc 6c|6g fg fk 6k"},
    Cut{'F', "00 60 6k 0k|68 d8 dc 6c|6g fg fk 6k"},
    Cut{'G', "04 40 64 6g 4k 0g|40 e0 b4 64|6g gg ek 4k|bd gd gg bg|b4 e0 g4 ga ba|87 b7 ba 8a"},
    Cut{'H', "00 60 6k 0k|68 c8 cc 6c|c0 i0 ik ck"},
    Cut{'I', "00 60 6k 0k"},
    Cut{'J', "94 b0 f4 fk 9k|40 b0 94 64|04 40 64 68 08"},
    Cut{'K', "00 60 6k 0k|68 a9 ik bk 6d|b0 i0 ba 88"},
    Cut{'L', "00 60 6k 0k|60 e0 e4 64"},
    Cut{'M', "00 60 6k 0k|6c b6 bd 6k|b6 gc gk bd|g0 m0 mk gk"},
    Cut{'N', "00 60 6k 0k|6c d0 d8 6k|d0 j0 jk dk"},
    Cut{'O', "04 40 64 6g 4k 0g|40 e0 c4 64|6g cg ek 4k|i4 ig ek cg c4 e0"},
    Cut{'P', "00 60 6k 0k|68 d8 bc 6c|6g bg dk 6k|d8 hc hg dk bg bc"},
    Cut{'Q', "04 40 64 6g 4k 0g|40 e0 c4 64|6g cg ek 4k|i4 ig ek cg c4 e0|e0 k0 i4"},
    Cut{'R', "00 60 6k 0k|68 d8 bc 6c|6g bg dk 6k|d8 hc hg dk bg bc|b0 i0 d8 78"},
    Cut{'S', "0c 48 6c 6g 4k 0g|20 c0 a4 04|48 a8 cc 6c|6g gg ek 4k|g4 g8 cc a8 a4 c0"},
    Cut{'T', "60 c0 cg 6g|0g ig ik 0k"},
    Cut{'U', "04 40 64 6k 0k|40 e0 c4 64|c4 e0 i4 ik ck"},
    Cut{'V', "70 a0 a6 6k 0k|a0 d0 kk ek a6"},
    Cut{'W', "00 60 6k 0k|60 b7 be 68|b7 g0 g8 be|g0 m0 mk gk"},
    Cut{'X', "00 70 kk dk|0k 7a af 7k|k0 da a5 d0"},
    Cut{'Y', "70 d0 d9 79|79 a9 ae 6k 0k|a9 d9 kk ek ae"},
    Cut{'Z', "00 h0 h4 04|04 74 hg ag|0g hg hk 0k"},
    Cut{'0', "04 40 64 6g 4k 0g|40 c0 a4 64|6g ag ck 4k|g4 gg ck ag a4 c0"},
    Cut{'1', "0d 5d 5k 0g|50 b0 bk 5k"},
    Cut{'2', "04 64 68 4c 08|00 g0 g4 04|68 c8 ac 4c|0g ag ck 2k|ac c8 gc gg ck ag"},
    Cut{'3', "00 c0 a4 04|38 a8 ca ac 3c|0g ag ck 0k|c0 g4 g7 ca a8 a4|ac ca gd gg ck ag"},
    Cut{'4', "08 58 8d 8k|04 84 88 08|80 e0 ek 8k|e4 h4 h8 e8"},
    Cut{'5', "00 c0 a4 04|08 a8 cc 0c|0c 6c 6g 0g|0g fg fk 0k|g4 g8 cc a8 a4 c0"},
    Cut{'6', "04 40 64 6g 4k 0g|40 c0 a4 64|68 a8 cc 6c|6g eg ek 4k|g4 g8 cc a8 a4 c0"},
    Cut{'7', "30 90 gg ag|0g gg gk 0k"},
    Cut{'8', "0d 4a 6c 6g 4k 0g|04 40 64 68 4a 07|40 c0 a4 64|4a 68 a8 ca ac 6c|6g ag ck 4k|"
             "c0 g4 g7 ca a8 a4|ca gd gg ck ag ac"},
    Cut{'9', "0g 0c 48 6c 6g 4k|20 c0 a4 24|48 a8 ac 6c|6g ag ck 4k|a4 c0 g4 gg ck ag"},
    Cut{'.', "00 60 65 05"},
    Cut{',', "00 30 69 09"},
    Cut{'!', "00 60 65 05|18 58 6k 0k"},
    Cut{'?', "50 b0 b4 54|56 b6 c9 ac 5c|0g ag ck 2k|ac c9 gc gg ck ag"},
    Cut{':', "03 63 67 07|0c 6c 6g 0g"},
    Cut{'-', "08 a8 ac 0c"},
    Cut{'+', "08 58 5c 0c|53 b3 bh 5h|b8 g8 gc bc"},
    Cut{'/', "00 50 gk bk"},
    Cut{'%', "00 50 gk bk|0e 5e 5k 0k|b0 g0 g6 b6"},
    Cut{'\'', "1d 4d 5k 0k"},
    Cut{'(', "04 40 64 6g 4k 0g"},
    Cut{')', "20 64 6g 2k 0g 04"},
};

constexpr int digitOf(char c) {
    return c <= '9' ? c - '0' : c - 'a' + 10;
}

Letterform formOf(std::string_view stones) {
    Letterform form;
    form.stones.emplace_back();
    while (stones.size() >= 2) {
        const Vec2 corner{static_cast<Real>(digitOf(stones[0])),
                          static_cast<Real>(digitOf(stones[1]))};
        form.stones.back().push_back(corner);
        form.width = std::max(form.width, corner.x);
        stones.remove_prefix(2);
        if (!stones.empty()) {
            if (stones[0] == '|') {
                form.stones.emplace_back();
            }
            stones.remove_prefix(1);
        }
    }
    return form;
}

/// The corners of a convex polygon whose edges have moved inwards.
std::vector<Vec2> inset(std::span<const Vec2> corners, Real depth) {
    std::vector<Vec2> smaller;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 before = corners[(i + corners.size() - 1) % corners.size()];
        const Vec2 after = corners[(i + 1) % corners.size()];
        const Vec2 in = normalize(corners[i] - before);
        const Vec2 out = normalize(after - corners[i]);
        // The point at `depth` from both edges: along both edges, by depth over the sine.
        const Real sine = std::max(cross(in, out), Real(0.2));
        smaller.push_back(corners[i] + depth / sine * (out - in));
    }
    return smaller;
}

char capitalOf(char sign) {
    return sign >= 'a' && sign <= 'z' ? static_cast<char>(sign - 'a' + 'A') : sign;
}

} // namespace

const Letterform* letterformOf(char sign) {
    static const std::vector<Letterform> kForms = [] {
        std::vector<Letterform> forms;
        for (const Cut& cut : kCuts) {
            forms.push_back(formOf(cut.stones));
        }
        return forms;
    }();
    for (std::size_t i = 0; i < kCuts.size(); ++i) {
        if (kCuts[i].sign == sign) {
            return &kForms[i];
        }
    }
    return nullptr;
}

std::optional<LaidText> layStones(std::string_view text, Real joint) {
    LaidText laid;
    Real pen = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == ' ') {
            pen += kSpace;
            continue;
        }
        const char capital = capitalOf(text[i]);
        const Letterform* form = letterformOf(capital);
        if (form == nullptr) {
            return std::nullopt;
        }
        const Real size = capital == text[i] ? Real(1) : kSmallCapital;
        for (const std::vector<Vec2>& stone : form->stones) {
            std::vector<Vec2> corners = inset(stone, joint / 2);
            for (Vec2& corner : corners) {
                corner = Vec2{pen, 0} + size * corner;
            }
            laid.stones.push_back({std::move(corners), i});
        }
        pen += size * form->width;
        laid.width = pen;
        pen += kBetween;
    }
    return laid;
}

} // namespace apart
