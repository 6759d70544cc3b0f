// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "engine.hpp"

namespace crosscheck {

bool hasBox2d3() {
    return false;
}

std::unique_ptr<Engine> makeBox2d3(const scenes::SceneDef&, double) {
    throw std::logic_error("Box2D 3 is not in this build");
}

} // namespace crosscheck
