// SPDX-License-Identifier: MIT
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

namespace kodo_c {
namespace {

static_assert(KODO_BEGIN == static_cast<int>(kodo::TouchPhase::Begin));
static_assert(KODO_PERSIST == static_cast<int>(kodo::TouchPhase::Persist));
static_assert(KODO_END == static_cast<int>(kodo::TouchPhase::End));

kodo_RecordPoint pointToC(const kodo::RecordPoint& point) {
    const auto& [position, separation, maxImpulse] = point;
    return {toC(position), separation, maxImpulse};
}

} // namespace

kodo_CollisionRecord toC(const kodo::CollisionRecord& record) {
    const auto& [a, b, partA, partB, phase, pointCount, points, point, normal, separation,
                 approachSpeed, maxImpulse, totalImpulse, tangentImpulse] = record;
    kodo_CollisionRecord made{};
    made.a = toC(a);
    made.b = toC(b);
    made.partA = partA;
    made.partB = partB;
    made.phase = static_cast<kodo_TouchPhase>(phase);
    made.pointCount = pointCount;
    made.points[0] = pointToC(points[0]);
    made.points[1] = pointToC(points[1]);
    made.point = toC(point);
    made.normal = toC(normal);
    made.separation = separation;
    made.approachSpeed = approachSpeed;
    made.maxImpulse = maxImpulse;
    made.totalImpulse = totalImpulse;
    made.tangentImpulse = tangentImpulse;
    return made;
}

} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_collisions(const kodo_World* world, kodo_CollisionRecord* records, size_t capacity,
                            size_t* count) {
    return guarded([&] { writeList(worldOf(world).collisions(), records, capacity, count); });
}

kodo_Status kodo_begunCollisions(const kodo_World* world, kodo_CollisionRecord* records,
                                 size_t capacity, size_t* count) {
    return guarded([&] { writeList(worldOf(world).begunCollisions(), records, capacity, count); });
}

kodo_Status kodo_endedCollisions(const kodo_World* world, kodo_CollisionRecord* records,
                                 size_t capacity, size_t* count) {
    return guarded([&] { writeList(worldOf(world).endedCollisions(), records, capacity, count); });
}

kodo_Status kodo_hits(const kodo_World* world, kodo_Real minSpeed, kodo_CollisionRecord* records,
                      size_t capacity, size_t* count) {
    return guarded([&] { writeList(worldOf(world).hits(minSpeed), records, capacity, count); });
}

kodo_Status kodo_collisionsOf(const kodo_World* world, kodo_BodyId id,
                              kodo_CollisionRecord* records, size_t capacity, size_t* count) {
    return guarded(
        [&] { writeList(worldOf(world).collisions(fromC(id)), records, capacity, count); });
}
