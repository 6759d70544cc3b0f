// SPDX-License-Identifier: MIT
#include <worlds/judges.hpp>
#include <worlds/ordinary.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

namespace worlds {

using namespace kodo;

namespace {

using Vec = BasicVec2<double>;
using Turn = BasicRot<double>;

constexpr const char* kJudges[] = {"energy", "gap", "limit", "ground", "rest", "jitter", "numbers"};

constexpr double kEnergyShare = 0.02; // of the scale
constexpr double kRestSpeed = 0.1;    // m/s, of all bodies: the least scale
constexpr double kGapShare = 0.05;    // of the diameter of the smaller body
constexpr double kAngleRoom = 0.1;    // rad, beyond a limit
constexpr double kLasting = 0.25;     // s, for which a gap must be open
constexpr double kRestWay = 0.05;     // m, in the last second
constexpr double kJitterSpeed = 0.1;  // m/s, changes of velocity to and fro
constexpr double kJitterTime = 0.5;   // s
constexpr double kJitterShare = 0.8;  // of the steps of that time

/// What a body is, from the recipe: equal for each engine.
struct Body {
    double mass = 0;    // kg; 0: cannot move
    double inertia = 0; // kg m^2
    double reach = 0;   // m, of its farthest point from the centre
    Vec center{};       // m, in the frame of the shape
};

/// Ends of a joint.
struct Ends {
    std::size_t a = 0;
    std::size_t b = 0;
    Vec onA{}; // m, in the frames of the shapes
    Vec onB{};
};

class OrdinaryJudge {
public:
    OrdinaryJudge(const Recipe& recipe, const OrdinaryEngine& engine)
        : recipe_(recipe), dt_(static_cast<double>(recipe.dt)) {
        const Scene scene = build(recipe);
        for (const BodyId id : scene.ids) {
            bodies_.push_back(bodyOf(scene.world[id]));
        }
        for (const JointDef& def : recipe.joints) {
            const Ends ends = endsOf(def);
            excluded_.insert({ends.a, ends.b});
            excluded_.insert({ends.b, ends.a});
        }
        open_.resize(recipe.joints.size());
        last_.resize(bodies_.size());
        change_.resize(bodies_.size());
        reversals_.resize(bodies_.size());
        way_.resize(bodies_.size());
        look(engine);
        last_ = now_;
        budget_ = energy() + energyOfSprings();
        scale_ = std::max({kinetic(), weight(), massOfAll() * kRestSpeed * kRestSpeed});
    }

    void afterStep(int step, const OrdinaryEngine& engine) {
        step_ = step;
        last_.swap(now_);
        look(engine);
        judgeNumbers();
        judgeEnergy();
        judgeJoints();
        judgeGround();
        judgeJitter();
        if (recipe_.rests && (recipe_.steps - step_) * dt_ < 1) {
            addWays();
        }
    }

    std::vector<Finding> finish() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (way_[i] > kRestWay) {
                object("rest", [&](auto& text) {
                    text << "body " << i << " moves by " << way_[i] << " m in the last second";
                });
            }
        }
        return std::move(faults_);
    }

