// SPDX-License-Identifier: MIT
// Any sequence of calls on a World. Judges: numbers stay finite, energy never grows where nothing
// puts any in, momentum stays in a closed World, removed ids are refused for ever, refusals change
// nothing, touches begin and end in turn, and copies and bytes have the same bits.
#include <support/every_kind.hpp>
#include <support/scenes.hpp>

#include <fuzz/fuzz.hpp>
#include <worlds/judges.hpp>

#include <functional>

namespace {

using namespace kodo;

class Calls {
public:
    Calls(const std::uint8_t* data, std::size_t size)
        : feed_(data, size), world_({.gravity = feed_.below(2) == 0 ? Vec2{} : Vec2{0, -10}}) {
        if (feed_.below(4) == 0) {
            StepSettings settings = thesis2006();
            settings.propagation().shockPasses = static_cast<int>(feed_.below(3));
            world_.setSettings(settings);
        }
        if (feed_.below(2) == 0) {
            world_.add({.shape = Box{30, 1}, .position = {0, -4}, .type = BodyType::Static});
        }
        copy_ = world_;
    }

    void run() {
        for (int calls = 0; !feed_.empty() && calls < 400; ++calls) {
            next();
        }
        step(4);
    }

private:
    /// Applies a change to the World and its copy. A refusal changes nothing.
    void change(const std::function<void(World&)>& apply) {
        const std::uint64_t before = world_.stateHash();
        bool refused = false;
        try {
            apply(world_);
        } catch (const BadDefinition&) {
            refused = true;
        } catch (const BadBodyId&) {
            refused = true;
        }
        if (refused) {
            fuzz::require(world_.stateHash() == before, "a refusal changes the World");
            return;
        }
        apply(copy_);
        if (!restored_) { // else the bytes may list other bounds to search in the next step
            requireSameBytes("a copy with the same change has other bytes");
        }
        const World copyNow = world_;
        fuzz::require(toBytes(copyNow) == toBytes(world_), "a copy of now has other bytes");
    }

    void requireSameBytes(const char* sentence) const {
        fuzz::require(toBytes(copy_) == toBytes(world_), sentence);
    }

    BodyId any() {
        const std::vector<BodyId> ids = world_.bodies();
        return ids.empty() ? BodyId{} : ids[feed_.below(ids.size())];
    }

    Primitive primitive() {
        const Real size = feed_.positive();
        switch (feed_.below(9)) {
        case 0:
            return Circle{size};
        case 1:
            return Box{size, feed_.positive()};
        case 2:
            return Polygon{{{-size, -size}, {size, -size}, {0, size}}};
        case 3:
            return Segment{{-size, 0}, {size, 0}};
        case 4:
            return Point{};
        case 5:
            return Capsule{{-size, 0}, feed_.point(), feed_.positive()};
        case 6:
            return Box{size, size, {}, {}, feed_.number()};
        case 7:
            return Segment{{-size, 0}, {size, 0}, false, feed_.positive()};
        default:
            return Box{size, feed_.number()};
        }
    }

    void addBody() {
        BodyDef def;
        def.shape = shapeOf(primitive());
        def.position = feed_.point();
        def.rotation = feed_.rotation();
        def.velocity = feed_.point();
        def.angularVelocity = feed_.number();
        def.density = feed_.positive();
        def.material =
            withFriction(feed_.positive() / 2, feed_.below(2) == 0 ? 0 : feed_.positive() / 2);
        constexpr Flags kFlags[] = {
            0, 0, 0, kSensor, kLockRotate, kNeverSleep, kMatchAny | 1, kDisabled};
        def.flags = kFlags[feed_.below(std::size(kFlags))];
        def.type = static_cast<BodyType>(feed_.below(8) < 6 ? 0 : feed_.below(3));
        if (world_.bodyCount() < 24) {
            change([&](World& world) { world.add(def); });
        }
    }

