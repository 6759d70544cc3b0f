// SPDX-License-Identifier: MIT
// Rope: links and revolute joints carry a load. A second load breaks the weakest one.
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

typedef struct Rope {
    kodo_World* world;
    kodo_BodyId last;
    float end; // m, of the lower end of `last`, in its frame
} Rope;

static kodo_BodyId addBody(kodo_World* world, kodo_Shape shape, kodo_Vec2 place, float density) {
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = shape;
    def.position = place;
    def.density = density;
    kodo_BodyId id;
    check(kodo_addBody(world, &def, &id));
    return id;
}

static kodo_JointId hang(Rope* rope, kodo_BodyId body, float top, float breakForce) {
    kodo_JointDef def = kodo_jointDef(KODO_REVOLUTE_JOINT);
    def.revolute.ends.a = rope->last;
    def.revolute.ends.b = body;
    def.revolute.ends.anchorA.y = rope->end;
    def.revolute.ends.anchorB.y = top;
    def.revolute.ends.breakForce = breakForce;
    kodo_JointId id;
    check(kodo_addJoint(rope->world, &def, &id));
    rope->last = body;
    rope->end = -top;
    return id;
}

static void addLoad(Rope* rope) { // 4 kg at the lower end
    kodo_BodyState last;
    check(kodo_bodyState(rope->world, rope->last, &last));
    kodo_Vec2 place = kodo_toWorld(last.transform, kodo_vec2(0, rope->end));
    place.y -= 0.5f;
    hang(rope, addBody(rope->world, kodo_box(1, 1), place, 4), 0.5f, INFINITY);
}

static void run(kodo_World* world, int steps) {
    for (int i = 0; i < steps; ++i) {
        check(kodo_step(world, 1.0f / 60, NULL));
        kodo_BrokenJoint broken[12];
        size_t count;
        check(kodo_brokenJoints(world, broken, 12, &count));
        for (size_t j = 0; j < count; ++j) {
            printf("joint %u broke at %.1f N\n", broken[j].id.index, broken[j].force);
        }
    }
}

int main(void) {
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -10;
    Rope rope;
    check(kodo_createWorld(&worldDef, &rope.world));
    kodo_BodyDef hook = kodo_bodyDef();
    hook.shape = kodo_circle(0.1f);
    hook.type = KODO_STATIC;
    check(kodo_addBody(rope.world, &hook, &rope.last));
    rope.end = 0;

    // Ten links of 0.5 m, 0.05 kg each, hang straight down. The joint in the middle is the weakest.
    kodo_JointId first;
    for (int i = 0; i < 10; ++i) {
        const kodo_Vec2 place = kodo_vec2(0, -0.25f - 0.5f * (float)i);
        const kodo_BodyId link = addBody(rope.world, kodo_box(0.1f, 0.5f), place, 1);
        const kodo_JointId joint = hang(&rope, link, 0.25f, i == 5 ? 70.0f : 200.0f);
        if (i == 0) {
            first = joint;
        }
    }
    kodo_Load load;
    run(rope.world, 60);
    check(kodo_jointLoad(rope.world, first, &load));
    printf("rope alone: %.1f N\n", load.force.y);
    addLoad(&rope);
    run(rope.world, 120);
    check(kodo_jointLoad(rope.world, first, &load));
    printf("with 4 kg: %.1f N\n", load.force.y);
    addLoad(&rope); // 8 kg in all
    run(rope.world, 60);
    size_t left;
    check(kodo_joints(rope.world, NULL, 0, &left));
    printf("%zu of 12 joints left\n", left);
    check(kodo_destroyWorld(rope.world));
    return 0;
}
