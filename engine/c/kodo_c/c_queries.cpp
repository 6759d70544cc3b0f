// SPDX-License-Identifier: MIT
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

#include <stdexcept>
#include <variant>

namespace kodo_c {
namespace {

static_assert(KODO_START_NORMAL == static_cast<int>(kodo::StartOverlap::Normal));
static_assert(KODO_START_IGNORE == static_cast<int>(kodo::StartOverlap::Ignore));

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

template <typename Placed>
kodo::Shape shapeFromC(const Placed* placed) {
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

kodo_QueryPoint toC(const kodo::QueryPoint& closest) {
    const auto& [body, part, point, normal, distance] = closest;
    return {true, toC(body), part, toC(point), toC(normal), distance};
}

kodo_RaySpan toC(const kodo::RaySpan& span) {
    const auto& [entry, exitFraction, exitPoint, exitNormal] = span;
    return {toC(entry), exitFraction, toC(exitPoint), toC(exitNormal)};
}

kodo_QueryContact toC(const kodo::QueryContact& contact) {
    const auto& [body, part, point, normal, separation] = contact;
    return {toC(body), part, toC(point), toC(normal), separation};
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

kodo_Status kodo_raySpans(const kodo_World* world, kodo_Ray ray, const kodo_Query* query,
                          kodo_RaySpan* spans, size_t capacity, size_t* count) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        writeList(kodo::raySpans(worldOf(world), fromC(ray.from), fromC(ray.to), which, except),
                  spans, capacity, count);
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

kodo_Status kodo_initCastDef(kodo_CastDef* def, kodo_Head head) {
    return guarded([&] {
        initialise(def, head, "kodo_CastDef");
        const auto [shape, start, displacement, angle, atStart] = kodo::ShapeCast{};
        def->shape = kodo_circle(std::get<kodo::Circle>(shape).radius);
        def->start = toC(start);
        def->displacement = toC(displacement);
        def->angle = angle;
        def->atStart = static_cast<kodo_StartOverlap>(atStart);
    });
}

kodo_Status kodo_castShape(const kodo_World* world, const kodo_CastDef* def,
                           const kodo_Query* query, kodo_QueryHit* hit) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        const kodo_CastDef& given = checked(def, "def", "kodo_CastDef");
        requireKind(given.atStart, KODO_START_IGNORE + 1, "def.atStart");
        const kodo::ShapeCast cast{fromC(given.shape), fromC(given.start),
                                   fromC(given.displacement), given.angle,
                                   static_cast<kodo::StartOverlap>(given.atStart)};
        const std::optional<kodo::QueryHit> found =
            kodo::shapeCast(worldOf(world), cast, which, except);
        required(hit, "hit") = found ? toC(*found) : kodo_QueryHit{};
    });
}

kodo_Status kodo_collide(const kodo_World* world, const kodo_NearShape* placed,
                         const kodo_Query* query, kodo_QueryContact* contacts, size_t capacity,
                         size_t* count) {
    return guarded([&] {
        const auto [which, except] = selectionOf(query);
        const kodo::Shape shape = shapeFromC(placed);
        writeList(
            kodo::collide(worldOf(world), shape, fromC(placed->at), placed->margin, which, except),
            contacts, capacity, count);
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
        required(closest, "closest") = found ? toC(*found) : kodo_QueryPoint{};
    });
}

kodo_Status kodo_closestPointOf(const kodo_World* world, kodo_BodyId id, kodo_Vec2 point,
                                kodo_QueryPoint* closest) {
    return guarded([&] {
        required(closest, "closest") =
            toC(kodo::closestPoint(worldOf(world)[fromC(id)], fromC(point)));
    });
}

kodo_Status kodo_distance(const kodo_World* world, kodo_BodyId a, kodo_BodyId b,
                          kodo_ClosestPoints* points) {
    return guarded([&] {
        const kodo::World& of = worldOf(world);
        const auto [onA, onB, normal, distance] = kodo::distance(of[fromC(a)], of[fromC(b)]);
        required(points, "points") = {toC(onA), toC(onB), toC(normal), distance};
    });
}

kodo_Status kodo_touching(const kodo_World* world, kodo_BodyId id, kodo_BodyId* ids,
                          size_t capacity, size_t* count) {
    return guarded(
        [&] { writeList(kodo::touching(worldOf(world), fromC(id)), ids, capacity, count); });
}
