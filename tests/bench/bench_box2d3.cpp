// SPDX-License-Identifier: MIT
// Compiled if KODO_BENCH_BOX2D3 names an installed Box2D 3, else bench_no_box2d3.cpp is.
#include <kodo/state_hash.hpp>
#include <scenes/in_box2d3.hpp>

#include <charconv>
#include <optional>
#include <string_view>

#include "bench_engine.hpp"

namespace bench {
namespace {

constexpr int kSubsteps = 4; // the number that the documentation of Box2D recommends

/// The value of text = name + "=60", if text begins so. Numbers out of range are no values.
std::optional<float> valueOf(const std::string& text, std::string_view name) {
    float value = 0;
    const char* const end = text.data() + text.size();
    if (text.starts_with(name)) {
        const auto read = std::from_chars(text.data() + name.size(), end, value);
        if (read.ec == std::errc() && read.ptr == end && value > 0 && value <= 1e4f) {
            return value;
        }
    }
    return std::nullopt;
}

/// Stiffness of contacts and joints, 1/s; empty: the default of Box2D. With bullets, fast bodies
/// stop at those that move too.
struct Numbers {
    std::optional<float> contactHertz{};
    std::optional<float> jointHertz{};
    std::optional<float> bullets{};

    explicit Numbers(const std::vector<std::string>& set) {
        for (const std::string& text : set) {
            const auto contact = valueOf(text, "contactHertz=");
            const auto joint = valueOf(text, "jointHertz=");
            const auto bullet = valueOf(text, "bullets=");
            if (!contact && !joint && !bullet) {
                throw WrongUse("'" + text +
                               "' is not contactHertz=NUMBER, jointHertz=NUMBER or bullets=1, "
                               "up to 1e4, for Box2D 3");
            }
            contactHertz = contact ? contact : contactHertz;
            jointHertz = joint ? joint : jointHertz;
            bullets = bullet ? bullet : bullets;
        }
    }
};

class Box2d3Engine final : public Engine {
public:
    Box2d3Engine(const scenes::SceneDef& scene, const StepOptions& options)
        : substeps_(options.substeps.value_or(kSubsteps)),
          events_(options.events),
          numbers_(options.set) {
        refuse(options);
        box2d3::b2SetLogFcn([](const char*) {}); // its warnings go to stdout, within the step
        box2d3::b2WorldDef def = scenes::v3::worldOf(scene.gravity);
        def.enableSleep = options.rest;
        def.contactHertz = numbers_.contactHertz.value_or(def.contactHertz);
        world_ = box2d3::b2CreateWorld(&def);
        for (const scenes::BodyDef& body : scene.bodies) {
            add(body);
        }
        for (const scenes::RevoluteJointDef& joint : scene.joints) {
            scenes::v3::addToBox2d(world_, joint, scene, bodies_, numbers_.jointHertz);
        }
    }
    ~Box2d3Engine() override { box2d3::b2DestroyWorld(world_); }

    void step(double dt) override {
        box2d3::b2World_Step(world_, static_cast<float>(dt), substeps_);
    }

    BodyState state(std::size_t body) const override {
        const box2d3::b2WorldTransform frame = box2d3::b2Body_GetTransform(bodies_[body]);
        return {wide(frame.p),
                {static_cast<double>(frame.q.c), static_cast<double>(frame.q.s)},
                wide(box2d3::b2Body_GetLinearVelocity(bodies_[body])),
                static_cast<double>(box2d3::b2Body_GetAngularVelocity(bodies_[body]))};
    }

    void add(const scenes::BodyDef& body) final {
        bodies_.push_back(scenes::v3::addToBox2d(world_, body, events_));
        if (numbers_.bullets) {
            box2d3::b2Body_SetBullet(bodies_.back(), true);
        }
    }
    void remove(std::size_t body) override {
        box2d3::b2DestroyBody(bodies_[body]);
        bodies_[body] = {};
    }

    void reload() override {
        const std::vector<std::uint8_t> bytes = snapshot();
        box2d3::b2World_Restore(world_, bytes.data(), static_cast<int>(bytes.size()));
    }

    void place(std::size_t body, scenes::Vec2 position) override {
        const box2d3::b2BodyId id = bodies_[body];
        box2d3::b2Body_SetTransform(id, scenes::v3::toBox2d(position),
                                    box2d3::b2Body_GetRotation(id));
        box2d3::b2Body_SetLinearVelocity(id, {0, 0});
    }
    void push(std::size_t body, scenes::Vec2 velocity) override {
        box2d3::b2Body_SetLinearVelocity(bodies_[body], scenes::v3::toBox2d(velocity));
    }

    double impulse(std::size_t a, std::size_t b) const override {
        double sum = 0;
        forEachContact(bodies_[a], [&](const box2d3::b2ContactData& contact, bool isFirst) {
            const box2d3::b2BodyId other =
                box2d3::b2Shape_GetBody(isFirst ? contact.shapeIdB : contact.shapeIdA);
            sum += other.index1 == bodies_[b].index1 ? impulseOf(contact.manifold) : 0;
        });
        return sum;
    }

