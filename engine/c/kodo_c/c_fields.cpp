// SPDX-License-Identifier: MIT
#include <kodo_c/c_fields.hpp>
#include <kodo_c/c_handles.hpp>

#include <utility>

namespace kodo_c {
namespace {

static_assert(KODO_GRAVITY == static_cast<int>(kodo::FieldKind::Gravity));
static_assert(KODO_DRAG == static_cast<int>(kodo::FieldKind::Drag));
static_assert(KODO_WIND == static_cast<int>(kodo::FieldKind::Wind));
static_assert(KODO_ATTRACTOR == static_cast<int>(kodo::FieldKind::Attractor));
static_assert(KODO_BUOYANCY == static_cast<int>(kodo::FieldKind::Buoyancy));
constexpr std::int32_t kFieldKinds = KODO_BUOYANCY + 1;

kodo_FieldBody fieldBodyOf(const kodo::BodyView& body, kodo::Real dt) {
    kodo_FieldBody made{};
    made.id = toC(body.id());
    made.flags = body.flags();
    made.transform = toC(body.transform());
    made.massFrame = toC(body.massFrame());
    made.midStep = toC(kodo::midStep(body, dt));
    made.velocity = toC(body.velocity());
    made.angularVelocity = body.angularVelocity();
    made.mass = body.mass();
    made.inertia = body.inertia();
    made.area = body.area();
    made.userData = body.userData();
    return made;
}

const OwnField* asOwn(const kodo::ForceField& field) {
    return dynamic_cast<const OwnField*>(&field);
}

/// The field of a World with this function and context, or null.
std::shared_ptr<const kodo::ForceField> sameField(const kodo::World& world,
                                                  const kodo_OwnField& callbacks) {
    for (const kodo::FieldEntry& entry : world.fields()) {
        const OwnField* own = asOwn(*entry.field);
        if (own != nullptr && own->callbacks().at == callbacks.at &&
            own->callbacks().context == callbacks.context) {
            return entry.field;
        }
    }
    return nullptr;
}

kodo::DragLaw lawFromC(const kodo_DragLaw& law) {
    return {law.linear, law.quadratic};
}
kodo_DragLaw lawToC(const kodo::DragLaw& law) {
    const auto& [linear, quadratic] = law;
    return {linear, quadratic};
}

std::shared_ptr<const kodo::ForceField> engineField(const kodo_Field& field) {
    switch (field.kind) {
    case KODO_GRAVITY:
        return std::make_shared<kodo::Gravity>(fromC(field.gravity.acceleration));
    case KODO_DRAG:
        return std::make_shared<kodo::Drag>(lawFromC(field.drag.law), fromC(field.drag.air));
    case KODO_WIND:
        return std::make_shared<kodo::Wind>(
            lawFromC(field.wind.law), fromC(field.wind.velocity),
            optionalFromC(field.wind.hasRegion, field.wind.region, "hasRegion"));
    case KODO_ATTRACTOR:
        requireKind(field.attractor.law, KODO_LINEAR + 1, "field.attractor.law");
        return std::make_shared<kodo::Attractor>(
            static_cast<kodo::Attractor::Law>(field.attractor.law), fromC(field.attractor.center),
            field.attractor.strength, field.attractor.softening);
    case KODO_BUOYANCY:
        return std::make_shared<kodo::Buoyancy>(
            kodo::Buoyancy::Fluid{field.buoyancy.density, field.buoyancy.drag},
            fromC(field.buoyancy.surface), fromC(field.buoyancy.gravity));
    default:
        requireKind(field.kind, kFieldKinds, "field.kind");
        return nullptr;
    }
}

kodo::FieldEntry entryFromC(const kodo_Field& field, const kodo::World& world, OwnFields& own) {
    requireHead(field.head, sizeof(kodo_Field), "kodo_Field");
    std::shared_ptr<const kodo::ForceField> made;
    if (field.kind == KODO_OWN_FIELD) {
        made = sameField(world, field.own);
        made = made ? made : own.add(field.own);
    } else {
        made = engineField(field);
    }
    return {std::move(made), fromC(field.which)};
}

void writeField(const kodo::ForceField& field, kodo_Field& made) {
    switch (field.kind()) {
    case kodo::FieldKind::Own:
        if (const OwnField* own = asOwn(field)) {
            made.own = own->callbacks();
        }
        break;
    case kodo::FieldKind::Gravity:
        made.gravity = {toC(static_cast<const kodo::Gravity&>(field).acceleration())};
        break;
    case kodo::FieldKind::Drag: {
        const auto& drag = static_cast<const kodo::Drag&>(field);
        made.drag = {lawToC(drag.law()), toC(drag.air())};
        break;
    }
    case kodo::FieldKind::Wind: {
        const auto& wind = static_cast<const kodo::Wind&>(field);
        const std::optional<kodo::Aabb> region = wind.region();
        made.wind = {lawToC(wind.law()), toC(wind.velocity()), region.has_value(),
                     region ? toC(*region) : kodo_Aabb{}};
        break;
    }
    case kodo::FieldKind::Attractor: {
        const auto& attractor = static_cast<const kodo::Attractor&>(field);
        made.attractor = {static_cast<kodo_AttractorLaw>(attractor.law()), toC(attractor.center()),
                          attractor.strength(), attractor.softening()};
        break;
    }
    case kodo::FieldKind::Buoyancy: {
        const auto& buoyancy = static_cast<const kodo::Buoyancy&>(field);
        const auto& [density, drag] = buoyancy.fluid();
        made.buoyancy = {density, drag, toC(buoyancy.surface()), toC(buoyancy.gravity())};
        break;
    }
    }
}

} // namespace

OwnField::~OwnField() {
    if (owns_ && callbacks_.destroy != nullptr) {
        try {
            callbacks_.destroy(callbacks_.context);
        } catch (...) { // a destructor has no caller to tell
        }
    }
}

kodo::FieldForce OwnField::at(const kodo::BodyView& body, kodo::Real dt) const {
    kodo_FieldForce made{};
    try {
        const kodo_FieldBody about = fieldBodyOf(body, dt);
        callbacks_.at(callbacks_.context, &about, dt, &made);
    } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failed_) {
            error_ = std::current_exception();
            failed_ = true;
        }
        return {};
    }
    return {fromC(made.force), made.torque, made.drag, made.spinDrag};
}

