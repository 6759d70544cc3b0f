// SPDX-License-Identifier: MIT
#include <worlds/judges.hpp>

#include <algorithm>

namespace worlds {

using namespace kodo;

namespace {

/// The joint between bodies with these ids.
JointDef withIds(JointDef def, const std::vector<BodyId>& ids, std::size_t first) {
    std::visit(
        [&](auto& joint) {
            if constexpr (requires { joint.ends; }) {
                joint.ends.a = ids.at(first + joint.ends.a.index);
                joint.ends.b = ids.at(first + joint.ends.b.index);
            } else {
                joint.body = ids.at(first + joint.body.index);
            }
        },
        def);
    return def;
}

/// True if two parts overlap. One-sided segments count from their front alone.
bool areOverlapping(const BodyView& a, const BodyView& b) {
    for (std::size_t i = 0; i < a.partCount(); ++i) {
        for (std::size_t k = 0; k < b.partCount(); ++k) {
            const Manifold manifold =
                collide(a.part(i).convex, a.massFrame(), b.part(k).convex, b.massFrame());
            if (manifold.count > 0 && manifold.points[0].separation < 0) {
                return true;
            }
        }
    }
    return false;
}

/// True if a joint excludes the pair from collisions.
bool areExcluded(const World& world, BodyId a, BodyId b) {
    for (const JointId id : world.joints()) {
        const JointDef def = world.joint(id);
        const bool collide = std::visit(
            [](const auto& joint) {
                if constexpr (requires { joint.ends; }) {
                    return joint.ends.collide;
                } else {
                    return true;
                }
            },
            def);
        const BodyId one = firstBody(def);
        const BodyId other = secondBody(def);
        if (!collide && ((one == a && other == b) || (one == b && other == a))) {
            return true;
        }
    }
    return false;
}

bool canCollide(const World& world, BodyId a, BodyId b) {
    const auto filter = [&](BodyId id) {
        return CollisionFilter{world[id].flags(), world[id].required()};
    };
    return shouldCollide(filter(a), filter(b)) && !areExcluded(world, a, b);
}

} // namespace

Scene build(const Recipe& recipe) {
    Scene scene{World(recipe.world), {}};
    if (recipe.drag > 0) {
        scene.world.addField({std::make_shared<Drag>(DragLaw{recipe.drag, 0}), {}});
    }
    for (int tile = 0; tile < recipe.tiles; ++tile) {
        const std::size_t first = scene.ids.size();
        for (BodyDef def : recipe.bodies) {
            def.position.x += kTileWidth * static_cast<Real>(tile);
            scene.ids.push_back(scene.world.add(def));
        }
        for (const JointDef& joint : recipe.joints) {
            const JointDef def = withIds(joint, scene.ids, first);
            std::visit([&](const auto& own) { scene.world.add(own); }, def);
        }
    }
    return scene;
}

bool startsSound(const World& world, Pairs pairs) {
    const std::vector<BodyId> ids = world.bodies();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        for (std::size_t k = i + 1; k < ids.size(); ++k) {
            const BodyView a = world[ids[i]];
            const BodyView b = world[ids[k]];
            const bool dynamic = a.type() == BodyType::Dynamic || b.type() == BodyType::Dynamic;
            const bool counts = pairs == Pairs::All || canCollide(world, ids[i], ids[k]);
            if (dynamic && counts && areOverlapping(a, b)) {
                return false;
            }
        }
    }
    return true;
}

void apply(const Event& event, Scene& scene) {
    if (event.body >= scene.ids.size() || event.other >= scene.ids.size()) {
        return;
    }
    const BodyId body = scene.ids[event.body];
    const BodyId other = scene.ids[event.other];
    if (!scene.world.contains(body)) {
        return;
    }
    switch (event.kind) {
    case Event::Kind::Remove:
        scene.world.remove(body);
        return;
    case Event::Kind::Weld:
        if (scene.world.contains(other) && body != other) {
            scene.world.weld(body, other);
        }
        return;
    case Event::Kind::Drive:
        if (scene.world[body].type() == BodyType::Kinematic) {
            scene.world[body].setVelocity(event.velocity);
            scene.world[body].setAngularVelocity(event.spin);
        }
        return;
    }
}

} // namespace worlds
