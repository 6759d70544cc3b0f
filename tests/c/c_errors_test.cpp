// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <new>
#include <stdexcept>
#include <thread>

#include "c_world.hpp"

namespace {

using namespace c_test;

/// The call fails with this status and sentence.
void expectError(kodo_Status expected, const std::string& sentence, kodo_Status status) {
    EXPECT_EQ(expected, status);
    EXPECT_EQ(sentence, kodo_errorText());
}

TEST(CErrors, ABadBodyHasTheSentenceOfCpp) {
    const CWorld world;
    kodo_BodyDef def = bodyAt(0, 0, kodo_circle(-1));
    kodo_BodyId id{};
    const kodo::BodyDef same{.shape = kodo::Circle{-1}};
    expectError(KODO_BAD_DEFINITION, kodo::check(same)->text(), kodo_addBody(world, &def, &id));
    std::size_t count = 1;
    EXPECT_OK(kodo_bodyCount(world, &count));
    EXPECT_EQ(0u, count);
}

TEST(CErrors, BadValuesOfEachCallHaveTheSentenceOfCpp) {
    const CWorld world;
    const kodo_BodyId id = world.add(bodyAt(0, 0));
    kodo::World other = cppWorld();
    const kodo::BodyId same = other.add({});
    const kodo_Real nan = std::numeric_limits<kodo_Real>::quiet_NaN();
    expectError(KODO_BAD_DEFINITION, sentenceOf([&] { other.step(2); }),
                kodo_step(world, 2, nullptr));
    expectError(KODO_BAD_DEFINITION, sentenceOf([&] {
                    other[same].setVelocity({nan, 0});
                }),
                kodo_setVelocity(world, id, kodo_vec2(nan, 0)));
    expectError(KODO_BAD_DEFINITION, sentenceOf([&] { other.joint({}); }),
                kodo_removeJoint(world, kodo_JointId{}));
    expectError(KODO_BAD_DEFINITION, sentenceOf([&] { kodo::rayCast(other, {}, {}); }),
                kodo_rayCast(world, kodo_Ray{}, nullptr, nullptr));
    kodo_Settings settings = kodo_settings(KODO_FAST);
    settings.soft.substeps = 65;
    kodo::StepSettings otherSettings = kodo::fast();
    otherSettings.soft().substeps = 65;
    expectError(KODO_BAD_DEFINITION, sentenceOf([&] { other.setSettings(otherSettings); }),
                kodo_setSettings(world, &settings));
    kodo_WorldDef def = kodo_worldDef();
    def.lengthUnit = 0;
    kodo_World* made = nullptr;
    expectError(KODO_BAD_DEFINITION, sentenceOf([] { kodo::World({.lengthUnit = 0}); }),
                kodo_createWorld(&def, &made));
    kodo_ThreadPool* pool = nullptr;
    expectError(KODO_BAD_DEFINITION, sentenceOf([] { kodo::ThreadPool(-1); }),
                kodo_createThreadPool(-1, &pool));
    kodo_Part part{};
    expectError(KODO_WRONG_USE, sentenceOf([&] { other[same].part(1); }),
                kodo_part(world, id, 1, &part, nullptr, 0));
}

TEST(CErrors, AnUnknownBodyHasTheSentenceOfCpp) {
    const CWorld world;
    const kodo_BodyId id = world.add(bodyAt(0, 0));
    kodo::World other = cppWorld();
    const kodo::BodyId same = other.add({});
    EXPECT_OK(kodo_removeBody(world, id));
    other.remove(same);
    expectError(KODO_BAD_ID, sentenceOf([&] { other.remove(same); }), kodo_removeBody(world, id));
    kodo_BodyState state{};
    expectError(KODO_BAD_ID, sentenceOf([&] { static_cast<void>(other[same].position()); }),
                kodo_bodyState(world, id, &state));
}

TEST(CErrors, BadBytesHaveTheSentenceOfCpp) {
    const std::array<std::byte, 5> bytes{};
    kodo_SnapshotDef def = kodo_snapshotDef();
    def.bytes = bytes.data();
    def.byteCount = bytes.size();
    kodo_World* made = nullptr;
    expectError(KODO_BAD_SNAPSHOT, sentenceOf([&] { kodo::fromBytes(bytes); }),
                kodo_fromBytes(&def, &made));
    kodo_Field gravity = kodo_field(KODO_GRAVITY);
    def.ownFields = &gravity;
    def.ownFieldCount = 1;
    expectError(KODO_BAD_DEFINITION, "ownFields: must be of the kind KODO_OWN_FIELD",
                kodo_fromBytes(&def, &made));
    EXPECT_EQ(nullptr, made);
}

TEST(CErrors, KindsBeyondTheLastAreRefused) {
    const CWorld world;
    kodo_BodyId id{};
    kodo_BodyDef body = bodyAt(0, 0, kodo_shapeOfKind(10));
    expectError(KODO_BAD_DEFINITION, "shape.kind: must be from 0 to 9, but is 10",
                kodo_addBody(world, &body, &id));
    body = bodyAt(0, 0);
    body.type = -1;
    expectError(KODO_BAD_DEFINITION, "type: must be from 0 to 2, but is -1",
                kodo_addBody(world, &body, &id));
    const kodo_Shape nested = kodo_compound(nullptr, 0);
    body = bodyAt(0, 0, kodo_compound(&nested, 1));
    expectError(KODO_BAD_DEFINITION,
                "shape.compound.parts: must be convex, not a compound, heightmap or chain",
                kodo_addBody(world, &body, &id));
    const kodo_JointDef joint = kodo_jointDef(99);
    kodo_JointId jointId{};
    expectError(KODO_BAD_DEFINITION, "kind: must be from 0 to 9, but is 99",
                kodo_addJoint(world, &joint, &jointId));
    const kodo_Field field = kodo_field(6);
    expectError(KODO_BAD_DEFINITION, "field.kind: must be from 0 to 5, but is 6",
                kodo_addField(world, &field));
    kodo_Field attractor = kodo_field(KODO_ATTRACTOR);
    attractor.attractor.law = 2;
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_addField(world, &attractor));
    const kodo_Settings settings = kodo_settings(4);
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_setSettings(world, &settings));
}

