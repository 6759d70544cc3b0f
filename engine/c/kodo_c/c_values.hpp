// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/axis_lock.hpp>
#include <kodo/explosion.hpp>
#include <kodo/query.hpp>
#include <kodo_c/c_guard.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace kodo_c {

static_assert(sizeof(kodo_Real) == sizeof(kodo::Real));

// The same values in C and in C++. Structured bindings name all members of a struct of C++: a new
// one does not compile until it has its counterpart in C.

inline kodo::Vec2 fromC(kodo_Vec2 v) {
    return {v.x, v.y};
}
inline kodo::Rot fromC(kodo_Rot q) {
    return {q.c, q.s};
}
inline kodo::Transform fromC(const kodo_Transform& t) {
    return {fromC(t.position), fromC(t.rotation)};
}
inline kodo::Aabb fromC(const kodo_Aabb& box) {
    return {fromC(box.lower), fromC(box.upper)};
}
inline kodo::BodyId fromC(kodo_BodyId id) {
    return {id.index, id.generation, id.world};
}
inline kodo::JointId fromC(kodo_JointId id) {
    return {id.index, id.generation, id.world};
}
inline kodo::CollisionFilter fromC(kodo_Filter filter) {
    return {filter.flags, filter.required, filter.group};
}
inline kodo::Material fromC(const kodo_Material& m) {
    static_assert(KODO_MAXIMUM == static_cast<int>(kodo::MixRule::Maximum));
    return {m.staticFriction,
            m.kineticFriction,
            m.restitution,
            m.rollingResistance,
            m.surfaceSpeed,
            static_cast<kodo::MixRule>(m.frictionRule),
            static_cast<kodo::MixRule>(m.restitutionRule)};
}
inline kodo::Range fromC(const kodo_Range& range) {
    return {range.lower, range.upper};
}

/// The items of an array of the caller, which may be null if there are none.
template <typename Item>
std::span<const Item> itemsOf(const Item* items, std::size_t count, const char* name) {
    if (count > 0) {
        requirePointer(items, name);
    }
    return {items, count};
}
template <typename C>
auto listFromC(std::span<const C> items) {
    std::vector<decltype(fromC(items[0]))> list;
    list.reserve(items.size());
    for (const C& item : items) {
        list.push_back(fromC(item));
    }
    return list;
}

inline std::size_t toC(std::size_t size) {
    return size;
}
inline kodo_Vec2 toC(kodo::Vec2 v) {
    return {v.x, v.y};
}
inline kodo_Rot toC(kodo::Rot q) {
    return {q.c, q.s};
}
inline kodo_Transform toC(const kodo::Transform& t) {
    return {toC(t.position), toC(t.rotation)};
}
inline kodo_Aabb toC(const kodo::Aabb& box) {
    return {toC(box.lower), toC(box.upper)};
}
inline kodo_BodyId toC(kodo::BodyId id) {
    const auto& [index, generation, world] = id;
    return {index, generation, world};
}
inline kodo_JointId toC(kodo::JointId id) {
    const auto& [index, generation, world] = id;
    return {index, generation, world};
}
inline kodo_Filter toC(kodo::CollisionFilter filter) {
    const auto& [flags, required, group] = filter;
    return {flags, required, group};
}
inline kodo_Material toC(const kodo::Material& material) {
    const auto& [staticFriction, kineticFriction, restitution, rollingResistance, surfaceSpeed,
                 frictionRule, restitutionRule] = material;
    return {staticFriction,
            kineticFriction,
            restitution,
            rollingResistance,
            surfaceSpeed,
            static_cast<kodo_MixRule>(frictionRule),
            static_cast<kodo_MixRule>(restitutionRule)};
}
inline kodo_Range toC(const kodo::Range& range) {
    const auto& [lower, upper] = range;
    return {lower, upper};
}
inline kodo_BodyType toC(kodo::BodyType type) {
    return static_cast<kodo_BodyType>(type);
}
kodo::BodyType bodyTypeFromC(kodo_BodyType type);
kodo::ContinuousMode continuousModeFromC(kodo_ContinuousMode mode);

kodo::Shape fromC(const kodo_Shape& shape);
/// Throws BadDefinition for a compound, a heightmap and a chain.
kodo::Primitive primitiveFromC(const kodo_Shape& shape, const char* field);
/// The corners of a polygon are not written: the struct has their number, and no pointer.
kodo_Shape toC(const kodo::Primitive& primitive);

kodo::MassDef fromC(const kodo_MassDef& mass);
kodo::BodyDef fromC(const kodo_BodyDef& def);
kodo::JointDef fromC(const kodo_JointDef& def);
kodo::StepSettings fromC(const kodo_Settings& settings);
/// With the head of this library.
kodo_JointDef toC(const kodo::JointDef& def);
kodo_Settings toC(const kodo::StepSettings& settings);

kodo_BodyState stateOf(const kodo::BodyView& body);
kodo_JointState toC(const kodo::JointState& state);
kodo_BrokenJoint toC(const kodo::BrokenJoint& broken);
kodo_CollisionRecord toC(const kodo::CollisionRecord& record);
kodo_QueryHit toC(const kodo::QueryHit& hit);
kodo_QueryPoint toC(const kodo::QueryPoint& point);
kodo_RaySpan toC(const kodo::RaySpan& span);
kodo_QueryContact toC(const kodo::QueryContact& contact);
kodo_ExplosionHit toC(const kodo::ExplosionHit& hit);
kodo_Field toC(const kodo::FieldEntry& entry);

inline kodo_Real fromC(kodo_Real value) {
    return value;
}

inline bool isSet(kodo_Real value) {
    return value != 0;
}
inline bool isSet(kodo_Vec2 value) {
    return value.x != 0 || value.y != 0;
}
inline bool isSet(kodo_Range value) {
    return value.lower != 0 || value.upper != 0;
}
inline bool isSet(const kodo_Aabb& value) {
    return isSet(value.lower) || isSet(value.upper);
}
inline bool isSet(const kodo_Filter& value) {
    return value.flags != 0 || value.required != 0 || value.group != 0;
}
inline bool isSet(const kodo_MassDef& value) {
    return value.mass != 0;
}

/// A value of C with a flag that says whether it counts. Throws BadDefinition if a value is given
/// and the flag is not: a user who forgets the flag gets a sentence.
template <typename C>
auto optionalFromC(bool present, const C& value, const char* flag) {
    if (!present && isSet(value)) {
        throw kodo::BadDefinition({flag, "is false, but the value that it stands for is set"});
    }
    return present ? std::optional(fromC(value)) : std::nullopt;
}

/// Writes a list to the memory of the caller, as far as it has room, and the number of all items.
template <typename List, typename Item>
void writeList(const List& list, Item* items, std::size_t capacity, std::size_t* count) {
    required(count, "count") = list.size();
    const std::size_t written = (std::min)(capacity, list.size());
    if (written > 0) {
        requirePointer(items, "items");
    }
    for (std::size_t i = 0; i < written; ++i) {
        items[i] = toC(list[i]);
    }
}

} // namespace kodo_c
