// SPDX-License-Identifier: MIT
// A World as a picture: writes an SVG of boxes and circles, from their parts, to the output.
#include <kodo.h>
#include <stdio.h>
#include <stdlib.h>

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

static kodo_World* newPyramid(void) {
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -10;
    kodo_World* world;
    check(kodo_createWorld(&worldDef, &world));
    kodo_BodyId id;
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = kodo_box(10, 1);
    def.position.y = -0.5f;
    def.type = KODO_STATIC;
    check(kodo_addBody(world, &def, &id));
    def.shape = kodo_box(0.9f, 0.9f);
    def.type = KODO_DYNAMIC;
    for (int row = 0; row < 4; ++row) {
        for (int i = 0; i < 4 - row; ++i) {
            def.position = kodo_vec2((float)i - 0.5f * (float)(3 - row), 0.5f + (float)row);
            check(kodo_addBody(world, &def, &id));
        }
    }
    def.shape = kodo_circle(0.4f);
    def.position = kodo_vec2(0, 6);
    check(kodo_addBody(world, &def, &id));
    return world;
}

static void drawBody(const kodo_World* world, kodo_BodyId id) {
    kodo_BodyState body;
    check(kodo_bodyState(world, id, &body));
    const kodo_Vec2 place = body.transform.position;
    double degrees = kodo_angle(body.transform.rotation) * 57.29578;
    degrees = degrees > -0.05 && degrees < 0.05 ? 0 : degrees; // no "-0.0"
    printf("<g transform=\"translate(%.2f %.2f) rotate(%.1f)\">", place.x, place.y, degrees);
    for (size_t i = 0; i < body.partCount; ++i) {
        kodo_Part part;
        check(kodo_part(world, id, i, &part, NULL, 0));
        if (part.shape.kind == KODO_CIRCLE) {
            printf("<circle r=\"%.2f\"/>", part.shape.circle.radius);
        } else if (part.shape.kind == KODO_BOX) {
            const double width = part.shape.box.width;
            const double height = part.shape.box.height;
            printf("<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\"/>", -width / 2,
                   -height / 2, width, height);
        }
    }
    printf("</g>\n");
}

int main(void) {
    kodo_World* world = newPyramid();
    for (int step = 0; step < 60; ++step) {
        check(kodo_step(world, 1.0f / 60, NULL));
    }
    kodo_BodyId ids[16];
    size_t count;
    check(kodo_bodies(world, ids, 16, &count));
    // y points up in the World and down in an SVG.
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-5 -7 10 8\">\n"
           "<g transform=\"scale(1 -1)\" fill=\"#9cf\" stroke=\"#246\" stroke-width=\"0.05\">\n");
    for (size_t i = 0; i < count && i < 16; ++i) {
        drawBody(world, ids[i]);
    }
    printf("</g>\n</svg>\n");
    check(kodo_destroyWorld(world));
    return 0;
}
