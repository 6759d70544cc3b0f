// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include <worlds/invariance.hpp>
#include <worlds/judges.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace worlds {

using namespace kodo;

namespace {

constexpr int kStruckSteps = 60;
constexpr double kRoom = 0.01;       // m or rad
constexpr double kSpeedShare = 0.05; // of the largest speed so far, plus 1 m/s
constexpr int kLate = 3;             // steps by which an impact may be late
constexpr double kNoise = 1e-4;      // m and m/s, of worlds that begin slightly differently
constexpr int kNoisyWorlds = 3;
constexpr double kSubnormal = 1e-30; // of floats: below, they are on a fixed grid
constexpr double kTells = 10;        // times what these differ by

bool isStruck(std::uint64_t seed) {
    return seed % 2 == 0;
}

/// A kinematic body that moves, turns or both, and one or two bodies in its way.
Recipe struckRecipe(std::uint64_t seed) {
    support::RandomNumbers random(seed + 31000);
    Recipe recipe;
    constexpr int kRates[] = {30, 60, 60, 120, 240};
    recipe.dt = 1 / static_cast<Real>(kRates[random.below(std::size(kRates))]);
    recipe.steps = kStruckSteps;
    const Material material = withFriction(random.below(2) == 0 ? 0 : random.between(0, 1),
                                           static_cast<Real>(random.below(3)) / 2);
    const auto shape = [&](double size) -> Shape {
        const Real s = static_cast<Real>(size) * random.between(0.5, 1.0);
        const Shape shapes[] = {Circle{s}, Box{2 * s, s}, Box{3 * s, s / 4},
                                Capsule{{-s, 0}, {s, 0}, s / 4}};
        return shapes[random.below(std::size(shapes))];
    };
    BodyDef mover{.shape = shape(1), .rotation = random.rotation(), .material = material};
    mover.type = BodyType::Kinematic;
    const bool turns = random.below(2) == 0;
    mover.angularVelocity = turns ? random.between(0.1, 2) / recipe.dt / 4 : Real(0);
    mover.velocity = {turns && random.below(2) == 0 ? Real(0) : random.between(1, 40), 0};
    recipe.bodies.push_back(mover);
    for (std::size_t i = 0; i <= random.below(2); ++i) {
        const Real far = mover.velocity.x == 0 ? random.between(0.3, 1.5) : random.between(1.5, 3);
        BodyDef def{.shape = shape(0.4), .material = material};
        def.position = {static_cast<Real>(i) * 2 + far, random.between(-1.2, 1.2)};
        def.velocity = mover.velocity.x == 0 ? Vec2{random.between(-6, 0), 0} : Vec2{};
        if (mover.velocity.x == 0) {
            def.position.x += Real(1.5);
        }
        def.rotation = random.rotation();
        recipe.bodies.push_back(def);
    }
    return recipe;
}

/// The same world, with bodies that begin slightly elsewhere.
Recipe noisy(const Recipe& recipe, int number) {
    support::RandomNumbers random(static_cast<std::uint64_t>(number) + 99);
    Recipe result = recipe;
    for (BodyDef& def : result.bodies) {
        const bool moves = (def.flags & kLockMove) == 0;
        if (def.type == BodyType::Dynamic && moves) {
            def.position += random.point(kNoise);
            def.velocity += random.point(kNoise);
        }
    }
    return result;
}

struct Difference {
    double size = 0; // m, m/s, 1 or rad/s
    std::size_t body = 0;
    const char* quantity = "";
};

/// The largest difference of numbers of bodies, and what it is of.
template <typename Quantities>
Difference largest(std::size_t bodies, Quantities quantities) {
    Difference worst;
    for (std::size_t i = 0; i < bodies; ++i) {
        for (const auto& [name, size] : quantities(i)) {
            if (size > worst.size) {
                worst = {size, i, name};
            }
        }
    }
    return worst;
}
struct Quantity {
    const char* name;
    double size;
};

double turnOf(const Motion& a, const Motion& b) {
    return std::abs((a.rotation * b.rotation.inverse()).angle());
}

/// Runs two worlds, and compares them after each step.
class Comparison {
public:
    Comparison(const Recipe& recipe, const Changed& changed)
        : recipe_(recipe),
          changed_(changed),
          exact_(isExact(changed.invariance)),
          dt_(static_cast<double>(recipe.dt)),
          one_(ordinaryInKodo(recipe)),
          other_(ordinaryInKodo(changed.recipe)),
          lasting_(recipe.bodies.size()) {
        for (int i = 0; i < (exact_ ? 0 : kNoisyWorlds); ++i) {
            noisy_.push_back(ordinaryInKodo(noisy(recipe, i)));
        }
    }

