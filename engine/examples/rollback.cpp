// SPDX-License-Identifier: MIT
// Rollback: two players, and the input of the second one arrives ten steps late.
#include <kodo/kodo.hpp>

#include <algorithm>
#include <array>
#include <cstdio>

struct Game {
    kodo::World world{{.gravity = {0, -10}}};
    std::array<kodo::BodyId, 2> players{};

    Game() {
        world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
        players[0] = world.add({.shape = kodo::Box{1, 1}, .position = {-2, 0.5f}});
        players[1] = world.add({.shape = kodo::Box{1, 1}, .position = {2, 0.5f}});
        world.add({.shape = kodo::Circle{0.4f}, .position = {0, 3}});
    }
    void step(const std::array<float, 2>& push) { // N, to the right
        for (std::size_t i = 0; i < 2; ++i) {
            world[players[i]].applyForce({push[i], 0});
        }
        world.step(1.0f / 60);
    }
};

float inputOf(int player, int step) {
    return step / 20 % 2 != 0 ? 0 : player == 0 ? 12.0f : -12.0f;
}

int main() {
    constexpr int kSteps = 120;
    constexpr int kDelay = 10; // steps
    Game exact;                // the reference: all inputs arrive in time
    for (int step = 0; step < kSteps; ++step) {
        exact.step({inputOf(0, step), inputOf(1, step)});
    }

    Game confirmed; // contains only steps with the inputs of both players
    int worst = 0;  // steps repeated in one frame
    for (int step = 0; step < kSteps + kDelay; ++step) {
        if (step >= kDelay) { // the input of step - kDelay has arrived
            confirmed.step({inputOf(0, step - kDelay), inputOf(1, step - kDelay)});
        }
        Game shown = confirmed; // a copy is a snapshot
        const int first = std::max(0, step - kDelay + 1);
        for (int ahead = first; ahead <= step; ++ahead) { // prediction: player 2 does nothing
            shown.step({inputOf(0, ahead), 0});
        }
        worst = std::max(worst, step - first + 1);
    }
    std::printf("predicted steps in a frame: %d at most\n", worst);
    std::printf("state equal: %s\n",
                exact.world.stateHash() == confirmed.world.stateHash() ? "yes" : "no");
    std::printf("bytes equal: %s\n",
                kodo::toBytes(exact.world) == kodo::toBytes(confirmed.world) ? "yes" : "no");
}