// A value beside a flag that is false would be dropped.
TEST(CErrors, AValueWithoutItsFlagIsRefused) {
    const CWorld world;
    const std::string sentence = ": is false, but the value that it stands for is set";
    kodo_BodyId id{};
    kodo_BodyDef body = bodyAt(0, 0);
    body.mass.mass = 5;
    expectError(KODO_BAD_DEFINITION, ("hasMass" + sentence).c_str(),
                kodo_addBody(world, &body, &id));
    body.mass.hasCenter = false;
    body.hasMass = true;
    body.mass.inertia = 2;
    expectError(KODO_BAD_DEFINITION, ("hasInertia" + sentence).c_str(),
                kodo_addBody(world, &body, &id));
    body.mass.inertia = 0;
    body.mass.center = {1, 0};
    expectError(KODO_BAD_DEFINITION, ("hasCenter" + sentence).c_str(),
                kodo_addBody(world, &body, &id));
    kodo_JointId jointId{};
    kodo_JointDef joint = kodo_jointDef(KODO_PRISMATIC_JOINT);
    joint.prismatic.limits = {-1, 1};
    expectError(KODO_BAD_DEFINITION, ("hasLimits" + sentence).c_str(),
                kodo_addJoint(world, &joint, &jointId));
    joint = kodo_jointDef(KODO_GEAR_JOINT);
    joint.gear.rack = {1, 0};
    expectError(KODO_BAD_DEFINITION, ("hasRack" + sentence).c_str(),
                kodo_addJoint(world, &joint, &jointId));
}

