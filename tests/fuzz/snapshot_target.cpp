// SPDX-License-Identifier: MIT
// Any bytes as a snapshot, with the right checksum: refused, or a World that steps, and whose bytes
// give the same World again. The bytes are changes of those of a small World: pairs of place and
// value. Without the first byte's lowest bit they are the snapshot itself.
#include "base/checksum.hpp"

#include <fuzz/fuzz.hpp>

#include <vector>

namespace {

using namespace kodo;

World smallWorld() {
    World world({.gravity = {0, -10}});
    world.add({.shape = Box{20, 1}, .type = BodyType::Static});
    const BodyId ball = world.add({.shape = Circle{Real(0.5)}, .position = {0, 1}});
    const BodyId box = world.add({.shape = Box{1, 1}, .position = {2, 1}});
    world.add({.shape = Compound{{Circle{Real(0.3)}, Box{1, Real(0.2)}}}, .position = {-3, 3}});
    world.add(RevoluteJoint{.ends = {.a = ball, .b = box, .anchorB = {-2, 0}}});
    world.addField({std::make_shared<Drag>(DragLaw{1, 0}), {}});
    world.setRegion(Aabb{{-9, -9}, {9, 9}});
    for (int step = 0; step < 40; ++step) {
        world.step(Real(1) / 60);
    }
    return world;
}

std::vector<std::byte> changedBytes(const std::uint8_t* data, std::size_t size) {
    static const std::vector<std::byte> start = toBytes(smallWorld());
    std::vector<std::byte> bytes(start.begin(), start.end() - 8);
    for (std::size_t i = 1; i + 2 < size; i += 3) {
        const std::size_t place = (data[i] + 256u * data[i + 1]) % bytes.size();
        bytes[place] = std::byte{data[i + 2]};
    }
    return bytes;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::byte> bytes;
    if (size > 0 && data[0] % 2 == 1) {
        bytes = changedBytes(data, size);
    } else {
        for (std::size_t i = 1; i < size; ++i) {
            bytes.push_back(std::byte{data[i]});
        }
    }
    const std::uint64_t checksum = checksumOf(bytes);
    for (int i = 0; i < 8; ++i) {
        bytes.push_back(std::byte(static_cast<std::uint8_t>(checksum >> 8 * i)));
    }
    try {
        World world = fromBytes(bytes);
        World again = fromBytes(toBytes(world));
        fuzz::require(again.stateHash() == world.stateHash(), "the bytes give another World");
        world.step(Real(1) / 60);
        world.step(Real(1) / 60);
        toBytes(world);
    } catch (const BadSnapshot&) {
    }
    return 0;
}
