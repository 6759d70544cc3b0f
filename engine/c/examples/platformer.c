// SPDX-License-Identifier: MIT
// Platformer: a mover walks over tiles, up a slope and steps, rides on a lift, and jumps through a
// one-way ledge.
#include <kodo.h>
#include <stdio.h>
#include <stdlib.h>

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

static void tell(const kodo_Mover* player, const char* what, int step) {
    printf("step %3d: %s at (%.2f, %.2f)\n", step, what, player->position.x, player->position.y);
}

static void addStatic(kodo_World* world, kodo_Shape shape) {
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = shape;
    def.type = KODO_STATIC;
    kodo_BodyId id;
    check(kodo_addBody(world, &def, &id));
}

static kodo_Shape boxAt(kodo_Real height, kodo_Vec2 center) {
    kodo_Shape box = kodo_box(1, height);
    box.box.center = center;
    return box;
}

static void addGround(kodo_World* world) {
    // Ten flat cells of 1 m, a slope of 27 degrees, and two steps of 0.25 m.
    const kodo_Real heights[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5f, 1, 1};
    addStatic(world, kodo_heightmap(1, heights, sizeof(heights) / sizeof(heights[0])));
    addStatic(world, boxAt(0.25f, kodo_vec2(13.5f, 1.125f)));
    addStatic(world, boxAt(0.5f, kodo_vec2(14.5f, 1.25f)));
    // The front of a one-sided segment is on the left of from -> to: here, above.
    kodo_Shape ledge = kodo_segment(kodo_vec2(4, 2), kodo_vec2(9, 2));
    ledge.segment.oneSided = true;
    addStatic(world, ledge);
}

int main(void) {
    kodo_World* world; // the mover has its own gravity
    check(kodo_createWorld(NULL, &world));
    addGround(world);
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = kodo_box(2, 0.5f);
    def.position = kodo_vec2(16, 1.25f);
    def.type = KODO_KINEMATIC;
    kodo_BodyId lift;
    check(kodo_addBody(world, &def, &lift));

    kodo_Mover player = kodo_mover();
    player.position = kodo_vec2(1, 0.71f);
    const kodo_Real dt = 1.0f / 60, gravity = 20; // s, m/s^2
    bool wasGrounded = false;
    for (int step = 1; step <= 420; ++step) {
        if (step == 300) {
            check(kodo_setVelocity(world, lift, kodo_vec2(0, 1)));
        }
        check(kodo_step(world, dt, NULL));
        const bool jumps = step == 40 && player.grounded;
        const bool runs = player.position.x < 16;
        const kodo_Real rise = jumps ? 10 : player.velocity.y - gravity * dt;
        check(kodo_moveMover(world, &player, kodo_vec2(runs ? 5 : 0, rise), dt));
        if (player.grounded != wasGrounded) {
            tell(&player, player.grounded ? "lands" : "leaves the ground", step);
        }
        wasGrounded = player.grounded;
    }
    tell(&player, kodo_sameBody(player.groundBody, lift) ? "rides on the lift" : "stands", 420);
    check(kodo_destroyWorld(world));
    return 0;
}
