// SPDX-License-Identifier: MIT
// What the page of the game paints again, and what it keeps.
#include <apart/web/still_part.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace {

using apart::StillPart;
using apart::TouchedTiles;
using kodo_draw::Blend;
using kodo_draw::Fill;
using kodo_draw::MeshRun;
using kodo_draw::MeshVertex;

constexpr kodo_draw::Size kPicture{640, 320}; // pixels, ten by five tiles

/// Two triangles with a corner and a size (pixels).
void addQuad(std::vector<MeshVertex>& all, float x, float y, float width, float height) {
    const auto at = [](float px, float py) { return MeshVertex{{px, py}, {}, {}}; };
    all.insert(all.end(), {at(x, y), at(x + width, y), at(x + width, y + height), at(x, y),
                           at(x + width, y + height), at(x, y + height)});
}

/// A picture of two layers that stay, with a square over them.
struct Picture {
    explicit Picture(float squareX) {
        addQuad(vertices, 0, 0, 640, 320);
        addQuad(vertices, 0, 0, 640, 320);
        addQuad(vertices, squareX, 100, 20, 20);
    }
    std::vector<MeshVertex> vertices;
    std::vector<MeshRun> runs{{0, Blend::Replace, Fill::Plain, nullptr},
                              {6, Blend::Over, Fill::Edges, nullptr}};
};

constexpr std::size_t kStill = 12; // vertices of the two layers

/// Shows frames with a moving square until the layers are kept.
StillPart kept() {
    StillPart part;
    for (int i = 0; i < 20; ++i) {
        const Picture picture(static_cast<float>(i));
        const StillPart::Plan plan = part.next(picture.vertices, picture.runs, kPicture);
        EXPECT_TRUE(plan.kept == 0 || plan.kept == kStill) << plan.kept;
        if (plan.keep > 0) {
            EXPECT_EQ(plan.keep, kStill);
            return part;
        }
    }
    ADD_FAILURE() << "nothing is kept";
    return part;
}

TEST(StillPart, KeepsWhatStaysTheSameBelowWhatMoves) {
    StillPart part = kept();
    for (int i = 20; i < 40; ++i) {
        const Picture picture(static_cast<float>(i));
        const StillPart::Plan plan = part.next(picture.vertices, picture.runs, kPicture);
        EXPECT_EQ(plan.kept, kStill);
        EXPECT_EQ(plan.keep, 0u) << "it is drawn once";
    }
}

TEST(StillPart, IsDrawnAgainInTheFrameInWhichItChanges) {
    StillPart part = kept();
    Picture color(50);
    color.vertices[7].color.r = 1;
    EXPECT_EQ(part.next(color.vertices, color.runs, kPicture).kept, 0u);

    part = kept();
    Picture blend(50);
    blend.runs[1].blend = Blend::Replace;
    EXPECT_EQ(part.next(blend.vertices, blend.runs, kPicture).kept, 0u);

    part = kept();
    Picture fewer(50);
    fewer.runs.pop_back();
    EXPECT_EQ(part.next(fewer.vertices, fewer.runs, kPicture).kept, 0u);

    part = kept();
    part.forget();
    const Picture same(50);
    EXPECT_EQ(part.next(same.vertices, same.runs, kPicture).kept, 0u);
}

TEST(StillPart, LeavesOutWhatCostsNoMoreThanItsCopy) {
    StillPart part;
    for (int i = 0; i < 40; ++i) {
        Picture picture(static_cast<float>(i));
        picture.vertices.erase(picture.vertices.begin(), picture.vertices.begin() + 6);
        picture.runs = {{0, Blend::Replace, Fill::Plain, nullptr}};
        EXPECT_EQ(part.next(picture.vertices, picture.runs, kPicture).kept, 0u);
    }
}

TEST(TouchedTiles, AreTheOnesUnderTriangles) {
    TouchedTiles tiles;
    tiles.touchAll(kPicture);
    EXPECT_EQ(tiles.quads().size(), 5u * 6);
    tiles.clear();
    EXPECT_TRUE(tiles.quads().empty());
    std::vector<MeshVertex> square;
    addQuad(square, 70, 130, 100, 20); // tiles 1 and 2 of row 2
    tiles.touch(square);
    const std::vector<MeshVertex> quads = tiles.quads();
    ASSERT_EQ(quads.size(), 6u);
    EXPECT_EQ(quads[0].place, (kodo_draw::Pixel{64, 128}));
    EXPECT_EQ(quads[2].place, (kodo_draw::Pixel{192, 192}));
    square.clear();
    addQuad(square, -5000, 700, 9000, 20); // below the picture: at its border
    tiles.clear();
    tiles.touch(square);
    EXPECT_EQ(tiles.quads().size(), 6u);
}

} // namespace
