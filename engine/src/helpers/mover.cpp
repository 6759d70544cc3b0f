// SPDX-License-Identifier: MIT
#include <kodo/mover.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include "helpers/obstacles.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr int kMostSlides = 4;            // changes of direction in one move
constexpr int kMostRecoveries = 4;        // searches for what has moved into the mover
constexpr Real kLeastLift = Real(0.25);   // cosine: on a steeper corner the gap is smaller
constexpr Real kLeastLanding = Real(0.5); // cosine: a fall ends on no steeper part of a corner

void require(const Mover& mover, Vec2 wish, Real dt) {
    if (auto problem = check(mover.shape)) {
        throw BadDefinition({"shape." + problem->field, problem->reason});
    }
    if (std::holds_alternative<Plane>(mover.shape)) {
        throw BadDefinition({"shape", "must not be a plane"});
    }
    struct Number {
        const char* field;
        Real value, low, high;
    };
    for (const auto& [field, value, low, high] : {
             Number{"up", length(mover.up), Real(0.9999), Real(1.0001)},
             Number{"slopeLimit", mover.slopeLimit, 0, Real(1.5)},
             Number{"stepHeight", mover.stepHeight, 0, kMaxCoordinate},
             Number{"skin", mover.skin, Real(1e-6), kMaxCoordinate},
             Number{"pushForce", mover.pushForce, 0, kMaxMass},
             Number{"weight", mover.weight, 0, kMaxMass},
             Number{"wish", length(wish), 0, kMaxSpeed},
             Number{"position", length(mover.position), 0, 2 * kMaxCoordinate},
             Number{"dt", dt, kMinTimeStep, kMaxTimeStep},
         }) {
        if (!(value >= low && value <= high)) { // also for NaN
            throw BadDefinition({field, "must be from " + std::to_string(low) + " to " +
                                            std::to_string(high) + ", but is " +
                                            std::to_string(value)});
        }
    }
}

/// The part of v that does not lead into a surface.
Vec2 clipped(Vec2 v, Vec2 normal) {
    return v - (std::min)(dot(v, normal), Real(0)) * normal;
}

/// One call of Mover::move().
class Motion {
public:
    Motion(World& world, Mover& mover, Real dt)
        : world_(world),
          mover_(mover),
          dt_(dt),
          up_(mover.up),
          right_(-perp(up_)),
          obstacles_(world, mover),
          budget_(mover.pushForce * dt) {}

    void run(Vec2 wish) {
        const Vec2 carried = carriedWay();
        const Real reach = length(carried) + length(wish + groundVelocity_) * dt_;
        obstacles_.findNear(2 * (reach + mover_.stepHeight + reach * obstacles_.slope()) +
                            4 * mover_.skin);
        carry(carried);
        recover();
        const bool walks = mover_.grounded && dot(wish, up_) <= 0;
        mover_.wallNormal = {};
        if (walks) {
            walk(dot(wish, right_));
        } else {
            fly(wish + groundVelocity_);
        }
        finish();
    }

private:
    /// How far the ground has moved since the last move.
    Vec2 carriedWay() {
        if (!mover_.grounded || !world_.contains(mover_.groundBody)) {
            return {};
        }
        const BodyView ground = world_[mover_.groundBody];
        const Transform pose = ground.transform();
        groundVelocity_ = ground.velocityAt(obstacles_.at());
        if (pose == mover_.groundPose) {
            return {};
        }
        mover_.groundNormal =
            pose.rotation * unrotate(mover_.groundPose.rotation, mover_.groundNormal);
        return pose * toLocal(mover_.groundPose, obstacles_.at()) - obstacles_.at();
    }

    void carry(Vec2 way) {
        Real moved = 0;
        obstacles_.except(mover_.groundBody);
        obstacles_.advance(way, moved);
        obstacles_.exceptNoMore();
    }

    /// Moves out of what has moved into the mover, as far as other things let it.
    void recover() {
        for (int i = 0; i < kMostRecoveries; ++i) {
            Vec2 shift{};
            for (const QueryContact& touch : obstacles_.touches(mover_.skin)) {
                const BodyView body = world_[touch.body];
                const Real closing = dot(body.velocityAt(touch.point), touch.normal);
                const Real separation = touch.separation + dot(shift, touch.normal);
                const bool passes =
                    body.part(touch.part).convex.oneSided &&
                    touch.separation < -mover_.skin - 2 * dt_ * (std::max)(closing, Real(0));
                if (!passes && separation < mover_.skin / 2) {
                    shift += (mover_.skin - separation) * touch.normal;
                }
            }
            Real moved = 0;
            if (shift == Vec2{} || (obstacles_.advance(shift, moved), moved == 0)) {
                return;
            }
        }
    }