template <typename Definition>
void expectHeadsChecked(const char* type, const Definition& good,
                        kodo_Status (*use)(kodo_World*, const Definition*)) {
    const CWorld world;
    const std::string name(type);
    const std::string size = std::to_string(sizeof(Definition));
    Definition bad = good;
    bad.head = {};
    expectError(KODO_WRONG_USE,
                name + ": is not initialised; the function named after it, as kodo_bodyDef() for "
                       "kodo_BodyDef, makes one",
                use(world, &bad));
    bad.head = good.head;
    bad.head.size += 8;
    expectError(KODO_WRONG_USE,
                name + ": has " + std::to_string(sizeof(Definition) + 8) +
                    " bytes in version 3, but this library expects " + size +
                    " bytes in version 3; compile the program with the kodo.h of the library",
                use(world, &bad));
    bad.head = good.head;
    bad.head.version = 9;
    EXPECT_EQ(KODO_WRONG_USE, use(world, &bad));
    bad.head = good.head;
    bad.head.realSize = 12 - good.head.realSize; // the other precision
    EXPECT_EQ(KODO_WRONG_USE, use(world, &bad));
    EXPECT_NE(std::string::npos, std::string(kodo_errorText()).find("KODO_DOUBLE"));
    expectError(KODO_WRONG_USE, std::string(kodo_errorText()), use(world, &bad));
}

TEST(CErrors, ADefinitionOfAnotherHeaderIsRefused) {
    expectHeadsChecked<kodo_BodyDef>("kodo_BodyDef", kodo_bodyDef(),
                                     [](kodo_World* world, const kodo_BodyDef* def) {
                                         kodo_BodyId id{};
                                         return kodo_addBody(world, def, &id);
                                     });
    expectHeadsChecked<kodo_WorldDef>("kodo_WorldDef", kodo_worldDef(),
                                      [](kodo_World*, const kodo_WorldDef* def) {
                                          kodo_World* made = nullptr;
                                          return kodo_createWorld(def, &made);
                                      });
    expectHeadsChecked<kodo_Settings>("kodo_Settings", kodo_settings(KODO_FAST),
                                      [](kodo_World* world, const kodo_Settings* settings) {
                                          return kodo_setSettings(world, settings);
                                      });
    expectHeadsChecked<kodo_JointDef>("kodo_JointDef", kodo_jointDef(KODO_MOUSE_JOINT),
                                      [](kodo_World* world, const kodo_JointDef* def) {
                                          kodo_JointId id{};
                                          return kodo_addJoint(world, def, &id);
                                      });
    expectHeadsChecked<kodo_Field>(
        "kodo_Field", kodo_field(KODO_GRAVITY),
        [](kodo_World* world, const kodo_Field* field) { return kodo_addField(world, field); });
    expectHeadsChecked<kodo_StepOptions>("kodo_StepOptions", kodo_stepOptions(),
                                         [](kodo_World* world, const kodo_StepOptions* options) {
                                             return kodo_step(world, kDt, options);
                                         });
    expectHeadsChecked<kodo_Query>("kodo_Query", kodo_query(),
                                   [](kodo_World* world, const kodo_Query* query) {
                                       kodo_QueryHit hit{};
                                       return kodo_rayCast(world, {{0, 0}, {1, 0}}, query, &hit);
                                   });
    expectHeadsChecked<kodo_SnapshotDef>("kodo_SnapshotDef", kodo_snapshotDef(),
                                         [](kodo_World*, const kodo_SnapshotDef* def) {
                                             kodo_World* made = nullptr;
                                             return kodo_fromBytes(def, &made);
                                         });
}

TEST(CErrors, AnInitialiserWritesNoMoreThanTheCallerHas) {
    std::array<unsigned char, sizeof(kodo_BodyDef)> memory{};
    memory.fill(7);
    auto* def = reinterpret_cast<kodo_BodyDef*>(memory.data());
    kodo_Head head = kodo_headOf(sizeof(kodo_Head) + 8); // a smaller struct of another version
    EXPECT_EQ(KODO_WRONG_USE, kodo_initBodyDef(def, head));
    EXPECT_EQ(0, memory[sizeof(kodo_Head)]);
    EXPECT_EQ(7, memory[sizeof(kodo_Head) + 8]);
    head.size = 1;
    EXPECT_EQ(KODO_WRONG_USE, kodo_initBodyDef(def, head));
}

