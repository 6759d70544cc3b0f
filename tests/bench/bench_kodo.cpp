// SPDX-License-Identifier: MIT
// Compiled twice: for kodo::kodo into bench::f32, for kodo::kodo64 into bench::f64.
#include <kodo/query.hpp>
#include <kodo/snapshot.hpp>
#include <scenes/in_kodo.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ctime>

#include "bench_engine.hpp"
#include "heap.hpp"
#include "lanes/contact.hpp"
#include "lanes/contact_block.hpp"

namespace bench::KODO_PRECISION {
namespace {

kodo::StepSettings profileOf(const std::string& name) {
    if (name == kBalanced) {
        return kodo::balanced();
    }
    if (name == "fast") {
        return kodo::fast();
    }
    if (name == "accurate") {
        return kodo::accurate();
    }
    if (name == "thesis2006") {
        return kodo::thesis2006();
    }
    throw WrongUse("Kodo has no profile '" + name + "'");
}

kodo::Feature featureOf(const std::string& name) {
    const std::vector<std::string>& names = featureNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        throw WrongUse("Kodo has no feature '" + name + "' to leave out");
    }
    return static_cast<kodo::Feature>(1u << (found - names.begin()));
}
static_assert(static_cast<int>(kodo::Feature::Friction) == 1 << 0 &&
              static_cast<int>(kodo::Feature::RollingResistance) == 1 << 1 &&
              static_cast<int>(kodo::Feature::Restitution) == 1 << 2 &&
              static_cast<int>(kodo::Feature::ContinuousCollision) == 1 << 3 &&
              static_cast<int>(kodo::Feature::Records) == 1 << 4 &&
              static_cast<int>(kodo::Feature::Sleep) == 1 << 5 &&
              static_cast<int>(kodo::Feature::Rotation) == 1 << 6 &&
              static_cast<int>(kodo::Feature::Collision) == 1 << 7); // same order as featureNames()

kodo::ContinuousMode modeOf(const std::string& name) {
    const std::vector<std::string>& names = continuousModeNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        throw WrongUse("Kodo has no continuous mode '" + name + "'");
    }
    return static_cast<kodo::ContinuousMode>(found - names.begin());
}

/// A single value of the settings. set() returns why it cannot be set, or "".
struct Number {
    const char* name;
    std::string (*set)(kodo::StepSettings&, double);
    bool (*isIn)(const kodo::StepSettings&); // whether the solver has it
};

template <typename Number>
std::string setTo(Number& number, double value) {
    if (!std::isfinite(value)) {
        return "is no finite number";
    }
    if (std::abs(value) > 1e9) {
        return "is out of range: up to 1e9";
    }
    if (std::is_integral_v<Number> && value != std::floor(value)) {
        return "is no whole number";
    }
    number = static_cast<Number>(value);
    return "";
}

template <typename Settings, typename Number>
Settings settingsWith(Number Settings::*);

template <auto member>
bool hasMember(const kodo::StepSettings& settings) {
    return std::holds_alternative<decltype(settingsWith(member))>(settings.solver);
}

template <auto member>
void setIn(kodo::StepSettings& settings, double value, std::string& problem) {
    if (auto* const solver = std::get_if<decltype(settingsWith(member))>(&settings.solver)) {
        problem = setTo(solver->*member, value);
    }
}

/// A value that the solver in the settings has, as one of these members.
template <auto... members>
std::string setMember(kodo::StepSettings& settings, double value) {
    std::string problem;
    (setIn<members>(settings, value, problem), ...);
    return problem;
}

template <auto... members>
constexpr Number numberOf(const char* name) {
    return {name, setMember<members...>, [](const kodo::StepSettings& settings) {
                return (hasMember<members>(settings) || ...);
            }};
}

using Soft = kodo::SoftSettings;
using Propagation = kodo::PropagationSettings;
constexpr Number kNumbers[] = {
    numberOf<&Soft::impactPasses, &Propagation::impactPasses>("impactPasses"),
    numberOf<&Propagation::contactPasses>("contactPasses"),
    numberOf<&Propagation::shockPasses>("shockPasses"),
    numberOf<&Soft::contactHertz>("contactHertz"),
    numberOf<&Soft::contactDamping>("contactDamping"),
    numberOf<&Soft::jointHertz, &Propagation::jointHertz>("jointHertz"),
    numberOf<&Soft::jointDamping, &Propagation::jointDamping>("jointDamping"),
    numberOf<&Soft::jointGap>("jointGap"),
    numberOf<&Soft::pushSpeed, &Propagation::pushSpeed>("pushSpeed"),
};

