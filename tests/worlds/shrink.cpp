// SPDX-License-Identifier: MIT
#include <worlds/recipe.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace worlds {

using namespace kodo;

namespace {

/// The recipe without one body, and without what names it.
Recipe withoutBody(const Recipe& recipe, std::size_t body) {
    Recipe smaller = recipe;
    smaller.bodies.erase(smaller.bodies.begin() + static_cast<std::ptrdiff_t>(body));
    smaller.joints.clear();
    const auto after = [&](std::uint32_t index) { return index > body ? index - 1 : index; };
    for (JointDef joint : recipe.joints) {
        if (firstBody(joint).index == body || secondBody(joint).index == body) {
            continue;
        }
        std::visit(
            [&](auto& own) {
                if constexpr (requires { own.ends; }) {
                    own.ends.a.index = after(own.ends.a.index);
                    own.ends.b.index = after(own.ends.b.index);
                } else {
                    own.body.index = after(own.body.index);
                }
            },
            joint);
        smaller.joints.push_back(joint);
    }
    smaller.events.clear();
    for (Event event : recipe.events) {
        const bool welds = event.kind == Event::Kind::Weld;
        if (event.body != body && !(welds && event.other == body)) {
            event.body -= event.body > body ? 1 : 0;
            event.other -= event.other > body ? 1 : 0;
            event.other = welds ? event.other : 0;
            smaller.events.push_back(event);
        }
    }
    return smaller;
}

/// A body with a motion lock and that velocity is driven, and puts energy in. A particle has no
/// moment of inertia: its spin is locked.
bool movesLocked(const BodyDef& def) {
    return ((def.flags & kLockMove) != 0 && def.velocity != Vec2{}) ||
           (((def.flags & kLockRotate) != 0 || std::holds_alternative<Point>(def.shape)) &&
            def.angularVelocity != 0);
}

Real rounded(Real value, double grid) {
    return static_cast<Real>(std::round(static_cast<double>(value) / grid) * grid);
}

/// Simplifications of one body, each by itself.
using BodyChange = std::function<void(BodyDef&)>;
const std::vector<BodyChange>& bodyChanges() {
    static const std::vector<BodyChange> changes = {
        [](BodyDef& def) { def.shape = Circle{Real(0.5)}; },
        [](BodyDef& def) {
            def.shape = Box{1, 1};
        },
        [](BodyDef& def) {
            const auto* compound = std::get_if<Compound>(&def.shape);
            if (compound != nullptr && compound->parts.size() > 1) {
                Compound fewer = *compound;
                fewer.parts.pop_back();
                def.shape = fewer;
            }
        },
        [](BodyDef& def) {
            const auto* compound = std::get_if<Compound>(&def.shape);
            if (compound != nullptr && compound->parts.size() > 1) {
                Compound fewer = *compound;
                fewer.parts.erase(fewer.parts.begin());
                def.shape = fewer;
            }
        },
        [](BodyDef& def) {
            const auto* compound = std::get_if<Compound>(&def.shape);
            if (compound != nullptr && compound->parts.size() == 1) {
                def.shape = shapeOf(compound->parts[0]);
            }
        },
        [](BodyDef& def) { def.rotation = {}; },
        [](BodyDef& def) { def.velocity = {}; },
        [](BodyDef& def) { def.angularVelocity = 0; },
        [](BodyDef& def) { def.flags = 0; },
        [](BodyDef& def) { def.density = 1; },
        [](BodyDef& def) { def.material = withFriction(0); },
        [](BodyDef& def) { def.material = Material{}; },
        [](BodyDef& def) { def.material.rollingResistance = 0; },
        [](BodyDef& def) { def.material.restitution = rounded(def.material.restitution, 1); },
        [](BodyDef& def) {
            def.type = BodyType::Static, def.velocity = {}, def.angularVelocity = 0;
        },
        [](BodyDef& def) {
            def.position = {rounded(def.position.x, 0.25), rounded(def.position.y, 0.25)};
        },
        [](BodyDef& def) {
            def.velocity = {rounded(def.velocity.x, 0.5), rounded(def.velocity.y, 0.5)};
        },
    };
    return changes;
}

using RecipeChange = std::function<void(Recipe&)>;
const std::vector<RecipeChange>& recipeChanges() {
    static const std::vector<RecipeChange> changes = {
        [](Recipe& recipe) { recipe.tiles = std::max(1, recipe.tiles / 2); },
        [](Recipe& recipe) { recipe.twin = Twin::None; },
        [](Recipe& recipe) { recipe.drag = 0; },
        [](Recipe& recipe) { recipe.world.gravity = {}; },
        [](Recipe& recipe) {
            if (recipe.world.gravity != Vec2{}) {
                recipe.world.gravity = {0, -10};
            }
        },
        [](Recipe& recipe) { recipe.world.settings = {}; },
        [](Recipe& recipe) { recipe.world.settings.leaveOut = {}; },
        [](Recipe& recipe) { recipe.dt = Real(1) / 60; },
        [](Recipe& recipe) { recipe.twinStep = 0; },
    };
    return changes;
}

class Shrinker {
public:
    Shrinker(const Recipe& recipe, std::string name, const Judge& judge, int tries)
        : best_(recipe), name_(std::move(name)), judge_(judge), tries_(tries) {}

    Recipe shrink() {
        while (changeOnce() && tries_ > 0) {
        }
        return best_;
    }

private:
    /// Tries each change once, and keeps those that still fail.
    bool changeOnce() {
        bool any = false;
        for (std::size_t i = best_.bodies.size(); i-- > 0;) {
            any = attempt(withoutBody(best_, i)) || any;
        }
        for (std::size_t i = best_.joints.size(); i-- > 0;) {
            Recipe smaller = best_;
            smaller.joints.erase(smaller.joints.begin() + static_cast<std::ptrdiff_t>(i));
            any = attempt(smaller) || any;
        }
        for (std::size_t i = best_.events.size(); i-- > 0;) {
            Recipe smaller = best_;
            smaller.events.erase(smaller.events.begin() + static_cast<std::ptrdiff_t>(i));
            any = attempt(smaller) || any;
        }
        for (const RecipeChange& change : recipeChanges()) {
            Recipe simpler = best_;
            change(simpler);
            any = attempt(simpler) || any;
        }
        for (std::size_t i = 0; i < best_.bodies.size(); ++i) {
            for (const BodyChange& change : bodyChanges()) {
                Recipe simpler = best_;
                change(simpler.bodies[i]);
                any = attempt(simpler) || any;
            }
        }
        return any;
    }

    /// Takes the recipe if it differs and the same judge objects. Steps after that are dropped.
    bool attempt(Recipe recipe) {
        closeJoints(recipe);
        if (tries_ <= 0 || toText(recipe) == toText(best_)) {
            return false;
        }
        --tries_;
        const bool fixed = std::any_of(recipe.bodies.begin(), recipe.bodies.end(), movesLocked);
        const std::optional<Finding> finding = fixed ? std::nullopt : judge_(recipe);
        if (!finding || finding->judge != name_) {
            return false;
        }
        if (name_ != "sleep" && name_ != "rest") {
            recipe.steps = std::min(recipe.steps, finding->step + 1);
        }
        best_ = std::move(recipe);
        return true;
    }

    Recipe best_;
    std::string name_;
    const Judge& judge_;
    int tries_;
};

} // namespace

Recipe shrink(const Recipe& recipe, const Finding& finding, const Judge& judge, int tries) {
    return Shrinker(recipe, finding.judge, judge, tries).shrink();
}

} // namespace worlds
