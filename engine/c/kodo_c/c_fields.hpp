// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/force_field.hpp>
#include <kodo_c/c_values.hpp>

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace kodo_c {

/// A field of the user, whose force a function of C returns.
class OwnField final : public kodo::ForceField {
public:
    explicit OwnField(const kodo_OwnField& callbacks) : callbacks_(callbacks) {}
    ~OwnField() override;

    /// Force 0 if the function throws: rethrow() then throws its exception.
    kodo::FieldForce at(const kodo::BodyView& body, kodo::Real dt) const override;
    bool steady() const override { return callbacks_.steady; }

    const kodo_OwnField& callbacks() const { return callbacks_; }
    /// From now on, the end of the field calls `destroy`.
    void own() const { owns_ = true; }
    /// Throws the first exception since the last call.
    void rethrow() const;

private:
    kodo_OwnField callbacks_;
    mutable std::atomic<bool> owns_{false};
    // at() is called on several threads.
    mutable std::atomic<bool> failed_{false};
    mutable std::mutex mutex_;
    mutable std::exception_ptr error_;
};

/// Fields of the user that a call takes over. Until keep(), their contexts stay the caller's.
class OwnFields {
public:
    OwnFields() = default;
    /// Throws BadDefinition for a field of another kind.
    explicit OwnFields(std::span<const kodo_Field> list);

    std::shared_ptr<const kodo::ForceField> add(const kodo_OwnField& callbacks);
    std::span<const std::shared_ptr<const kodo::ForceField>> fields() const { return fields_; }
    void keep() const;

private:
    std::vector<std::shared_ptr<const kodo::ForceField>> fields_;
};

/// Throws an exception that a field of the user has thrown since the last call.
void rethrowFieldErrors(const kodo::World& world);

} // namespace kodo_c
