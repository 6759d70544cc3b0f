// SPDX-License-Identifier: MIT
// Compiled if KODO_BENCH_BOX2D3 names an installed Box2D 3, else ordinary_no_box2d3.cpp is.
#include <kodo/kodo.hpp>
#include <scenes/in_box2d3.hpp>

#include <worlds/judges.hpp>
#include <worlds/ordinary.hpp>

#include <mutex>
#include <stdexcept>

namespace worlds {
namespace {

using box2d3::b2BodyId;
using box2d3::b2Rot;
using box2d3::b2Transform;
using box2d3::b2Vec2;
using box2d3::b2WorldId;

constexpr int kSubsteps = 4; // the number that the documentation of Box2D recommends

std::mutex worldsMutex; // the list of worlds of Box2D is global

b2Vec2 toBox2d(kodo::Vec2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}
b2Rot toBox2d(kodo::Rot q) {
    return {static_cast<float>(q.c), static_cast<float>(q.s)};
}
float toFloat(kodo::Real value) {
    return static_cast<float>(value);
}

box2d3::b2BodyType typeOf(kodo::BodyType type) {
    switch (type) {
    case kodo::BodyType::Dynamic:
        return box2d3::b2_dynamicBody;
    case kodo::BodyType::Kinematic:
        return box2d3::b2_kinematicBody;
    case kodo::BodyType::Static:
        return box2d3::b2_staticBody;
    }
    return box2d3::b2_staticBody;
}

box2d3::b2ShapeDef shapeDefOf(const kodo::BodyDef& source) {
    box2d3::b2ShapeDef def = box2d3::b2DefaultShapeDef();
    def.density = toFloat(source.density);
    def.material.friction = toFloat(source.material.kineticFriction);
    def.material.restitution = toFloat(source.material.restitution);
    def.filter.categoryBits = source.flags & kodo::kUserFlags;
    if ((source.flags & kodo::kMatchAny) != 0) {
        def.filter.maskBits = source.required;
    }
    def.updateBodyMass = source.type != kodo::BodyType::Dynamic;
    return def;
}

void addPart(b2BodyId body, const box2d3::b2ShapeDef& def, const kodo::Primitive& part) {
    if (const auto* circle = std::get_if<kodo::Circle>(&part)) {
        const box2d3::b2Circle shape{toBox2d(circle->center), toFloat(circle->radius)};
        box2d3::b2CreateCircleShape(body, &def, &shape);
        return;
    }
    const auto* box = std::get_if<kodo::Box>(&part);
    if (box == nullptr) {
        throw std::logic_error("an ordinary scene has a shape that its adapter does not know");
    }
    const box2d3::b2Polygon shape =
        box2d3::b2MakeOffsetBox(toFloat(box->width / 2), toFloat(box->height / 2),
                                toBox2d(box->center), toBox2d(box->rotation));
    box2d3::b2CreatePolygonShape(body, &def, &shape);
}

/// A chain from right to left: its front is on its right, which is up. The end points of an open
/// chain are ghosts, so both are repeated beyond the ends.
void addTerrain(b2BodyId body, const kodo::BodyDef& source, const kodo::Heightmap& map) {
    std::vector<b2Vec2> points;
    const auto add = [&](kodo::Real x, kodo::Real height) {
        points.push_back(toBox2d(map.origin + kodo::Vec2{x * map.spacing, height}));
    };
    const std::size_t count = map.heights.size();
    add(static_cast<kodo::Real>(count), map.heights.back());
    for (std::size_t i = count; i-- > 0;) {
        add(static_cast<kodo::Real>(i), map.heights[i]);
    }
    add(-1, map.heights.front());
    const box2d3::b2ShapeDef shape = shapeDefOf(source);
    box2d3::b2ChainDef def = box2d3::b2DefaultChainDef();
    def.points = points.data();
    def.count = static_cast<int>(points.size());
    def.materials = &shape.material;
    def.materialCount = 1;
    def.filter = shape.filter;
    box2d3::b2CreateChain(body, &def);
}

class Box2d3Engine final : public OrdinaryEngine {
public:
    explicit Box2d3Engine(const Recipe& recipe) : dt_(toFloat(recipe.dt)) {
        const std::lock_guard lock(worldsMutex);
        box2d3::b2SetLogFcn([](const char*) {}); // its warnings go to stdout
        const kodo::Vec2 gravity = recipe.world.gravity;
        const box2d3::b2WorldDef def =
            scenes::v3::worldOf({static_cast<double>(gravity.x), static_cast<double>(gravity.y)});
        world_ = box2d3::b2CreateWorld(&def);
        const Scene scene = build(recipe); // masses
        for (std::size_t i = 0; i < recipe.bodies.size(); ++i) {
            addBody(recipe.bodies[i], scene.world[scene.ids[i]]);
        }
        for (const kodo::JointDef& joint : recipe.joints) {
            std::visit([&](const auto& own) { add(own); }, joint);
        }
    }
    ~Box2d3Engine() override {
        const std::lock_guard lock(worldsMutex);
        box2d3::b2DestroyWorld(world_);
    }

    void step() override { box2d3::b2World_Step(world_, dt_, kSubsteps); }