    bool goesOn() const { return !found_.contains("numbers"); }

private:
    static Body bodyOf(const BodyView& body) {
        Body result;
        result.center = toDouble(body.localCenter());
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            const auto reach = static_cast<double>(body.part(i).convex.boundingRadius);
            result.reach = std::max(result.reach, reach);
        }
        if (body.type() == BodyType::Dynamic) {
            result.mass = static_cast<double>(body.mass());
            result.inertia = static_cast<double>(body.inertia());
        }
        return result;
    }

    template <typename Write>
    void object(const char* judge, Write write) {
        if (found_.emplace(judge, step_).second) {
            std::ostringstream text;
            write(text);
            faults_.push_back({judge, step_, text.str()});
        }
    }

    void look(const OrdinaryEngine& engine) {
        now_.clear();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            now_.push_back(engine.motion(i));
        }
    }

    Vec centerOf(std::size_t i) const {
        return now_[i].position + now_[i].rotation * bodies_[i].center;
    }

    void judgeNumbers() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Motion& m = now_[i];
            const double sum = m.position.x + m.position.y + m.velocity.x + m.velocity.y + m.spin;
            if (!std::isfinite(sum)) {
                object("numbers", [&](auto& text) { text << "body " << i; });
            }
        }
    }

    double kinetic() const {
        double sum = 0;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            sum += bodies_[i].mass * dot(now_[i].velocity, now_[i].velocity) / 2;
            sum += bodies_[i].inertia * now_[i].spin * now_[i].spin / 2;
        }
        return sum;
    }
    /// J, without that of springs: a lower bound.
    double energy() const {
        double sum = kinetic();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            sum -= bodies_[i].mass * dot(toDouble(recipe_.world.gravity), centerOf(i));
        }
        return sum;
    }
    double massOfAll() const {
        double sum = 0;
        for (const Body& body : bodies_) {
            sum += body.mass;
        }
        return sum;
    }
    /// J, of a fall of all bodies by 1 m.
    double weight() const { return massOfAll() * length(toDouble(recipe_.world.gravity)); }

    static Ends endsOf(const JointDef& def) {
        return std::visit(
            [](const auto& joint) {
                if constexpr (requires { joint.ends; }) {
                    return Ends{joint.ends.a.index, joint.ends.b.index,
                                toDouble(joint.ends.anchorA), toDouble(joint.ends.anchorB)};
                } else {
                    return Ends{joint.body.index, joint.body.index, {}, {}};
                }
            },
            def);
    }

    static Vec place(const std::vector<Motion>& motions, std::size_t body, Vec anchor) {
        return motions[body].position + motions[body].rotation * anchor;
    }
    /// m, from anchor a to anchor b.
    Vec gapOf(const Ends& ends) const {
        return place(now_, ends.b, ends.onB) - place(now_, ends.a, ends.onA);
    }
    static double angleOf(const std::vector<Motion>& motions, const Ends& ends, double reference) {
        const Turn turned = motions[ends.b].rotation * motions[ends.a].rotation.inverse();
        return (turned * Turn::fromAngle(-reference)).angle();
    }

    double energyOfSprings() const {
        double sum = 0;
        for (const JointDef& def : recipe_.joints) {
            const auto* spring = std::get_if<DistanceJoint>(&def);
            if (spring == nullptr || spring->hertz == 0) {
                continue;
            }
            const Ends ends = endsOf(def);
            const auto inverse = [&](std::size_t i) {
                return bodies_[i].mass > 0 ? 1 / bodies_[i].mass : 0;
            };
            const double omega = 2 * std::numbers::pi * static_cast<double>(spring->hertz);
            const double stretch = length(gapOf(ends)) - static_cast<double>(spring->length);
            sum += omega * omega * stretch * stretch / (inverse(ends.a) + inverse(ends.b)) / 2;
        }
        return sum;
    }

    /// J; upper bound of the work of motors in the step.
    double workOfMotors() const {
        double work = 0;
        for (const JointDef& def : recipe_.joints) {
            const Ends ends = endsOf(def);
            if (const auto* pin = std::get_if<RevoluteJoint>(&def)) {
                const double turned = std::abs(angleOf(now_, ends, 0) - angleOf(last_, ends, 0));
                const double spin = std::max(std::abs(now_[ends.b].spin - now_[ends.a].spin),
                                             std::abs(last_[ends.b].spin - last_[ends.a].spin));
                const double most =
                    std::max(std::min(turned, 2 * std::numbers::pi - turned), dt_ * spin);
                work += pin->motorSpeed != 0 ? static_cast<double>(pin->motorTorque) * most : 0;
            } else if (const auto* slider = std::get_if<PrismaticJoint>(&def)) {
                const Vec moved =
                    gapOf(ends) - (place(last_, ends.b, ends.onB) - place(last_, ends.a, ends.onA));
                const double speed =
                    std::max(length(now_[ends.b].velocity - now_[ends.a].velocity),
                             length(last_[ends.b].velocity - last_[ends.a].velocity));
                work +=
                    static_cast<double>(slider->motorForce) * std::max(length(moved), dt_ * speed);
            }
        }
        return work;
    }

    void judgeEnergy() {
        const double work = workOfMotors();
        budget_ += work;
        scale_ = std::max(scale_ + work, kinetic());
        const double excess = energy() - budget_;
        if (excess > kEnergyShare * scale_) {
            object("energy", [&](auto& text) {
                text << excess << " J more than put in, " << excess / scale_ << " of the scale";
            });
        }
    }

    /// m; diameter of the smaller body that a joint moves.
    double sizeOf(const Ends& ends) const {
        const Body& a = bodies_[ends.a];
        const Body& b = bodies_[ends.b];
        const double least = a.mass == 0   ? b.reach
                             : b.mass == 0 ? a.reach
                                           : std::min(a.reach, b.reach);
        return 2 * least;
    }

    /// How far a joint is open (m), and how far its limit is passed, as share of what is allowed.
    struct Opening {
        double gap = 0;
        double limit = 0;
    };
    static double beyond(const std::optional<Range>& range, double value) {
        return range ? std::max({0.0, static_cast<double>(range->lower) - value,
                                 value - static_cast<double>(range->upper)})
                     : 0;
    }
    Opening openingOf(const JointDef& def) const {
        const Ends ends = endsOf(def);
        const double room = kGapShare * sizeOf(ends);
        const Vec gap = gapOf(ends);
        if (const auto* pin = std::get_if<RevoluteJoint>(&def)) {
            const double angle = angleOf(now_, ends, static_cast<double>(pin->reference));
            return {length(gap) / room, beyond(pin->limits, angle) / kAngleRoom};
        }
        if (const auto* weld = std::get_if<FixedJoint>(&def)) {
            const double angle = angleOf(now_, ends, static_cast<double>(weld->reference));
            return {std::max(length(gap) / room, std::abs(angle) / kAngleRoom), 0};
        }
        if (const auto* slider = std::get_if<PrismaticJoint>(&def)) {
            const Vec axis = now_[ends.a].rotation * toDouble(slider->axis);
            const double angle = angleOf(now_, ends, static_cast<double>(slider->reference));
            const double aside = std::abs(cross(axis, gap));
            return {std::max(aside / room, std::abs(angle) / kAngleRoom),
                    beyond(slider->limits, dot(axis, gap)) / room};
        }
        if (const auto* rope = std::get_if<DistanceJoint>(&def)) {
            return {beyond(rope->limits, length(gap)) / room, 0};
        }
        return {};
    }

    void judgeJoints() {
        for (std::size_t i = 0; i < recipe_.joints.size(); ++i) {
            const Opening opening = openingOf(recipe_.joints[i]);
            const auto count = [&](double& time, double share, const char* judge) {
                time = share > 1 ? time + dt_ : 0;
                if (time > kLasting) {
                    object(judge, [&](auto& text) {
                        text << "joint " << i << ", " << share << " of what is allowed";
                    });
                }
            };
            count(open_[i].gap, opening.gap, "gap");
            count(open_[i].limit, opening.limit, "limit");
        }
    }

    bool collide(std::size_t i, std::size_t k) const {
        const auto filter = [&](std::size_t index) {
            return CollisionFilter{recipe_.bodies[index].flags, recipe_.bodies[index].required};
        };
        return shouldCollide(filter(i), filter(k)) && !excluded_.contains({i, k});
    }

    bool isInside(Vec center, std::size_t ground) const {
        const Vec2 point{static_cast<Real>(center.x), static_cast<Real>(center.y)};
        const BodyDef& def = recipe_.bodies[ground];
        const Vec2 local = unrotate(def.rotation, point - def.position);
        if (const auto* map = std::get_if<Heightmap>(&def.shape)) {
            const Real share = (local.x - map->origin.x) / map->spacing;
            const auto cell = static_cast<std::ptrdiff_t>(std::floor(share));
            if (cell < 0 || cell + 1 >= std::ssize(map->heights)) {
                return false;
            }
            const Real left = map->heights[static_cast<std::size_t>(cell)];
            const Real right = map->heights[static_cast<std::size_t>(cell) + 1];
            const Real height = left + (share - static_cast<Real>(cell)) * (right - left);
            return local.y < map->origin.y + height;
        }
        for (const Primitive& primitive : primitivesOf(def.shape)) {
            if (kodo::contains(convexShapeOf(primitive, {}), {}, local)) {
                return true;
            }
        }
        return false;
    }

    void judgeGround() {
        for (std::size_t ground = 0; ground < bodies_.size(); ++ground) {
            if (recipe_.bodies[ground].type != BodyType::Static) {
                continue;
            }
            for (std::size_t i = 0; i < bodies_.size(); ++i) {
                if (bodies_[i].mass > 0 && collide(i, ground) && isInside(centerOf(i), ground)) {
                    object("ground", [&](auto& text) {
                        text << "body " << i << " in body " << ground << " at (" << centerOf(i).x
                             << ", " << centerOf(i).y << ")";
                    });
                }
            }
        }
    }

    /// A body whose velocity changes to and fro from step to step.
    void judgeJitter() {
        const double window = std::ceil(kJitterTime / dt_);
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Motion& last = last_[i];
            const Vec linear = now_[i].velocity - last.velocity;
            const double rim = (now_[i].spin - last.spin) * bodies_[i].reach;
            const auto [before, rimBefore] = change_[i];
            const double product = dot(linear, before) + rim * rimBefore;
            const double size = dot(linear, linear) + rim * rim;
            const double sizeBefore = dot(before, before) + rimBefore * rimBefore;
            const double least = kJitterSpeed * kJitterSpeed;
            const bool reverses =
                std::min(size, sizeBefore) > least && product < -0.5 * std::sqrt(size * sizeBefore);
            change_[i] = {linear, rim};
            // The mean over about the window; 1 if each step reverses.
            reversals_[i] += ((reverses ? 1.0 : 0.0) - reversals_[i]) * 2 / window;
            if (reversals_[i] > kJitterShare) {
                object("jitter", [&](auto& text) {
                    text << "body " << i << " by " << std::sqrt(size) << " m/s in each step";
                });
            }
        }
    }

    void addWays() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Vec from = last_[i].position + last_[i].rotation * bodies_[i].center;
            const Turn turned = now_[i].rotation * last_[i].rotation.inverse();
            way_[i] += length(centerOf(i) - from) + std::abs(turned.angle()) * bodies_[i].reach;
        }
    }

    const Recipe& recipe_;
    double dt_;    // s
    int step_ = 0; // the present one
    std::vector<Body> bodies_;
    std::vector<Motion> now_;
    std::vector<Motion> last_;
    double budget_ = 0;                          // J
    double scale_ = 0;                           // J
    std::vector<Opening> open_;                  // s, for which joints have been open
    std::vector<std::pair<Vec, double>> change_; // m/s, of the centre and the rim in the last step
    std::vector<double> reversals_;              // mean share
    std::vector<double> way_;                    // m, in the last second
    std::set<std::pair<std::size_t, std::size_t>> excluded_; // by joints
    std::map<std::string, int> found_;
    std::vector<Finding> faults_;
};

} // namespace

std::span<const char* const> ordinaryJudges() {
    return kJudges;
}

OrdinaryRun runOrdinary(const Recipe& recipe, OrdinaryEngine& engine) {
    OrdinaryRun run;
    OrdinaryJudge judge(recipe, engine);
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    for (int step = 0; step < recipe.steps && judge.goesOn(); ++step) {
        const double start = now();
        engine.step();
        run.seconds += now() - start;
        judge.afterStep(step, engine);
    }
    run.faults = judge.finish();
    return run;
}

std::optional<Finding> judgeOrdinary(const Recipe& recipe, const std::string& judge) {
    try {
        if (!startsSound(build(recipe).world, Pairs::Colliding)) {
            return std::nullopt;
        }
        for (const Finding& fault : runOrdinary(recipe, *ordinaryInKodo(recipe)).faults) {
            if (fault.judge == judge) {
                return fault;
            }
        }
    } catch (const BadDefinition&) {
    }
    return std::nullopt;
}

} // namespace worlds
