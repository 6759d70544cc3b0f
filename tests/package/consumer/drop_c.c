// SPDX-License-Identifier: MIT
// The program of drop.cpp in C: prints the same.
#include <inttypes.h>
#include <kodo.h>
#include <stdio.h>
#include <stdlib.h>

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

static void lift(void* context, const kodo_FieldBody* body, kodo_Real dt, kodo_FieldForce* force) {
    (void)context;
    (void)dt;
    force->force.y = body->mass;
}

int main(void) {
    kodo_ThreadPool* threads;
    kodo_World* world;
    kodo_BodyId id;
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -10;
    check(kodo_createThreadPool(1, &threads));
    check(kodo_createWorld(&worldDef, &world));
    kodo_Field field = kodo_field(KODO_OWN_FIELD);
    field.own.at = lift;
    check(kodo_addField(world, &field));
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = kodo_box(20, 1);
    def.type = KODO_STATIC;
    check(kodo_addBody(world, &def, &id));
    def = kodo_bodyDef();
    def.position.y = 10;
    def.rotation = kodo_rotation(1);
    def.material = kodo_withFriction((kodo_Real)0.5, 1);
    check(kodo_addBody(world, &def, &id));
    kodo_StepOptions options = kodo_stepOptions();
    options.pool = threads;
    for (int i = 0; i < 240; ++i) {
        check(kodo_step(world, (kodo_Real)1 / 60, &options));
    }
    def.shape = kodo_circle(-1);
    if (kodo_addBody(world, &def, &id) != KODO_BAD_DEFINITION) {
        return 1;
    }
    uint64_t hash;
    const unsigned version = kodo_version();
    check(kodo_stateHash(world, &hash));
    printf("%016" PRIx64 " %u.%u.%u\n", hash, version / 10000, version / 100 % 100, version % 100);
    check(kodo_destroyWorld(world));
    check(kodo_destroyThreadPool(threads));
    return 0;
}