    void changeBody() {
        const BodyId id = any();
        const BodyId other = any();
        const Vec2 point = feed_.point();
        const Rot turned = feed_.rotation();
        constexpr Flags kFlags[] = {0,       1,         kLockRotate,   kLockMove,
                                    kSensor, kDisabled, kMatchAll | 2, 1u << 27};
        const Flags flags = kFlags[feed_.below(std::size(kFlags))];
        const std::function<void(World&)> changes[] = {
            [=](World& w) { w[id].setPosition(point); },
            [=](World& w) { w[id].setRotation(turned); },
            [=](World& w) { w[id].setVelocity(point); },
            [=](World& w) { w[id].setAngularVelocity(point.x); },
            [=](World& w) { w[id].applyImpulse(point, point); },
            [=](World& w) { w[id].applyForce(point); },
            [=](World& w) { w[id].setFlags(flags); },
            [=](World& w) { w[id].setRequired(static_cast<std::uint16_t>(flags & 3)); },
            [=](World& w) { w[id].setMaterial(withFriction(point.x, point.y)); },
            [=](World& w) { w[id].setType(static_cast<BodyType>(flags % 3)); },
            [=](World& w) { w[id].moveTo(point, Real(1) / 60); },
            [=](World& w) { w[id].setMass(point.x); },
            [=](World& w) { w[id].setMass({.mass = 2, .center = point, .inertia = turned.s}); },
            [=](World& w) { w[id].setMassFromDensity(); },
            [=](World& w) { w[id].copyFrom(w[other]); },
            [=](World& w) { w[id].wake(); },
        };
        change(changes[feed_.below(std::size(changes))]);
    }

    void changeParts() {
        const BodyId one = any();
        const BodyId other = any();
        const Vec2 point = feed_.point();
        const std::size_t part = feed_.below(4);
        const Primitive shape = primitive();
        switch (feed_.below(5)) {
        case 0:
            return change([=](World& w) { w.weld(one, other); });
        case 1:
            return change([=](World& w) { w.weld(one, shape, {}, 1); });
        case 2:
            renumbered_ = true; // later parts move up by one, and so do their touches
            return change([=](World& w) { w.unweld(one, part); });
        case 3:
            return world_.bodyCount() < 24 ? change([=](World& w) { w.clone(one, point); })
                                           : void();
        default:
            removed_.push_back(one);
            return change([=](World& w) { w.remove(one); });
        }
    }

    void changeJoints() {
        const JointEnds ends{
            .a = any(), .b = any(), .anchorA = feed_.point(), .anchorB = feed_.point()};
        const Real number = feed_.number();
        const support::EveryKind<JointDef> kinds{
            RevoluteJoint{.ends = ends},
            RevoluteJoint{.ends = ends, .motorSpeed = number, .motorTorque = 5},
            FixedJoint{.ends = ends},
            DistanceJoint{.ends = ends, .length = 1, .hertz = number},
            DistanceJoint{.ends = ends, .limits = Range{0, number}},
            PrismaticJoint{.ends = ends, .limits = Range{-1, number}},
            MotorJoint{.ends = ends, .force = number, .torque = 1},
            MouseJoint{.body = ends.a, .target = ends.anchorA, .force = number},
            RevoluteJoint{.ends = ends, .limits = Range{-9, number}, .target = 4, .hertz = 2},
            RevoluteJoint{.ends = ends, .limits = Range{-9, 9}, .ratchet = number},
            FixedJoint{.ends = ends, .hertz = number, .damping = 1},
            DistanceJoint{.ends = ends, .motorSpeed = number, .motorForce = 5},
            PrismaticJoint{.ends = ends, .target = number, .hertz = 3},
            WheelJoint{.ends = ends, .hertz = 4, .motorSpeed = number, .motorTorque = 5},
            PulleyJoint{.ends = ends, .groundA = {0, 9}, .groundB = {3, 9}, .length = number},
            GearJoint{.ends = ends, .ratio = number},
            GearJoint{.ends = ends, .ratio = number, .rack = Vec2{1, 0}},
            FilterJoint{.ends = ends}};
        const JointDef def = kinds.list[feed_.below(kinds.list.size())];
        const std::vector<JointId> joints = world_.joints();
        if (joints.size() < 12 && feed_.below(3) > 0) {
            change([&](World& w) { std::visit([&](const auto& own) { w.add(own); }, def); });
        } else if (!joints.empty()) {
            const JointId id = joints[feed_.below(joints.size())];
            change([=](World& w) { w.remove(id); });
        }
    }

