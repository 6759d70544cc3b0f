// SPDX-License-Identifier: MIT
// A World as a picture: writes an SVG to the output.
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

int main(void) {
    kodo_World* world = newPyramid();
    for (int step = 0; step < 60; ++step) {
        check(kodo_step(world, 1.0f / 60, NULL));
    }
    kodo_DrawOptions options = kodo_drawOptions();
    options.contacts = true;
    const kodo_Aabb view = {{-5, -1}, {5, 7}};
    size_t count; // first the number of bytes, then the bytes
    check(kodo_svg(world, &options, &view, NULL, 0, &count));
    char* text = malloc(count);
    check(kodo_svg(world, &options, &view, text, count, &count));
    fwrite(text, 1, count, stdout);
    free(text);
    check(kodo_destroyWorld(world));
    return 0;
}
