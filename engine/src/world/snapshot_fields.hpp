// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/force_field.hpp>

#include "base/byte_stream.hpp"
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
class SnapshotFields {
public:
    using OwnFields = std::span<const std::shared_ptr<const ForceField>>;

    SnapshotFields(ByteStream& stream, OwnFields ownFields)
        : stream_(stream), ownFields_(ownFields) {}

    /// When reading, `world` must be new.
    void world(WorldImpl& world);
    /// Writes what decides the future beside the motion: settings, fields, geometry, materials,
    /// user data and the numbers of joints. Of a user's own fields only that they exist.
    void definitions(const WorldImpl& world);

private:
    bool reads() const { return stream_.reads(); }
    static void require(bool good, const char* sentence) {
        if (!good) {
            throw BadSnapshot(sentence);
        }
    }
    static void require(const std::optional<Problem>& problem) {
        if (problem) {
            throw BadSnapshot(problem->text());
        }
    }

    template <typename... Values>
    void all(Values&... values) {
        (one(values), ...);
    }

    template <typename Number>
    requires std::is_arithmetic_v<Number>
    void one(Number& number) { stream_.number(number); }
    /// A number stored with another size, or an enumerator.
    template <typename Stored, typename Value>
    void as(Value& value) {
        auto stored = static_cast<Stored>(value);
        stream_.number(stored);
        value = static_cast<Value>(stored);
    }
    void one(ReorderPolicy& reorderPolicy) {
        auto& [strayed, cost] = reorderPolicy;
        all(strayed, cost);
    }
    template <typename Value>
    void one(std::vector<Value>& list) {
        std::uint32_t length = lengthOf(list.size());
        if (reads()) {
            list.clear();
            while (length-- > 0) {
                one(list.emplace_back()); // a wrong length fails before the list is large
            }
            return;
        }
        for (Value& value : list) {
            one(value);
        }
    }
    template <typename Value, std::size_t N>
    void one(std::array<Value, N>& values) {
        for (Value& value : values) {
            one(value);
        }
    }
    template <typename Value>
    void one(std::optional<Value>& value) {
        bool there = value.has_value();
        one(there);
        if (there) {
            one(reads() ? value.emplace() : *value);
        } else {
            value.reset();
        }
    }
    template <typename... Kinds>
    void one(std::variant<Kinds...>& value) {
        std::uint8_t kind = static_cast<std::uint8_t>(value.index());
        one(kind);
        if (reads()) {
            std::uint8_t i = 0;
            const bool known = ((i++ == kind && (value = Kinds{}, true)) || ...);
            require(known, "the kind of a shape, joint or solver is unknown");
        }
        std::visit([this](auto& alternative) { this->one(alternative); }, value);
    }

    template <typename T>
    void one(BasicVec2<T>& v) {
        auto& [x, y] = v;
        all(x, y);
    }
    void one(Rot& q) {
        auto& [c, s] = q;
        all(c, s);
    }
    void one(Transform& t) {
        auto& [position, rotation] = t;
        all(position, rotation);
    }
    void one(Aabb& box) {
        auto& [lower, upper] = box;
        all(lower, upper);
    }

    void one(Octagon& octagon) {
        auto& [lower, upper] = octagon;
        for (Octagon::Each* each : {&lower, &upper}) {
            for (int i = 0; i < 4; ++i) {
                Real value = (*each)[i];
                one(value);
                (*each)[i] = value;
            }
        }
    }

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
    void one(BodyId& id) {
        auto& [index, generation, world] = id; // the World is not stored
        all(index, generation);
    }
    void one(CollisionFilter& filter);
    void one(BodyVelocity& motion);
    void one(Acceleration& acceleration);
    void one(SleepState& rest);
    void one(IdPool& pool);
    void one(Bodies& bodies);
    static void completeBody(Bodies& bodies, std::uint32_t body);
    static void checkAwake(const Bodies& bodies);

    // Force fields.
    void one(DragLaw& law);
    void one(Buoyancy::Fluid& fluid);
    void one(Attractor::Law& law);
    void one(FieldEntry& entry);
    template <typename Field, typename... Values>
    void field(std::shared_ptr<const ForceField>& field, Values (Field::*... get)() const);
    std::shared_ptr<const ForceField> nextOwnField();

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
    static void completeContact(Contact& contact, const Bodies& bodies);
    /// True for ascending indices below `count`.
    static bool inOrder(std::span<const std::uint32_t> bodies, std::size_t count);

    // Joints.
    void one(JointId& id) {
        auto& [index, generation, world] = id; // the World is not stored
        all(index, generation);
    }
    void one(Range& range);
    void one(JointEnds& ends);
    void one(RevoluteJoint& pin);
    void one(FixedJoint& weld);
    void one(DistanceJoint& spring);
    void one(PrismaticJoint& slider);
    void one(MotorJoint& motor);
    void one(MouseJoint& mouse);
    void one(JointSet::Joint& joint);
    void one(BrokenJoint& broken);
    void joints(JointSet& set, const Bodies& bodies, Real lengthUnit);

    void one(SoftSettings& settings);
    void one(PropagationSettings& settings);
    void one(StepSettings& settings);
    void one(Tolerances& tolerances);
    std::uint32_t lengthOf(std::size_t size);

    ByteStream& stream_;
    OwnFields ownFields_; // not used yet
    std::vector<std::shared_ptr<const BodyGeometry>> geometries_;
    std::map<const BodyGeometry*, std::uint32_t> geometryNumbers_; // for look-up, never iterated
};

} // namespace KODO_PRECISION
} // namespace kodo