/// Of the solver in the settings.
std::string namesOfNumbers(const kodo::StepSettings& settings) {
    std::string names;
    for (const Number& number : kNumbers) {
        if (number.isIn(settings)) {
            names += (names.empty() ? "" : ", ") + std::string(number.name);
        }
    }
    return names;
}

/// "contactHertz=120".
void setNumber(kodo::StepSettings& settings, const std::string& text, const std::string& profile) {
    const std::size_t sign = text.find('=');
    const std::string name = text.substr(0, sign);
    const auto* number =
        std::find_if(std::begin(kNumbers), std::end(kNumbers),
                     [&](const Number& candidate) { return name == candidate.name; });
    if (number == std::end(kNumbers)) {
        throw WrongUse("'" + text + "' sets no number of Kodo's settings: these are " +
                       namesOfNumbers(settings));
    }
    if (!number->isIn(settings)) {
        throw WrongUse("the solver of the profile " + profile + " has no " + name + ": it has " +
                       namesOfNumbers(settings));
    }
    double value = 0;
    const char* end = text.data() + text.size();
    const char* start = sign == std::string::npos ? end : text.data() + sign + 1;
    const auto read = std::from_chars(start, end, value);
    if (read.ec != std::errc() || read.ptr != end) {
        throw WrongUse("'" + text + "' is not " + name + "=NUMBER");
    }
    if (const std::string problem = number->set(settings, value); !problem.empty()) {
        throw WrongUse(name + ": " + std::string(start, end) + " " + problem);
    }
}

kodo::StepSettings settingsOf(const StepOptions& options) {
    if (options.passes || options.positionPasses) {
        throw WrongUse("passes and position passes are Box2D's; for Kodo, set contactPasses");
    }
    const std::string profile = options.profile.value_or(kBalanced);
    kodo::StepSettings settings = profileOf(profile);
    std::visit([&](auto& solver) { solver.substeps = options.substeps.value_or(solver.substeps); },
               settings.solver);
    for (const std::string& text : options.set) {
        setNumber(settings, text, profile);
    }
    for (const std::string& name : options.leaveOut) {
        settings.leaveOut |= featureOf(name);
    }
    if (!options.rest) {
        settings.leaveOut |= kodo::Feature::Sleep;
    }
    if (const auto problem = check(settings)) {
        throw WrongUse(problem->field + " " + problem->reason);
    }
    return settings;
}

/// Sums up the time of each stage.
class StageClock final : public kodo::StageListener {
public:
    void enter(kodo::StepStage stage) override {
        leave();
        now_ = static_cast<int>(stage);
    }
    void leave() override {
        timespec clock{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &clock);
        const double at =
            static_cast<double>(clock.tv_sec) + 1e-9 * static_cast<double>(clock.tv_nsec);
        if (now_ >= 0) {
            seconds_[static_cast<std::size_t>(now_)] += at - since_;
        }
        since_ = at;
        now_ = -1;
    }
    std::vector<StageTime> times() const {
        std::vector<StageTime> times;
        for (std::size_t i = 0; i < seconds_.size(); ++i) {
            if (seconds_[i] > 0) {
                times.push_back({std::string(kodo::kStepStageNames[i]), seconds_[i]});
            }
        }
        return times;
    }

private:
    std::array<double, kodo::kStepStageNames.size()> seconds_{};
    double since_ = 0; // s
    int now_ = -1;
};

class KodoEngine final : public Engine {
public:
    KodoEngine(const scenes::SceneDef& scene, const StepOptions& options)
        : scene_(scenes::inKodo(scene, settingsOf(options))),
          pool_(options.threads - 1),
          timesStages_(options.stages),
          mode_(modeOf(options.continuous)) {
        if (mode_ != kodo::ContinuousMode::All) { // a setter wakes the body
            for (const kodo::BodyId id : scene_.ids) {
                scene_.world[id].setContinuousMode(mode_);
            }
        }
    }

    void step(double dt) override {
        scene_.world.step(static_cast<kodo::Real>(dt),
                          {.executor = &pool_, .listener = timesStages_ ? &stages_ : nullptr});
    }

