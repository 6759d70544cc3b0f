// SPDX-License-Identifier: MIT
// Each setter with each kind of body and each kind of number: it refuses by name and changes
// nothing, or it accepts, and then the World can be stepped, copied, written and restored.
#include <kodo/snapshot.hpp>
#include <support/scenes.hpp>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace kodo {
namespace {

using support::kDt;
using support::kInf;
using support::kNan;

struct Kind {
    const char* name;
    std::function<BodyDef()> def;
};

BodyDef box(BodyType type, Flags flags = 0) {
    return {.shape = Box{1, 1}, .position = {0, 1}, .type = type, .flags = flags};
}

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = {
        {"dynamic", [] { return box(BodyType::Dynamic); }},
        {"static", [] { return box(BodyType::Static); }},
        {"kinematic", [] { return box(BodyType::Kinematic); }},
        {"sensor", [] { return box(BodyType::Dynamic, kSensor); }},
        {"disabled", [] { return box(BodyType::Dynamic, kDisabled); }},
        {"locked", [] { return box(BodyType::Dynamic, kLockMove | kLockRotate); }},
        {"point",
         [] {
             return BodyDef{.shape = Point{{0, Real(0.1)}}};
         }},
        {"segment",
         [] {
             return BodyDef{.shape = Segment{{-1, 0}, {1, 0}}};
         }},
        {"plane", [] { return BodyDef{.shape = Plane{}, .type = BodyType::Static}; }},
        {"heightmap",
         [] {
             return BodyDef{.shape = Heightmap{{-1, 0}, 1, {0, 1, 0}}, .type = BodyType::Static};
         }},
        {"points",
         [] {
             return BodyDef{.shape = Compound{{Point{}, Point{{1, 0}}}}};
         }},
        {"compound",
         [] {
             BodyDef def{.shape = Compound{{Box{1, 1}, Circle{1, {1, 0}}}}, .position = {0, 3}};
             def.mass = MassDef{.mass = 4, .center = Vec2{0, Real(-0.5)}, .inertia = 9};
             return def;
         }},
    };
    return all;
}

/// A floor, another body, and the subject after a few steps.
struct Scene {
    World world{{.gravity = support::kEarth}};
    BodyId floor;
    BodyId other;
    BodyId subject;

    explicit Scene(const Kind& kind) {
        floor = support::addFloor(world);
        other = world.add(support::ballDef({0, 5}, Real(0.5)));
        subject = world.add(kind.def());
        support::run(world, 3);
    }
};

struct Call {
    std::string name;
    std::function<void(Scene&)> apply;
};

const std::vector<Real>& numbers() {
    using Limits = std::numeric_limits<Real>;
    static const std::vector<Real> all = {kNan,
                                          kInf,
                                          -kInf,
                                          -1,
                                          0,
                                          1,
                                          Limits::denorm_min(),
                                          Limits::min(),
                                          Limits::max(),
                                          -Limits::max(),
                                          Real(1e-6),
                                          Real(1e9),
                                          kMaxCoordinate,
                                          kMaxSpeed,
                                          1 / kMaxMass,
                                          kMaxMass};
    return all;
}

using Set = std::function<void(Scene&, Real)>;
using NamedSet = std::pair<const char*, Set>;

/// A setter of the subject.
template <typename Change>
Set self(Change change) {
    return [=](Scene& s, Real v) { change(s.world[s.subject], v); };
}

