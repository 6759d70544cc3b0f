// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// A World as bytes, for a file or another machine. The World that fromBytes() makes of them
/// continues with the same bits and the same ids, and has the records of the last step.
///
/// The bytes are the same on every machine. They depend on the precision: kodo64 refuses those of
/// kodo, and the other way round. Within one program, a copy of a World is the cheaper snapshot.
/// A copy has the same bytes at any time, if both get the same calls. A World of fromBytes() has
/// them after each step; between a change and the next step its bytes may list other parts whose
/// neighbours that step searches.
KODO_API std::vector<std::byte> toBytes(const World& world);

/// Throws BadSnapshot, with a reason, for bytes that are truncated, changed, of another format or
/// of the other precision, and for values that no World can have.
///
/// Force fields of the engine are part of the bytes. Fields of your own are not: pass as many as
/// toBytes() met, in the order of World::fields(). Their filters are part of the bytes. The World
/// accepts ids of any World, since bytes do not name theirs.
KODO_API World fromBytes(std::span<const std::byte> bytes,
                         std::span<const std::shared_ptr<const ForceField>> ownFields = {});

} // namespace KODO_PRECISION
} // namespace kodo
