// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <world/snapshot_scenes.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>

namespace kodo {
namespace {

using support::kDt;
using support::run;

using support::Bytes;
using support::seal;

/// A user-defined class on top of Drag, which must not be restored as a Drag.
class Halved final : public ForceField {
public:
    FieldForce at(const BodyView& body, Real dt) const override {
        FieldForce push = drag_.at(body, dt);
        push.force = Real(0.5) * push.force;
        return push;
    }

private:
    Drag drag_{DragLaw{1, 0}};
};

/// Touching bodies, a sleeping one, one outside the region, a joint and a field: every list in few
/// bytes.
World smallWorld() {
    World world({.gravity = {0, -10}});
    world.addField({std::make_shared<Drag>(DragLaw{Real(0.25), 0}), {kMatchAny, 1}});
    world.add({.shape = Plane{}, .type = BodyType::Static});
    const BodyId a = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    const BodyId b = world.add({.shape = Polygon{{{0, 0}, {1, 0}, {0, 1}}}, .position = {1, 0}});
    world.add(RevoluteJoint{{a, b, {Real(0.5), 0}, {Real(-0.5), 0}}, 0, Range{-1, 1}});
    world.add(support::boxDef({5, Real(0.5)}, 1, 1));
    run(world, 40); // the separate box is asleep by now
    world.remove(world.add({.shape = Compound{{Circle{1}, Point{}}}, .position = {0, 50}}));
    world.add({.shape = Segment{{-1, 0}, {1, 0}, true}, .position = {0, 9}});
    world[a].applyImpulse({0, 1});
    world.add(support::boxDef({-40, Real(0.5)}, 1, 1));
    run(world, 2);
    world.setRegion(Aabb{{-20, -100}, {20, 100}});
    run(world, 1);
    return world;
}

/// The reason of the refusal; empty if the bytes are accepted.
std::string refusalOf(const Bytes& bytes) {
    try {
        fromBytes(bytes);
        return {};
    } catch (const BadSnapshot& bad) {
        return bad.what();
    }
}

Bytes changed(Bytes bytes, std::size_t place, int value) {
    bytes[place] = static_cast<std::byte>(value);
    seal(bytes);
    return bytes;
}

// Offsets in the header: 4 bytes "Kodo", 4 bytes for the format, 1 byte for the precision.
constexpr std::size_t kFormatAt = 4;
constexpr std::size_t kPrecisionAt = 8;

TEST(SnapshotRefused, WithAReason) {
    const Bytes good = toBytes(smallWorld());
    EXPECT_EQ(refusalOf(good), "");
    EXPECT_EQ(refusalOf({}), "the bytes end too soon");
    EXPECT_EQ(refusalOf(changed(good, 0, 'k')), "these bytes are no snapshot of a Kodo World");
    EXPECT_EQ(refusalOf(changed(good, kFormatAt, 200)),
              "the snapshot has format 200, but this version of Kodo reads format 26");
    const int mine = sizeof(Real);
    const int other = 12 - mine;
    EXPECT_EQ(refusalOf(changed(good, kPrecisionAt, other)),
              "the snapshot has numbers of " + std::to_string(other) +
                  " bytes, but this Kodo computes with " + std::to_string(mine));
    Bytes damaged = good;
    damaged[20] ^= std::byte{1};
    EXPECT_EQ(refusalOf(damaged), "the snapshot is damaged: its checksum is wrong");
    Bytes longer = good;
    longer.resize(good.size() + 5);
    seal(longer);
    EXPECT_EQ(refusalOf(longer), "something follows the end of the snapshot");
}

TEST(SnapshotRefused, EveryTruncatedLength) {
    const Bytes good = toBytes(smallWorld());
    for (std::size_t length = 0; length < good.size(); ++length) {
        Bytes cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length));
        ASSERT_NE(refusalOf(cut), "") << length;
        if (length >= 8) { // truncated within the fields, with a valid checksum
            seal(cut);
            ASSERT_NE(refusalOf(cut), "") << length << ", sealed";
        }
    }
}

