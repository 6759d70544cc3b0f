// SPDX-License-Identifier: MIT
// Needs copies of inline functions of the headers in this file, and prints a state hash.
#include <kodo/kodo.hpp>

#include <cinttypes>
#include <cstdio>
#include <span>

using kodo::Real;
using kodo::Vec2;

// By volatile pointers, so that the compiler must write out each function.
Real (*volatile keep_cross)(kodo::BasicVec2<Real>, kodo::BasicVec2<Real>) = &kodo::cross<Real>;
kodo::Polygon (*volatile keep_polygon)(const kodo::Box&) = &kodo::polygonOf<Real>;
kodo::Mass (*volatile keep_mass)(std::span<const Vec2>, Real) = &kodo::massOf<Real>;
kodo::Mass (*volatile keep_sum)(const kodo::Mass&, const kodo::Mass&) = &kodo::combine<Real>;
kodo::Aabb (*volatile keep_bounds)(const kodo::Box&) = &kodo::boundsOf<kodo::BasicBox, Real>;

int main() {
    kodo::World world{{.gravity = {Real(0.3), -10}}};
    world.add({.shape = kodo::Box{20, 1}, .type = kodo::BodyType::Static});
    for (int i = 0; i < 8; ++i) {
        const Real size = Real(0.3) + Real(i) / 29;
        const kodo::Polygon shape{{{0, 0}, {size, Real(0.1)}, {size / 3, Real(0.77)}}};
        world.add({.shape = kodo::Compound{{shape, kodo::Box{size, Real(0.21), {-size, size}}}},
                   .position = {Real(i) / 3, Real(i) + 1},
                   .rotation = kodo::Rot::fromAngle(Real(i))});
    }
    for (int i = 0; i < 240; ++i) {
        world.step(Real(1) / 60);
    }
    std::printf("%016" PRIx64 "\n", world.stateHash());
    return keep_cross == nullptr || keep_polygon == nullptr || keep_mass == nullptr ||
           keep_sum == nullptr || keep_bounds == nullptr;
}
