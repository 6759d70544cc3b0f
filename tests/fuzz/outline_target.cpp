// SPDX-License-Identifier: MIT
// Points of a user as a hull, polygon, heightmap or chain: check() and add() agree, hulls contain
// their points, and a World with the shape steps.
#include <fuzz/fuzz.hpp>

#include <cmath>

namespace {

using namespace kodo;

std::vector<Vec2> points(fuzz::Feed& feed) {
    std::vector<Vec2> result(feed.below(64));
    for (Vec2& point : result) {
        point = feed.point();
    }
    return result;
}

/// check() refuses exactly what add() refuses, with the same words.
void addIfGood(const BodyDef& def) {
    World world({.gravity = {0, -10}});
    const std::optional<Problem> problem = check(def);
    const std::uint64_t before = world.stateHash();
    try {
        world.add(def);
        fuzz::require(!problem, "add() accepts what check() refuses");
    } catch (const BadDefinition& refused) {
        fuzz::require(problem && problem->text() == refused.problem().text(),
                      "add() refuses for another reason than check()");
        fuzz::require(world.stateHash() == before, "a refusal changes the World");
        return;
    }
    world.add({.shape = Circle{Real(0.5)}, .position = {0, 3}});
    world.add({.shape = Box{1, Real(0.3)}, .position = {1, 4}});
    for (int step = 0; step < 12; ++step) {
        world.step(Real(1) / 30);
    }
    for (const BodyId id : world.bodies()) {
        const Vec2 p = world[id].position();
        fuzz::require(std::isfinite(p.x) && std::isfinite(p.y), "a position is not finite");
    }
}

void tryHull(const std::vector<Vec2>& given) {
    const auto hull = convexHull(given);
    const auto box = fitBox(given);
    fuzz::require(hull.index() == box.index(), "there is a hull, but no box, or the reverse");
    const auto* const polygon = std::get_if<Polygon>(&hull);
    if (polygon == nullptr) {
        return;
    }
    fuzz::require(!check(Primitive(*polygon)), "check() refuses a hull");
    const Aabb bounds = boundsOf(*polygon);
    const Real size = length(bounds.extent()) + length(bounds.center());
    const ConvexShape convex = convexShapeOf(*polygon, {});
    for (const Vec2 point : given) {
        fuzz::require(distance(convex, {}, point).distance <= Real(1e-4) * size,
                      "a point lies outside its hull");
    }
    addIfGood({.shape = *polygon});
}

Chain chainOf(fuzz::Feed& feed) {
    const unsigned kind = static_cast<unsigned>(feed.below(4));
    return {.points = points(feed), .closed = (kind & 1) != 0, .oneSided = (kind & 2) != 0};
}

Heightmap heightmapOf(fuzz::Feed& feed) {
    Heightmap map{feed.point(), feed.number(), {}};
    map.heights.resize(feed.below(64));
    for (Real& height : map.heights) {
        height = feed.number();
    }
    return map;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Feed feed(data, size);
    switch (feed.below(4)) {
    case 0:
        tryHull(points(feed));
        break;
    case 1:
        addIfGood({.shape = Polygon{points(feed)}});
        break;
    case 2:
        addIfGood({.shape = heightmapOf(feed), .type = BodyType::Static});
        break;
    default:
        addIfGood({.shape = chainOf(feed), .type = BodyType::Static});
        break;
    }
    return 0;
}
