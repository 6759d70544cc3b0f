// SPDX-License-Identifier: MIT
// Platformer ground: a heightmap without ghost collisions, and a one-way ledge.
#include <kodo.h>
#include <stdio.h>
#include <stdlib.h>

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

// Supported: a contact of the last step that carries the player.
static bool onGround(const kodo_World* world, kodo_BodyId player) {
    kodo_CollisionRecord hits[8];
    size_t count;
    check(kodo_collisionsOf(world, player, hits, 8, &count));
    for (size_t i = 0; i < count; ++i) {
        const float y = hits[i].normal.y;
        const float up = kodo_sameBody(hits[i].a, player) ? -y : y;
        if (hits[i].totalImpulse > 0 && up > 0.7f) {
            return true;
        }
    }
    return false;
}

static void tell(const kodo_World* world, kodo_BodyId player, const char* what, int step) {
    kodo_BodyState state;
    check(kodo_bodyState(world, player, &state));
    const kodo_Vec2 place = state.transform.position;
    printf("step %3d: %s at (%.1f, %.1f)\n", step, what, place.x, place.y);
}

static void addGround(kodo_World* world) {
    // Ten flat cells of 1 m, then a slope. Bodies slide over the joins.
    const kodo_Real heights[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5f, 1, 1.5f, 2};
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = kodo_heightmap(1, heights, sizeof(heights) / sizeof(heights[0]));
    def.type = KODO_STATIC;
    kodo_BodyId id;
    check(kodo_addBody(world, &def, &id));
    // The front of a one-sided segment is on the left of from -> to: here, above.
    def.shape = kodo_segment(kodo_vec2(7, 2), kodo_vec2(9, 2));
    def.shape.segment.oneSided = true;
    check(kodo_addBody(world, &def, &id));
}

int main(void) {
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -20;
    kodo_World* world;
    check(kodo_createWorld(&worldDef, &world));
    addGround(world);
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = kodo_box(0.6f, 1);
    def.position = kodo_vec2(1, 0.5f);
    def.material = kodo_withFriction(0, 0);
    def.flags = KODO_LOCK_ROTATE | KODO_NEVER_SLEEP;
    kodo_BodyId player;
    check(kodo_addBody(world, &def, &player));

    bool wasOnGround = true;
    for (int step = 1; step <= 240; ++step) {
        kodo_BodyState state;
        check(kodo_bodyState(world, player, &state));
        state.velocity.x = step < 90 ? 5.0f : 0.0f;  // run to the right, then stand
        if (step == 72 && onGround(world, player)) { // jump through the ledge
            state.velocity.y = 10;
            tell(world, player, "jumps", step);
        }
        check(kodo_setVelocity(world, player, state.velocity));
        check(kodo_step(world, 1.0f / 60, NULL));
        const bool isOnGround = onGround(world, player);
        if (isOnGround && !wasOnGround) {
            tell(world, player, "lands", step);
        }
        wasOnGround = isOnGround;
    }
    tell(world, player, "stands", 240);
    check(kodo_destroyWorld(world));
    return 0;
}
