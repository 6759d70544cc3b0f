// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/effects/popups.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

#include <array>

namespace apart {
namespace {

Popup word(const char* text, Vec2 place, Real height = Real(0.5)) {
    return {text, place, {}, height};
}
Popup points(int count, Vec2 place) {
    return {"", place, {}, Real(0.45), count};
}

TEST(Popups, NearbyRecentPointsAreSummed) {
    Popups popups;
    popups.add(points(50, {0, 9}));
    popups.add(points(70, {1, 9}));
    ASSERT_EQ(popups.all().size(), 1u);
    EXPECT_EQ(popups.all()[0].text, "+120");
    popups.add(points(50, {4, 9})); // far away
    EXPECT_EQ(popups.all().size(), 2u);
    for (int tick = 0; tick < 50; ++tick) {
        popups.tick();
    }
    popups.add(points(50, {0, 9}));
    EXPECT_EQ(popups.all().size(), 3u);
}

// Regression: a fall was told by "combo of five", "combo of eight!" and "a dozen!" at once.
TEST(Popups, OneOfSeveralPraisesIsShown) {
    Popups popups;
    for (const char* text : {"combo of five", "combo of eight!", "a dozen!"}) {
        Popup praise = word(text, {0, 9}, Real(0.8));
        praise.praise = true;
        popups.add(praise);
        popups.add(word("torn off", {5, 9}));
    }
    ASSERT_EQ(popups.all().size(), 2u);
    EXPECT_EQ(popups.all()[0].text, "torn off");
    EXPECT_EQ(popups.all()[1].text, "a dozen!");
    for (const char* text : {"30 in one fall!", "twenty in a row!"}) { // the second is smaller
        Popup praise = word(text, {0, 3}, *text == '3' ? Real(1.2) : Real(0.8));
        praise.praise = true;
        popups.add(praise);
    }
    ASSERT_EQ(popups.all().size(), 2u);
    EXPECT_EQ(popups.all()[1].text, "30 in one fall!");
}

// Two notices at one position are both shown, without overlap.
TEST(Popups, WordsAtOnePositionDoNotOverlap) {
    Popups popups;
    popups.add(word("welded", {3, 5}));
    popups.add(word("knocked off", {Real(3.5), 5}));
    popups.add(word("welded", {3, 5})); // a recent popup with the same text
    ASSERT_EQ(popups.all().size(), 2u);
    EXPECT_EQ(popups.all()[0].text, "welded");
    EXPECT_EQ(popups.all()[1].text, "knocked off");
    EXPECT_FALSE(overlap(popups.all()[0].box(), popups.all()[1].box()));
    EXPECT_NEAR(popups.all()[1].place.y, 5, 1); // as near as possible
}

// Regression: the places were those of usual letters; at 140 % words covered each other.
TEST(Popups, LargerTextsHaveMoreRoom) {
    Popups popups;
    popups.setTextScale(Real(1.4));
    popups.add(word("heavy balls", {3, 5}));
    popups.add(word("knocked off", {3, 5}));
    ASSERT_EQ(popups.all().size(), 2u);
    const Aabb box = popups.all()[0].box();
    EXPECT_NEAR(box.extent().y, Real(1.4) * word("heavy balls", {}).box().extent().y, 1e-4);
    EXPECT_FALSE(overlap(box, popups.all()[1].box()));
    const Aabb title = word("boss down!", {}, Real(1.1)).box();
    popups.add(word("boss down!", {-5, 5}, Real(1.1)));
    EXPECT_NEAR(popups.all()[2].box().extent().x, title.extent().x, 1e-4) << "one size";
}

// A word over a block is hard to read: it moves beside one, but not across a whole wall of them.
TEST(Popups, StandBesideABlockAndOverAWall) {
    const Aabb block{{Real(-0.8), Real(8.6)}, {Real(0.8), Real(9.4)}};
    Popups popups;
    popups.add(word("torn off", {0, 9}), {}, std::array{block});
    Popup later = popups.all()[0];
    later.age = 30;
    EXPECT_FALSE(overlap(popups.all()[0].box(), block));
    EXPECT_FALSE(overlap(later.box(), block));
    EXPECT_NEAR(popups.all()[0].place.y, 9, 2);

    std::vector<Aabb> wall;
    for (int i = 0; i < 150; ++i) {
        const Vec2 corner{-12 + Real(1.6) * static_cast<Real>(i % 15), 6 + Real(0.8 * (i / 15))};
        wall.push_back({corner, corner + Vec2{Real(1.6), Real(0.8)}});
    }
    Popups over;
    over.add(word("+50", {0, 10}), {}, wall);
    EXPECT_NEAR(over.all()[0].place.y, 10, 3);
}

TEST(Popups, MoveIntoThePartOfTheFieldThatIsShown) {
    const Aabb shown{{-6, 3}, {6, 12}};
    for (const Vec2 place : {Vec2{9, 9}, Vec2{-9, 9}, Vec2{0, 14}, Vec2{5, 1}, Vec2{0, 9}}) {
        Popup popup = word("nine in one fall!", place);
        const Vec2 moved = popup.placeIn(shown);
        EXPECT_EQ(moved == place, shown.contains(popup.box()));
        popup.place = moved;
        EXPECT_TRUE(shown.grown(Real(1e-4)).contains(popup.box()));
    }
}

TEST(Popups, NeverOverlapOrLeaveTheField) {
    constexpr std::uint64_t kSeed = 21;
    SCOPED_TRACE("seed 21");
    support::RandomNumbers random(kSeed);
    constexpr std::array<const char*, 5> kWords = {"pull now", "the mounts give way soon", "welded",
                                                   "a dozen!", "2 balls more"};
    const Aabb field{{layout::kLeft, -1}, {layout::kRight, layout::kTop}};
    Popups popups;
    for (int tick = 0; tick < 3000 && !HasFailure(); ++tick) {
        const Vec2 place{random.between(-12, 12), random.between(0, 18)};
        if (tick % 16 == 0) { // six at a time, more than in a game
            popups.add(tick % 32 == 0 ? word(kWords[random.below(5)], place, Real(0.6))
                                      : points(50, place));
        }
        popups.tick();
        for (std::size_t a = 0; a < popups.all().size(); ++a) {
            // Within the rounding of positions of about 18 m.
            const Aabb box = popups.all()[a].box().grown(Real(-1e-4));
            EXPECT_TRUE(field.contains(box)) << popups.all()[a].text;
            for (std::size_t b = 0; b < a; ++b) {
                EXPECT_FALSE(overlap(box, popups.all()[b].box()))
                    << popups.all()[a].text << " over " << popups.all()[b].text;
            }
        }
    }
}

} // namespace
} // namespace apart
