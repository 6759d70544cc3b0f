// SPDX-License-Identifier: MIT
#include <worlds/recipe.hpp>

#include <cstdlib>
#include <limits>
#include <sstream>

namespace worlds {
namespace {

using namespace kodo;

// 1: shapes without a radius; 2: joints without springs of all kinds; 3: settings without a gap
constexpr int kFormat = 4;

/// Writes and reads the same fields, so that both directions agree.
class Writer {
public:
    Writer() { out_.precision(std::numeric_limits<Real>::max_digits10); }
    static constexpr bool reads() { return false; }
    bool ok() const { return true; }
    void word(const char* word) { out_ << word << ' '; }
    void one(Real& value) { out_ << value << ' '; }
    template <typename Integer>
    requires std::is_integral_v<Integer>
    void one(Integer& value) { out_ << +value << ' '; }
    void line() { out_ << '\n'; }
    std::string text() const { return out_.str(); }
    int format = kFormat;

private:
    std::ostringstream out_;
};

class Reader {
public:
    explicit Reader(const std::string& text) : in_(text) {}
    int format = kFormat;
    static constexpr bool reads() { return true; }
    bool ok() const { return !in_.fail(); }
    void word(const char* word) {
        std::string found;
        in_ >> found;
        if (found != word) {
            in_.setstate(std::ios::failbit);
        }
    }
    void one(Real& value) {
        std::string digits;
        in_ >> digits;
        char* end = nullptr;
        const double wide = std::strtod(digits.c_str(), &end);
        value = static_cast<Real>(wide);
        if (digits.empty() || *end != '\0') {
            in_.setstate(std::ios::failbit);
        }
    }
    template <typename Integer>
    requires std::is_integral_v<Integer>
    void one(Integer& value) {
        long long wide = 0;
        in_ >> wide;
        value = static_cast<Integer>(wide);
    }
    void line() {}

private:
    std::istringstream in_;
};

template <typename Stream>
void visit(Stream& s, Vec2& v) {
    s.one(v.x);
    s.one(v.y);
}

template <typename Stream, typename Value, typename Visit>
void visitOptional(Stream& s, std::optional<Value>& value, Visit visitValue) {
    bool has = value.has_value();
    s.one(has);
    if (has) {
        Value inner = value.value_or(Value{});
        visitValue(inner);
        value = inner;
    } else {
        value.reset();
    }
}

/// Reads or writes the length of a list, at most 10,000.
template <typename Stream, typename List>
void visitLength(Stream& s, List& list) {
    std::size_t length = list.size();
    s.one(length);
    if (!s.ok() || length > 10000) {
        length = 0;
    }
    list.resize(length);
}

template <typename Stream>
void visit(Stream& s, Circle& circle) {
    s.one(circle.radius);
    visit(s, circle.center);
}
/// The radius around a shape, which files of format 1 do not have.
template <typename Stream>
void visitRadius(Stream& s, Real& radius) {
    if (s.format > 1) {
        s.one(radius);
    }
}
template <typename Stream>
void visit(Stream& s, Capsule& capsule) {
    visit(s, capsule.from);
    visit(s, capsule.to);
    s.one(capsule.radius);
}
template <typename Stream>
void visit(Stream& s, Box& box) {
    s.one(box.width);
    s.one(box.height);
    visit(s, box.center);
    s.one(box.rotation.c);
    s.one(box.rotation.s);
    visitRadius(s, box.radius);
}
template <typename Stream>
void visit(Stream& s, Polygon& polygon) {
    visitLength(s, polygon.corners);
    for (Vec2& corner : polygon.corners) {
        visit(s, corner);
    }
    visitRadius(s, polygon.radius);
}
template <typename Stream>
void visit(Stream& s, Point& point) {
    visit(s, point.position);
}
template <typename Stream>
void visit(Stream& s, Segment& segment) {
    visit(s, segment.from);
    visit(s, segment.to);
    s.one(segment.oneSided);
    visitRadius(s, segment.radius);
}
template <typename Stream>
void visit(Stream& s, Plane& plane) {
    visit(s, plane.normal);
    s.one(plane.offset);
}
template <typename Stream>
void visit(Stream& s, Heightmap& map) {
    visit(s, map.origin);
    s.one(map.spacing);
    visitLength(s, map.heights);
    for (Real& height : map.heights) {
        s.one(height);
    }
}

template <typename Stream>
void visit(Stream& s, Material& material) {
    s.one(material.staticFriction);
    s.one(material.kineticFriction);
    s.one(material.restitution);
    s.one(material.rollingResistance);
}
template <typename Stream>
void visit(Stream& s, Chain& chain) {
    visitLength(s, chain.points);
    for (Vec2& point : chain.points) {
        visit(s, point);
    }
    s.one(chain.closed);
    s.one(chain.oneSided);
    visitLength(s, chain.materials);
    for (Material& material : chain.materials) {
        visit(s, material);
    }
}

template <std::size_t kIndex = 0, typename Variant>
void emplaceAt(Variant& variant, std::size_t index) {
    if constexpr (kIndex < std::variant_size_v<Variant>) {
        if (index == kIndex) {
            variant.template emplace<kIndex>();
        } else {
            emplaceAt<kIndex + 1>(variant, index);
        }
    }
}

/// The index of an alternative, then the alternative.
template <typename Stream, typename Variant>
void visitVariant(Stream& s, Variant& variant) {
    std::size_t index = variant.index();
    s.one(index);
    if constexpr (Stream::reads()) {
        emplaceAt(variant, index);
    }
    std::visit([&](auto& own) { visit(s, own); }, variant);
}

template <typename Stream>
void visit(Stream& s, Compound& compound) {
    visitLength(s, compound.parts);
    for (Primitive& part : compound.parts) {
        visitVariant(s, part);
    }
}

template <typename Stream>
void visit(Stream& s, BodyDef& def) {
    s.word("body");
    int type = static_cast<int>(def.type);
    s.one(type);
    def.type = static_cast<BodyType>(type % 3);
    s.one(def.flags);
    s.one(def.required);
    visit(s, def.position);
    s.one(def.rotation.c);
    s.one(def.rotation.s);
    visit(s, def.velocity);
    s.one(def.angularVelocity);
    s.one(def.density);
    visit(s, def.material);
    visitVariant(s, def.shape);
    s.line();
}

/// Members of joints that files of formats 1 and 2 do not have.
template <typename Stream, typename... Members>
void later(Stream& s, Members&... members) {
    if (s.format > 2) {
        (s.one(members), ...);
    }
}

template <typename Stream>
void visit(Stream& s, JointEnds& ends) {
    s.one(ends.a.index);
    s.one(ends.b.index);
    visit(s, ends.anchorA);
    visit(s, ends.anchorB);
    s.one(ends.breakForce); // "inf" for one that does not break
    s.one(ends.breakTorque);
    s.one(ends.collide);
    later(s, ends.userData);
}

template <typename Stream>
void visit(Stream& s, std::optional<Range>& limits) {
    visitOptional(s, limits, [&](Range& range) {
        s.one(range.lower);
        s.one(range.upper);
    });
}
template <typename Stream>
void visit(Stream& s, RevoluteJoint& joint) {
    visit(s, joint.ends);
    s.one(joint.reference);
    visit(s, joint.limits);
    s.one(joint.motorSpeed);
    s.one(joint.motorTorque);
    later(s, joint.target, joint.hertz, joint.damping, joint.ratchet);
}
template <typename Stream>
void visit(Stream& s, FixedJoint& joint) {
    visit(s, joint.ends);
    s.one(joint.reference);
    later(s, joint.hertz, joint.damping);
}
template <typename Stream>
void visit(Stream& s, DistanceJoint& joint) {
    visit(s, joint.ends);
    s.one(joint.length);
    s.one(joint.hertz);
    s.one(joint.damping);
    visit(s, joint.limits);
    later(s, joint.motorSpeed, joint.motorForce);
}
template <typename Stream>
void visit(Stream& s, PrismaticJoint& joint) {
    visit(s, joint.ends);
    visit(s, joint.axis);
    s.one(joint.reference);
    visit(s, joint.limits);
    s.one(joint.motorSpeed);
    s.one(joint.motorForce);
    later(s, joint.target, joint.hertz, joint.damping);
}
template <typename Stream>
void visit(Stream& s, MotorJoint& joint) {
    visit(s, joint.ends);
    s.one(joint.reference);
    s.one(joint.force);
    s.one(joint.torque);
    s.one(joint.hertz);
    s.one(joint.damping);
}
template <typename Stream>
void visit(Stream& s, MouseJoint& joint) {
    s.one(joint.body.index);
    visit(s, joint.anchor);
    visit(s, joint.target);
    s.one(joint.force);
    s.one(joint.hertz);
    s.one(joint.damping);
    later(s, joint.userData);
}
template <typename Stream>
void visit(Stream& s, WheelJoint& joint) {
    visit(s, joint.ends);
    visit(s, joint.axis);
    visit(s, joint.limits);
    s.one(joint.hertz);
    s.one(joint.damping);
    s.one(joint.motorSpeed);
    s.one(joint.motorTorque);
}
template <typename Stream>
void visit(Stream& s, PulleyJoint& joint) {
    visit(s, joint.ends);
    visit(s, joint.groundA);
    visit(s, joint.groundB);
    s.one(joint.length);
    s.one(joint.ratio);
}
template <typename Stream>
void visit(Stream& s, GearJoint& joint) {
    visit(s, joint.ends);
    s.one(joint.ratio);
    visitOptional(s, joint.rack, [&](Vec2& rack) { visit(s, rack); });
}
template <typename Stream>
void visit(Stream& s, FilterJoint& joint) {
    visit(s, joint.ends);
}

template <typename Stream>
void visit(Stream& s, Event& event) {
    s.word("event");
    int kind = static_cast<int>(event.kind);
    s.one(kind);
    event.kind = static_cast<Event::Kind>(kind % 3);
    s.one(event.step);
    s.one(event.body);
    s.one(event.other);
    visit(s, event.velocity);
    s.one(event.spin);
    s.line();
}

template <typename Stream>
void visit(Stream& s, SoftSettings& soft) {
    s.one(soft.substeps);
    s.one(soft.impactPasses);
    s.one(soft.contactHertz);
    s.one(soft.contactDamping);
    s.one(soft.jointHertz);
    s.one(soft.jointDamping);
    s.one(soft.pushSpeed);
    if (s.format > 3) {
        s.one(soft.jointGap);
    }
}
template <typename Stream>
void visit(Stream& s, PropagationSettings& propagation) {
    s.one(propagation.substeps);
    s.one(propagation.impactPasses);
    s.one(propagation.contactPasses);
    s.one(propagation.shockPasses);
    s.one(propagation.jointHertz);
    s.one(propagation.jointDamping);
    s.one(propagation.pushSpeed);
}

template <typename Stream>
void visitWorld(Stream& s, Recipe& recipe) {
    s.word("world");
    s.one(s.format);
    s.line();
    s.word("gravity");
    visit(s, recipe.world.gravity);
    s.one(recipe.world.lengthUnit);
    s.one(recipe.drag);
    s.line();
    s.word("solver");
    visitVariant(s, recipe.world.settings.solver);
    s.one(recipe.world.settings.sleepSteps);
    s.one(recipe.world.settings.leaveOut.bits);
    s.line();
    s.word("run");
    s.one(recipe.dt);
    s.one(recipe.steps);
    s.one(recipe.tiles);
    int twin = static_cast<int>(recipe.twin);
    s.one(twin);
    recipe.twin = static_cast<Twin>(twin % kTwins);
    s.one(recipe.twinStep);
    s.one(recipe.rests);
    s.line();
}

template <typename Stream>
void visit(Stream& s, Recipe& recipe) {
    visitWorld(s, recipe);
    s.word("bodies");
    visitLength(s, recipe.bodies);
    s.word("joints");
    visitLength(s, recipe.joints);
    s.word("events");
    visitLength(s, recipe.events);
    s.line();
    for (BodyDef& body : recipe.bodies) {
        visit(s, body);
    }
    for (JointDef& joint : recipe.joints) {
        s.word("joint");
        visitVariant(s, joint);
        s.line();
    }
    for (Event& event : recipe.events) {
        visit(s, event);
    }
}

} // namespace

std::string toText(const Recipe& recipe) {
    Writer writer;
    Recipe copy = recipe;
    visit(writer, copy);
    return writer.text();
}

std::optional<Recipe> fromText(const std::string& text) {
    Reader reader(text);
    Recipe recipe;
    visit(reader, recipe);
    return reader.ok() ? std::optional(recipe) : std::nullopt;
}

} // namespace worlds