std::vector<NamedSet> bodySetters() {
    return {
        {"setPosition", self([](BodyRef b, Real v) {
             b.setPosition({v, 0});
         })},
        {"setRotation", self([](BodyRef b, Real v) {
             b.setRotation({v, 0});
         })},
        {"setVelocity", self([](BodyRef b, Real v) {
             b.setVelocity({0, v});
         })},
        {"setAngularVelocity", self([](BodyRef b, Real v) { b.setAngularVelocity(v); })},
        {"moveTo", self([](BodyRef b, Real v) {
             b.moveTo({v, v}, kDt);
         })},
        {"moveTo, rotation", self([](BodyRef b, Real v) {
             b.moveTo({}, {0, v}, kDt);
         })},
        {"moveTo, dt", self([](BodyRef b, Real v) {
             b.moveTo({1, 1}, v);
         })},
        {"applyForce", self([](BodyRef b, Real v) {
             b.applyForce({v, v});
         })},
        {"applyForce, point", self([](BodyRef b, Real v) {
             b.applyForce({v, 1}, {1, v});
         })},
        {"applyTorque", self([](BodyRef b, Real v) { b.applyTorque(v); })},
        {"applyImpulse", self([](BodyRef b, Real v) {
             b.applyImpulse({0, v});
         })},
        {"applyImpulse, point", self([](BodyRef b, Real v) {
             b.applyImpulse({1, v}, {v, 0});
         })},
        {"setMass", self([](BodyRef b, Real v) { b.setMass(v); })},
        {"setMass, centre", self([](BodyRef b, Real v) {
             b.setMass({.mass = 2, .center = Vec2{v, 0}});
         })},
        {"setMass, inertia", self([](BodyRef b, Real v) { b.setMass({.mass = 2, .inertia = v}); })},
        {"setMass, all", self([](BodyRef b, Real v) {
             b.setMass({.mass = v, .center = Vec2{v, v}, .inertia = v});
         })},
        {"setMaterial, friction", self([](BodyRef b, Real v) { b.setMaterial(withFriction(v)); })},
        {"setMaterial, restitution",
         self([](BodyRef b, Real v) { b.setMaterial(withFriction(0, v)); })},
        {"setMaterial, rolling",
         self([](BodyRef b, Real v) { b.setMaterial({.rollingResistance = v}); })},
    };
}

std::vector<NamedSet> worldSetters() {
    return {
        {"clone",
         [](Scene& s, Real v) {
             s.world.clone(s.subject, {v, v});
         }},
        {"weld a circle", [](Scene& s, Real v) { s.world.weld(s.subject, Circle{v}, {}, 1); }},
        {"weld a circle beside",
         [](Scene& s, Real v) {
             s.world.weld(s.subject, Circle{1, {v, 0}}, {}, 1);
         }},
        {"weld with a density",
         [](Scene& s, Real v) { s.world.weld(s.subject, Circle{1}, {}, v); }},
        {"force on all",
         [](Scene& s, Real v) {
             s.world.applyForceToAll({v, 0});
         }},
        {"torque on all", [](Scene& s, Real v) { s.world.applyTorqueToAll(v); }},
        {"region",
         [](Scene& s, Real v) {
             s.world.setRegion(Aabb{{-1, -1}, {v, v}});
         }},
        {"a field",
         [](Scene& s, Real v) {
             s.world.addField({std::make_shared<Gravity>(Vec2{0, v}), {}});
         }},
        {"an attractor",
         [](Scene& s, Real v) {
             const auto law = Attractor::Law::InverseSquare;
             s.world.addField({std::make_shared<Attractor>(law, Vec2{}, v, v), {}});
         }},
        {"a pin far off",
         [](Scene& s, Real v) {
             s.world.add(RevoluteJoint{.ends = {s.other, s.subject, {v, 0}, {0, v}}});
         }},
        {"a spring",
         [](Scene& s, Real v) {
             s.world.add(DistanceJoint{
                 .ends = {s.other, s.subject}, .length = v, .hertz = v, .damping = v});
         }},
        {"a motor",
         [](Scene& s, Real v) {
             s.world.add(
                 MotorJoint{.ends = {s.other, s.subject}, .force = v, .torque = v, .hertz = 5});
         }},
        {"a mouse",
         [](Scene& s, Real v) {
             s.world.add(MouseJoint{.body = s.subject, .target = {v, 0}});
         }},
    };
}

/// Calls with one number in each place of each setter.
std::vector<Call> numberCalls() {
    std::vector<Call> calls;
    for (const std::vector<NamedSet>& list : {bodySetters(), worldSetters()}) {
        for (const NamedSet& entry : list) {
            for (const Real value : numbers()) {
                const Set set = entry.second;
                calls.push_back({std::string(entry.first) + " of " + std::to_string(value),
                                 [=](Scene& s) { set(s, value); }});
            }
        }
    }
    return calls;
}

