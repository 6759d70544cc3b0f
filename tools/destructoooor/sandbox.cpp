// SPDX-License-Identifier: MIT
#include "sandbox.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace destructoooor {

namespace {

constexpr Real kGone = 80;                // m outside of what was there; bodies are removed
constexpr std::size_t kMostBodies = 3000; // nothing is dropped beyond it
constexpr Real kPull = 3000;              // N per kg of the body that the mouse holds

bool isDynamic(const kodo::BodyView& body) {
    return body.type() == kodo::BodyType::Dynamic;
}

/// Where bodies are kept (m): around all that a World has.
kodo::Aabb keptOf(const kodo::World& world) {
    std::optional<kodo::Aabb> all;
    for (const BodyId id : world.bodies()) {
        const kodo::Aabb own = world[id].bounds();
        all = all ? kodo::unite(*all, own) : own;
    }
    return all.value_or(kodo::Aabb{}).grown(kGone);
}

} // namespace

Sandbox::Sandbox() {
    open(0);
}

void Sandbox::open(std::size_t scene) {
    place_.reset();
    begin(scene, catalogue()[scene].settings);
}

void Sandbox::visit(std::size_t tour, std::size_t stop) {
    place_ = {tour, stop};
    const Stop& wanted = *this->stop();
    const std::span<const Scene> all = catalogue();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Scene& scene) { return scene.name == wanted.scene; });
    begin(static_cast<std::size_t>(found - all.begin()), wanted.settings);
    if (wanted.beside) {
        compareWith(*wanted.beside);
    }
}

void Sandbox::restart() {
    if (adopted_) {
        rewind(history_.first());
    } else {
        place_ ? visit(place_->tour, place_->stop) : open(scene_);
    }
}

void Sandbox::begin(std::size_t scene, const kodo::StepSettings& settings) {
    scene_ = scene;
    Staged staged = stage(catalogue()[scene], settings);
    world_ = std::move(staged.world);
    kept_ = keptOf(world_);
    ids_ = std::move(staged.ids);
    act_ = catalogue()[scene].act;
    adopted_ = false;
    fileTitle_.clear();
    twin_.reset();
    held_.reset();
    verdict_.reset();
    untouched_ = true;
    lastTick_ = 0;
    drops_ = 0;
    friction_ = Real(0.6);
    restitution_ = 0;
    noteFields();
    measures_.clear();
    history_.clear();
    history_.record(world_, true);
}

/// The dials show the fields of the World.
void Sandbox::noteFields() {
    gravity_ = 0;
    wind_ = 0;
    waterLevel_ = kNoWater;
    sceneFields_.clear();
    for (const kodo::FieldEntry& entry : world_.fields()) {
        if (entry.field->kind() == kodo::FieldKind::Gravity) {
            gravity_ = -static_cast<const kodo::Gravity&>(*entry.field).acceleration().y;
        } else {
            sceneFields_.push_back(entry);
        }
    }
}

void Sandbox::stepOnce(kodo::World& world) {
    const bool whole =
        std::all_of(ids_.begin(), ids_.end(), [&](BodyId id) { return world.contains(id); });
    if (act_ != nullptr && whole) {
        act_(world, ids_, world.stepCount());
    }
    world.step(kStepSeconds, {.listener = &world == &world_ ? &measures_ : nullptr});
    removeLost(world);
}

void Sandbox::step() {
    if (tick() < lastTick_) {
        history_.forgetAfter(tick());
    }
    history_.record(world_, false);
    stepOnce(world_);
    if (twin_) {
        stepOnce(*twin_);
    }
    lastTick_ = tick();
    measures_.sample(world_, gravity_);
    const auto due = static_cast<std::uint64_t>(std::lround(judgedAfter() / kStepSeconds));
    if (untouched_ && tick() == due) {
        verdict_ = asExpected();
    }
}

bool Sandbox::asExpected() const {
    if (const Stop* const here = stop()) {
        const Real overlap = measures_.last().overlap;
        return here->overlap.lower <= overlap && overlap <= here->overlap.upper;
    }
    return scene().holds(world_, ids_);
}

void Sandbox::rewind(std::uint64_t wanted) {
    const std::uint64_t last = std::max(lastTick_, tick());
    wanted = std::clamp(wanted, history_.first(), last);
    world_ = history_.before(wanted);
    twin_.reset();
    held_.reset();
    while (tick() < wanted) {
        stepOnce(world_);
    }
    lastTick_ = last;
}

void Sandbox::removeLost(kodo::World& world) const {
    for (const BodyId id : world.bodies()) {
        const kodo::BodyView body = std::as_const(world)[id];
        if (isDynamic(body) && !kept_.contains(body.center())) {
            world.remove(id);
        }
    }
}

void Sandbox::touched() {
    untouched_ = false;
    history_.forgetAfter(tick());
    history_.record(world_, true);
    lastTick_ = tick();
}

void Sandbox::change(const std::function<void(kodo::World&)>& work) {
    work(world_);
    if (twin_) {
        work(*twin_);
    }
    touched();
}

void Sandbox::grab(Vec2 point) {
    const std::optional<BodyId> body = bodyAt(world_, point);
    if (!body) {
        return;
    }
    change([&](kodo::World& world) {
        kodo::MouseJoint joint;
        joint.body = *body;
        joint.anchor = kodo::toLocal(std::as_const(world)[*body].transform(), point);
        joint.target = point;
        joint.force = kPull * std::as_const(world)[*body].mass();
        held_ = world.add(joint);
    });
}