    Motion motion(std::size_t body) const override {
        const auto frame = box2d3::b2Body_GetTransform(bodies_[body]);
        const b2Vec2 velocity = box2d3::b2Body_GetLinearVelocity(bodies_[body]);
        return {{static_cast<double>(frame.p.x), static_cast<double>(frame.p.y)},
                {static_cast<double>(frame.q.c), static_cast<double>(frame.q.s)},
                {static_cast<double>(velocity.x), static_cast<double>(velocity.y)},
                static_cast<double>(box2d3::b2Body_GetAngularVelocity(bodies_[body]))};
    }

private:
    void addBody(const kodo::BodyDef& source, const kodo::BodyView& view) {
        box2d3::b2BodyDef def = box2d3::b2DefaultBodyDef();
        def.type = typeOf(source.type);
        def.position = toBox2d(source.position);
        def.rotation = toBox2d(source.rotation);
        const b2BodyId body = box2d3::b2CreateBody(world_, &def);
        bodies_.push_back(body);
        if (const auto* map = std::get_if<kodo::Heightmap>(&source.shape)) {
            addTerrain(body, source, *map);
            return;
        }
        const box2d3::b2ShapeDef shape = shapeDefOf(source);
        for (const kodo::Primitive& part : kodo::primitivesOf(source.shape)) {
            addPart(body, shape, part);
        }
        if (source.type == kodo::BodyType::Dynamic) {
            box2d3::b2Body_SetMassData(
                body, {toFloat(view.mass()), toBox2d(view.localCenter()), toFloat(view.inertia())});
        }
        if (source.type != kodo::BodyType::Static) {
            box2d3::b2Body_SetLinearVelocity(body, toBox2d(source.velocity));
            box2d3::b2Body_SetAngularVelocity(body, toFloat(source.angularVelocity));
        }
    }

    /// The frames are parallel if the relative angle is `reference`.
    void setEnds(box2d3::b2JointDef& base, const kodo::JointEnds& ends, kodo::Real reference = 0,
                 kodo::Vec2 axis = {1, 0}) const {
        const kodo::Rot along{axis.x, axis.y};
        base.bodyIdA = bodies_[ends.a.index];
        base.bodyIdB = bodies_[ends.b.index];
        base.localFrameA = {toBox2d(ends.anchorA), toBox2d(along)};
        base.localFrameB = {toBox2d(ends.anchorB),
                            toBox2d(kodo::Rot::fromAngle(reference).inverse() * along)};
        base.collideConnected = ends.collide;
    }

    void add(const kodo::RevoluteJoint& joint) {
        box2d3::b2RevoluteJointDef def = box2d3::b2DefaultRevoluteJointDef();
        setEnds(def.base, joint.ends, joint.reference);
        def.enableMotor = joint.motorTorque > 0;
        def.motorSpeed = toFloat(joint.motorSpeed);
        def.maxMotorTorque = toFloat(joint.motorTorque);
        if (joint.limits) {
            def.enableLimit = true;
            def.lowerAngle = toFloat(joint.limits->lower);
            def.upperAngle = toFloat(joint.limits->upper);
        }
        box2d3::b2CreateRevoluteJoint(world_, &def);
    }
    void add(const kodo::FixedJoint& joint) {
        box2d3::b2WeldJointDef def = box2d3::b2DefaultWeldJointDef();
        setEnds(def.base, joint.ends, joint.reference);
        box2d3::b2CreateWeldJoint(world_, &def);
    }
    void add(const kodo::DistanceJoint& joint) {
        box2d3::b2DistanceJointDef def = box2d3::b2DefaultDistanceJointDef();
        setEnds(def.base, joint.ends);
        def.length = toFloat(joint.hertz > 0 ? joint.length : joint.limits->upper);
        const bool rod = joint.limits && joint.limits->lower == joint.limits->upper;
        def.enableSpring = !rod; // a rope: a spring without stiffness
        def.hertz = toFloat(joint.hertz);
        def.dampingRatio = toFloat(joint.damping);
        if (joint.limits && !rod) {
            def.enableLimit = true;
            def.minLength = toFloat(joint.limits->lower);
            def.maxLength = toFloat(joint.limits->upper);
        }
        box2d3::b2CreateDistanceJoint(world_, &def);
    }
    void add(const kodo::PrismaticJoint& joint) {
        box2d3::b2PrismaticJointDef def = box2d3::b2DefaultPrismaticJointDef();
        setEnds(def.base, joint.ends, joint.reference, joint.axis);
        def.enableMotor = joint.motorForce > 0;
        def.motorSpeed = toFloat(joint.motorSpeed);
        def.maxMotorForce = toFloat(joint.motorForce);
        if (joint.limits) {
            def.enableLimit = true;
            def.lowerTranslation = toFloat(joint.limits->lower);
            def.upperTranslation = toFloat(joint.limits->upper);
        }
        box2d3::b2CreatePrismaticJoint(world_, &def);
    }
    template <typename Other>
    void add(const Other&) {
        throw std::logic_error("an ordinary scene has a joint that its adapter does not know");
    }

    float dt_;
    b2WorldId world_{};
    std::vector<b2BodyId> bodies_;
};

} // namespace

bool hasOrdinaryBox2d3() {
    return true;
}

std::unique_ptr<OrdinaryEngine> ordinaryInBox2d3(const Recipe& recipe) {
    return std::make_unique<Box2d3Engine>(recipe);
}

} // namespace worlds
