// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <kodo.h>
#include <string>
#include <vector>

/// The call succeeds.
#define EXPECT_OK(call) EXPECT_EQ(KODO_OK, (call)) << kodo_errorText()

namespace c_test {

constexpr kodo_Real kDt = kodo_Real(1) / 60; // s

/// A World of the C interface that its scope destroys.
class CWorld {
public:
    explicit CWorld(kodo_Real gravity = -10) {
        kodo_WorldDef def = kodo_worldDef();
        def.gravity.y = gravity;
        EXPECT_OK(kodo_createWorld(&def, &handle_));
    }
    explicit CWorld(kodo_World* handle) : handle_(handle) {}
    CWorld(const CWorld& other) { EXPECT_OK(kodo_copyWorld(other.handle_, &handle_)); }
    CWorld& operator=(const CWorld&) = delete;
    ~CWorld() { EXPECT_OK(kodo_destroyWorld(handle_)); }

    operator kodo_World*() const { return handle_; }

    kodo_BodyId add(const kodo_BodyDef& def) const {
        kodo_BodyId id{};
        EXPECT_OK(kodo_addBody(handle_, &def, &id));
        return id;
    }
    kodo_JointId add(const kodo_JointDef& def) const {
        kodo_JointId id{};
        EXPECT_OK(kodo_addJoint(handle_, &def, &id));
        return id;
    }
    void step(int count = 1) const {
        for (int i = 0; i < count; ++i) {
            EXPECT_OK(kodo_step(handle_, kodo_Real(1) / 60, nullptr));
        }
    }
    std::uint64_t hash() const {
        std::uint64_t value = 0;
        EXPECT_OK(kodo_stateHash(handle_, &value));
        return value;
    }
    std::vector<std::byte> bytes() const {
        std::size_t size = 0;
        EXPECT_OK(kodo_toBytes(handle_, nullptr, 0, &size));
        std::vector<std::byte> all(size);
        EXPECT_OK(kodo_toBytes(handle_, all.data(), all.size(), &size));
        return all;
    }
    kodo_BodyState state(kodo_BodyId id) const {
        kodo_BodyState read{};
        EXPECT_OK(kodo_bodyState(handle_, id, &read));
        return read;
    }

private:
    kodo_World* handle_ = nullptr;
};

inline kodo::World cppWorld(kodo::Real gravity = -10) {
    return kodo::World({.gravity = {0, gravity}});
}

/// A body of a shape, 0.5 m wide by default.
inline kodo_BodyDef bodyAt(kodo_Real x, kodo_Real y,
                           kodo_Shape shape = kodo_circle(kodo_Real(0.5))) {
    kodo_BodyDef def = kodo_bodyDef();
    def.shape = shape;
    def.position = kodo_vec2(x, y);
    return def;
}

inline kodo_BodyDef groundDef() {
    kodo_BodyDef def = bodyAt(0, 0, kodo_plane(kodo_vec2(0, 1), 0));
    def.type = KODO_STATIC;
    return def;
}

/// What an exception of C++ says.
template <typename Call>
std::string sentenceOf(Call&& call) {
    try {
        call();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no exception";
}

} // namespace c_test
