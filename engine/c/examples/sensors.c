// SPDX-License-Identifier: MIT
// Sensors: a gate counts the balls of one team that roll through it, without touching them.
#include <kodo.h>
#include <stdio.h>
#include <stdlib.h>

enum { RED = 1, BLUE = 2 }; // categories

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

typedef kodo_Status (*List)(const kodo_World*, kodo_CollisionRecord*, size_t, size_t*);

static void report(const kodo_World* world, kodo_BodyId gate, List list, int step, int* inside) {
    const bool begins = list == kodo_begunCollisions;
    kodo_CollisionRecord touches[8];
    size_t count;
    check(list(world, touches, 8, &count));
    for (size_t i = 0; i < count; ++i) {
        const kodo_BodyId other = kodo_other(&touches[i], gate);
        bool exists;
        check(kodo_containsBody(world, other, &exists));
        if (!kodo_involves(&touches[i], gate)) {
            continue;
        }
        *inside += begins ? 1 : -1;
        if (exists) { // else it was removed while inside
            kodo_BodyState ball;
            check(kodo_bodyState(world, other, &ball));
            printf("%.2f s: ball %d %s, %d inside\n", step / 60.0, (int)ball.userData,
                   begins ? "enters" : "leaves", *inside);
        }
    }
}

int main(void) {
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -10;
    kodo_World* world;
    check(kodo_createWorld(&worldDef, &world));
    kodo_BodyId gate;
    kodo_BodyDef fixed = kodo_bodyDef();
    fixed.shape = kodo_plane(kodo_vec2(0, 1), 0);
    fixed.type = KODO_STATIC;
    check(kodo_addBody(world, &fixed, &gate));
    fixed.shape = kodo_box(0.2f, 3);
    fixed.position.y = 1.5f;
    fixed.flags = KODO_SENSOR | KODO_MATCH_ANY; // detects bodies with a required flag
    fixed.required = RED;
    check(kodo_addBody(world, &fixed, &gate));
    for (int i = 0; i < 4; ++i) {
        kodo_BodyDef ball = kodo_bodyDef();
        ball.shape = kodo_circle(0.25f);
        ball.position = kodo_vec2(-2 - (float)i, 0.25f);
        ball.velocity.x = 4;
        ball.flags = i % 2 == 0 ? RED : BLUE;
        ball.userData = (uint64_t)i;
        kodo_BodyId id;
        check(kodo_addBody(world, &ball, &id));
    }

    int inside = 0;
    for (int step = 1; step <= 150; ++step) {
        check(kodo_step(world, 1.0f / 60, NULL));
        report(world, gate, kodo_begunCollisions, step, &inside);
        report(world, gate, kodo_endedCollisions, step, &inside);
    }

    // A query finds what is in a region now, without a sensor.
    kodo_Query query = kodo_query();
    query.which.flags = KODO_MATCH_ANY;
    query.which.required = BLUE;
    const kodo_Aabb box = {{0, 0}, {20, 3}};
    size_t count;
    check(kodo_overlapBox(world, box, &query, NULL, 0, &count));
    printf("%zu blue balls behind the gate\n", count);
    check(kodo_destroyWorld(world));
    return 0;
}