/// Calls without numbers: types, all single flags, handles and other bodies.
std::vector<Call> otherCalls() {
    std::vector<Call> calls = {
        {"setType 7", [](Scene& s) { s.world[s.subject].setType(static_cast<BodyType>(7)); }},
        {"setMassFromDensity", [](Scene& s) { s.world[s.subject].setMassFromDensity(); }},
        {"copyFrom the floor", [](Scene& s) { s.world[s.subject].copyFrom(s.world[s.floor]); }},
        {"copyFrom the ball", [](Scene& s) { s.world[s.subject].copyFrom(s.world[s.other]); }},
        {"copy to the ball", [](Scene& s) { s.world[s.other].copyFrom(s.world[s.subject]); }},
        {"copy to the floor", [](Scene& s) { s.world[s.floor].copyFrom(s.world[s.subject]); }},
        {"a law that is none",
         [](Scene& s) {
             const auto law = static_cast<Attractor::Law>(7);
             s.world.addField({std::make_shared<Attractor>(law, Vec2{}, 1), {}});
         }},
        {"weld to the ball", [](Scene& s) { s.world.weld(s.other, s.subject); }},
        {"weld to the floor", [](Scene& s) { s.world.weld(s.floor, s.subject); }},
        {"weld the ball", [](Scene& s) { s.world.weld(s.subject, s.other); }},
        {"weld a plane", [](Scene& s) { s.world.weld(s.subject, Plane{}, {}, 1); }},
        {"weld itself", [](Scene& s) { s.world.weld(s.subject, s.subject); }},
        {"unweld", [](Scene& s) { s.world.unweld(s.subject, 0); }},
        {"unweld part 9", [](Scene& s) { s.world.unweld(s.subject, 9); }},
        {"weld and unweld",
         [](Scene& s) { s.world.unweld(s.subject, s.world.weld(s.subject, s.other)); }},
        {"remove", [](Scene& s) { s.world.remove(s.subject); }},
        {"wake", [](Scene& s) { s.world[s.subject].wake(); }},
    };
    for (const BodyType type : {BodyType::Dynamic, BodyType::Kinematic, BodyType::Static}) {
        calls.push_back({"setType " + std::to_string(static_cast<int>(type)),
                         [=](Scene& s) { s.world[s.subject].setType(type); }});
    }
    for (int bit = 0; bit < 32; ++bit) {
        const Flags flag = Flags{1} << bit;
        const std::string number = std::to_string(bit);
        calls.push_back(
            {"setFlags " + number, [=](Scene& s) { s.world[s.subject].setFlags(flag); }});
        calls.push_back(
            {"unweld, flag " + number, [=](Scene& s) { s.world.unweld(s.subject, 0, flag | 1); }});
        calls.push_back({"filter of a field, flag " + number, [=](Scene& s) {
                             s.world.addField({std::make_shared<Gravity>(Vec2{1, 0}), {flag, 1}});
                         }});
        calls.push_back({"filter of a force, flag " + number, [=](Scene& s) {
                             s.world.applyForceToAll({1, 0}, {flag, 1});
                         }});
        calls.push_back({"a definition, flag " + number, [=](Scene& s) {
                             s.world.add({.position = {9, 9}, .flags = flag | 1});
                         }});
    }
    return calls;
}

/// Bytes and copies of a World have its state. copyFrom() of each body itself is accepted.
void expectRestorable(const World& world) {
    const World loaded = fromBytes(toBytes(world));
    ASSERT_EQ(loaded.stateHash(), world.stateHash());
    World copy = world;
    ASSERT_EQ(copy.stateHash(), world.stateHash());
    for (const BodyId id : world.bodies()) {
        const Vec2 at = world[id].position();
        if (std::max(std::abs(at.x), std::abs(at.y)) < kMaxCoordinate &&
            length(world[id].velocity()) < kMaxSpeed) {
            EXPECT_NO_THROW(copy[id].copyFrom(world[id])) << id.index;
        }
    }
}