TEST(SnapshotRefused, EveryFlippedBit) {
    Bytes bytes = toBytes(smallWorld());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        for (int bit = 0; bit < 8; ++bit) {
            const std::byte mask = std::byte{1} << bit;
            bytes[i] ^= mask;
            ASSERT_NE(refusalOf(bytes), "") << "bit " << bit << " of byte " << i;
            bytes[i] ^= mask;
        }
    }
}

/// Bytes with a valid checksum are refused, or give a World whose steps keep all poses finite. True
/// if they were accepted.
bool refusedOrSound(const Bytes& bytes) {
    if (!refusalOf(bytes).empty()) {
        return false;
    }
    World world = fromBytes(bytes);
    for (int step = 0; step < 8; ++step) {
        if (step == 4) { // activates sleeping and outside bodies
            world.setRegion(std::nullopt);
            for (const BodyId id : world.bodies()) {
                world[id].setVelocity({});
            }
        }
        world.step(kDt);
        for (const BodyId id : world.bodies()) {
            const Transform& place = world[id].massFrame();
            EXPECT_TRUE(isFinite(place.position));
            EXPECT_TRUE(std::isfinite(place.rotation.c) && std::isfinite(place.rotation.s));
        }
    }
    for (const BodyId id : world.bodies()) {
        world.remove(id); // visits all references to it
    }
    world.step(kDt);
    EXPECT_EQ(world.bodyCount(), 0u);
    return true;
}

// A length with bytes of 0xff requests more memory than exists; sanitizers detect the allocation.
TEST(SnapshotLoad, AChangedByteWithAValidChecksumIsRefusedOrSound) {
    const Bytes good = toBytes(smallWorld());
    int taken = 0;
    int refused = 0;
    for (std::size_t i = 0; i + 8 < good.size(); ++i) {
        for (const int value : support::variants({0xff, 0x00, 0x01, 0x7f})) {
            SCOPED_TRACE(testing::Message() << "byte " << i << " set to " << value);
            ++(refusedOrSound(changed(good, i, value)) ? taken : refused);
            ASSERT_FALSE(HasFailure());
        }
        SCOPED_TRACE(testing::Message() << "byte " << i << " set to a colour of what is locked");
        ++(refusedOrSound(changed(changed(good, i, 50), i + 1, 1)) ? taken : refused);
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(taken, 0);
    EXPECT_GT(refused, 0);
}

TEST(SnapshotLoad, RandomChangesWithAValidChecksumAreRefusedOrSound) {
    constexpr std::uint64_t kSeed = 17;
    support::RandomNumbers random(kSeed);
    const Bytes good = toBytes(smallWorld());
    for (int trial = 0; trial < support::draws(3000); ++trial) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", trial " << trial);
        Bytes bytes = good;
        for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) {
            bytes[random.below(good.size() - 8)] = static_cast<std::byte>(random.below(256));
        }
        const std::size_t size = random.below(4) == 0 ? 8 + random.below(good.size()) : good.size();
        bytes.resize(size); // some are truncated or padded with zeros
        seal(bytes);
        refusedOrSound(bytes);
        ASSERT_FALSE(HasFailure());
    }
}

/// Offset of the bytes of a number that the World contains once.
std::size_t placeOf(const Bytes& bytes, Real number) {
    StateStream stream;
    stream(number);
    const Bytes wanted = stream.takeWritten();
    const auto found = std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end());
    EXPECT_NE(found, bytes.end()) << number;
    return static_cast<std::size_t>(found - bytes.begin());
}

/// The refusal after one number was replaced.
std::string refusalWith(const World& world, Real number, Real instead) {
    Bytes bytes = toBytes(world);
    const std::size_t place = placeOf(bytes, number);
    StateStream stream;
    stream(instead);
    const Bytes other = stream.takeWritten();
    std::copy(other.begin(), other.end(), bytes.begin() + static_cast<std::ptrdiff_t>(place));
    seal(bytes);
    return refusalOf(bytes);
}

