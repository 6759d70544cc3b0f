// SPDX-License-Identifier: MIT
#include "bench_engine.hpp"

namespace bench {

bool hasBox2d3() {
    return false;
}

std::unique_ptr<Engine> makeBox2d3(const scenes::SceneDef&, const StepOptions&) {
    throw WrongUse("box2d3 is not in this build: install Box2D 3 (github.com/erincatto/box2d) into "
                   "a folder DIR and configure with -DKODO_BENCH_BOX2D3=DIR");
}

} // namespace bench
