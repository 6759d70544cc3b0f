// SPDX-License-Identifier: MIT
// Hello: a ball falls on the ground and bounces.
#include <kodo.h>
#include <stdio.h>
#include <stdlib.h>

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

int main(void) {
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -10;
    kodo_World* world;
    check(kodo_createWorld(&worldDef, &world));

    // A contact takes the smaller restitution of the two materials.
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = kodo_box(20, 1);
    def.position.y = -0.5f;
    def.material = kodo_withFriction(0.6f, 0.8f);
    def.type = KODO_STATIC;
    kodo_BodyId ground;
    check(kodo_addBody(world, &def, &ground));
    def.shape = kodo_circle(0.5f);
    def.position.y = 4;
    def.type = KODO_DYNAMIC;
    kodo_BodyId ball;
    check(kodo_addBody(world, &def, &ball));

    for (int step = 1; step <= 180; ++step) {
        check(kodo_step(world, 1.0f / 60, NULL));
        kodo_CollisionRecord hits[4];
        size_t count;
        check(kodo_begunCollisions(world, hits, 4, &count));
        for (size_t i = 0; i < count; ++i) {
            if (kodo_involves(&hits[i], ground)) {
                printf("%.2f s: hits the ground at %.1f m/s\n", step / 60.0, hits[i].approachSpeed);
            }
        }
        if (step % 30 == 0) {
            kodo_BodyState state;
            check(kodo_bodyState(world, ball, &state));
            printf("%.2f s: height %.2f m\n", step / 60.0, state.transform.position.y);
        }
    }
    check(kodo_destroyWorld(world));
    return 0;
}