void Sandbox::pull(Vec2 point) {
    if (!held_ || !world_.contains(*held_)) {
        return;
    }
    change([&](kodo::World& world) {
        kodo::JointDef def = world.joint(*held_);
        std::get<kodo::MouseJoint>(def).target = point;
        world.setJoint(*held_, def);
    });
}

void Sandbox::letGo() {
    if (held_ && world_.contains(*held_)) {
        change([&](kodo::World& world) { world.remove(*held_); });
    }
    held_.reset();
}

void Sandbox::drop(Thing what, Vec2 place, Real size) {
    if (world_.bodyCount() < kMostBodies) {
        ++drops_;
        change([&](kodo::World& world) {
            destructoooor::drop(world, what, place, size,
                                kodo::withFriction(friction_, restitution_), drops_);
        });
    }
}

void Sandbox::setSettings(const kodo::StepSettings& settings) {
    world_.setSettings(settings);
    touched();
}

void Sandbox::updateFields() {
    std::vector<kodo::FieldEntry> fields{{std::make_shared<kodo::Gravity>(Vec2{0, -gravity_}), {}}};
    fields.insert(fields.end(), sceneFields_.begin(), sceneFields_.end());
    if (wind_ != 0) {
        fields.push_back(
            {std::make_shared<kodo::Wind>(kodo::DragLaw{.linear = 2}, Vec2{wind_, 0}), {}});
    }
    if (waterLevel_ > kNoWater && gravity_ != 0) {
        fields.push_back(
            {std::make_shared<kodo::Buoyancy>(kodo::Buoyancy::Fluid{.density = 2, .drag = 2},
                                              Vec2{0, waterLevel_}, Vec2{0, -gravity_}),
             {}});
    }
    change([&](kodo::World& world) { world.setFields(fields); });
}

void Sandbox::setGravity(Real gravity) {
    gravity_ = gravity;
    updateFields();
}
void Sandbox::setWind(Real wind) {
    wind_ = wind;
    updateFields();
}
void Sandbox::setWaterLevel(Real level) {
    waterLevel_ = level;
    updateFields();
}

void Sandbox::setMaterial(Real friction, Real restitution) {
    friction_ = friction;
    restitution_ = restitution;
    change([&](kodo::World& world) {
        for (const BodyId id : world.bodies()) {
            world[id].setMaterial(kodo::withFriction(friction, restitution));
        }
    });
}

void Sandbox::compareWith(const kodo::StepSettings& settings) {
    kodo::World twin = world_;
    twin.setSettings(settings);
    twin_ = std::move(twin);
}

Real Sandbox::difference() const {
    Real largest = 0;
    if (twin_) {
        for (const BodyId id : world_.bodies()) {
            if (twin_->contains(id)) {
                const Vec2 apart = world_[id].center() - std::as_const(*twin_)[id].center();
                largest = std::max(largest, kodo::length(apart));
            }
        }
    }
    return largest;
}

void Sandbox::take(std::span<const std::byte> bytes) {
    adopt(kodo::fromBytes(bytes));
}

void Sandbox::adopt(kodo::World world) {
    world_ = std::move(world);
    kept_ = keptOf(world_);
    place_.reset();
    act_ = nullptr;
    adopted_ = true;
    fileTitle_.clear();
    twin_.reset();
    held_.reset();
    untouched_ = false;
    verdict_.reset();
    noteFields();
    history_.clear();
    history_.record(world_, true);
    lastTick_ = tick();
}

kodo::Aabb Sandbox::view() const {
    if (!adopted_) {
        return scene().view;
    }
    constexpr Real kFarthest = 60; // m; ground may be endless
    std::optional<kodo::Aabb> all;
    for (const BodyId id : world_.bodies()) {
        const kodo::Aabb own = world_[id].bounds();
        if (isDynamic(world_[id]) || own.extent().x < kFarthest) {
            all = all ? kodo::unite(*all, own) : own;
        }
    }
    const kodo::Aabb found = all.value_or(kodo::Aabb{{-10, -10}, {10, 10}});
    return {found.lower - Vec2{1, 1}, found.upper + Vec2{1, 1}};
}

std::string codeOf(const kodo::StepSettings& settings) {
    char text[512];
    const auto number = [](Real value) { return static_cast<double>(value); };
    if (const auto* const soft = std::get_if<kodo::SoftSettings>(&settings.solver)) {
        std::snprintf(text, sizeof text,
                      "kodo::StepSettings{.solver = kodo::SoftSettings{.substeps = %d, "
                      ".impactPasses = %d, .contactHertz = %g, .contactDamping = %g, .jointHertz = "
                      "%g, .jointDamping = %g, .pushSpeed = %g, .jointGap = %g}, .sleepSteps = %d}",
                      soft->substeps, soft->impactPasses, number(soft->contactHertz),
                      number(soft->contactDamping), number(soft->jointHertz),
                      number(soft->jointDamping), number(soft->pushSpeed), number(soft->jointGap),
                      settings.sleepSteps);
        return text;
    }
    const kodo::PropagationSettings& own = settings.propagation();
    std::snprintf(text, sizeof text,
                  "kodo::StepSettings{.solver = kodo::PropagationSettings{.substeps = %d, "
                  ".impactPasses = %d, .contactPasses = %d, .shockPasses = %d, .jointHertz = %g, "
                  ".jointDamping = %g, .pushSpeed = %g}, .sleepSteps = %d}",
                  own.substeps, own.impactPasses, own.contactPasses, own.shockPasses,
                  number(own.jointHertz), number(own.jointDamping), number(own.pushSpeed),
                  settings.sleepSteps);
    return text;
}

} // namespace destructoooor
