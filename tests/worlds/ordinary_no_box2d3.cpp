// SPDX-License-Identifier: MIT
#include <worlds/ordinary.hpp>

#include <stdexcept>

namespace worlds {

bool hasOrdinaryBox2d3() {
    return false;
}

std::unique_ptr<OrdinaryEngine> ordinaryInBox2d3(const Recipe&) {
    throw std::logic_error("Box2D 3 is not in this build");
}

} // namespace worlds