    void stand(const QueryHit& hit, Vec2 normal) {
        mover_.grounded = true;
        mover_.groundNormal = normal;
        mover_.groundBody = hit.body;
        groundPoint_ = hit.point;
    }

    /// Moves down to ground within `reach` (m). `velocity`: of the mover (m/s, world), if it must
    /// not rise from this ground.
    bool snap(Real reach, std::optional<Vec2> velocity) {
        const Real all = reach + 2 * mover_.skin;
        const auto hit = obstacles_.cast(-all * up_);
        const auto normal = hit ? obstacles_.groundOf(*hit) : std::nullopt;
        if (!normal) {
            return hit && leans(velocity);
        }
        const Real lift = (std::max)(dot(hit->normal, up_), kLeastLift);
        const Real down = all * hit->fraction - mover_.skin / lift;
        if (down > reach || (velocity && rises(*velocity, hit->body, hit->point))) {
            return false;
        }
        if (down > mover_.skin / 8) {
            obstacles_.setAt(obstacles_.at() - down * up_);
        }
        stand(*hit, *normal);
        return true;
    }

    bool rises(Vec2 velocity, BodyId ground, Vec2 point) const {
        return dot(velocity - world_[ground].velocityAt(point), up_) > Real(1e-3);
    }

    /// True if something that touches the mover is ground, beside a steeper thing below it.
    bool leans(std::optional<Vec2> velocity) {
        for (const QueryContact& touch : obstacles_.touches(2 * mover_.skin)) {
            if (obstacles_.isFlat(touch.normal) &&
                !(velocity && rises(*velocity, touch.body, touch.point))) {
                stand({touch.body, touch.part, 0, touch.point, touch.normal}, touch.normal);
                return true;
            }
        }
        return false;
    }

    /// Up, forward and down again, if that ends on higher ground.
    bool stepsUp(Vec2 forward) {
        const Vec2 from = obstacles_.at();
        Real up = 0, moved = 0, down = 0;
        obstacles_.advance(mover_.stepHeight * up_, up);
        const Real least = 2 * mover_.skin;
        obstacles_.advance((std::max)(length(forward), least) * normalize(forward), moved);
        const Vec2 over = obstacles_.at();
        const auto hit = obstacles_.advance(-(up + least) * up_, down);
        const auto normal = hit && moved > mover_.skin ? obstacles_.groundOf(*hit) : std::nullopt;
        const Real rise = up - down;
        if (!normal || rise < mover_.skin / 2 ||
            dot(hit->point - from, up_) - obstacles_.lowest() > mover_.stepHeight + mover_.skin) {
            obstacles_.setAt(from);
            return false;
        }
        obstacles_.setAt(over - down * up_);
        stand(*hit, *normal);
        return true;
    }

    void walk(Real speed) {
        Vec2 normal = mover_.groundNormal;
        Real left = std::abs(speed) * dt_; // m
        const Real reach = mover_.stepHeight + left * obstacles_.slope();
        const Real side = speed < 0 ? Real(-1) : Real(1);
        mover_.grounded = false;
        for (int i = 0; i < kMostSlides && left > 0; ++i) {
            const Vec2 along = -side * perp(normal);
            Real moved = 0;
            const auto hit = obstacles_.advance(left * along, moved);
            left -= moved;
            if (!hit) {
                break;
            }
            if (obstacles_.isFlat(hit->normal)) {
                normal = hit->normal;
            } else if (stepsUp(left * side * right_)) {
                left = 0;
            } else {
                push(*hit, speed * right_ + groundVelocity_);
                mover_.wallNormal = hit->normal;
                speed = 0;
                left = 0;
            }
        }
        const bool stands = mover_.grounded || snap(reach, std::nullopt);
        mover_.velocity = speed * right_ + (stands ? Vec2{} : groundVelocity_);
    }

