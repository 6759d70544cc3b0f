// SPDX-License-Identifier: MIT
#include <kodo/snapshot.hpp>

#include "world/snapshot_fields.hpp"

#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::uint32_t kMagic = 0x6f646f4b; // "Kodo"
constexpr std::uint32_t kFormat = 12;        // increases with every change of the field lists
constexpr std::size_t kChecksumSize = sizeof(std::uint64_t);

void refuseUnless(bool good, const std::string& sentence) {
    if (!good) {
        throw BadSnapshot(sentence);
    }
}

/// Identifies a snapshot, its format and its precision.
void header(ByteStream& stream) {
    std::uint32_t magic = kMagic;
    std::uint32_t format = kFormat;
    std::uint8_t precision = sizeof(Real);
    stream.number(magic);
    refuseUnless(magic == kMagic, "these bytes are no snapshot of a Kodo World");
    stream.number(format);
    refuseUnless(format == kFormat, "the snapshot has format " + std::to_string(format) +
                                        ", but this version of Kodo reads format " +
                                        std::to_string(kFormat));
    stream.number(precision);
    refuseUnless(precision == sizeof(Real),
                 "the snapshot has numbers of " + std::to_string(precision) +
                     " bytes, but this Kodo computes with " + std::to_string(sizeof(Real)));
}

} // namespace

std::vector<std::byte> toBytes(const World& world) {
    ByteStream stream;
    header(stream);
    world.impl().guard().requireWhole("toBytes");
    WorldImpl copy = world.impl(); // the field lists need mutable references
    SnapshotFields(stream, {}).world(copy);
    std::vector<std::byte> bytes = stream.takeWritten();
    std::uint64_t checksum = checksumOf(bytes);
    ByteStream end;
    end.number(checksum);
    const std::vector<std::byte> tail = end.takeWritten();
    bytes.insert(bytes.end(), tail.begin(), tail.end());
    return bytes;
}

World fromBytes(std::span<const std::byte> bytes,
                std::span<const std::shared_ptr<const ForceField>> ownFields) {
    const std::size_t size = bytes.size() - std::min(bytes.size(), kChecksumSize);
    ByteStream stream(bytes.first(size));
    header(stream);
    ByteStream end(bytes.subspan(size));
    std::uint64_t checksum = 0;
    end.number(checksum);
    refuseUnless(checksum == checksumOf(bytes.first(size)),
                 "the snapshot is damaged: its checksum is wrong");
    World world;
    SnapshotFields(stream, ownFields).world(world.impl());
    refuseUnless(stream.left() == 0, "something follows the end of the snapshot");
    return world;
}

} // namespace KODO_PRECISION
} // namespace kodo
