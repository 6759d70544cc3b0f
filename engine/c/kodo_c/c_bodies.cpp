// SPDX-License-Identifier: MIT
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

namespace kodo_c {
namespace {

void writeMass(const std::optional<kodo::MassDef>& mass, kodo_BodyDef& def) {
    def.hasMass = mass.has_value();
    if (mass) {
        const auto& [kilograms, center, inertia] = *mass;
        def.mass = {kilograms, center.has_value(), toC(center.value_or(kodo::Vec2{})),
                    inertia.has_value(), inertia.value_or(kodo::Real(0))};
    }
}

void writeDefaults(kodo_BodyDef& def) {
    const auto& [shape, position, rotation, velocity, angularVelocity, material, density, mass,
                 linearDamping, angularDamping, gravityScale, continuousMode, type, flags, required,
                 group, userData] = kodo::BodyDef{};
    def.shape = toC(kodo::primitivesOf(shape).front());
    def.position = toC(position);
    def.rotation = toC(rotation);
    def.velocity = toC(velocity);
    def.angularVelocity = angularVelocity;
    def.material = toC(material);
    def.density = density;
    writeMass(mass, def);
    def.linearDamping = linearDamping;
    def.angularDamping = angularDamping;
    def.gravityScale = gravityScale;
    def.continuousMode = static_cast<kodo_ContinuousMode>(continuousMode);
    def.type = toC(type);
    def.flags = flags;
    def.required = required;
    def.group = group;
    def.userData = userData;
}

kodo::Part partFromC(const kodo_Part& part) {
    const auto& [shape, material, density, hasFilter, filter, userData] = part;
    return {primitiveFromC(shape, "part.shape"), fromC(material), density,
            optionalFromC(hasFilter, filter, "hasFilter"), userData};
}

} // namespace

kodo::BodyType bodyTypeFromC(kodo_BodyType type) {
    static_assert(KODO_KINEMATIC == static_cast<int>(kodo::BodyType::Kinematic));
    static_assert(KODO_STATIC == static_cast<int>(kodo::BodyType::Static));
    requireKind(type, KODO_STATIC + 1, "type");
    return static_cast<kodo::BodyType>(type);
}

kodo::ContinuousMode continuousModeFromC(kodo_ContinuousMode mode) {
    static_assert(KODO_CONTINUOUS_STATIC == static_cast<int>(kodo::ContinuousMode::Static));
    static_assert(KODO_CONTINUOUS_ALL == static_cast<int>(kodo::ContinuousMode::All));
    requireKind(mode, KODO_CONTINUOUS_ALL + 1, "continuousMode");
    return static_cast<kodo::ContinuousMode>(mode);
}

kodo::MassDef fromC(const kodo_MassDef& mass) {
    return {mass.mass, optionalFromC(mass.hasCenter, mass.center, "hasCenter"),
            optionalFromC(mass.hasInertia, mass.inertia, "hasInertia")};
}

kodo::BodyDef fromC(const kodo_BodyDef& def) {
    return {fromC(def.shape),
            fromC(def.position),
            fromC(def.rotation),
            fromC(def.velocity),
            def.angularVelocity,
            fromC(def.material),
            def.density,
            optionalFromC(def.hasMass, def.mass, "hasMass"),
            def.linearDamping,
            def.angularDamping,
            def.gravityScale,
            continuousModeFromC(def.continuousMode),
            bodyTypeFromC(def.type),
            def.flags,
            def.required,
            def.group,
            def.userData};
}

kodo_BodyState stateOf(const kodo::BodyView& body) {
    kodo_BodyState state{};
    state.id = toC(body.id());
    state.type = toC(body.type());
    state.transform = toC(body.transform());
    state.massFrame = toC(body.massFrame());
    state.velocity = toC(body.velocity());
    state.angularVelocity = body.angularVelocity();
    state.mass = body.mass();
    state.inertia = body.inertia();
    state.localCenter = toC(body.localCenter());
    state.area = body.area();
    state.bounds = toC(body.bounds());
    state.flags = body.flags();
    state.required = body.required();
    state.group = body.group();
    state.hasSetMass = body.hasSetMass();
    state.isAsleep = body.isAsleep();
    state.userData = body.userData();
    state.partCount = body.partCount();
    state.linearDamping = body.linearDamping();
    state.angularDamping = body.angularDamping();
    state.gravityScale = body.gravityScale();
    state.continuousMode = static_cast<kodo_ContinuousMode>(body.continuousMode());
    return state;
}

} // namespace kodo_c

using namespace kodo_c;

kodo_Rot kodo_rotation(kodo_Real radians) {
    return toC(kodo::Rot::fromAngle(radians));
}

kodo_Real kodo_angle(kodo_Rot rotation) {
    return fromC(rotation).angle();
}