    std::optional<Finding> run() {
        for (int step = 0; step < recipe_.steps; ++step) {
            one_->step();
            other_->step();
            const double time = dt_ * (step + 1);
            const auto other = [&](std::size_t i) { return changed_.original(*other_, i, time); };
            const Difference found = exact_ ? bits(other) : outcome(other);
            if (found.size > 0) {
                std::ostringstream text;
                text << found.quantity << " of body " << found.body << " differs by " << found.size;
                return Finding{nameOf(changed_.invariance), step, text.str()};
            }
            if (noise_ > kRoom) {
                return std::nullopt; // small differences grow: nothing can be told from here on
            }
        }
        return std::nullopt;
    }

private:
    /// Each number has the same bits, except what is next to nothing: that is rounded to a fixed
    /// grid.
    template <typename Other>
    Difference bits(Other other) const {
        const Difference found = largest(recipe_.bodies.size(), [&](std::size_t i) {
            const Motion a = one_->motion(i);
            const Motion b = other(i);
            return std::array{Quantity{"position", length(a.position - b.position)},
                              Quantity{"rotation", std::abs(a.rotation.c - b.rotation.c) +
                                                       std::abs(a.rotation.s - b.rotation.s)},
                              Quantity{"velocity", length(a.velocity - b.velocity)},
                              Quantity{"spin", std::abs(a.spin - b.spin)}};
        });
        return found.size > kSubnormal ? found : Difference{};
    }

    /// Velocities agree but for a few steps, in which one world is ahead; places agree but for the
    /// way of such a step.
    template <typename Other>
    Difference outcome(Other other) {
        const double noiseOfSpeed = addNoise();
        for (std::size_t i = 0; i < recipe_.bodies.size(); ++i) {
            fastest_ = std::max(fastest_, length(one_->motion(i).velocity));
        }
        const double roomOfSpeed = std::max(kSpeedShare * (fastest_ + 1), kTells * noiseOfSpeed);
        const double room = std::max(kRoom, kTells * noise_) + kLate * dt_ * fastest_;
        return largest(recipe_.bodies.size(), [&](std::size_t i) {
            const Motion a = one_->motion(i);
            const Motion b = other(i);
            const double speed = length(a.velocity - b.velocity);
            lasting_[i] = speed > roomOfSpeed ? lasting_[i] + 1 : 0;
            const double far = length(a.position - b.position);
            return std::array{Quantity{"velocity", lasting_[i] > kLate ? speed : 0},
                              Quantity{"position", far > room ? far : 0}};
        });
    }

    /// Of places and angles; of velocities as result.
    double addNoise() {
        double ofSpeed = 0;
        for (const auto& engine : noisy_) {
            engine->step();
            for (std::size_t i = 0; i < recipe_.bodies.size(); ++i) {
                const Motion a = one_->motion(i);
                const Motion b = engine->motion(i);
                noise_ = std::max({noise_, length(a.position - b.position), turnOf(a, b)});
                ofSpeed = std::max(ofSpeed, length(a.velocity - b.velocity));
            }
        }
        return ofSpeed;
    }

    const Recipe& recipe_;
    const Changed& changed_;
    bool exact_;
    double dt_; // s
    std::unique_ptr<OrdinaryEngine> one_;
    std::unique_ptr<OrdinaryEngine> other_;
    std::vector<std::unique_ptr<OrdinaryEngine>> noisy_;
    std::vector<int> lasting_; // steps for which the velocity of a body has differed
    double noise_ = 0;         // m or rad
    double fastest_ = 0;       // m/s
};

} // namespace

Recipe invarianceRecipe(std::uint64_t seed) {
    if (isStruck(seed)) {
        return struckRecipe(seed);
    }
    Recipe recipe = randomRecipe(seed);
    recipe.world.settings.leaveOut |= Feature::Sleep; // bodies at rest have a velocity elsewhere
    recipe.drag = 0;
    recipe.twin = Twin::None;
    recipe.tiles = 1;
    recipe.rests = false;
    recipe.events.clear();
    recipe.steps = std::min(recipe.steps, 60);
    return recipe;
}

bool isExact(Invariance invariance) {
    return invariance == Invariance::Length || invariance == Invariance::Mass ||
           invariance == Invariance::AtRest;
}

std::optional<Finding> compare(const Recipe& recipe, const Changed& changed) {
    return Comparison(recipe, changed).run();
}

std::optional<Finding> judgeInvariance(const Recipe& recipe, Invariance invariance) {
    try {
        const std::optional<Changed> other = changed(recipe, invariance);
        // How bodies in overlap part depends on rounding.
        const bool judged = other && (isExact(invariance) || startsSound(build(recipe).world));
        return judged ? compare(recipe, *other) : std::nullopt;
    } catch (const std::exception& error) {
        return Finding{nameOf(invariance), 0, error.what()};
    }
}

std::optional<Finding> judgeInvariance(const Recipe& recipe, const std::string& name) {
    const auto* const found = std::find_if(kInvariances.begin(), kInvariances.end(),
                                           [&](Invariance one) { return nameOf(one) == name; });
    return found != kInvariances.end() ? judgeInvariance(recipe, *found) : std::nullopt;
}

std::vector<Finding> judgeInvariances(const Recipe& recipe) {
    std::vector<Finding> found;
    for (const Invariance invariance : kInvariances) {
        if (const std::optional<Finding> finding = judgeInvariance(recipe, invariance)) {
            found.push_back(*finding);
        }
    }
    return found;
}

} // namespace worlds
