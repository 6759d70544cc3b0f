// SPDX-License-Identifier: MIT
#pragma once

#include <worlds/recipe.hpp>

#include <map>
#include <set>
#include <tuple>

namespace worlds {

/// A recipe as a World.
struct Scene {
    kodo::World world;
    std::vector<kodo::BodyId> ids; // by index in the recipe; of the first tile
};
Scene build(const Recipe& recipe);

/// Pairs of bodies that are looked at: all, or those that filters and joints let collide.
enum class Pairs { All, Colliding };
/// True if no bodies overlap: nothing parts at the start.
bool startsSound(const kodo::World& world, Pairs pairs = Pairs::All);

/// Applies an event, unless one of its bodies is gone.
void apply(const Event& event, Scene& scene);

/// Kinetic and potential energy never exceed what was put in: their value at the start, energy of
/// springs at the start, work of motors, and work of kinematic bodies by contacts and joints.
class EnergyJudge {
public:
    explicit EnergyJudge(const Recipe& recipe) : gravity_(recipe.world.gravity), dt_(recipe.dt) {}
    /// After an event: what is there now counts as put in.
    void restart(const kodo::World& world);
    std::optional<std::string> afterStep(const kodo::World& world);

private:
    /// Motion of the ends of a joint against each other.
    struct Ends {
        kodo::Vec2 gap{};      // m, from anchor a to anchor b
        kodo::Vec2 velocity{}; // m/s
        kodo::Rot angle{};
        kodo::Real spin = 0; // rad/s
    };
    static Ends endsOf(const kodo::World& world, const kodo::JointDef& def);

    long double energyOf(const kodo::World& world) const;
    long double workOfJoints(const kodo::World& world);
    long double workOfContacts(const kodo::World& world) const;

    kodo::Vec2 gravity_;
    kodo::Real dt_;
    long double budget_ = 0; // J
    long double scale_ = 0;  // J, of rounding and of the order of integration
    std::map<kodo::JointId, Ends> before_;
};

/// Momentum and angular momentum of a closed system are constant.
class MomentumJudge {
public:
    explicit MomentumJudge(const Recipe& recipe);
    void restart(const kodo::World& world);
    std::optional<std::string> afterStep(const kodo::World& world);

private:
    bool closed_;
    kodo::BasicVec2<long double> momentum_{};
    long double spin_ = 0;
    long double momentumScale_ = 0; // kg m/s
    long double spinScale_ = 0;     // kg m^2/s
};

/// No body passes through another: counts crossings of its path, in the frame of the other.
class PathJudge {
public:
    void restart(const kodo::World& world);
    std::optional<std::string> afterStep(const kodo::World& world);

private:
    struct Place {
        kodo::Transform frame{}; // of the centre of mass
        kodo::Vec2 middle{};     // m, world; of the first part
    };
    struct Path {
        kodo::Vec2 from{}; // m, in the frame of the obstacle
        kodo::Vec2 to{};
        kodo::Real reach = 0; // m, bounding radius of the body
        bool resting = true;  // the obstacle has hardly turned
    };
    using Key = std::tuple<kodo::BodyId, kodo::BodyId, std::size_t>;

    void findPressed(const kodo::World& world);
    bool passes(const kodo::BodyView& obstacle, std::size_t part, const Path& path, const Key& key);
    bool passesOneSided(const kodo::ConvexShape& convex, const Path& path, const Key& key);
    bool passesLine(const kodo::ConvexShape& convex, const Path& path, const Key& key);
    bool passesSolid(const kodo::ConvexShape& convex, const Path& path, const Key& key);
    bool lasts(const Key& key, bool beyond);

    std::map<kodo::BodyId, Place> places_;
    std::map<Key, kodo::Vec2> entered_; // normal where the path has entered a part
    std::set<Key> inFront_;             // of one-sided segments
    std::set<Key> beyond_;              // on the other side
    std::map<Key, int> steps_;          // since then
    std::set<std::pair<kodo::BodyId, kodo::BodyId>> jointed_;
    std::map<kodo::BodyId, int> pressed_; // steps for which a body counts as crushed
};

/// Each touching pair begins, persists, and ends once.
class TouchJudge {
public:
    std::optional<std::string> afterStep(const kodo::World& world);
    std::size_t openCount() const { return open_.size(); }

private:
    using Key = std::tuple<kodo::BodyId, std::uint16_t, kodo::BodyId, std::uint16_t>;
    std::set<Key> open_;
};

/// All bodies sleep, and none of them would move without sleep. Nothing if some are awake.
std::optional<std::string> judgeSleep(const kodo::World& world);

/// All numbers are finite, rotations are of length 1, and no body is frozen.
std::optional<std::string> judgeNumbers(const kodo::World& world);

} // namespace worlds
