// SPDX-License-Identifier: MIT
// Without the game, whose reader of TOML scene files use.
#include "bench_scenes.hpp"

namespace bench {

std::vector<Recipe> sandboxRecipes() {
    return {};
}

} // namespace bench