TEST(SnapshotRefused, ValuesThatDefinitionsRefuse) {
    World world({.lengthUnit = Real(1.75)});
    const BodyId ball = world.add({.shape = Circle{Real(1.125)},
                                   .material = {Real(0.875), Real(0.375), Real(0.625), 0},
                                   .density = Real(2.125)});
    const BodyId other = world.add(support::ballDef({5, 0}, 1));
    world.add(DistanceJoint{{ball, other}, Real(3.875), 1});
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const auto startsWith = [&](Real number, Real instead, const std::string& start) {
        const std::string refusal = refusalWith(world, number, instead);
        EXPECT_EQ(refusal.substr(0, start.size()), start);
    };
    startsWith(Real(1.75), -1, "lengthUnit: must be");
    startsWith(world.settings().soft().pushSpeed, -1, "settings.pushSpeed: must be");
    startsWith(Real(1.125), -1, "radius: must be");
    startsWith(Real(1.125), nan, "radius: must be");
    startsWith(Real(0.625), 3, "material.restitution: must be");
    startsWith(Real(2.125), 0, "density: must be");
    startsWith(Real(3.875), nan, "length: must be");
}

// Regression: a NaN in a contact was accepted, and was in a collision record then.
TEST(SnapshotRefused, NotANumberAtAnyPlace) {
    const Bytes good = toBytes(smallWorld());
    StateStream stream;
    Real number = std::numeric_limits<Real>::quiet_NaN();
    stream(number);
    const Bytes nan = stream.takeWritten();
    const auto isSound = [](const World& world) {
        for (const BodyId id : world.bodies()) {
            const BodyView body = world[id];
            if (!isFinite(body.position()) || !isFinite(body.velocity())) {
                return false;
            }
        }
        const auto finite = [](const CollisionRecord& record) {
            return isFinite(record.point) && isFinite(record.normal) &&
                   std::isfinite(record.separation + record.approachSpeed + record.maxImpulse +
                                 record.totalImpulse);
        };
        const std::span<const CollisionRecord> records = world.collisions();
        return std::all_of(records.begin(), records.end(), finite);
    };
    for (std::size_t place = 0; place + nan.size() <= good.size(); ++place) {
        Bytes bytes = good;
        std::copy(nan.begin(), nan.end(), bytes.begin() + static_cast<std::ptrdiff_t>(place));
        seal(bytes);
        try {
            World world = fromBytes(bytes);
            ASSERT_TRUE(isSound(world)) << "at byte " << place;
            world.step(kDt);
            ASSERT_TRUE(isSound(world)) << "after a step, at byte " << place;
        } catch (const BadSnapshot&) {
            // as it should be
        }
    }
}

// Fields of the engine are restored from the bytes. All others come from the caller, in equal
// number.
TEST(SnapshotRefused, AWrongNumberOfUserDefinedFields) {
    World world;
    const auto own = std::make_shared<Halved>();
    world.addField({own, {kMatchAny, 4}});
    world.addField({std::make_shared<Gravity>(Vec2{0, -1})});
    world.addField({own});
    const Bytes bytes = toBytes(world);
    using Given = std::vector<std::shared_ptr<const ForceField>>;
    for (const Given& given : {Given{}, Given{own}, Given{own, own, own}, Given{own, nullptr}}) {
        EXPECT_THROW(fromBytes(bytes, given), BadSnapshot) << given.size();
    }
    const World loaded = fromBytes(bytes, Given{own, own});
    ASSERT_EQ(loaded.fields().size(), 3u);
    EXPECT_EQ(loaded.fields()[0].field, own);
    EXPECT_EQ(loaded.fields()[0].which.required, 4);
    EXPECT_NE(dynamic_cast<const Gravity*>(loaded.fields()[1].field.get()), nullptr);
    EXPECT_EQ(loaded.fields()[2].field, own);
}

} // namespace
} // namespace kodo
