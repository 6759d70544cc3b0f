// SPDX-License-Identifier: MIT
#include <kodo/snapshot.hpp>

#include "base/checksum.hpp"
#include "world/world_impl.hpp"

#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::uint32_t kMagic = 0x6f646f4b; // "Kodo"
constexpr std::uint32_t kFormat = 26;        // increases with every change of visitState()
constexpr std::size_t kChecksumSize = sizeof(std::uint64_t);
constexpr std::size_t kBytesPerBody = 256; // as of most Worlds; more bytes cost a copy of them
constexpr std::size_t kBytesPerContact = 384;

void refuseUnless(bool good, const std::string& sentence) {
    if (!good) {
        throw BadSnapshot(sentence);
    }
}

/// Identifies a snapshot, its format and its precision.
void header(StateStream& stream) {
    std::uint32_t magic = kMagic;
    std::uint32_t format = kFormat;
    std::uint8_t precision = sizeof(Real);
    stream(magic);
    refuseUnless(magic == kMagic, "these bytes are no snapshot of a Kodo World");
    stream(format);
    refuseUnless(format == kFormat, "the snapshot has format " + std::to_string(format) +
                                        ", but this version of Kodo reads format " +
                                        std::to_string(kFormat));
    stream(precision);
    refuseUnless(precision == sizeof(Real),
                 "the snapshot has numbers of " + std::to_string(precision) +
                     " bytes, but this Kodo computes with " + std::to_string(sizeof(Real)));
}

} // namespace

void WorldImpl::visitState(StateStream& stream, OwnFields ownFields) {
    auto& [guard, settings, tolerances, stepCount, count, roomFor, bodies, flagBlocks, fields,
           contacts, softSolver, propagation, work, changeVisits, continuous, sleep, joints, broken,
           frozen, region, lastGeometry] = *this;
    // Left out is what the next step computes before use: solvers, continuous collision, caches.
    kodo::visitState(stream, settings);
    kodo::visitState(stream, tolerances);
    if (stream.reads()) {
        bodies.leftOut = settings.leaveOut;
    }
    kodo::visitState(stream, bodies, lastGeometry);
    stream.list(fields, [&](FieldEntry& entry) {
        kodo::visitState(stream, entry, ownFields);
        require(entry.field == nullptr ? std::nullopt
                                       : checkField(*entry.field, tolerances_.unit()));
    });
    require(ownFields.empty(), "more user-defined force fields were given than the snapshot needs");
    joints.visitState(stream, bodies, tolerances.unit());
    contacts.visitState(stream, bodies);
    sleep.visitState(stream, bodies);
    for (std::size_t* const each :
         {&work.contacts, &work.refinedBodies, &work.continuousPairs, &work.continuousStops}) {
        stream.as<std::uint64_t>(*each);
    }
    stream(work.mostParts, stepCount, broken, frozen);
    region.visitState(stream, bodies);
    if (!stream.reads()) {
        return;
    }
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        count += bodies.ids.aliveAt(i) ? 1 : 0;
        flagBlocks.note(i, bodies.filter[i].flags);
    }
}

std::vector<std::byte> toBytes(const World& world) {
    const WorldImpl& impl = world.impl();
    impl.guard().requireWhole("toBytes");
    StateStream stream(kBytesPerBody * impl.bodyCount() +
                       kBytesPerContact * impl.contactData().store().size());
    header(stream);
    if (impl.contactData().isUpToDate()) {
        const_cast<WorldImpl&>(impl).visitState(stream, {}); // writing changes nothing
    } else {
        WorldImpl copy = impl; // the bytes hold no changes that the next step would apply
        copy.contactData().applyChanges(copy.bodyData(), copy.tolerances());
        copy.visitState(stream, {});
    }
    stream.write(checksumOf(stream.written()));
    return stream.takeWritten();
}

World fromBytes(std::span<const std::byte> bytes,
                std::span<const std::shared_ptr<const ForceField>> ownFields) {
    const std::size_t size = bytes.size() - std::min(bytes.size(), kChecksumSize);
    StateStream stream(bytes.first(size));
    header(stream);
    StateStream end(bytes.subspan(size));
    std::uint64_t checksum = 0;
    end(checksum);
    refuseUnless(checksum == checksumOf(bytes.first(size)),
                 "the snapshot is damaged: its checksum is wrong");
    World world;
    world.impl().visitState(stream, ownFields);
    refuseUnless(stream.left() == 0, "something follows the end of the snapshot");
    return world;
}

} // namespace KODO_PRECISION
} // namespace kodo