    double readContacts() const override {
        double sum = 0;
        for (const box2d3::b2BodyId body : bodies_) { // each pair once: at its first body
            if (body.index1 != 0) {
                forEachContact(body, [&](const box2d3::b2ContactData& contact, bool isFirst) {
                    sum += isFirst ? impulseOf(contact.manifold) : 0;
                });
            }
        }
        return sum;
    }

    double readEvents() const override {
        const box2d3::b2ContactEvents events = box2d3::b2World_GetContactEvents(world_);
        double sum = events.beginCount + events.endCount;
        for (int i = 0; i < events.hitCount; ++i) {
            sum += static_cast<double>(events.hitEvents[i].approachSpeed);
        }
        return sum;
    }

    double rayCast(scenes::Vec2 from, scenes::Vec2 to) const override {
        const box2d3::b2QueryFilter all{~std::uint64_t{0}, ~std::uint64_t{0}};
        const box2d3::b2RayResult hit = box2d3::b2World_CastRayClosest(
            world_, scenes::v3::toBox2d(from), scenes::v3::toBox2d(to - from), all);
        return hit.hit ? static_cast<double>(hit.fraction) : 1;
    }

    std::size_t bodyCount() const override {
        return static_cast<std::size_t>(box2d3::b2World_GetCounters(world_).bodyCount);
    }

    double mass() const override {
        double sum = 0;
        for (const box2d3::b2BodyId body : bodies_) { // 0 for static and kinematic bodies
            sum += body.index1 == 0 ? 0 : static_cast<double>(box2d3::b2Body_GetMass(body));
        }
        return sum;
    }

    std::uint64_t stateHash() const override {
        kodo::StateHash hash;
        for (const box2d3::b2BodyId body : bodies_) {
            if (body.index1 == 0) {
                continue;
            }
            const box2d3::b2WorldTransform frame = box2d3::b2Body_GetTransform(body);
            const box2d3::b2Vec2 velocity = box2d3::b2Body_GetLinearVelocity(body);
            for (const float value : {frame.p.x, frame.p.y, frame.q.c, frame.q.s, velocity.x,
                                      velocity.y, box2d3::b2Body_GetAngularVelocity(body)}) {
                hash.add(value);
            }
        }
        return hash.value();
    }

    SnapshotWork snapshotWork() const override {
        return {[this] { return snapshot().size(); }, {}};
    }

private:
    std::vector<std::uint8_t> snapshot() const {
        const int size = box2d3::b2World_Snapshot(world_, nullptr, 0);
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
        box2d3::b2World_Snapshot(world_, bytes.data(), size);
        return bytes;
    }

    static scenes::Vec2 wide(box2d3::b2Vec2 v) {
        return {static_cast<double>(v.x), static_cast<double>(v.y)};
    }

    /// N s, over all substeps.
    static double impulseOf(const box2d3::b2Manifold& manifold) {
        double sum = 0;
        for (int i = 0; i < manifold.pointCount; ++i) {
            sum += static_cast<double>(manifold.points[i].totalNormalImpulse);
        }
        return sum;
    }

    /// Calls visit(contact, whether the body is the first of the pair) for the touching pairs of a
    /// body.
    template <typename Visit>
    void forEachContact(box2d3::b2BodyId body, Visit visit) const {
        const int capacity = box2d3::b2Body_GetContactCapacity(body);
        contacts_.resize(static_cast<std::size_t>(capacity));
        const int count = box2d3::b2Body_GetContactData(body, contacts_.data(), capacity);
        for (int i = 0; i < count; ++i) {
            const box2d3::b2ContactData& contact = contacts_[static_cast<std::size_t>(i)];
            visit(contact, box2d3::b2Shape_GetBody(contact.shapeIdA).index1 == body.index1);
        }
    }

    static void refuse(const StepOptions& options) {
        if (options.profile || options.passes || options.positionPasses ||
            !options.leaveOut.empty() || options.continuous != "all" || options.threads != 1) {
            throw WrongUse(
                "Box2D 3 takes substeps, contactHertz, jointHertz and bullets, and nothing else");
        }
        if (box2d3::b2IsDoublePrecision()) { // positions have another type
            throw WrongUse("Box2D 3 must be built without BOX2D_DOUBLE_PRECISION");
        }
    }

    int substeps_;
    bool events_;
    Numbers numbers_;
    box2d3::b2WorldId world_{};
    std::vector<box2d3::b2BodyId> bodies_;                // index1 is 0: removed
    mutable std::vector<box2d3::b2ContactData> contacts_; // scratch
};

} // namespace

bool hasBox2d3() {
    return true;
}

std::unique_ptr<Engine> makeBox2d3(const scenes::SceneDef& scene, const StepOptions& options) {
    return std::make_unique<Box2d3Engine>(scene, options);
}

} // namespace bench