kodo_Status kodo_initBodyDef(kodo_BodyDef* def, kodo_Head head) {
    return guarded([&] {
        initialise(def, head, "kodo_BodyDef");
        writeDefaults(*def);
    });
}

kodo_Status kodo_addBody(kodo_World* world, const kodo_BodyDef* def, kodo_BodyId* id) {
    return guarded([&] {
        kodo_BodyId& added = required(id, "id");
        kodo::World& into = worldOf(world);
        added = toC(into.add(fromC(checked(def, "def", "kodo_BodyDef"))));
    });
}

kodo_Status kodo_removeBody(kodo_World* world, kodo_BodyId id) {
    return guarded([&] { worldOf(world).remove(fromC(id)); });
}

kodo_Status kodo_cloneBody(kodo_World* world, kodo_BodyId id, kodo_Vec2 position,
                           kodo_BodyId* clone) {
    return guarded([&] {
        kodo_BodyId& added = required(clone, "clone");
        added = toC(worldOf(world).clone(fromC(id), fromC(position)));
    });
}

kodo_Status kodo_containsBody(const kodo_World* world, kodo_BodyId id, bool* contained) {
    return guarded([&] { required(contained, "contained") = worldOf(world).contains(fromC(id)); });
}

kodo_Status kodo_bodyCount(const kodo_World* world, size_t* count) {
    return guarded([&] { required(count, "count") = worldOf(world).bodyCount(); });
}

kodo_Status kodo_bodies(const kodo_World* world, kodo_BodyId* ids, size_t capacity, size_t* count) {
    return guarded([&] { writeList(worldOf(world).bodies(), ids, capacity, count); });
}

kodo_Status kodo_movedBodies(const kodo_World* world, kodo_BodyId* ids, size_t capacity,
                             size_t* count) {
    return guarded([&] { writeList(worldOf(world).movedBodies(), ids, capacity, count); });
}

kodo_Status kodo_bodyState(const kodo_World* world, kodo_BodyId id, kodo_BodyState* state) {
    return guarded([&] { required(state, "state") = stateOf(worldOf(world)[fromC(id)]); });
}

kodo_Status kodo_velocityAt(const kodo_World* world, kodo_BodyId id, kodo_Vec2 point,
                            kodo_Vec2* velocity) {
    return guarded([&] {
        required(velocity, "velocity") = toC(worldOf(world)[fromC(id)].velocityAt(fromC(point)));
    });
}

kodo_Status kodo_containsPoint(const kodo_World* world, kodo_BodyId id, kodo_Vec2 point,
                               bool* contained) {
    return guarded([&] {
        required(contained, "contained") = worldOf(world)[fromC(id)].contains(fromC(point));
    });
}

kodo_Status kodo_part(const kodo_World* world, kodo_BodyId id, size_t index, kodo_Part* part,
                      kodo_Vec2* corners, size_t capacity) {
    return guarded([&] {
        const kodo::Part& found = worldOf(world)[fromC(id)].part(index);
        const auto& [primitive, material, density, filter, userData, convex] = found;
        kodo_Part made{toC(primitive),
                       toC(material),
                       density,
                       filter.has_value(),
                       toC(filter.value_or(kodo::CollisionFilter{})),
                       userData};
        if (const auto* polygon = std::get_if<kodo::Polygon>(&primitive)) {
            writeList(polygon->corners, corners, capacity, &made.shape.polygon.cornerCount);
            made.shape.polygon.corners = corners;
        }
        required(part, "part") = made;
    });
}

kodo_Status kodo_setPart(kodo_World* world, kodo_BodyId id, size_t index, const kodo_Part* part) {
    return guarded(
        [&] { worldOf(world)[fromC(id)].setPart(index, partFromC(required(part, "part"))); });
}

kodo_Status kodo_weld(kodo_World* world, kodo_BodyId into, kodo_BodyId part, size_t* first) {
    return guarded([&] {
        std::size_t& index = required(first, "first");
        index = worldOf(world).weld(fromC(into), fromC(part));
    });
}

kodo_Status kodo_weldPart(kodo_World* world, kodo_BodyId into, const kodo_Part* part,
                          size_t* first) {
    return guarded([&] {
        std::size_t& index = required(first, "first");
        const kodo::Part given = partFromC(required(part, "part"));
        kodo::World& to = worldOf(world);
        index = to.weld(fromC(into), given.primitive, given.material, given.density);
        if (given.filter || given.userData != 0) {
            to[fromC(into)].setPart(index, given);
        }
    });
}

kodo_Status kodo_unweld(kodo_World* world, kodo_BodyId body, size_t part, const kodo_Flags* flags,
                        kodo_BodyId* id) {
    return guarded([&] {
        kodo_BodyId& added = required(id, "id");
        added = toC(worldOf(world).unweld(fromC(body), part,
                                          flags == nullptr ? std::nullopt : std::optional(*flags)));
    });
}
