// SPDX-License-Identifier: MIT
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

#include <stdexcept>

namespace kodo_c {
namespace {

/// What a query of the caller says, or what a null pointer means.
struct Selection {
    kodo::CollisionFilter which{};
    std::vector<kodo::BodyId> except{};
};

Selection selectionOf(const kodo_Query* query) {
    if (query == nullptr) {
        return {};
    }
    const kodo_Query& given = checked(query, "query", "kodo_Query");
    return {fromC(given.which), listFromC(itemsOf(given.except, given.exceptCount, "except"))};
}

kodo::Shape shapeFromC(const kodo_PlacedShape* placed) {
    return fromC(required(required(placed, "shape").shape, "shape.shape"));
}

void requireFunction(bool present) {
    if (!present) {
        throw std::logic_error("visit: must not be null");
    }
}

} // namespace

kodo_QueryHit toC(const kodo::QueryHit& hit) {
    const auto& [body, part, fraction, point, normal] = hit;
    return {true, toC(body), part, fraction, toC(point), toC(normal)};
}

} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_initQuery(kodo_Query* query, kodo_Head head) {
    return guarded([&] { initialise(query, head, "kodo_Query"); });
}

kodo_Status kodo_rayCast(const kodo_World* world, kodo_Ray ray, const kodo_Query* query,
                         kodo_QueryHit* hit) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        const std::optional<kodo::QueryHit> found =
            kodo::rayCast(worldOf(world), fromC(ray.from), fromC(ray.to), which, except);
        required(hit, "hit") = found ? toC(*found) : kodo_QueryHit{};
    });
}

kodo_Status kodo_rayCastAll(const kodo_World* world, kodo_Ray ray, const kodo_Query* query,
                            kodo_QueryHit* hits, size_t capacity, size_t* count) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        writeList(kodo::rayCastAll(worldOf(world), fromC(ray.from), fromC(ray.to), which, except),
                  hits, capacity, count);
    });
}

kodo_Status kodo_visitRay(const kodo_World* world, kodo_Ray ray, const kodo_Query* query,
                          kodo_VisitHit visit, void* context) {
    return guarded([&] {
        requireFunction(visit != nullptr);
        const auto [which, except] = selectionOf(query);
        const kodo::World& visited = worldOf(world);
        const InUse use(*world);
        kodo::visitRay(
            visited, fromC(ray.from), fromC(ray.to),
            [&](const kodo::QueryHit& hit) {
                const kodo_QueryHit made = toC(hit);
                return visit(context, &made);
            },
            which, except);
    });
}

kodo_Status kodo_shapeCast(const kodo_World* world, const kodo_PlacedShape* start,
                           kodo_Vec2 displacement, const kodo_Query* query, kodo_QueryHit* hit) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        const kodo::Shape shape = shapeFromC(start);
        const std::optional<kodo::QueryHit> found = kodo::shapeCast(
            worldOf(world), shape, fromC(start->at), fromC(displacement), which, except);
        required(hit, "hit") = found ? toC(*found) : kodo_QueryHit{};
    });
}

kodo_Status kodo_overlapBox(const kodo_World* world, kodo_Aabb box, const kodo_Query* query,
                            kodo_BodyId* ids, size_t capacity, size_t* count) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        writeList(kodo::overlap(worldOf(world), fromC(box), which, except), ids, capacity, count);
    });
}

kodo_Status kodo_overlapShape(const kodo_World* world, const kodo_PlacedShape* placed,
                              const kodo_Query* query, kodo_BodyId* ids, size_t capacity,
                              size_t* count) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        const kodo::Shape shape = shapeFromC(placed);
        writeList(kodo::overlap(worldOf(world), shape, fromC(placed->at), which, except), ids,
                  capacity, count);
    });
}

kodo_Status kodo_visitOverlaps(const kodo_World* world, const kodo_PlacedShape* placed,
                               const kodo_Query* query, kodo_VisitBody visit, void* context) {
    return guarded([&] {
        requireFunction(visit != nullptr);
        const auto [which, except] = selectionOf(query);
        const kodo::Shape shape = shapeFromC(placed);
        const kodo::World& visited = worldOf(world);
        const InUse use(*world);
        kodo::visitOverlaps(
            visited, shape, fromC(placed->at),
            [&](kodo::BodyId id) { return visit(context, toC(id)); }, which, except);
    });
}

kodo_Status kodo_closestPoint(const kodo_World* world, kodo_Vec2 point, kodo_Real maxDistance,
                              const kodo_Query* query, kodo_QueryPoint* closest) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        const std::optional<kodo::QueryPoint> found =
            kodo::closestPoint(worldOf(world), fromC(point), maxDistance, which, except);
        kodo_QueryPoint& made = required(closest, "closest");
        made = {};
        if (found) {
            const auto& [body, part, place, normal, distance] = *found;
            made = {true, toC(body), part, toC(place), toC(normal), distance};
        }
    });
}
