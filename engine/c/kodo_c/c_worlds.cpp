// SPDX-License-Identifier: MIT
#include <kodo/snapshot.hpp>
#include <kodo/step_stats.hpp>
#include <kodo_c/c_fields.hpp>
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace kodo_c {
namespace {

kodo::WorldDef worldDefFromC(const kodo_WorldDef& def) {
    requireHead(def.settings.head, sizeof(kodo_Settings), "kodo_Settings");
    return {fromC(def.gravity), def.lengthUnit, fromC(def.settings)};
}

/// The result of a call that makes a World, which the caller then owns.
void give(kodo::World&& world, kodo_World** handle) {
    kodo_World*& given = required(handle, "world");
    given = new kodo_World{std::move(world)};
}

} // namespace
} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_initWorldDef(kodo_WorldDef* def, kodo_Head head) {
    return guarded([&] {
        initialise(def, head, "kodo_WorldDef");
        const auto& [gravity, lengthUnit, settings] = kodo::WorldDef{};
        def->gravity = toC(gravity);
        def->lengthUnit = lengthUnit;
        def->settings = toC(settings);
    });
}

kodo_Status kodo_createWorld(const kodo_WorldDef* def, kodo_World** world) {
    return guarded([&] {
        give(def == nullptr ? kodo::World()
                            : kodo::World(worldDefFromC(checked(def, "def", "kodo_WorldDef"))),
             world);
    });
}

kodo_Status kodo_copyWorld(const kodo_World* from, kodo_World** world) {
    return guarded([&] { give(kodo::World(required(from, "from").world), world); });
}

kodo_Status kodo_assignWorld(kodo_World* into, const kodo_World* from) {
    return guarded([&] { required(into, "into").world = required(from, "from").world; });
}

kodo_Status kodo_destroyWorld(kodo_World* world) {
    return guarded([&] {
        if (required(world, "world").users != 0) {
            throw std::logic_error("kodo_destroyWorld is not possible within a step or a visit of "
                                   "the World: note it, and do it after the call returns");
        }
        delete world;
    });
}

kodo_Status kodo_setRegion(kodo_World* world, const kodo_Aabb* region) {
    return guarded([&] {
        worldOf(world).setRegion(region == nullptr ? std::nullopt : std::optional(fromC(*region)));
    });
}

kodo_Status kodo_region(const kodo_World* world, kodo_Aabb* region, bool* set) {
    return guarded([&] {
        const std::optional<kodo::Aabb>& box = worldOf(world).region();
        requirePointer(set, "set");
        required(region, "region") = box ? toC(*box) : kodo_Aabb{};
        *set = box.has_value();
    });
}

kodo_Status kodo_stepCount(const kodo_World* world, uint64_t* count) {
    return guarded([&] { required(count, "count") = worldOf(world).stepCount(); });
}

kodo_Status kodo_stepStats(const kodo_World* world, kodo_StepStats* stats) {
    return guarded([&] {
        const auto [bodies, contacts, joints, parts, refined, pairs, continuousPairs,
                    continuousStops, pairWork, changeVisits] = kodo::stepStats(worldOf(world));
        required(stats, "stats") = {bodies,   contacts,    joints,          parts,
                                    refined,  pairs,       continuousPairs, continuousStops,
                                    pairWork, changeVisits};
    });
}

kodo_Status kodo_frozenBodies(const kodo_World* world, kodo_BodyId* ids, size_t capacity,
                              size_t* count) {
    return guarded([&] { writeList(worldOf(world).frozenBodies(), ids, capacity, count); });
}

kodo_Status kodo_stateHash(const kodo_World* world, uint64_t* hash) {
    return guarded([&] { required(hash, "hash") = worldOf(world).stateHash(); });
}

kodo_Status kodo_toBytes(const kodo_World* world, void* bytes, size_t capacity, size_t* count) {
    return guarded([&] {
        const std::vector<std::byte> all = kodo::toBytes(worldOf(world));
        required(count, "count") = all.size();
        const std::size_t written = std::min(capacity, all.size());
        if (written > 0) {
            requirePointer(bytes, "bytes");
            std::memcpy(bytes, all.data(), written);
        }
    });
}

kodo_Status kodo_initSnapshotDef(kodo_SnapshotDef* def, kodo_Head head) {
    return guarded([&] { initialise(def, head, "kodo_SnapshotDef"); });
}

kodo_Status kodo_fromBytes(const kodo_SnapshotDef* def, kodo_World** world) {
    return guarded([&] {
        const kodo_SnapshotDef& snapshot = checked(def, "def", "kodo_SnapshotDef");
        const auto bytes =
            itemsOf(static_cast<const std::byte*>(snapshot.bytes), snapshot.byteCount, "bytes");
        OwnFields own(itemsOf(snapshot.ownFields, snapshot.ownFieldCount, "ownFields"));
        requirePointer(world, "world");
        give(kodo::fromBytes(bytes, own.fields()), world);
        own.keep();
    });
}