    void changeSurroundings() {
        const Vec2 at = feed_.point();
        StepSettings settings;
        settings.soft().substeps = static_cast<int>(feed_.below(10));
        settings.leaveOut.bits = static_cast<std::uint8_t>(feed_.byte() & ~kRecords);
        switch (feed_.below(4)) {
        case 0:
            return change([=](World& w) { w.setSettings(settings); });
        case 1:
            return change([=](World& w) { w.setRegion(Aabb{at - Vec2{3, 3}, at + Vec2{4, 4}}); });
        case 2:
            return change([=](World& w) { w.setRegion(std::nullopt); });
        default:
            return change([=](World& w) { w.applyForceToAll(at); });
        }
    }

    void ask() {
        const Vec2 from = feed_.point();
        const Vec2 to = feed_.point();
        try {
            rayCastAll(world_, from, to);
            overlap(world_, Aabb{from, to});
            closestPoint(world_, from, 2);
            shapeCast(world_, Circle{Real(0.2)}, {from, {}}, to);
        } catch (const BadDefinition&) {
        }
        for (const BodyId id : removed_) {
            try {
                world_[id].setVelocity({});
                fuzz::require(world_.contains(id), "a removed id is accepted");
            } catch (const BadBodyId&) {
            } catch (const BadDefinition&) { // static
                fuzz::require(world_.contains(id), "a removed id is accepted");
            }
        }
        restored_ = !restored_;
        copy_ = restored_ ? fromBytes(toBytes(world_)) : world_;
    }

    void step(std::size_t count) {
        for (; count > 0; --count) {
            const bool alone = isQuiet();
            const long double before = alone ? support::totalsOf(world_).kinetic : 0;
            world_.step(Real(1) / 60);
            copy_.step(Real(1) / 60);
            fuzz::require(copy_.stateHash() == world_.stateHash(), "a copy has other bits");
            requireSameBytes("a copy has other bytes after a step");
            if (const auto text = worlds::judgeNumbers(world_); text && *text != "frozen body") {
                fuzz::require(false, text->c_str());
            }
            if (const auto text = touches_.afterStep(world_); text && !renumbered_) {
                fuzz::require(false, text->c_str());
            }
            if (alone) {
                fuzz::require(support::totalsOf(world_).kinetic <= before * 1.01L + 1e-6L,
                              "energy grows from nothing");
            }
        }
    }

    /// True if nothing can put energy in: no gravity, joint, overlap, force or moving obstacle.
    bool isQuiet() const {
        if (!world_.fields().empty() || !world_.joints().empty() || forced_) {
            return false;
        }
        for (const BodyId id : world_.bodies()) {
            const BodyView body = world_[id];
            const bool locked =
                (body.flags() & (kLockMove | kLockRotate)) != 0 || body.inertia() == 0;
            const bool moves = body.velocity() != Vec2{} || body.angularVelocity() != 0;
            if (moves && (locked || body.type() == BodyType::Kinematic)) {
                return false;
            }
        }
        return worlds::startsSound(world_);
    }

    void next() {
        switch (feed_.below(10)) {
        case 0:
        case 1:
            return addBody();
        case 2:
        case 3:
            forced_ = true;
            return changeBody();
        case 4:
            return changeParts();
        case 5:
            return changeJoints();
        case 6:
            forced_ = true;
            return changeSurroundings();
        case 7:
            return ask();
        case 8: {
            const World restored = fromBytes(toBytes(world_));
            fuzz::require(restored.stateHash() == world_.stateHash(), "bytes give another World");
            World left = restored;
            World right = world_;
            left.step(Real(1) / 60);
            right.step(Real(1) / 60);
            fuzz::require(left.stateHash() == right.stateHash(), "bytes continue with other bits");
            fuzz::require(toBytes(left) == toBytes(right), "bytes continue with other bytes");
            return;
        }
        default:
            step(1 + feed_.below(16));
            forced_ = false; // forces act in one step
            return;
        }
    }

    static constexpr unsigned kRecords = static_cast<unsigned>(Feature::Records);

    fuzz::Feed feed_;
    World world_;
    World copy_;
    worlds::TouchJudge touches_;
    std::vector<BodyId> removed_;
    bool forced_ = false;
    bool restored_ = false; // the copy is one of the bytes
    bool renumbered_ = false;
};

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Calls(data, size).run();
    return 0;
}