    BodyState state(std::size_t body) const override {
        const kodo::BodyView view = std::as_const(scene_.world)[scene_.ids[body]];
        return {wide(view.position()),
                {wide(view.rotation().c), wide(view.rotation().s)},
                wide(view.velocity()),
                wide(view.angularVelocity())};
    }

    void add(const scenes::BodyDef& body) override {
        kodo::BodyDef def = scenes::toKodo(body);
        def.continuousMode = mode_;
        scene_.ids.push_back(scene_.world.add(def));
    }
    void remove(std::size_t body) override { scene_.world.remove(scene_.ids[body]); }

    void reload() override { scene_.world = kodo::fromBytes(kodo::toBytes(scene_.world)); }

    void place(std::size_t body, scenes::Vec2 position) override {
        kodo::BodyRef ref = scene_.world[scene_.ids[body]];
        ref.setPosition(scenes::toKodo(position));
        ref.setVelocity({});
    }

    void push(std::size_t body, scenes::Vec2 velocity) override {
        scene_.world[scene_.ids[body]].setVelocity(scenes::toKodo(velocity));
    }

    double readContacts() const override {
        double sum = 0;
        for (const kodo::CollisionRecord& record : scene_.world.collisions()) {
            sum += wide(record.totalImpulse);
        }
        return sum;
    }

    double readEvents() const override {
        constexpr kodo::Real kLeastSpeed = 1; // m/s, as Box2D v3 by default
        const kodo::World& world = scene_.world;
        double sum =
            static_cast<double>(world.begunCollisions().size() + world.endedCollisions().size());
        for (const kodo::CollisionRecord& record : world.hits(kLeastSpeed)) {
            sum += wide(record.approachSpeed);
        }
        return sum;
    }

    double impulse(std::size_t a, std::size_t b) const override {
        double sum = 0;
        for (const kodo::CollisionRecord& record : scene_.world.collisions()) {
            if (record.involves(scene_.ids[a]) && record.involves(scene_.ids[b])) {
                sum += wide(record.totalImpulse);
            }
        }
        return sum;
    }

    double rayCast(scenes::Vec2 from, scenes::Vec2 to) const override {
        const auto hit = kodo::rayCast(scene_.world, scenes::toKodo(from), scenes::toKodo(to));
        return hit ? wide(hit->fraction) : 1;
    }

    std::size_t bodyCount() const override { return scene_.world.bodyCount(); }

    double mass() const override {
        double sum = 0;
        for (const kodo::BodyId id : scene_.world.bodies()) {
            const kodo::BodyView view = std::as_const(scene_.world)[id];
            sum += view.type() != kodo::BodyType::Dynamic ? 0 : wide(view.mass());
        }
        return sum;
    }

    std::uint64_t stateHash() const override { return scene_.world.stateHash(); }
    std::optional<std::uint64_t> pairWork() const override {
        return stepStats(scene_.world).pairWork;
    }
    std::optional<ContactBytes> contactBytes() const override {
        constexpr std::size_t kRow = sizeof(kodo::ContactBlock) / kodo::ContactBlock::kContacts;
        constexpr std::size_t kRest = sizeof(kodo::Contact) + sizeof(kodo::ContactSummary) +
                                      sizeof(kodo::ContactBlock) / kodo::ContactBlock::kContacts;
        return ContactBytes{kRest + kRow, kRow};
    }
    SnapshotWork snapshotWork() const override {
        return {[this] { return kodo::toBytes(scene_.world).size(); },
                [this] {
                    const std::size_t before = heapBytes();
                    const kodo::World copy = scene_.world;
                    return heapBytes() - before;
                }};
    }
    std::vector<StageTime> stages() const override { return stages_.times(); }

private:
    static double wide(kodo::Real value) { return static_cast<double>(value); }
    static scenes::Vec2 wide(kodo::Vec2 v) { return {wide(v.x), wide(v.y)}; }

    scenes::KodoScene scene_;
    kodo::ThreadPool pool_;
    StageClock stages_;
    bool timesStages_ = false;
    kodo::ContinuousMode mode_;
};

} // namespace

std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene, const StepOptions& options) {
    return std::make_unique<KodoEngine>(scene, options);
}

} // namespace bench::KODO_PRECISION