/// A change of the World from within its step, by each kind of callback.
TEST(CErrors, ChangesWithinAStepHaveTheSentenceOfCpp) {
    struct Within {
        CWorld world;
        kodo_Status add = KODO_OK;
        kodo_Status destroy = KODO_OK;
        kodo_Status copy = KODO_OK;
        std::string sentence;
    } within;
    within.world.add(bodyAt(0, 0));
    kodo_StepOptions options = kodo_stepOptions();
    options.context = &within;
    options.enterStage = [](void* context, kodo_StepStage) {
        auto& at = *static_cast<Within*>(context);
        kodo_BodyId id{};
        kodo_World* copy = nullptr;
        const kodo_BodyDef def = kodo_bodyDef();
        at.destroy = kodo_destroyWorld(at.world);
        at.copy = kodo_copyWorld(at.world, &copy);
        at.add = kodo_addBody(at.world, &def, &id);
        at.sentence = kodo_errorText();
    };
    EXPECT_OK(kodo_step(within.world, kDt, &options));
    EXPECT_EQ(KODO_WRONG_USE, within.add);
    EXPECT_EQ(KODO_WRONG_USE, within.destroy);
    EXPECT_EQ(KODO_WRONG_USE, within.copy);
    EXPECT_EQ("World::add is not possible within a step: note what is to be done, and do it after "
              "World::step() returns",
              within.sentence);
}

/// No exception of C++ crosses the interface, whatever its type.
TEST(CErrors, AnExceptionOfAVisitorBecomesAStatus) {
    const CWorld world;
    world.add(bodyAt(0, 0));
    const kodo_Ray ray{{-5, 0}, {5, 0}};
    const auto visit = [&](kodo_VisitHit visitor) {
        return kodo_visitRay(world, ray, nullptr, visitor, nullptr);
    };
    expectError(KODO_NO_MEMORY, "there is not enough memory",
                visit([](void*, const kodo_QueryHit*) -> bool { throw std::bad_alloc(); }));
    expectError(KODO_OTHER_ERROR, "text", visit([](void*, const kodo_QueryHit*) -> bool {
                    throw std::runtime_error("text");
                }));
    expectError(KODO_WRONG_USE, "text",
                visit([](void*, const kodo_QueryHit*) -> bool { throw std::logic_error("text"); }));
    expectError(KODO_OTHER_ERROR, "an exception that is no std::exception",
                visit([](void*, const kodo_QueryHit*) -> bool { throw 1; }));
    EXPECT_OK(visit([](void*, const kodo_QueryHit*) { return true; }));
    kodo_StepOptions options = kodo_stepOptions();
    options.leaveStages = [](void*) { throw std::runtime_error("the listener is out of order"); };
    expectError(KODO_OTHER_ERROR, "the listener is out of order", kodo_step(world, kDt, &options));
    const std::string longText(5000, 'x');
    static const std::string* thrown = nullptr;
    thrown = &longText;
    EXPECT_EQ(KODO_OTHER_ERROR, visit([](void*, const kodo_QueryHit*) -> bool {
                  throw std::runtime_error(*thrown);
              }));
    EXPECT_EQ(1023u, std::string(kodo_errorText()).size());
}

TEST(CErrors, EachThreadHasItsOwnSentence) {
    expectError(KODO_WRONG_USE, "world: must not be null", kodo_step(nullptr, kDt, nullptr));
    std::string before = "none";
    std::thread([&before] { before = kodo_errorText(); }).join();
    EXPECT_EQ("", before);
    EXPECT_STREQ("world: must not be null", kodo_errorText());
}

TEST(CErrors, TheLibraryTellsItsPrecisionAndVersion) {
    EXPECT_EQ(sizeof(kodo_Real), kodo_realSize());
    EXPECT_EQ(static_cast<unsigned>(KODO_VERSION), kodo_version());
}

} // namespace