void OwnField::rethrow() const {
    if (!failed_) {
        return;
    }
    std::exception_ptr error;
    {
        const std::lock_guard lock(mutex_);
        std::swap(error, error_);
        failed_ = false;
    }
    if (error) {
        std::rethrow_exception(error);
    }
}

OwnFields::OwnFields(std::span<const kodo_Field> list) {
    for (const kodo_Field& field : list) {
        requireHead(field.head, sizeof(kodo_Field), "kodo_Field");
        if (field.kind != KODO_OWN_FIELD) {
            refuse("ownFields", "must be of the kind KODO_OWN_FIELD");
        }
        add(field.own);
    }
}

std::shared_ptr<const kodo::ForceField> OwnFields::add(const kodo_OwnField& callbacks) {
    if (callbacks.at == nullptr) {
        throw std::logic_error("field.own.at: must not be null");
    }
    for (const auto& field : fields_) {
        const kodo_OwnField& other = asOwn(*field)->callbacks();
        if (other.at == callbacks.at && other.context == callbacks.context) {
            fields_.push_back(field);
            return field;
        }
    }
    return fields_.emplace_back(std::make_shared<OwnField>(callbacks));
}

void OwnFields::keep() const {
    for (const auto& field : fields_) {
        asOwn(*field)->own();
    }
}

void rethrowFieldErrors(const kodo::World& world) {
    for (const kodo::FieldEntry& entry : world.fields()) {
        if (const OwnField* own = asOwn(*entry.field)) {
            own->rethrow();
        }
    }
}

kodo_Field toC(const kodo::FieldEntry& entry) {
    kodo_Field made{};
    made.head = kodo_headOf(sizeof(kodo_Field));
    made.which = toC(entry.which);
    made.kind = static_cast<kodo_FieldKind>(entry.field->kind());
    writeField(*entry.field, made);
    return made;
}

} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_initField(kodo_Field* field, kodo_Head head, kodo_FieldKind kind) {
    return guarded([&] {
        initialise(field, head, "kodo_Field");
        field->kind = kind;
        requireKind(kind, kFieldKinds, "kind");
    });
}

kodo_Status kodo_addField(kodo_World* world, const kodo_Field* field) {
    return guarded([&] {
        kodo::World& into = worldOf(world);
        OwnFields own;
        into.addField(entryFromC(checked(field, "field", "kodo_Field"), into, own));
        own.keep();
    });
}

kodo_Status kodo_setFields(kodo_World* world, const kodo_Field* fields, size_t count) {
    return guarded([&] {
        kodo::World& into = worldOf(world);
        OwnFields own;
        std::vector<kodo::FieldEntry> entries;
        for (const kodo_Field& field : itemsOf(fields, count, "fields")) {
            entries.push_back(entryFromC(field, into, own));
        }
        into.setFields(std::move(entries));
        own.keep();
    });
}

kodo_Status kodo_fields(const kodo_World* world, kodo_Field* fields, size_t capacity,
                        size_t* count) {
    return guarded([&] { writeList(worldOf(world).fields(), fields, capacity, count); });
}

kodo_Status kodo_applyForceToAll(kodo_World* world, kodo_Vec2 force, const kodo_Filter* which) {
    return guarded([&] {
        worldOf(world).applyForceToAll(fromC(force),
                                       which == nullptr ? kodo::CollisionFilter{} : fromC(*which));
    });
}

kodo_Status kodo_applyTorqueToAll(kodo_World* world, kodo_Real torque, const kodo_Filter* which) {
    return guarded([&] {
        worldOf(world).applyTorqueToAll(torque,
                                        which == nullptr ? kodo::CollisionFilter{} : fromC(*which));
    });
}
