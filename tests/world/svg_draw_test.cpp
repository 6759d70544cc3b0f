// SPDX-License-Identifier: MIT
#include <kodo/debug_draw.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace kodo {
namespace {

/// Elements of an XML document by name. Fails for tags that do not match, a bad attribute or bare
/// reserved letters in a text.
std::map<std::string, int> elementsOf(const std::string& xml) {
    std::map<std::string, int> counts;
    std::vector<std::string> open;
    std::size_t at = 0;
    while (at < xml.size()) {
        if (xml[at] != '<') {
            const std::size_t end = std::min(xml.find('<', at), xml.size());
            const std::string text = xml.substr(at, end - at);
            EXPECT_EQ(text.find('>'), std::string::npos) << text;
            for (std::size_t i = text.find('&'); i != std::string::npos;
                 i = text.find('&', i + 1)) {
                EXPECT_LT(text.find(';', i), i + 5) << text;
            }
            at = end;
            continue;
        }
        const std::size_t end = xml.find('>', at);
        std::string tag = xml.substr(at + 1, end - at - 1);
        at = end == std::string::npos ? xml.size() : end + 1;
        if (tag[0] == '/') {
            EXPECT_FALSE(open.empty() || open.back() != tag.substr(1)) << tag;
            open.pop_back();
            continue;
        }
        const std::string name = tag.substr(0, tag.find_first_of(" /"));
        ++counts[name];
        if (tag.back() != '/') {
            open.push_back(name);
        }
        EXPECT_EQ(std::count(tag.begin(), tag.end(), '"') % 2, 0) << tag;
        EXPECT_EQ(std::count(tag.begin(), tag.end(), '='),
                  std::count(tag.begin(), tag.end(), '"') / 2)
            << tag;
    }
    EXPECT_TRUE(open.empty());
    return counts;
}

TEST(SvgDraw, EachShapeIsAnElementOfAWellFormedDocument) {
    World world;
    world.add({.shape = Circle{1}, .position = {-5, 0}});
    world.add({.shape = Circle{1}, .position = {0, 0}});
    world.add({.shape = Box{1, 1}, .position = {5, 0}});
    world.add({.shape = Chain{.points = {{-8, -3}, {0, -4}, {8, -3}}}, .type = BodyType::Static});
    auto counts = elementsOf(svg(world));
    EXPECT_EQ(counts["svg"], 1);
    EXPECT_EQ(counts["circle"], 2);
    EXPECT_EQ(counts["polygon"], 1);
    EXPECT_EQ(counts["polyline"], 2 + 3); // segments, and the spokes of three bodies
    EXPECT_EQ(counts["text"], 0);
    counts = elementsOf(svg(world, {.labels = true}));
    EXPECT_EQ(counts["text"], 4);
}

TEST(SvgDraw, PlacesAreTenthsOfAPixelFromTheUpperLeftCorner) {
    SvgDraw picture({{-2, -1}, {2, 1}}, 400);
    picture.circle({-1, Real(0.5)}, Real(0.25), {});
    picture.line({-2, 1}, {2, -1}, {{255, 0, 127, 51}});
    const std::string text = picture.document();
    EXPECT_NE(text.find("viewBox=\"0 0 4000 2000\""), std::string::npos) << text;
    EXPECT_NE(text.find("translate(1000,500)\" r=\"250\""), std::string::npos) << text;
    EXPECT_NE(text.find("points=\"0,0 4000,2000\""), std::string::npos) << text;
    EXPECT_NE(text.find("stroke=\"rgb(255,0,127)\" stroke-opacity=\"0.20\""), std::string::npos)
        << text;
}

TEST(SvgDraw, TextsAreEscaped) {
    SvgDraw picture({{-2, -1}, {2, 1}});
    picture.text({}, "<a & b>\n\x01]]>", {});
    EXPECT_EQ(elementsOf(picture.document())["text"], 1);
    EXPECT_NE(picture.document().find(">&lt;a &amp; b&gt;]]&gt;<"), std::string::npos);
}

TEST(SvgDraw, ABadViewOrWidthIsRefused) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_THROW(SvgDraw({{0, 0}, {0, 1}}), BadDefinition);
    EXPECT_THROW(SvgDraw({{0, 1}, {1, 0}}), BadDefinition);
    EXPECT_THROW(SvgDraw({{0, 0}, {nan, 1}}), BadDefinition);
    EXPECT_THROW(SvgDraw({{0, 0}, {1, 1}}, 15), BadDefinition);
    EXPECT_THROW(SvgDraw({{0, 0}, {1, 1}}, 16385), BadDefinition);
    EXPECT_NO_THROW(SvgDraw({{0, 0}, {1, 1}}, 16));
}

} // namespace
} // namespace kodo
