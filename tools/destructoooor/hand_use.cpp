// SPDX-License-Identifier: MIT
#include "hand_use.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace destructoooor {

namespace {

constexpr Real kBlastRadius = 5; // m
constexpr Real kBlastSpeed = 14; // m/s, at the centre
constexpr Real kMotorSpeed = 4;  // rad/s
constexpr Real kSpringHertz = 2;
const kodo::DrawColor kTwinColor{255, 120, 120, 200};
const kodo::DrawColor kWaterColor{45, 90, 150, 110};

void drawWater(const kodo::World& world, kodo::DebugDraw& picture) {
    const kodo::Aabb shown = picture.view();
    for (const kodo::FieldEntry& entry : world.fields()) {
        if (entry.field->kind() != kodo::FieldKind::Buoyancy) {
            continue;
        }
        const Real surface =
            std::min(static_cast<const kodo::Buoyancy&>(*entry.field).surface().y, shown.upper.y);
        if (surface > shown.lower.y) {
            const std::array<Vec2, 4> corners = {shown.lower,
                                                 {shown.upper.x, shown.lower.y},
                                                 {shown.upper.x, surface},
                                                 {shown.lower.x, surface}};
            picture.polygon(corners, {.line = kWaterColor, .fill = kWaterColor});
        }
    }
}

} // namespace

std::string use(Sandbox& sandbox, Hand hand, std::span<const Vec2> path, const Dropped& dropped) {
    const Vec2 from = path.front();
    const Vec2 to = path.back();
    const std::optional<BodyId> first = bodyAt(sandbox.world(), from);
    const std::optional<BodyId> second = bodyAt(sandbox.world(), to);
    std::string message;
    const auto changeOrSay = [&](bool possible, const char* otherwise, auto work) {
        if (possible) {
            sandbox.change(work);
        } else {
            message = otherwise;
        }
    };
    switch (hand) {
    case Hand::Drop:
        sandbox.drop(dropped.thing, to, static_cast<Real>(dropped.size));
        break;
    case Hand::Draw:
        sandbox.change([&](kodo::World& world) {
            const auto drawn = destructoooor::draw(world, path.first(path.size() - 1));
            if (const auto* const sentence = std::get_if<std::string>(&drawn)) {
                message = *sentence;
            }
        });
        break;
    case Hand::Cut:
        sandbox.change([&](kodo::World& world) { cut(world, from, to); });
        break;
    case Hand::Shatter:
        changeOrSay(second.has_value(), "There is no body.",
                    [&](kodo::World& world) { shatter(world, *second, to); });
        break;
    case Hand::Weld:
        changeOrSay(first && second && first != second, "Draw from one body to another.",
                    [&](kodo::World& world) { world.weld(*first, *second); });
        break;
    case Hand::Pin:
    case Hand::Motor:
        changeOrSay(second.has_value(), "There is no body.", [&](kodo::World& world) {
            pinAt(world, to, hand == Hand::Motor ? kMotorSpeed : 0);
        });
        break;
    case Hand::Rope:
    case Hand::Spring:
        changeOrSay((first || second) && first != second, "Draw from a body to another place.",
                    [&](kodo::World& world) {
                        tie(world, from, to, hand == Hand::Spring ? kSpringHertz : 0);
                    });
        break;
    case Hand::Explode:
        sandbox.change([&](kodo::World& world) { explode(world, to, kBlastRadius, kBlastSpeed); });
        break;
    case Hand::Drag:
        break;
    }
    return message;
}

void Stroke::press(Sandbox& sandbox, Hand hand, Vec2 at) {
    hand_ = hand;
    path_ = {at};
    if (hand_ == Hand::Drag) {
        sandbox.grab(at);
    }
}

void Stroke::move(Sandbox& sandbox, Vec2 at) {
    if (!isDown()) {
        return;
    }
    if (hand_ == Hand::Drag) {
        sandbox.pull(at);
    } else if (kodo::length(at - path_.back()) > kPathStride) {
        path_.push_back(at);
    }
}

std::string Stroke::release(Sandbox& sandbox, const Dropped& dropped, Vec2 at) {
    if (!isDown() || hand_ == Hand::Drag) {
        abandon(sandbox);
        return {};
    }
    std::vector<Vec2> path = std::exchange(path_, {});
    path.push_back(at);
    return use(sandbox, hand_, path, dropped);
}

void Stroke::abandon(Sandbox& sandbox) {
    path_.clear();
    sandbox.letGo();
}

void drawScene(const Sandbox& sandbox, kodo::DebugDraw& picture, const kodo::DrawOptions& look) {
    drawWater(sandbox.world(), picture);
    kodo::draw(sandbox.world(), picture, look);
    const kodo::World* const twin = sandbox.twin();
    if (twin == nullptr) {
        return;
    }
    for (const BodyId id : twin->bodies()) {
        const kodo::BodyView body = (*twin)[id];
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            if (body.type() == kodo::BodyType::Dynamic) {
                kodo::draw(body.part(i).convex, body.massFrame(), picture, {kTwinColor});
            }
        }
    }
}

} // namespace destructoooor
