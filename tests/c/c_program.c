// SPDX-License-Identifier: MIT
// The header in C11: every function that makes a definition, shapes, and one World from begin to
// end. Prints nothing; exit code 1 names the line that failed.
#include <kodo.h>
#include <stdio.h>

#define REQUIRE(condition)                                                                         \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "line %d: %s: %s\n", __LINE__, #condition, kodo_errorText());          \
            return 1;                                                                              \
        }                                                                                          \
    } while (0)

static bool isNear(kodo_Real value, kodo_Real wanted) {
    const kodo_Real off = value - wanted;
    const kodo_Real most = (kodo_Real)0.01;
    return -most < off && off < most;
}

static int testValues(void) {
    const kodo_Rot quarter = kodo_rotation((kodo_Real)1.5707963267948966);
    const kodo_Transform t = {{1, 2}, quarter};
    const kodo_Vec2 p = kodo_toWorld(t, kodo_vec2(3, 0));
    const kodo_Vec2 back = kodo_toLocal(t, p);
    REQUIRE(isNear(p.x, 1) && isNear(p.y, 5));
    REQUIRE(isNear(back.x, 3) && isNear(back.y, 0));
    REQUIRE(isNear(kodo_angle(quarter), (kodo_Real)1.5708));
    REQUIRE(kodo_realSize() == sizeof(kodo_Real));
    return 0;
}

static int testWorld(void) {
    kodo_WorldDef def = kodo_worldDef();
    kodo_World* world;
    kodo_ThreadPool* pool;
    kodo_BodyId ground;
    kodo_BodyId box;
    kodo_JointId joint;
    const kodo_Vec2 points[] = {{-5, 0}, {0, 0}, {5, 0}};
    def.gravity.y = -10;
    def.settings = kodo_settings(KODO_ACCURATE);
    REQUIRE(kodo_createWorld(&def, &world) == KODO_OK);
    REQUIRE(kodo_createThreadPool(1, &pool) == KODO_OK);
    kodo_BodyDef body = kodo_bodyDef();
    body.shape = kodo_chain(points, 3);
    body.type = KODO_STATIC;
    REQUIRE(kodo_addBody(world, &body, &ground) == KODO_OK);
    body = kodo_bodyDef();
    body.shape = kodo_box(1, 1);
    body.position.y = 1;
    REQUIRE(kodo_addBody(world, &body, &box) == KODO_OK);
    kodo_JointDef slide = kodo_jointDef(KODO_PRISMATIC_JOINT);
    slide.prismatic.ends.a = ground;
    slide.prismatic.ends.b = box;
    slide.prismatic.ends.collide = true;
    slide.prismatic.axis = kodo_vec2(0, 1);
    REQUIRE(kodo_addJoint(world, &slide, &joint) == KODO_OK);
    kodo_StepOptions options = kodo_stepOptions();
    options.pool = pool;
    for (int i = 0; i < 60; ++i) {
        REQUIRE(kodo_step(world, (kodo_Real)1 / 60, &options) == KODO_OK);
    }
    kodo_BodyState state;
    REQUIRE(kodo_bodyState(world, box, &state) == KODO_OK);
    REQUIRE(isNear(state.transform.position.y, (kodo_Real)0.5));
    REQUIRE(kodo_step(world, -1, NULL) == KODO_BAD_DEFINITION);
    REQUIRE(kodo_errorText()[0] != '\0');
    REQUIRE(kodo_destroyWorld(world) == KODO_OK);
    REQUIRE(kodo_destroyThreadPool(pool) == KODO_OK);
    return 0;
}

int main(void) {
    return testValues() + testWorld();
}
