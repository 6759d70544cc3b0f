// SPDX-License-Identifier: MIT
#include <kodo/mover.hpp>
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

namespace kodo_c {
namespace {

/// All members but the head and the shape, which a move does not change.
void writeMover(const kodo::Mover& mover, kodo_Mover& made) {
    const auto& [shape, position, up, slopeLimit, stepHeight, skin, pushForce, weight, which, body,
                 velocity, grounded, groundNormal, groundBody, groundPose, wallNormal] = mover;
    static_cast<void>(shape);
    made.position = toC(position);
    made.up = toC(up);
    made.slopeLimit = slopeLimit;
    made.stepHeight = stepHeight;
    made.skin = skin;
    made.pushForce = pushForce;
    made.weight = weight;
    made.which = toC(which);
    made.body = toC(body);
    made.velocity = toC(velocity);
    made.grounded = grounded;
    made.groundNormal = toC(groundNormal);
    made.groundBody = toC(groundBody);
    made.groundPose = toC(groundPose);
    made.wallNormal = toC(wallNormal);
}

kodo::Mover moverFromC(const kodo_Mover& given) {
    kodo::Mover made;
    made.shape = primitiveFromC(given.shape, "mover.shape");
    made.position = fromC(given.position);
    made.up = fromC(given.up);
    made.slopeLimit = given.slopeLimit;
    made.stepHeight = given.stepHeight;
    made.skin = given.skin;
    made.pushForce = given.pushForce;
    made.weight = given.weight;
    made.which = fromC(given.which);
    made.body = fromC(given.body);
    made.velocity = fromC(given.velocity);
    made.grounded = given.grounded;
    made.groundNormal = fromC(given.groundNormal);
    made.groundBody = fromC(given.groundBody);
    made.groundPose = fromC(given.groundPose);
    made.wallNormal = fromC(given.wallNormal);
    return made;
}

} // namespace

kodo_ExplosionHit toC(const kodo::ExplosionHit& hit) {
    const auto& [body, point, impulse, width] = hit;
    return {toC(body), toC(point), toC(impulse), width};
}

} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_initMover(kodo_Mover* mover, kodo_Head head) {
    return guarded([&] {
        initialise(mover, head, "kodo_Mover");
        const kodo::Mover defaults;
        mover->shape = toC(defaults.shape);
        writeMover(defaults, *mover);
    });
}

kodo_Status kodo_moveMover(kodo_World* world, kodo_Mover* mover, kodo_Vec2 wish, kodo_Real dt) {
    return guarded([&] {
        kodo::Mover moved = moverFromC(checked(mover, "mover", "kodo_Mover"));
        moved.move(worldOf(world), fromC(wish), dt);
        writeMover(moved, *mover);
    });
}

kodo_Status kodo_initExplosion(kodo_Explosion* explosion, kodo_Head head) {
    return guarded([&] {
        initialise(explosion, head, "kodo_Explosion");
        const auto [center, radius, falloff, impulse, which] = kodo::Explosion{};
        explosion->center = toC(center);
        explosion->radius = radius;
        explosion->falloff = falloff;
        explosion->impulse = impulse;
        explosion->which = toC(which);
    });
}

kodo_Status kodo_lockAxis(kodo_World* world, kodo_BodyId body, kodo_Vec2 axis,
                          kodo_BodyId* groove) {
    return guarded([&] {
        requirePointer(groove, "groove"); // before anything is added
        *groove = toC(kodo::lockAxis(worldOf(world), fromC(body), fromC(axis)));
    });
}

kodo_Status kodo_explode(kodo_World* world, const kodo_Explosion* explosion,
                         kodo_ExplosionHit* hits, size_t capacity, size_t* count) {
    return guarded([&] {
        const kodo_Explosion& given = checked(explosion, "explosion", "kodo_Explosion");
        requirePointer(count, "count"); // before anything is pushed
        if (capacity > 0) {
            requirePointer(hits, "items");
        }
        writeList(kodo::explode(worldOf(world), {fromC(given.center), given.radius, given.falloff,
                                                 given.impulse, fromC(given.which)}),
                  hits, capacity, count);
    });
}
