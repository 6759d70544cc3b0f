// SPDX-License-Identifier: MIT
// Compiled if KODO_BENCH_BOX2D3 names an installed Box2D 3, else no_box2d3.cpp is.
#include <scenes/in_box2d3.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine.hpp"

namespace crosscheck {
namespace {

using box2d3::b2BodyId;
using box2d3::b2JointId;
using box2d3::b2Transform;
using box2d3::b2Vec2;
using scenes::v3::toBox2d;

constexpr int kSubsteps = 4;       // the number that the documentation of Box2D recommends
constexpr double kTouching = 5e-3; // m, its slop; contacts are made from 20 mm of distance on

float small(double value) {
    return static_cast<float>(value);
}
scenes::Vec2 wide(b2Vec2 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

class Box2d3Engine final : public Engine {
public:
    Box2d3Engine(const scenes::SceneDef& scene, double bounceThreshold) : defs_(scene.bodies) {
        box2d3::b2SetLogFcn([](const char*) {}); // its warnings go to stdout
        box2d3::b2WorldDef def = scenes::v3::worldOf(scene.gravity);
        def.restitutionThreshold = small(bounceThreshold);
        def.enableSleep = scene.sleep;
        world_ = box2d3::b2CreateWorld(&def);
        try {
            for (std::size_t i = 0; i < defs_.size(); ++i) {
                addBody(defs_[i]);
            }
        } catch (...) {
            box2d3::b2DestroyWorld(world_);
            throw;
        }
        for (const scenes::ChainDef& chain : scene.chains) {
            addChain(chain);
        }
    }
    ~Box2d3Engine() override { box2d3::b2DestroyWorld(world_); }

    void step(double dt) override {
        box2d3::b2World_Step(world_, small(dt), kSubsteps);
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            const auto size = [&] { return std::sqrt(dot(jointForce(i), jointForce(i))); };
            if (breakForces_[i] > 0 && !isBroken(i) && size() > breakForces_[i]) {
                box2d3::b2DestroyJoint(joints_[i]);
                joints_[i] = {};
            }
        }
    }

    void join(const Link& link) override {
        using Kind = Link::Kind;
        joints_.push_back(link.kind == Kind::FixedJoint       ? fixed(link)
                          : link.kind == Kind::RevoluteJoint  ? revolute(link)
                          : link.kind == Kind::PrismaticJoint ? prismatic(link)
                          : link.kind == Kind::MouseJoint     ? mouse(link)
                                                              : distance(link));
        breakForces_.push_back(link.breakForce);
    }

    void split(std::size_t index, std::size_t part) override {
        const b2BodyId old = bodies_[index];
        scenes::BodyDef piece = defs_[index];
        piece.parts = {piece.parts[part]};
        const b2Transform frame = box2d3::b2Body_GetTransform(old);
        piece.position = wide(frame.p);
        piece.rotation = {static_cast<double>(frame.q.c), static_cast<double>(frame.q.s)};
        defs_[index].parts.erase(defs_[index].parts.begin() + static_cast<std::ptrdiff_t>(part));
        const Mass rest = massOf(defs_[index]);
        const auto velocityAt = [&](scenes::Vec2 center) {
            return wide(box2d3::b2Body_GetLocalPointVelocity(old, toBox2d(center)));
        };
        piece.velocity = velocityAt(massOf(piece).center);
        piece.spin = static_cast<double>(box2d3::b2Body_GetAngularVelocity(old));
        const scenes::Vec2 velocity = velocityAt(rest.center);
        removePart(old, part);
        box2d3::b2Body_SetMassData(old,
                                   {small(rest.mass), toBox2d(rest.center), small(rest.inertia)});
        box2d3::b2Body_SetLinearVelocity(old, toBox2d(velocity));
        addBody(piece);
        defs_.push_back(std::move(piece));
    }

    State state(std::size_t index) const override {
        const b2BodyId body = bodies_[index];
        const bool dynamic = box2d3::b2Body_GetType(body) == box2d3::b2_dynamicBody;
        // Without mass, Box2D takes the origin of the frame for the centre.
        const b2Vec2 center =
            dynamic ? box2d3::b2Body_GetWorldCenter(body)
                    : box2d3::b2Body_GetWorldPoint(body, toBox2d(massOf(defs_[index]).center));
        const box2d3::b2Rot turn = box2d3::b2Body_GetRotation(body);
        return {wide(center), std::atan2(static_cast<double>(turn.s), static_cast<double>(turn.c)),
                wide(box2d3::b2Body_GetLinearVelocity(body)),
                static_cast<double>(box2d3::b2Body_GetAngularVelocity(body))};
    }

    std::vector<Touch> touches() const override {
        std::vector<Touch> result;
        std::vector<box2d3::b2ContactData> contacts;
        for (const b2BodyId body : bodies_) { // each pair once: at its first body
            contacts.resize(static_cast<std::size_t>(box2d3::b2Body_GetContactCapacity(body)));
            const int count = box2d3::b2Body_GetContactData(body, contacts.data(),
                                                            static_cast<int>(contacts.size()));
            for (int i = 0; i < count; ++i) {
                const box2d3::b2ContactData& one = contacts[static_cast<std::size_t>(i)];
                if (box2d3::b2Shape_GetBody(one.shapeIdA).index1 == body.index1 &&
                    isTouching(one.manifold)) {
                    result.push_back(touch(one.shapeIdA, one.shapeIdB, impulseOf(one.manifold)));
                }
            }
        }
        for (const box2d3::b2ShapeId sensor : sensors_) {
            addVisitors(sensor, result);
        }
        return result;
    }

    scenes::Vec2 jointForce(std::size_t joint) const override {
        return wide(box2d3::b2Joint_GetConstraintForce(joints_[joint])); // of the last substep
    }

    bool isBroken(std::size_t joint) const override { return joints_[joint].index1 == 0; }

    bool isAsleep(std::size_t body) const override {
        return !box2d3::b2Body_IsAwake(bodies_[body]);
    }

    std::optional<RayFound> rayCast(scenes::Vec2 from, scenes::Vec2 to) const override {
        const box2d3::b2RayResult hit = box2d3::b2World_CastRayClosest(
            world_, toBox2d(from), toBox2d(to - from), box2d3::b2DefaultQueryFilter());
        return hit.hit ? std::optional(
                             RayFound{indexOf(hit.shapeId), static_cast<double>(hit.fraction)})
                       : std::nullopt;
    }

    std::optional<RayFound> shapeCast(const scenes::Part& shape, scenes::Vec2 from,
                                      scenes::Vec2 to) const override {
        const auto closest = [](box2d3::b2ShapeId hit, b2Vec2, b2Vec2, float fraction,
                                void* found) {
            *static_cast<std::optional<RayFound>*>(found) =
                RayFound{indexOf(hit), static_cast<double>(fraction)};
            return fraction;
        };
        std::optional<RayFound> found;
        const box2d3::b2ShapeProxy proxy = proxyOf(shape);
        box2d3::b2World_CastShape(world_, toBox2d(from), &proxy, toBox2d(to - from),
                                  box2d3::b2DefaultQueryFilter(), closest, &found);
        return found;
    }

    std::vector<std::size_t> overlap(scenes::Vec2 low, scenes::Vec2 high) const override {
        const auto add = [](box2d3::b2ShapeId shape, void* found) {
            static_cast<std::vector<std::size_t>*>(found)->push_back(indexOf(shape));
            return true;
        };
        std::vector<std::size_t> found;
        const scenes::Vec2 size = high - low;
        const box2d3::b2ShapeProxy box = proxyOf(scenes::Box{size.x, size.y});
        box2d3::b2World_OverlapShape(world_, toBox2d(0.5 * (low + high)), &box,
                                     box2d3::b2DefaultQueryFilter(), add, &found);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

private:
    void addBody(const scenes::BodyDef& def) {
        bodies_.push_back(scenes::v3::addToBox2d(world_, def, true));
        const b2BodyId body = bodies_.back();
        box2d3::b2Body_SetUserData(body, reinterpret_cast<void*>(bodies_.size()));
        for (const box2d3::b2ShapeId shape : shapesOf(body)) {
            if (box2d3::b2Shape_IsSensor(shape)) {
                sensors_.push_back(shape);
            }
        }
    }

    static std::vector<box2d3::b2ShapeId> shapesOf(b2BodyId body) {
        std::vector<box2d3::b2ShapeId> shapes(
            static_cast<std::size_t>(box2d3::b2Body_GetShapeCount(body)));
        box2d3::b2Body_GetShapes(body, shapes.data(), static_cast<int>(shapes.size()));
        return shapes;
    }

    /// Parts keep the order of their definition: what follows the part moves up.
    static void removePart(b2BodyId body, std::size_t part) {
        for (const box2d3::b2ShapeId shape : shapesOf(body)) {
            const std::size_t own = partOf(shape);
            if (own == part) {
                box2d3::b2DestroyShape(shape, false);
            } else if (own > part) {
                box2d3::b2Shape_SetUserData(shape, reinterpret_cast<void*>(own - 1));
            }
        }
    }

    /// From right to left: its front is on its right, which is up. The end points of an open chain
    /// are ghosts.
    void addChain(const scenes::ChainDef& chain) {
        std::vector<b2Vec2> points;
        const std::vector<scenes::Vec2>& line = chain.points;
        const std::size_t last = line.size() - 1;
        points.push_back(toBox2d(line[last] + (line[last] - line[last - 1])));
        for (auto point = line.rbegin(); point != line.rend(); ++point) {
            points.push_back(toBox2d(*point));
        }
        points.push_back(toBox2d(line[0] + (line[0] - line[1])));
        scenes::BodyDef surface;
        surface.material = chain.material;
        const box2d3::b2ShapeDef shape = scenes::v3::shapeDefOf(surface, true);
        box2d3::b2ChainDef def = box2d3::b2DefaultChainDef();
        def.points = points.data();
        def.count = static_cast<int>(points.size());
        def.materials = &shape.material;
        def.materialCount = 1;
        const box2d3::b2BodyDef body = box2d3::b2DefaultBodyDef(); // no body of the scene
        box2d3::b2CreateChain(box2d3::b2CreateBody(world_, &body), &def);
    }

    static box2d3::b2ShapeProxy proxyOf(const scenes::Part& part) {
        if (const auto* circle = std::get_if<scenes::Circle>(&part)) {
            const b2Vec2 center = toBox2d(circle->center);
            return box2d3::b2MakeProxy(&center, 1, small(circle->radius));
        }
        std::vector<b2Vec2> corners;
        for (const scenes::Vec2 corner : cornersOf(std::get<scenes::Box>(part))) {
            corners.push_back(toBox2d(corner));
        }
        return box2d3::b2MakeProxy(corners.data(), static_cast<int>(corners.size()), 0);
    }

    /// The frames of a joint at two world points, both turned to `axis`. Their angle is 0 where
    /// that of b relative to a is the reference.
    void setEnds(box2d3::b2JointDef& base, const Link& link, scenes::Vec2 pointB,
                 scenes::Vec2 axis = {1, 0}) const {
        const b2Transform a = box2d3::b2Body_GetTransform(bodies_[link.a]);
        const b2Transform b = box2d3::b2Body_GetTransform(bodies_[link.b]);
        base.bodyIdA = bodies_[link.a];
        base.bodyIdB = bodies_[link.b];
        const b2Vec2 along = box2d3::b2InvRotateVector(a.q, toBox2d(axis));
        const box2d3::b2Rot frame{along.x, along.y};
        const box2d3::b2Rot apart = link.reference ? box2d3::b2MakeRot(small(*link.reference))
                                                   : box2d3::b2InvMulRot(a.q, b.q);
        base.localFrameA = {box2d3::b2Body_GetLocalPoint(bodies_[link.a], toBox2d(link.point)),
                            frame};
        base.localFrameB = {box2d3::b2Body_GetLocalPoint(bodies_[link.b], toBox2d(pointB)),
                            box2d3::b2InvMulRot(apart, frame)};
    }

    b2JointId fixed(const Link& link) {
        box2d3::b2WeldJointDef def = box2d3::b2DefaultWeldJointDef();
        setEnds(def.base, link, link.point);
        return box2d3::b2CreateWeldJoint(world_, &def);
    }

    b2JointId revolute(const Link& link) {
        box2d3::b2RevoluteJointDef def = box2d3::b2DefaultRevoluteJointDef();
        setEnds(def.base, link, link.point);
        def.enableMotor = link.motorTorque > 0;
        def.motorSpeed = small(link.motorSpeed);
        def.maxMotorTorque = small(link.motorTorque);
        def.enableLimit = link.limits.has_value();
        def.lowerAngle = small(link.limits.value_or(Limits{}).lower);
        def.upperAngle = small(link.limits.value_or(Limits{}).upper);
        return box2d3::b2CreateRevoluteJoint(world_, &def);
    }

    b2JointId prismatic(const Link& link) {
        box2d3::b2PrismaticJointDef def = box2d3::b2DefaultPrismaticJointDef();
        setEnds(def.base, link, link.point, link.axis);
        def.enableMotor = link.motorTorque > 0;
        def.motorSpeed = small(link.motorSpeed);
        def.maxMotorForce = small(link.motorTorque);
        def.enableLimit = link.limits.has_value();
        def.lowerTranslation = small(link.limits.value_or(Limits{}).lower);
        def.upperTranslation = small(link.limits.value_or(Limits{}).upper);
        return box2d3::b2CreatePrismaticJoint(world_, &def);
    }

    /// A spring from body a, at the target, to the anchor of b.
    b2JointId mouse(const Link& link) {
        box2d3::b2MotorJointDef def = box2d3::b2DefaultMotorJointDef();
        Link moved = link;
        moved.point = link.pointB;
        setEnds(def.base, moved, link.point);
        def.base.collideConnected = true;
        def.linearHertz = small(link.hertz);
        def.linearDampingRatio = small(link.damping);
        def.maxSpringForce = small(link.motorTorque);
        return box2d3::b2CreateMotorJoint(world_, &def);
    }

    b2JointId distance(const Link& link) {
        box2d3::b2DistanceJointDef def = box2d3::b2DefaultDistanceJointDef();
        setEnds(def.base, link, link.pointB);
        const scenes::Vec2 way = link.pointB - link.point;
        def.length = small(link.length.value_or(std::sqrt(dot(way, way))));
        const bool rope = link.kind == Link::Kind::RopeJoint;
        def.enableSpring = rope || link.hertz > 0; // a rope: a spring without stiffness
        def.hertz = rope ? 0 : small(link.hertz);
        def.dampingRatio = rope ? 0 : small(link.damping);
        def.enableLimit = rope;
        def.minLength = 0;
        def.maxLength = def.enableLimit ? def.length : def.maxLength;
        return box2d3::b2CreateDistanceJoint(world_, &def);
    }

    /// User data is 1 more than the index; chains have none, which gives the largest number.
    static std::size_t indexOf(box2d3::b2ShapeId shape) {
        return reinterpret_cast<std::size_t>(
                   box2d3::b2Body_GetUserData(box2d3::b2Shape_GetBody(shape))) -
               1;
    }
    static std::size_t partOf(box2d3::b2ShapeId shape) {
        return reinterpret_cast<std::size_t>(box2d3::b2Shape_GetUserData(shape));
    }

    static bool isTouching(const box2d3::b2Manifold& manifold) {
        return std::any_of(manifold.points, manifold.points + manifold.pointCount,
                           [](const box2d3::b2ManifoldPoint& point) {
                               return point.totalNormalImpulse > 0 ||
                                      static_cast<double>(point.separation) <= kTouching;
                           });
    }

    /// N s, over all substeps.
    static double impulseOf(const box2d3::b2Manifold& manifold) {
        double sum = 0;
        for (int i = 0; i < manifold.pointCount; ++i) {
            sum += static_cast<double>(manifold.points[i].totalNormalImpulse);
        }
        return sum;
    }

    static Touch touch(box2d3::b2ShapeId a, box2d3::b2ShapeId b, double impulse) {
        Touch one{indexOf(a), partOf(a), indexOf(b), partOf(b), impulse};
        if (one.a > one.b) {
            std::swap(one.a, one.b);
            std::swap(one.partA, one.partB);
        }
        return one;
    }

    static void addVisitors(box2d3::b2ShapeId sensor, std::vector<Touch>& result) {
        std::vector<box2d3::b2ShapeId> visitors(
            static_cast<std::size_t>(box2d3::b2Shape_GetSensorCapacity(sensor)));
        const int count = box2d3::b2Shape_GetSensorData(sensor, visitors.data(),
                                                        static_cast<int>(visitors.size()));
        for (int i = 0; i < count; ++i) {
            result.push_back(touch(sensor, visitors[static_cast<std::size_t>(i)], 0));
        }
    }

    std::vector<scenes::BodyDef> defs_;
    box2d3::b2WorldId world_{};
    std::vector<b2BodyId> bodies_;
    std::vector<box2d3::b2ShapeId> sensors_;
    std::vector<b2JointId> joints_;   // index 0: broken
    std::vector<double> breakForces_; // N; 0: none
};

} // namespace

bool hasBox2d3() {
    return true;
}

std::unique_ptr<Engine> makeBox2d3(const scenes::SceneDef& scene, double bounceThreshold) {
    return std::make_unique<Box2d3Engine>(scene, bounceThreshold);
}

} // namespace crosscheck
