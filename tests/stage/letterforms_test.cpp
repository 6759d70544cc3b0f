// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/stage/canvas/letterforms.hpp>

#include <gtest/gtest.h>

#include <bitset>
#include <string>

namespace apart {
namespace {

using kodo::Real;
using kodo::Vec2;

constexpr std::string_view kSigns = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,!?:-+/%'()";

TEST(Letterforms, EveryStoneIsConvexAndWithinItsLetter) {
    for (const char sign : kSigns) {
        SCOPED_TRACE(sign);
        const Letterform* form = letterformOf(sign);
        ASSERT_NE(form, nullptr);
        for (const std::vector<Vec2>& stone : form->stones) {
            ASSERT_GE(stone.size(), 3u);
            for (std::size_t i = 0; i < stone.size(); ++i) {
                const Vec2 a = stone[i];
                const Vec2 b = stone[(i + 1) % stone.size()];
                const Vec2 c = stone[(i + 2) % stone.size()];
                EXPECT_GT(cross(b - a, c - b), 0) << "corner " << i; // counter-clockwise
                EXPECT_GE(a.x, 0);
                EXPECT_LE(a.x, form->width);
                EXPECT_GE(a.y, 0);
                EXPECT_LE(a.y, kCapital);
            }
        }
    }
}

/// Whether a point lies in a stone of a letter, deeper than `margin`.
bool covered(const Letterform& form, Vec2 point, Real margin) {
    for (const std::vector<Vec2>& stone : form.stones) {
        bool inside = true;
        for (std::size_t i = 0; i < stone.size() && inside; ++i) {
            const Vec2 a = stone[i];
            const Vec2 way = stone[(i + 1) % stone.size()] - a;
            inside = cross(way, point - a) > margin * length(way);
        }
        if (inside) {
            return true;
        }
    }
    return false;
}

// Letters that differ in fewer units than a stem are mistaken for each other.
TEST(Letterforms, AnyTwoDifferByMoreThanAStem) {
    constexpr std::size_t kSide = 24; // squares of one unit
    std::vector<std::bitset<kSide * kSide>> pictures(kSigns.size());
    for (std::size_t sign = 0; sign < kSigns.size(); ++sign) {
        for (std::size_t i = 0; i < kSide * kSide; ++i) {
            const Vec2 point{static_cast<Real>(i % kSide) + Real(0.5),
                             static_cast<Real>(i / kSide) + Real(0.5)};
            pictures[sign][i] = covered(*letterformOf(kSigns[sign]), point, 0);
        }
    }
    for (std::size_t a = 0; a < kSigns.size(); ++a) {
        for (std::size_t b = a + 1; b < kSigns.size(); ++b) {
            EXPECT_GE((pictures[a] ^ pictures[b]).count(), 10u) << kSigns[a] << " " << kSigns[b];
        }
    }
}

TEST(Letterforms, TheStonesOfALetterDoNotOverlap) {
    for (const char sign : kSigns) {
        const Letterform& form = *letterformOf(sign);
        for (std::size_t a = 0; a < form.stones.size(); ++a) {
            for (std::size_t b = 0; b < form.stones.size(); ++b) {
                if (a == b) {
                    continue;
                }
                const Letterform other{{form.stones[b]}, form.width};
                for (const Vec2 corner : form.stones[a]) {
                    EXPECT_FALSE(covered(other, corner, Real(0.5))) << sign; // half a joint
                }
            }
        }
    }
}

TEST(Letterforms, SmallLettersAreSmallCapitals) {
    const auto heightOf = [](std::string_view text) {
        Real top = 0;
        const std::optional<LaidText> laid = layStones(text, Real(0.1));
        for (const LaidStone& stone : laid->stones) {
            for (const Vec2 corner : stone.corners) {
                top = std::max(top, corner.y);
            }
        }
        return top;
    };
    EXPECT_NEAR(heightOf("h"), kSmallCapital * heightOf("H"), Real(0.01));
    EXPECT_GT(layStones("HH", 1)->width, 2 * layStones("H", 1)->width);
    EXPECT_FALSE(layStones("\xc3\xa4", 1).has_value()); // such a text gets another face
}

TEST(Letterforms, HaveEverySignOfTheTitlesOfLevels) {
    for (const std::string& name : levelNames()) {
        const auto level = loadLevel(name);
        const std::string& title = std::get<Level>(level).title;
        EXPECT_TRUE(layStones(title, 1).has_value()) << title;
    }
}

} // namespace
} // namespace apart
