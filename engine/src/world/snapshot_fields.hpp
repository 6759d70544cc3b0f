// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/force_field.hpp>

#include "world/snapshot_stream.hpp"
#include "world/world_impl.hpp"

#include <map>

namespace kodo {
inline namespace KODO_PRECISION {

/// Lists the fields of all parts of a World, to write or to read them.
///
/// Each list names all members of its type in a structured binding. A new member does not compile
/// until it is stored or omitted deliberately. Omitted is state that the next step computes before
/// use: solver, continuous collision, ghost collisions, and the order of sweep and prune. Derived
/// data are omitted too: masses, convex shapes, lists by body.
class SnapshotFields : SnapshotStream<SnapshotFields> {
public:
    using OwnFields = std::span<const std::shared_ptr<const ForceField>>;

    SnapshotFields(ByteStream& stream, OwnFields ownFields)
        : SnapshotStream(stream), ownFields_(ownFields) {}

    /// When reading, `world` must be new.
    void world(WorldImpl& world);
    /// Writes what decides the future beside the motion: settings, fields, geometry, materials,
    /// user data and the numbers of joints. Of a user's own fields only that they exist.
    void definitions(const WorldImpl& world);

private:
    friend class SnapshotStream<SnapshotFields>;
    using SnapshotStream::one;

    // Shapes and body geometry.
    void one(Circle& circle);
    void one(Box& box);
    void one(Polygon& polygon);
    void one(Point& point);
    void one(Segment& segment);
    void one(Plane& plane);
    void one(Material& material);
    void one(Part& part);
    void one(std::shared_ptr<const BodyGeometry>& geometry);
    void geometries(WorldImpl& world);

    // Bodies.
    void one(CollisionFilter& filter);
    void one(BodyVelocity& motion);
    void one(Acceleration& acceleration);
    void one(SleepState& rest);
    void one(SleepState::Sample& sample);
    void one(IdPool& pool);
    void one(Bodies& bodies);

    // Force fields.
    void one(DragLaw& law);
    void one(Buoyancy::Fluid& fluid);
    void one(Attractor::Law& law);
    void one(FieldEntry& entry);
    template <typename Field, typename... Values>
    void field(std::shared_ptr<const ForceField>& field, Values (Field::*... get)() const);

    // Contacts.
    void one(ContactKey& key);
    void one(ManifoldPoint& point);
    void one(Manifold& manifold);
    void one(PointImpulse& impulse);
    void one(ContactRow& row);
    void one(Contact& contact);
    void one(CollisionRecord& record);
    void one(SleepSystem::Island& island);
    void contacts(ContactSet& set, const Bodies& bodies, const Tolerances& tolerances);
    void rest(SleepSystem& stage, Bodies& bodies);

    // Joints.
    void one(Range& range);
    void one(JointEnds& ends);
    void one(RevoluteJoint& joint);
    void one(FixedJoint& joint);
    void one(DistanceJoint& joint);
    void one(PrismaticJoint& joint);
    void one(MotorJoint& joint);
    void one(MouseJoint& joint);
    void one(JointSet::Joint& joint);
    void one(BrokenJoint& broken);
    void joints(JointSet& set, const Bodies& bodies, Real lengthUnit);

    void one(SoftSettings& settings);
    void one(PropagationSettings& settings);
    void one(StepSettings& settings);
    void one(Tolerances& tolerances);

    OwnFields ownFields_; // not used yet
    std::vector<std::shared_ptr<const BodyGeometry>> geometries_;
    std::map<const BodyGeometry*, std::uint32_t> geometryNumbers_; // for look-up, never iterated
};

/// Checks the bodies and parts of a contact that was read, and sets what follows from them.
void completeContact(Contact& contact, const Bodies& bodies);

/// True for ascending indices below `count`.
bool areInOrder(std::span<const std::uint32_t> bodies, std::size_t count);

} // namespace KODO_PRECISION
} // namespace kodo
