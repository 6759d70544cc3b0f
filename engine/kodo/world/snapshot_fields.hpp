// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/bytes.hpp>
#include <kodo/bodies/fields.hpp>
#include <kodo/world/world.hpp>

#include <map>

namespace kodo::inline KODO_PRECISION {

/// Lists the fields of everything that a World is made of, to write them or to read them.
///
/// Every list begins by naming all members of its type, so that one that is added does not compile
/// until somebody has decided whether it is to be stored. Left out is what the next step finds anew
/// before it reads it (the memory of solvers, sweep and seams; the order that the broad phase sorts
/// in, which changes no pair), and what follows from the rest (masses, outlines, lists by body).
class SnapshotFields {
public:
    using OwnFields = std::span<const std::shared_ptr<const ForceField>>;

    SnapshotFields(ByteStream& stream, OwnFields ownFields)
        : stream_(stream), ownFields_(ownFields) {}

    /// When reading, `world` is to be a fresh one.
    void world(World& world);

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
    /// A number of another size in memory, or an enumerator.
    template <typename Stored, typename Value>
    void as(Value& value) {
        auto stored = static_cast<Stored>(value);
        stream_.number(stored);
        value = static_cast<Value>(stored);
    }
    void one(Disorder& disorder) {
        auto& [strayed, cost] = disorder;
        all(strayed, cost);
    }
    template <typename Value>
    void one(std::vector<Value>& list) {
        std::uint32_t length = lengthOf(list.size());
        if (reads()) {
            list.clear();
            while (length-- > 0) {
                one(list.emplace_back()); // what is not there is refused before there is much of it
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
            require(known, "there is no such kind of shape or joint");
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

    // Shapes and forms.
    void one(Circle& circle);
    void one(Box& box);
    void one(Polygon& polygon);
    void one(Point& point);
    void one(Segment& segment);
    void one(Plane& plane);
    void one(Material& material);
    void one(Part& part);
    void one(std::shared_ptr<const Form>& form);
    void forms(World& world);

    // Bodies.
    void one(BodyId& id) {
        auto& [index, generation] = id;
        all(index, generation);
    }
    void one(CollisionFilter& filter);
    void one(Motion& motion);
    void one(Acceleration& acceleration);
    void one(RestState& rest);
    void one(IdPool& pool);
    void one(Bodies& bodies);
    static void completeBody(Bodies& bodies, std::uint32_t body);
    static void checkAwake(const Bodies& bodies);
    static void checkThinnest(const Bodies& bodies);

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
    void one(RestStage::Island& island);
    void contacts(ContactSet& set, const Bodies& bodies, const Tolerances& tolerances);
    void rest(RestStage& stage, Bodies& bodies);
    static void completeContact(Contact& contact, const Bodies& bodies);

    // Joints.
    void one(JointId& id) {
        auto& [index, generation] = id;
        all(index, generation);
    }
    void one(Range& range);
    void one(JointEnds& ends);
    void one(Pin& pin);
    void one(Weld& weld);
    void one(Spring& spring);
    void one(Slider& slider);
    void one(Motor& motor);
    void one(Mouse& mouse);
    void one(JointSet::Joint& joint);
    void one(BrokenJoint& broken);
    void joints(JointSet& set, const Bodies& bodies, Real lengthUnit);

    void one(StepSettings& settings);
    void one(Tolerances& tolerances);
    std::uint32_t lengthOf(std::size_t size);

    ByteStream& stream_;
    OwnFields ownFields_; // those that were not met yet
    std::vector<std::shared_ptr<const Form>> forms_;
    std::map<const Form*, std::uint32_t> formNumbers_; // to find, never to go through
};

} // namespace kodo::inline KODO_PRECISION
