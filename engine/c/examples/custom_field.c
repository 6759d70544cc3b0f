// SPDX-License-Identifier: MIT
// Custom force field: a magnet that pulls iron bodies and leaves wood alone.
#include <kodo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

typedef struct Magnet {
    kodo_Vec2 center;
    float radius; // m
    float pull;   // N
} Magnet;

// Pulls with a constant force within a radius, and brakes: F = pull d / |d| - drag v. Called once
// per step for each body. It depends on its arguments alone and changes nothing.
static void pull(void* context, const kodo_FieldBody* body, kodo_Real dt, kodo_FieldForce* force) {
    const Magnet* magnet = context;
    const float drag = 2; // N s/m; given as `drag`, so that no step overshoots
    const float x = magnet->center.x - body->midStep.position.x;
    const float y = magnet->center.y - body->midStep.position.y;
    const float distance = sqrtf(x * x + y * y);
    (void)dt;
    if (distance > 0 && distance <= magnet->radius) {
        force->force.x = magnet->pull * (x / distance) - drag * body->velocity.x;
        force->force.y = magnet->pull * (y / distance) - drag * body->velocity.y;
        force->drag = drag;
    }
}

static kodo_BodyId addBall(kodo_World* world, float x, float density, kodo_Flags flags) {
    kodo_BodyDef def = kodo_bodyDef(); // a circle of radius 0.5 m
    def.position = kodo_vec2(x, 2);
    def.density = density;
    def.flags = flags;
    kodo_BodyId id;
    check(kodo_addBody(world, &def, &id));
    return id;
}

static float heightOf(const kodo_World* world, kodo_BodyId id) {
    kodo_BodyState state;
    check(kodo_bodyState(world, id, &state));
    return state.transform.position.y;
}

int main(void) {
    enum { IRON = 1 }; // a category
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -10;
    kodo_World* world;
    check(kodo_createWorld(&worldDef, &world));
    kodo_BodyDef ground = kodo_bodyDef();
    ground.shape = kodo_plane(kodo_vec2(0, 1), 0);
    ground.type = KODO_STATIC;
    kodo_BodyId groundId;
    check(kodo_addBody(world, &ground, &groundId));

    Magnet magnet = {{0, 6}, 5, 30};
    kodo_Field field = kodo_field(KODO_OWN_FIELD);
    field.own.at = pull;
    field.own.context = &magnet;
    field.which.flags = KODO_MATCH_ANY; // acts on bodies with the category IRON
    field.which.required = IRON;
    check(kodo_addField(world, &field));

    const kodo_BodyId iron = addBall(world, -1, 1.5f, IRON);
    const kodo_BodyId wood = addBall(world, 1, 0.5f, 0);
    for (int step = 0; step <= 240; ++step) {
        if (step % 60 == 0) {
            printf("%d s: iron at %.1f m, wood at %.1f m\n", step / 60, heightOf(world, iron),
                   heightOf(world, wood));
        }
        check(kodo_step(world, 1.0f / 60, NULL));
    }
    check(kodo_destroyWorld(world));
    return 0;
}
