// SPDX-License-Identifier: MIT
// Breakable tower: a brick breaks into two halves if an impulse exceeds its strength.
#include <kodo.h>
#include <stdio.h>
#include <stdlib.h>

enum { BRICK = 1, MOST = 64 }; // a category; room for records

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

static kodo_BodyId add(kodo_World* world, const kodo_BodyDef* def) {
    kodo_BodyId id;
    check(kodo_addBody(world, def, &id));
    return id;
}

static void build(kodo_World* world) {
    kodo_BodyDef ground = kodo_bodyDef();
    ground.shape = kodo_plane(kodo_vec2(0, 1), 0);
    ground.type = KODO_STATIC;
    add(world, &ground);
    for (int row = 0; row < 8; ++row) {
        kodo_BodyDef brick = kodo_bodyDef();
        brick.shape = kodo_box(1, 0.5f);
        brick.position.y = 0.25f + 0.5f * (float)row;
        brick.flags = BRICK;
        add(world, &brick);
    }
    for (int step = 0; step < 60; ++step) {
        check(kodo_step(world, 1.0f / 60, NULL));
    }
    kodo_BodyDef ball = kodo_bodyDef();
    ball.shape = kodo_circle(0.4f);
    ball.position = kodo_vec2(-6, 2.2f);
    ball.velocity = kodo_vec2(25, 2);
    ball.density = 4;
    add(world, &ball);
}

// Adds a body to a list, once. Returns the new length.
static size_t note(kodo_BodyId* list, size_t length, kodo_BodyId id) {
    for (size_t i = 0; i < length; ++i) {
        if (kodo_sameBody(list[i], id)) {
            return length;
        }
    }
    list[length] = id;
    return length + 1;
}

static size_t brokenIn(const kodo_World* world, int step, kodo_BodyId* broken) {
    const float strength = 3; // N s; the lowest brick carries 0.7 N s per step
    kodo_CollisionRecord hits[MOST];
    size_t count;
    size_t length = 0;
    check(kodo_collisions(world, hits, MOST, &count));
    for (size_t i = 0; i < 2 * count && i < 2 * MOST; ++i) {
        const kodo_CollisionRecord* hit = &hits[i / 2];
        if (hit->totalImpulse <= strength) {
            continue;
        }
        kodo_BodyState body;
        check(kodo_bodyState(world, i % 2 == 0 ? hit->a : hit->b, &body));
        if ((body.flags & BRICK) != 0) {
            const size_t before = length;
            length = note(broken, length, body.id);
            if (length > before) {
                printf("step %d: brick %u breaks under %.1f N s\n", step, body.id.index,
                       hit->totalImpulse);
            }
        }
    }
    return length;
}

static void halve(kodo_World* world, kodo_BodyId id) { // keeps mass, momentum and spin
    kodo_BodyState brick;
    check(kodo_bodyState(world, id, &brick));
    for (int side = -1; side <= 1; side += 2) {
        kodo_BodyDef half = kodo_bodyDef();
        half.shape = kodo_box(0.5f, 0.5f);
        half.position = kodo_toWorld(brick.transform, kodo_vec2(0.25f * (float)side, 0));
        half.rotation = brick.transform.rotation;
        check(kodo_velocityAt(world, id, half.position, &half.velocity));
        half.angularVelocity = brick.angularVelocity;
        add(world, &half);
    }
    check(kodo_removeBody(world, id));
}

int main(void) {
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -10;
    kodo_World* world;
    check(kodo_createWorld(&worldDef, &world));
    build(world);
    for (int step = 0; step < 240; ++step) {
        check(kodo_step(world, 1.0f / 60, NULL));
        kodo_BodyId broken[2 * MOST];
        const size_t length = brokenIn(world, step, broken);
        for (size_t i = 0; i < length; ++i) {
            halve(world, broken[i]);
        }
    }
    size_t count;
    check(kodo_bodyCount(world, &count));
    printf("%zu bodies at the end\n", count);
    check(kodo_destroyWorld(world));
    return 0;
}
