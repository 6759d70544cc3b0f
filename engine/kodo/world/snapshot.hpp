// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world/world.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// A World as bytes, to be kept in a file or sent to another machine, and a World from them. Both
/// go on alike, bit for bit, with the same ids, and the last step's records are there too.
///
/// The bytes are the same on every machine. They depend on the precision: what kodo wrote, kodo64
/// refuses, and the other way round. A copy of a World is the cheaper snapshot within one program.

std::vector<std::byte> toBytes(const World& world);

/// A new World; throws BadSnapshot with a sentence for bytes that are cut off, changed, of another
/// format or of the other precision, and for values that no World can have.
///
/// The engine's force fields come with the bytes. Those that you wrote do not: pass as many as
/// toBytes met, in the order of World::fields(). Whom they push is remembered.
World fromBytes(std::span<const std::byte> bytes,
                std::span<const std::shared_ptr<const ForceField>> ownFields = {});

} // namespace kodo::inline KODO_PRECISION