    void fly(Vec2 velocity) {
        Vec2 way = dt_ * velocity;
        Vec2 before{}; // normal of the surface before
        mover_.grounded = false;
        for (int i = 0; i < kMostSlides && !mover_.grounded; ++i) {
            Real moved = 0;
            const Real all = length(way);
            const auto hit = obstacles_.advance(way, moved);
            if (!hit) {
                break;
            }
            way *= 1 - moved / all;
            const Vec2 normal = hit->normal;
            const auto ground = obstacles_.groundOf(*hit);
            const Real lift = dot(normal, up_);
            if (ground && (obstacles_.isFlat(normal) || lift >= kLeastLanding) &&
                !rises(velocity, hit->body, hit->point)) {
                land(*hit, *ground, velocity, way);
                return;
            }
            push(*hit, velocity);
            if (std::abs(lift) < kLeastLanding) {
                mover_.wallNormal = normal;
            }
            if (lift > 0) { // a slope that is too steep must not turn speed into height
                const Vec2 wall = normalize(normal - lift * up_);
                velocity = clipped(velocity, wall);
                way = clipped(way, wall);
            }
            velocity = clipped(velocity, normal);
            way = clipped(way, normal);
            if (dot(velocity, before) < 0) { // a corner
                if (lift > 0 && dot(before, up_) > 0) {
                    stand(*hit, up_); // wedged
                }
                velocity = {};
                break;
            }
            before = normal;
        }
        mover_.velocity = velocity;
        if (!mover_.grounded && snap(2 * mover_.skin, velocity)) {
            mover_.velocity = acrossUp(velocity);
        }
    }

    /// m/s, of what remains on the ground.
    Vec2 acrossUp(Vec2 velocity) const {
        const Vec2 ground = world_[mover_.groundBody].velocityAt(groundPoint_);
        return dot(velocity - ground, right_) * right_;
    }

    /// Spends the rest of the move along the ground.
    void land(const QueryHit& hit, Vec2 normal, Vec2 velocity, Vec2 way) {
        stand(hit, normal);
        mover_.velocity = acrossUp(velocity);
        Real moved = 0;
        obstacles_.advance(-dot(way, right_) * perp(normal), moved);
        if (!snap(mover_.stepHeight, std::nullopt)) {
            mover_.grounded = false;
            mover_.velocity = dot(velocity, right_) * right_;
        }
    }

    /// Pushes a body until it moves as the mover, with at most `pushForce`.
    void push(const QueryHit& hit, Vec2 velocity) {
        BodyRef body = world_[hit.body];
        const Real closing = -dot(velocity - body.velocityAt(hit.point), hit.normal);
        if (body.type() != BodyType::Dynamic || budget_ <= 0 || !(closing > 0)) {
            return;
        }
        const Real lever = cross(hit.point - body.center(), hit.normal);
        const bool turns = (body.flags() & kLockRotate) == 0 && body.inertia() > 0;
        const Real give = 1 / body.mass() + (turns ? lever * lever / body.inertia() : 0);
        const Real impulse = (std::min)(closing / give, budget_);
        body.applyForce(-impulse / dt_ * hit.normal, hit.point); // an impulse would beat friction
        budget_ -= impulse;
    }

    void finish() {
        mover_.position = obstacles_.at();
        if (!mover_.grounded) {
            mover_.groundNormal = {};
            mover_.groundBody = {};
            mover_.groundPose = {};
        } else {
            BodyRef ground = world_[mover_.groundBody];
            mover_.groundPose = ground.transform();
            if (mover_.weight > 0 && ground.type() == BodyType::Dynamic) {
                ground.applyForce(-mover_.weight * up_, groundPoint_);
            }
        }
        if (world_.contains(mover_.body)) {
            world_[mover_.body].moveTo(obstacles_.at(), dt_);
        }
    }

    World& world_;
    Mover& mover_;
    Real dt_;
    Vec2 up_;
    Vec2 right_;
    Obstacles obstacles_;
    Real budget_;           // N s, left to push with
    Vec2 groundVelocity_{}; // m/s, of the ground at the start
    Vec2 groundPoint_{};    // m, world
};

} // namespace

void Mover::move(World& world, Vec2 wish, Real dt) {
    require(*this, wish, dt);
    Motion(world, *this, dt).run(wish);
}

} // namespace KODO_PRECISION
} // namespace kodo
