// SPDX-License-Identifier: MIT
// Rollback: two players, and the input of the second one arrives ten steps late.
#include <kodo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void check(kodo_Status status) {
    if (status != KODO_OK) {
        fprintf(stderr, "%s\n", kodo_errorText());
        exit(1);
    }
}

static kodo_World* newGame(kodo_BodyId players[2]) {
    kodo_WorldDef worldDef = kodo_worldDef();
    worldDef.gravity.y = -10;
    kodo_World* world;
    check(kodo_createWorld(&worldDef, &world));
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = kodo_plane(kodo_vec2(0, 1), 0);
    def.type = KODO_STATIC;
    kodo_BodyId other;
    check(kodo_addBody(world, &def, &other));
    def.type = KODO_DYNAMIC;
    def.shape = kodo_box(1, 1);
    def.position = kodo_vec2(-2, 0.5f);
    check(kodo_addBody(world, &def, &players[0]));
    def.position.x = 2;
    check(kodo_addBody(world, &def, &players[1]));
    def.shape = kodo_circle(0.4f);
    def.position = kodo_vec2(0, 3);
    check(kodo_addBody(world, &def, &other));
    return world;
}

static float inputOf(int player, int step) { // N, to the right
    return step / 20 % 2 != 0 ? 0 : player == 0 ? 12.0f : -12.0f;
}

static void step(kodo_World* world, const kodo_BodyId players[2], float first, float second) {
    const kodo_Load loads[2] = {{{first, 0}, 0}, {{second, 0}, 0}};
    check(kodo_applyLoads(&world, 1, players, 2, loads));
    check(kodo_step(world, 1.0f / 60, NULL));
}

static bool equalBytes(const kodo_World* a, const kodo_World* b) {
    size_t sizes[2];
    check(kodo_toBytes(a, NULL, 0, &sizes[0]));
    check(kodo_toBytes(b, NULL, 0, &sizes[1]));
    char* bytes = malloc(sizes[0] + sizes[1]);
    check(kodo_toBytes(a, bytes, sizes[0], &sizes[0]));
    check(kodo_toBytes(b, bytes + sizes[0], sizes[1], &sizes[1]));
    const bool equal = sizes[0] == sizes[1] && memcmp(bytes, bytes + sizes[0], sizes[0]) == 0;
    free(bytes);
    return equal;
}

int main(void) {
    const int steps = 120;
    const int delay = 10; // steps
    kodo_BodyId players[2];
    kodo_World* exact = newGame(players); // the reference: all inputs arrive in time
    for (int i = 0; i < steps; ++i) {
        step(exact, players, inputOf(0, i), inputOf(1, i));
    }

    kodo_World* confirmed = newGame(players); // contains only steps with the inputs of both players
    kodo_World* shown;
    check(kodo_copyWorld(confirmed, &shown));
    int worst = 0; // steps repeated in one frame
    for (int i = 0; i < steps + delay; ++i) {
        if (i >= delay) { // the input of i - delay has arrived
            step(confirmed, players, inputOf(0, i - delay), inputOf(1, i - delay));
        }
        check(kodo_assignWorld(shown, confirmed)); // a copy is a snapshot
        const int first = i < delay ? 0 : i - delay + 1;
        for (int ahead = first; ahead <= i; ++ahead) { // prediction: player 2 does nothing
            step(shown, players, inputOf(0, ahead), 0);
        }
        worst = i - first + 1 > worst ? i - first + 1 : worst;
    }
    uint64_t hashes[2];
    check(kodo_stateHash(exact, &hashes[0]));
    check(kodo_stateHash(confirmed, &hashes[1]));
    printf("predicted steps in a frame: %d at most\n", worst);
    printf("state equal: %s\n", hashes[0] == hashes[1] ? "yes" : "no");
    printf("bytes equal: %s\n", equalBytes(exact, confirmed) ? "yes" : "no");
    check(kodo_destroyWorld(shown));
    check(kodo_destroyWorld(confirmed));
    check(kodo_destroyWorld(exact));
    return 0;
}