void expectSound(const Kind& kind, const Call& call) {
    SCOPED_TRACE(call.name + ", " + kind.name);
    Scene scene(kind);
    const std::uint64_t before = scene.world.stateHash();
    try {
        call.apply(scene);
    } catch (const BadDefinition& bad) {
        EXPECT_FALSE(bad.problem().field.empty() || bad.problem().reason.empty());
        EXPECT_EQ(scene.world.stateHash(), before) << "refused, but changed";
        return;
    }
    ASSERT_NO_FATAL_FAILURE(expectRestorable(scene.world));
    World loaded = fromBytes(toBytes(scene.world));
    for (int step = 0; step < 3; ++step) {
        scene.world.step(kDt);
        loaded.step(kDt);
    }
    ASSERT_EQ(loaded.stateHash(), scene.world.stateHash());
    ASSERT_NO_FATAL_FAILURE(expectRestorable(scene.world));
    for (const BodyId id : scene.world.bodies()) {
        const BodyView body = scene.world[id];
        EXPECT_TRUE(isFinite(body.position()) && isFinite(body.velocity()) &&
                    std::isfinite(body.angularVelocity()));
    }
}

TEST(SetterEdges, EachNumberIsRefusedOrSound) {
    for (const Call& call : numberCalls()) {
        for (const Kind& kind : kinds()) {
            expectSound(kind, call);
        }
    }
}

TEST(SetterEdges, EachTypeAndFlagIsRefusedOrSound) {
    for (const Call& call : otherCalls()) {
        for (const Kind& kind : kinds()) {
            expectSound(kind, call);
        }
    }
}

// These have a meaning in queries and as modes, but not as flags of a body beside another mode.
TEST(SetterEdges, FlagsOfQueriesAreRefusedByBodies) {
    for (const Kind& kind : kinds()) {
        for (const Flags flag : {kNoSensors, kMatchNone | kMatchAny}) {
            Scene scene(kind);
            EXPECT_THROW(scene.world[scene.subject].setFlags(flag), BadDefinition) << kind.name;
            EXPECT_THROW(scene.world.add({.flags = flag}), BadDefinition) << kind.name;
        }
    }
}

// Bits without a meaning, or with one that only the engine gives them.
TEST(SetterEdges, ReservedBitsAreRefusedEverywhere) {
    for (const Kind& kind : kinds()) {
        for (const int bit : {26, 31}) {
            const Flags flag = Flags{1} << bit;
            const std::vector<std::function<void(Scene&)>> calls = {
                [=](Scene& s) { s.world[s.subject].setFlags(flag); },
                [=](Scene& s) { s.world.add({.flags = flag}); },
                [=](Scene& s) {
                    s.world.applyTorqueToAll(1, {flag, 0});
                },
                [=](Scene& s) {
                    s.world.applyForceToAll({1, 0}, {flag | kMatchAny, 1});
                },
                [=](Scene& s) { s.world.unweld(s.subject, 0, flag); },
                [=](Scene& s) {
                    overlap(s.world, Aabb{{0, 0}, {1, 1}}, {flag, 0});
                },
                [=](Scene& s) {
                    s.world.setFields({{std::make_shared<Gravity>(Vec2{}), {flag, 0}}});
                },
            };
            for (std::size_t i = 0; i < calls.size(); ++i) {
                Scene scene(kind);
                EXPECT_THROW(calls[i](scene), BadDefinition) << kind.name << ", call " << i;
            }
        }
    }
}

// A handle of a removed body, and one of the next body in its slot.
TEST(SetterEdges, ARemovedHandleIsRefusedByEachSetter) {
    Scene scene(kinds()[0]);
    BodyRef gone = scene.world[scene.subject];
    scene.world.remove(scene.subject);
    for (const bool reused : {false, true}) {
        if (reused) {
            scene.world.add({});
        }
        const std::uint64_t before = scene.world.stateHash();
        for (const Call& call : numberCalls()) {
            if (call.name.find("on all") == std::string::npos &&
                call.name.find("region") == std::string::npos &&
                call.name.find("field") == std::string::npos &&
                call.name.find("attractor") == std::string::npos) {
                EXPECT_ANY_THROW(call.apply(scene)) << call.name;
            }
        }
        EXPECT_THROW(gone.setMassFromDensity(), BadBodyId);
        EXPECT_THROW(gone.copyFrom(scene.world[scene.other]), BadBodyId);
        EXPECT_THROW(scene.world[scene.other].copyFrom(gone), BadBodyId);
        EXPECT_THROW(gone.setMass(1), BadBodyId);
        EXPECT_THROW(gone.wake(), BadBodyId);
        EXPECT_EQ(scene.world.stateHash(), before);
    }
}

} // namespace
} // namespace kodo
