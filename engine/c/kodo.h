// SPDX-License-Identifier: MIT
#pragma once

/// C interface of Kodo, a 2D rigid-body engine: C11 or newer, and any C++. The library kodo_c
/// computes in float; kodo_c64 computes in double, and its users define KODO_DOUBLE. Both have the
/// same names, so a program links one of them.
///
/// CONVENTIONS
///   units       SI: metres, kilograms, seconds, radians. Density in kg/m^2, impulse in N s.
///   axes        x to the right, y up. Angles counter-clockwise.
///   frames      position is the origin of the shape's frame. Velocities are of the centre of mass.
///   status      each call returns KODO_OK or an error, and kodo_errorText() a sentence. After an
///               error nothing has changed, unless the comment of the call says so.
///   pointers    a null pointer is refused, unless the comment of the call permits it.
///   definitions a struct that begins with `head` is made by the function named after it, such as
///               kodo_bodyDef(), which sets the defaults of C++. Its size and version are checked.
///   lists       a call with `capacity` and `count` writes the first `capacity` items, and the
///               number of all to `count`. With capacity 0 the items may be null.
///   memory      of the caller: what a definition points to is copied. Worlds and pools are opaque.
///   threads     Worlds share no mutable data: each may be used on a thread of its own.
///   callbacks   must not jump out. A C++ exception from one is caught, and the call reports it.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if !defined(_WIN32)
#define KODO_C_API __attribute__((visibility("default")))
#elif defined(KODO_C_BUILD)
#define KODO_C_API __declspec(dllexport)
#else
#define KODO_C_API __declspec(dllimport)
#endif

#ifdef __cplusplus
extern "C" {
#endif

#ifdef KODO_DOUBLE
typedef double kodo_Real;
#else
typedef float kodo_Real;
#endif

// Errors.

typedef int32_t kodo_Status;
enum {
    KODO_OK = 0,
    KODO_BAD_DEFINITION = 1, // a value that cannot be used, or an unknown joint
    KODO_BAD_ID = 2,         // an unknown body
    KODO_BAD_SNAPSHOT = 3,   // bytes that are no snapshot, or not of this library
    KODO_WRONG_USE = 4,      // null pointer, definition of another header, change within a step
    KODO_NO_MEMORY = 5,      // the World of the call may then only be destroyed or assigned to
    KODO_OTHER_ERROR = 6     // no threads left, or an exception from a callback
};

/// Sentence of the last error of this thread, that of the C++ exception; "" if there was none.
/// Valid until the next call of this thread that fails.
KODO_C_API const char* kodo_errorText(void);
/// Version of the library, as KODO_VERSION: 1.3.5 is 10305.
KODO_C_API uint32_t kodo_version(void);
/// Number of bytes of the library's kodo_Real: 4 or 8.
KODO_C_API uint32_t kodo_realSize(void);

/// Raised with each change of a struct, an enumerator or a function.
#define KODO_C_VERSION 3

/// Begins a definition: which header it was compiled with.
typedef struct kodo_Head {
    size_t size;       // bytes of the whole struct
    uint32_t version;  // KODO_C_VERSION
    uint32_t realSize; // bytes of kodo_Real
} kodo_Head;

/// The head of a struct with a number of bytes.
static inline kodo_Head kodo_headOf(size_t size) {
    kodo_Head head;
    head.size = size;
    head.version = KODO_C_VERSION;
    head.realSize = sizeof(kodo_Real);
    return head;
}

// Plain values.

typedef struct kodo_Vec2 {
    kodo_Real x;
    kodo_Real y;
} kodo_Vec2;

/// A rotation: cosine and sine of its angle. {1, 0} is none.
typedef struct kodo_Rot {
    kodo_Real c;
    kodo_Real s;
} kodo_Rot;

/// Pose of a frame: rotation, then translation by `position` (m).
typedef struct kodo_Transform {
    kodo_Vec2 position;
    kodo_Rot rotation;
} kodo_Transform;

/// Axis-aligned box (m), corners included.
typedef struct kodo_Aabb {
    kodo_Vec2 lower;
    kodo_Vec2 upper;
} kodo_Aabb;

/// From lower to upper, both included.
typedef struct kodo_Range {
    kodo_Real lower;
    kodo_Real upper;
} kodo_Range;

static inline kodo_Vec2 kodo_vec2(kodo_Real x, kodo_Real y) {
    kodo_Vec2 v;
    v.x = x;
    v.y = y;
    return v;
}
/// A local point in the world: t.rotation * p + t.position.
static inline kodo_Vec2 kodo_toWorld(kodo_Transform t, kodo_Vec2 p) {
    return kodo_vec2(t.rotation.c * p.x - t.rotation.s * p.y + t.position.x,
                     t.rotation.s * p.x + t.rotation.c * p.y + t.position.y);
}
/// A point of the world in the frame t.
static inline kodo_Vec2 kodo_toLocal(kodo_Transform t, kodo_Vec2 p) {
    const kodo_Vec2 d = kodo_vec2(p.x - t.position.x, p.y - t.position.y);
    return kodo_vec2(t.rotation.c * d.x + t.rotation.s * d.y,
                     t.rotation.c * d.y - t.rotation.s * d.x);
}
/// The rotation by an angle (rad), and the angle of a rotation, -pi to pi: the same bits on every
/// machine.
KODO_C_API kodo_Rot kodo_rotation(kodo_Real radians);
KODO_C_API kodo_Real kodo_angle(kodo_Rot rotation);

/// Names a body of a World and of its copies. All zero names none.
typedef struct kodo_BodyId {
    uint32_t index;
    uint32_t generation;
    uint32_t world; // stamp of the World; 0 fits every World
} kodo_BodyId;

/// Names a joint.
typedef struct kodo_JointId {
    uint32_t index;
    uint32_t generation;
    uint32_t world;
} kodo_JointId;

static inline bool kodo_sameBody(kodo_BodyId a, kodo_BodyId b) {
    return a.index == b.index && a.generation == b.generation;
}

// Flags of a body. Bits 16 to 31 have a meaning for the engine. The other 48 are categories of the
// user, and filters compare them.

#define KODO_USER_FLAGS UINT64_C(0xffffffff0000ffff)
typedef uint64_t kodo_Flags;
enum {
    KODO_LOCK_MOVE = 1 << 16,        // infinite mass
    KODO_LOCK_ROTATE = 1 << 17,      // infinite moment of inertia
    KODO_DISABLED = 1 << 18,         // collides with nothing, no query finds it
    KODO_ASLEEP = 1 << 19,           // status
    KODO_NEVER_SLEEP = 1 << 20,      // the body keeps its island awake
    KODO_COLLIDING = 1 << 21,        // status: touched something in the last step
    KODO_SENSOR = 1 << 22,           // detects overlap, without any response
    KODO_FROZEN = 1 << 23,           // status: see kodo_frozenBodies()
    KODO_OUTSIDE = 1 << 24,          // status: outside the region
    KODO_NO_SENSORS = 1 << 25,       // of queries alone: parts that are sensors are left out
    KODO_DEFAULT_CATEGORY = 1 << 26, // of `required` alone: bodies without a category
    KODO_MATCH_NONE = 1 << 27,       // none of the required flags is set
    KODO_MATCH_ANY = 1 << 28,        // at least one of the required flags is set
    KODO_MATCH_ALL = 1 << 29,        // all of them are set
    KODO_MATCH_EQUAL = 1 << 30       // exactly these are set
};

/// Which bodies a query or a field concerns. All zero: all.
typedef struct kodo_Filter {
    kodo_Flags flags;    // at most one of KODO_MATCH_NONE to KODO_MATCH_EQUAL; KODO_NO_SENSORS
    kodo_Flags required; // user flags that the mode compares with those of a body
    int32_t group;       // before the mode: > 0 finds the bodies of the group, < 0 leaves them out
} kodo_Filter;

typedef int32_t kodo_BodyType;
enum { KODO_DYNAMIC = 0, KODO_KINEMATIC = 1, KODO_STATIC = 2 };

/// Against which bodies continuous collision checks a body. Of a pair, the lower mode counts.
typedef int32_t kodo_ContinuousMode;
enum { KODO_CONTINUOUS_NEVER = 0, KODO_CONTINUOUS_STATIC = 1, KODO_CONTINUOUS_ALL = 2 };

/// How a coefficient of a contact follows from those of its two parts. Of two rules, the later one
/// counts.
typedef uint8_t kodo_MixRule;
enum {
    KODO_GEOMETRIC_MEAN = 0,
    KODO_MINIMUM = 1,
    KODO_MEAN = 2,
    KODO_MULTIPLY = 3,
    KODO_MAXIMUM = 4
};

/// Surface of a body or a part.
typedef struct kodo_Material {
    kodo_Real staticFriction;    // >= kineticFriction
    kodo_Real kineticFriction;   // >= 0
    kodo_Real restitution;       // 0 to 2; above 1 an impact adds energy
    kodo_Real rollingResistance; // >= 0; lever arm of the braking torque, as share of the radius
    kodo_Real surfaceSpeed;      // m/s, clockwise around the body, as of a belt
    kodo_MixRule frictionRule;
    kodo_MixRule restitutionRule;
} kodo_Material;

static inline kodo_Material kodo_withFriction(kodo_Real friction, kodo_Real restitution) {
    kodo_Material material;
    material.staticFriction = material.kineticFriction = friction;
    material.restitution = restitution;
    material.rollingResistance = 0;
    material.surfaceSpeed = 0;
    material.frictionRule = KODO_GEOMETRIC_MEAN;
    material.restitutionRule = KODO_MINIMUM;
    return material;
}

// Shapes, in the frame of the body (m). kodo_circle() and the other functions make them.

typedef struct kodo_Circle {
    kodo_Real radius; // > 0
    kodo_Vec2 center;
} kodo_Circle;

typedef struct kodo_Box {
    kodo_Real width;  // > 0, without the radius
    kodo_Real height; // > 0, without the radius
    kodo_Vec2 center;
    kodo_Rot rotation;
    kodo_Real radius; // >= 0, around the rectangle
} kodo_Box;

typedef struct kodo_Polygon {
    const kodo_Vec2* corners; // counter-clockwise, strictly convex
    size_t cornerCount;       // 3 to 1024
    kodo_Real radius;         // >= 0, around the outline
} kodo_Polygon;

/// Several shapes as one body.
typedef struct kodo_Compound {
    const struct kodo_Shape* parts; // none of them a compound, heightmap or chain
    size_t partCount;               // 1 to 65535
} kodo_Compound;

/// A particle; the number given as density is its mass (kg).
typedef struct kodo_Point {
    kodo_Vec2 position;
} kodo_Point;

/// A line. Its density is a mass per length (kg/m), with a radius per area. A one-sided one
/// collides with what comes from the left of from -> to.
typedef struct kodo_Segment {
    kodo_Vec2 from;
    kodo_Vec2 to;
    bool oneSided;
    kodo_Real radius; // >= 0; two-sided only
} kodo_Segment;

/// The points p with dot(normal, p) <= offset; static and kinematic bodies only.
typedef struct kodo_Plane {
    kodo_Vec2 normal; // unit
    kodo_Real offset;
} kodo_Plane;

/// One-sided ground between the points origin + (i spacing, heights[i]); not for dynamic bodies.
typedef struct kodo_Heightmap {
    kodo_Vec2 origin;
    kodo_Real spacing; // > 0
    const kodo_Real* heights;
    size_t heightCount; // 2 to 65536
} kodo_Heightmap;

/// Linked segments from each point to the next.
typedef struct kodo_Chain {
    const kodo_Vec2* points;
    size_t pointCount; // 2 to 65536; closed: 3 to 65535
    bool closed;
    bool oneSided;                  // front: left of the points, or outside if closed
    const kodo_Material* materials; // of each segment, or null: that of the body
    size_t materialCount;
} kodo_Chain;

typedef struct kodo_Capsule {
    kodo_Vec2 from;
    kodo_Vec2 to;
    kodo_Real radius; // > 0
} kodo_Capsule;

typedef int32_t kodo_ShapeKind;
enum {
    KODO_CIRCLE = 0,
    KODO_BOX = 1,
    KODO_POLYGON = 2,
    KODO_COMPOUND = 3,
    KODO_POINT = 4,
    KODO_SEGMENT = 5,
    KODO_PLANE = 6,
    KODO_HEIGHTMAP = 7,
    KODO_CHAIN = 8,
    KODO_CAPSULE = 9
};

typedef struct kodo_Shape {
    kodo_ShapeKind kind; // which of the following counts
    union {
        kodo_Circle circle;
        kodo_Box box;
        kodo_Polygon polygon;
        kodo_Compound compound;
        kodo_Point point;
        kodo_Segment segment;
        kodo_Plane plane;
        kodo_Heightmap heightmap;
        kodo_Chain chain;
        kodo_Capsule capsule;
    };
} kodo_Shape;

static inline kodo_Shape kodo_shapeOfKind(kodo_ShapeKind kind) {
    kodo_Shape shape;
    memset(&shape, 0, sizeof(shape));
    shape.kind = kind;
    return shape;
}
static inline kodo_Shape kodo_circle(kodo_Real radius) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_CIRCLE);
    shape.circle.radius = radius;
    return shape;
}
static inline kodo_Shape kodo_box(kodo_Real width, kodo_Real height) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_BOX);
    shape.box.width = width;
    shape.box.height = height;
    shape.box.rotation.c = 1;
    return shape;
}
static inline kodo_Shape kodo_polygon(const kodo_Vec2* corners, size_t cornerCount) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_POLYGON);
    shape.polygon.corners = corners;
    shape.polygon.cornerCount = cornerCount;
    return shape;
}
static inline kodo_Shape kodo_compound(const kodo_Shape* parts, size_t partCount) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_COMPOUND);
    shape.compound.parts = parts;
    shape.compound.partCount = partCount;
    return shape;
}
static inline kodo_Shape kodo_point(kodo_Vec2 position) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_POINT);
    shape.point.position = position;
    return shape;
}
static inline kodo_Shape kodo_segment(kodo_Vec2 from, kodo_Vec2 to) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_SEGMENT);
    shape.segment.from = from;
    shape.segment.to = to;
    return shape;
}
static inline kodo_Shape kodo_plane(kodo_Vec2 normal, kodo_Real offset) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_PLANE);
    shape.plane.normal = normal;
    shape.plane.offset = offset;
    return shape;
}
static inline kodo_Shape kodo_heightmap(kodo_Real spacing, const kodo_Real* heights,
                                        size_t heightCount) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_HEIGHTMAP);
    shape.heightmap.spacing = spacing;
    shape.heightmap.heights = heights;
    shape.heightmap.heightCount = heightCount;
    return shape;
}
static inline kodo_Shape kodo_chain(const kodo_Vec2* points, size_t pointCount) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_CHAIN);
    shape.chain.points = points;
    shape.chain.pointCount = pointCount;
    return shape;
}
static inline kodo_Shape kodo_capsule(kodo_Vec2 from, kodo_Vec2 to, kodo_Real radius) {
    kodo_Shape shape = kodo_shapeOfKind(KODO_CAPSULE);
    shape.capsule.from = from;
    shape.capsule.to = to;
    shape.capsule.radius = radius;
    return shape;
}

// Polygons from points (m).

/// The corners of the smallest convex polygon around points in any order.
KODO_C_API kodo_Status kodo_convexHull(const kodo_Vec2* points, size_t pointCount,
                                       kodo_Vec2* corners, size_t capacity, size_t* count);

/// Convex polygons in memory of the caller: their corners one after the other, and how many each
/// has. What has no room is counted alone.
typedef struct kodo_Polygons {
    kodo_Vec2* corners; // may be null with cornerCapacity 0
    size_t cornerCapacity;
    size_t cornerCount; // written: of all polygons
    size_t* sizes;      // may be null with capacity 0
    size_t capacity;
    size_t count; // written: number of polygons
} kodo_Polygons;

/// Divides a concave outline, in either direction, into convex polygons: the parts of a compound.
KODO_C_API kodo_Status kodo_decompose(const kodo_Vec2* outline, size_t pointCount,
                                      kodo_Polygons* polygons);

// Settings of a World.

typedef int32_t kodo_SolverKind;
enum { KODO_SOFT = 0, KODO_PROPAGATION = 1 };

/// Substeps of soft contacts.
typedef struct kodo_SoftSettings {
    int32_t substeps;         // 1 to 64
    int32_t impactPasses;     // 0 to 1000
    kodo_Real contactHertz;   // > 0, up to 1e9
    kodo_Real contactDamping; // > 0, up to 1e6; 1 is critical
    kodo_Real jointHertz;     // > 0, up to 1e9
    kodo_Real jointDamping;   // > 0, up to 1e6
    kodo_Real pushSpeed;      // > 0, up to 1e7; length units/s
    kodo_Real jointGap;       // 1e-4 to 1e4; share of the smaller body's size
} kodo_SoftSettings;

/// The solver of the thesis, with shock propagation.
typedef struct kodo_PropagationSettings {
    int32_t substeps;      // 1 to 64
    int32_t impactPasses;  // 0 to 1000
    int32_t contactPasses; // 1 to 1000
    int32_t shockPasses;   // 0 to 1000; 0: no shock propagation
    kodo_Real jointHertz;
    kodo_Real jointDamping;
    kodo_Real pushSpeed;
} kodo_PropagationSettings;

/// Features that a step can leave out.
typedef uint8_t kodo_Features;
enum {
    KODO_FRICTION = 1,
    KODO_ROLLING_RESISTANCE = 2,
    KODO_RESTITUTION = 4,
    KODO_CONTINUOUS_COLLISION = 8,
    KODO_RECORDS = 16,
    KODO_SLEEP = 32,
    KODO_ROTATION = 64,
    KODO_COLLISION = 128
};

typedef struct kodo_Settings {
    kodo_Head head;
    kodo_SolverKind solver; // which of the following counts
    union {
        kodo_SoftSettings soft;
        kodo_PropagationSettings propagation;
    };
    int32_t sleepSteps; // 1 to 1000000; calm steps before an island falls asleep
    kodo_Features leaveOut;
} kodo_Settings;

/// Sets of all settings. A World has KODO_BALANCED by default.
typedef int32_t kodo_Profile;
enum { KODO_FAST = 0, KODO_BALANCED = 1, KODO_ACCURATE = 2, KODO_THESIS_2006 = 3 };

KODO_C_API kodo_Status kodo_initSettings(kodo_Settings* settings, kodo_Head head,
                                         kodo_Profile profile);
/// The settings of a profile. Of an unknown one, settings that each call refuses.
static inline kodo_Settings kodo_settings(kodo_Profile profile) {
    kodo_Settings settings;
    kodo_initSettings(&settings, kodo_headOf(sizeof(kodo_Settings)), profile);
    return settings;
}

// Worlds.

/// Bodies, joints, fields and their simulation.
typedef struct kodo_World kodo_World;
/// Threads that help a step.
typedef struct kodo_ThreadPool kodo_ThreadPool;

typedef struct kodo_WorldDef {
    kodo_Head head;
    kodo_Vec2 gravity;    // m/s^2; the first field, unless it is zero
    kodo_Real lengthUnit; // m; size of a typical body
    kodo_Settings settings;
} kodo_WorldDef;

KODO_C_API kodo_Status kodo_initWorldDef(kodo_WorldDef* def, kodo_Head head);
static inline kodo_WorldDef kodo_worldDef(void) {
    kodo_WorldDef def;
    kodo_initWorldDef(&def, kodo_headOf(sizeof(kodo_WorldDef)));
    return def;
}

/// `def` may be null: the defaults, without gravity.
KODO_C_API kodo_Status kodo_createWorld(const kodo_WorldDef* def, kodo_World** world);
/// Another World with the same state and ids: a snapshot in memory.
KODO_C_API kodo_Status kodo_copyWorld(const kodo_World* from, kodo_World** world);
/// Makes `into` equal to `from`, without a new World.
KODO_C_API kodo_Status kodo_assignWorld(kodo_World* into, const kodo_World* from);
/// Refused within a step or a visit of the World.
KODO_C_API kodo_Status kodo_destroyWorld(kodo_World* world);

KODO_C_API kodo_Status kodo_worldSettings(const kodo_World* world, kodo_Settings* settings);
KODO_C_API kodo_Status kodo_setSettings(kodo_World* world, const kodo_Settings* settings);
/// Simulates only bodies whose bounds meet the region (m, world). Null: all.
KODO_C_API kodo_Status kodo_setRegion(kodo_World* world, const kodo_Aabb* region);
/// `set` becomes false if there is no region.
KODO_C_API kodo_Status kodo_region(const kodo_World* world, kodo_Aabb* region, bool* set);

// Bodies.

/// A mass that is set, instead of that of shape and density.
typedef struct kodo_MassDef {
    kodo_Real mass; // kg
    bool hasCenter;
    kodo_Vec2 center; // m, in the frame of the shape; else that of the shapes
    bool hasInertia;
    kodo_Real inertia; // kg m^2, about the centre of mass; else that of the shapes, scaled
} kodo_MassDef;

typedef struct kodo_BodyDef {
    kodo_Head head;
    kodo_Shape shape;          // default: a circle of radius 0.5
    kodo_Vec2 position;        // m, world: origin of the shape's frame
    kodo_Rot rotation;         // of the shape's frame
    kodo_Vec2 velocity;        // m/s, of the centre of mass
    kodo_Real angularVelocity; // rad/s, counter-clockwise
    kodo_Material material;    // of all parts
    kodo_Real density;         // kg/m^2
    bool hasMass;
    kodo_MassDef mass;        // instead of that of the density
    kodo_Real linearDamping;  // 1/s, 0 to 1e6: v(t) = v exp(-c t) without forces
    kodo_Real angularDamping; // 1/s, likewise
    kodo_Real gravityScale;   // of the forces of all gravity fields
    kodo_ContinuousMode continuousMode;
    kodo_BodyType type;
    kodo_Flags flags;
    kodo_Flags required; // user flags, see kodo_Filter; needs a match mode in `flags`
    int32_t group;     // bodies of one group collide if it is > 0, and do not if it is < 0; 0: none
    uint64_t userData; // the engine never reads it
} kodo_BodyDef;

KODO_C_API kodo_Status kodo_initBodyDef(kodo_BodyDef* def, kodo_Head head);
static inline kodo_BodyDef kodo_bodyDef(void) {
    kodo_BodyDef def;
    kodo_initBodyDef(&def, kodo_headOf(sizeof(kodo_BodyDef)));
    return def;
}

KODO_C_API kodo_Status kodo_addBody(kodo_World* world, const kodo_BodyDef* def, kodo_BodyId* id);
/// Removes a body and its joints.
KODO_C_API kodo_Status kodo_removeBody(kodo_World* world, kodo_BodyId id);
/// Adds a copy of a body at another position (m, world).
KODO_C_API kodo_Status kodo_cloneBody(kodo_World* world, kodo_BodyId id, kodo_Vec2 position,
                                      kodo_BodyId* clone);
KODO_C_API kodo_Status kodo_containsBody(const kodo_World* world, kodo_BodyId id, bool* contained);
KODO_C_API kodo_Status kodo_bodyCount(const kodo_World* world, size_t* count);
/// In the order of ids.
KODO_C_API kodo_Status kodo_bodies(const kodo_World* world, kodo_BodyId* ids, size_t capacity,
                                   size_t* count);
/// The bodies that moved or fell asleep in the last step, in the order of ids.
KODO_C_API kodo_Status kodo_movedBodies(const kodo_World* world, kodo_BodyId* ids, size_t capacity,
                                        size_t* count);

/// All that can be read of one body.
typedef struct kodo_BodyState {
    kodo_BodyId id;
    kodo_BodyType type;
    kodo_Transform transform;  // of the shape's frame
    kodo_Transform massFrame;  // of the centre of mass: its position is the centre of mass (m)
    kodo_Vec2 velocity;        // m/s, of the centre of mass
    kodo_Real angularVelocity; // rad/s
    kodo_Real mass;            // kg
    kodo_Real inertia;         // kg m^2, about the centre of mass
    kodo_Vec2 localCenter;     // m, in the frame of the shape
    kodo_Real area;            // m^2; overlapping parts count twice
    kodo_Aabb bounds;          // m, world
    kodo_Flags flags;
    kodo_Flags required;
    int32_t group;
    bool hasSetMass;
    bool isAsleep;
    uint64_t userData;
    size_t partCount;
    kodo_Real linearDamping;  // 1/s
    kodo_Real angularDamping; // 1/s
    kodo_Real gravityScale;
    kodo_ContinuousMode continuousMode;
} kodo_BodyState;

KODO_C_API kodo_Status kodo_bodyState(const kodo_World* world, kodo_BodyId id,
                                      kodo_BodyState* state);
/// Velocity (m/s) of a body at a point of the world (m).
KODO_C_API kodo_Status kodo_velocityAt(const kodo_World* world, kodo_BodyId id, kodo_Vec2 point,
                                       kodo_Vec2* velocity);
/// Whether a point of the world (m) is inside a body or on its edge.
KODO_C_API kodo_Status kodo_containsPoint(const kodo_World* world, kodo_BodyId id, kodo_Vec2 point,
                                          bool* contained);

/// One convex part of a body.
typedef struct kodo_Part {
    kodo_Shape shape; // in the frame of the body's shape; the corners of a polygon: see kodo_part()
    kodo_Material material;
    kodo_Real density; // kg/m^2
    bool hasFilter;
    kodo_Filter filter; // instead of the filter and the KODO_SENSOR of the body
    uint64_t userData;  // the engine never reads it
} kodo_Part;

/// Reads a part. Its corners, if it is a polygon, are written to `corners`, at most `capacity` of
/// them, and `cornerCount` is the number of all. With capacity 0, `corners` may be null.
KODO_C_API kodo_Status kodo_part(const kodo_World* world, kodo_BodyId id, size_t index,
                                 kodo_Part* part, kodo_Vec2* corners, size_t capacity);

KODO_C_API kodo_Status kodo_setPosition(kodo_World* world, kodo_BodyId id, kodo_Vec2 position);
KODO_C_API kodo_Status kodo_setRotation(kodo_World* world, kodo_BodyId id, kodo_Rot rotation);
KODO_C_API kodo_Status kodo_setVelocity(kodo_World* world, kodo_BodyId id, kodo_Vec2 velocity);
KODO_C_API kodo_Status kodo_setAngularVelocity(kodo_World* world, kodo_BodyId id,
                                               kodo_Real radiansPerSecond);
/// Sets the velocities that bring the shape's frame to a position or pose in one step of dt (s).
KODO_C_API kodo_Status kodo_moveTo(kodo_World* world, kodo_BodyId id, kodo_Vec2 position,
                                   kodo_Real dt);
KODO_C_API kodo_Status kodo_moveToPose(kodo_World* world, kodo_BodyId id, kodo_Transform pose,
                                       kodo_Real dt);
/// N, during the next step: at the centre of mass, or at a point of the world (m).
KODO_C_API kodo_Status kodo_applyForce(kodo_World* world, kodo_BodyId id, kodo_Vec2 force);
KODO_C_API kodo_Status kodo_applyForceAt(kodo_World* world, kodo_BodyId id, kodo_Vec2 force,
                                         kodo_Vec2 point);
KODO_C_API kodo_Status kodo_applyTorque(kodo_World* world, kodo_BodyId id, kodo_Real torque);
/// N s, at once: at the centre of mass, or at a point of the world (m).
KODO_C_API kodo_Status kodo_applyImpulse(kodo_World* world, kodo_BodyId id, kodo_Vec2 impulse);
KODO_C_API kodo_Status kodo_applyImpulseAt(kodo_World* world, kodo_BodyId id, kodo_Vec2 impulse,
                                           kodo_Vec2 point);
/// N m s, counter-clockwise.
KODO_C_API kodo_Status kodo_applyAngularImpulse(kodo_World* world, kodo_BodyId id,
                                                kodo_Real impulse);
KODO_C_API kodo_Status kodo_setType(kodo_World* world, kodo_BodyId id, kodo_BodyType type);
KODO_C_API kodo_Status kodo_setFlags(kodo_World* world, kodo_BodyId id, kodo_Flags flags);
KODO_C_API kodo_Status kodo_setRequired(kodo_World* world, kodo_BodyId id, kodo_Flags required);
KODO_C_API kodo_Status kodo_setGroup(kodo_World* world, kodo_BodyId id, int32_t group);
KODO_C_API kodo_Status kodo_setUserData(kodo_World* world, kodo_BodyId id, uint64_t userData);
/// Of all parts.
KODO_C_API kodo_Status kodo_setMaterial(kodo_World* world, kodo_BodyId id,
                                        const kodo_Material* material);
/// Changes a part. A set mass stays: then the shape must stay too.
KODO_C_API kodo_Status kodo_setPart(kodo_World* world, kodo_BodyId id, size_t index,
                                    const kodo_Part* part);
KODO_C_API kodo_Status kodo_setLinearDamping(kodo_World* world, kodo_BodyId id,
                                             kodo_Real perSecond);
KODO_C_API kodo_Status kodo_setAngularDamping(kodo_World* world, kodo_BodyId id,
                                              kodo_Real perSecond);
KODO_C_API kodo_Status kodo_setGravityScale(kodo_World* world, kodo_BodyId id, kodo_Real scale);
KODO_C_API kodo_Status kodo_setContinuousMode(kodo_World* world, kodo_BodyId id,
                                              kodo_ContinuousMode mode);
KODO_C_API kodo_Status kodo_setMass(kodo_World* world, kodo_BodyId id, const kodo_MassDef* mass);
KODO_C_API kodo_Status kodo_setMassFromDensity(kodo_World* world, kodo_BodyId id);
/// Makes a body move as another one, of this or another World, with its own shapes.
KODO_C_API kodo_Status kodo_copyBodyFrom(kodo_World* world, kodo_BodyId id, const kodo_World* from,
                                         kodo_BodyId other);
KODO_C_API kodo_Status kodo_wake(kodo_World* world, kodo_BodyId id);
/// Puts the island of the body to sleep. `asleep` is false if something keeps it awake.
KODO_C_API kodo_Status kodo_sleep(kodo_World* world, kodo_BodyId id, bool* asleep);

/// Makes the parts of `part` parts of `into`, and removes `part`. `first` is the index of the first
/// part added.
KODO_C_API kodo_Status kodo_weld(kodo_World* world, kodo_BodyId into, kodo_BodyId part,
                                 size_t* first);
/// Adds a part in the frame of the shape of `into`. The corners of its polygon are copied.
KODO_C_API kodo_Status kodo_weldPart(kodo_World* world, kodo_BodyId into, const kodo_Part* part,
                                     size_t* first);
/// Makes a part a body of its own. With `flags`, which may be null, a dynamic one with these flags.
KODO_C_API kodo_Status kodo_unweld(kodo_World* world, kodo_BodyId body, size_t part,
                                   const kodo_Flags* flags, kodo_BodyId* id);

// Many bodies of many Worlds in one call, for one World `&world, 1`. Each id names a body of each
// World, as copies accept the ids of their original. Values of worlds[w] and ids[i] stand at index
// w * idCount + i. After an error, what lies before it in this order is done.

typedef struct kodo_Velocity {
    kodo_Vec2 linear;  // m/s, of the centre of mass
    kodo_Real angular; // rad/s
} kodo_Velocity;

/// Force and torque of a body during the next step.
typedef struct kodo_Load {
    kodo_Vec2 force;  // N, at the centre of mass
    kodo_Real torque; // N m, counter-clockwise
} kodo_Load;

KODO_C_API kodo_Status kodo_poses(kodo_World* const* worlds, size_t worldCount,
                                  const kodo_BodyId* ids, size_t idCount, kodo_Transform* poses);
KODO_C_API kodo_Status kodo_velocities(kodo_World* const* worlds, size_t worldCount,
                                       const kodo_BodyId* ids, size_t idCount,
                                       kodo_Velocity* velocities);
KODO_C_API kodo_Status kodo_applyLoads(kodo_World* const* worlds, size_t worldCount,
                                       const kodo_BodyId* ids, size_t idCount,
                                       const kodo_Load* loads);
KODO_C_API kodo_Status kodo_setVelocities(kodo_World* const* worlds, size_t worldCount,
                                          const kodo_BodyId* ids, size_t idCount,
                                          const kodo_Velocity* velocities);

// Joints. Forces and torques are those on body b; a feels the opposite.

/// What all joints between two bodies have.
typedef struct kodo_JointEnds {
    kodo_BodyId a;
    kodo_BodyId b;
    kodo_Vec2 anchorA;     // m, in the frame of a's shape
    kodo_Vec2 anchorB;     // m, in the frame of b's shape
    kodo_Real breakForce;  // N, > 0; default: infinite
    kodo_Real breakTorque; // N m, > 0; default: infinite
    bool collide;          // true: the two bodies collide with each other
    uint64_t userData;     // for the user
} kodo_JointEnds;

/// With a spring, a ratchet, or limits beyond -3 to 3 rad, the joint counts its turns.
typedef struct kodo_RevoluteJoint {
    kodo_JointEnds ends;
    kodo_Real reference; // rad; relative angle of b that counts as 0
    bool hasLimits;
    kodo_Range limits;     // rad
    kodo_Real motorSpeed;  // rad/s, of b relative to a
    kodo_Real motorTorque; // N m, >= 0; 0: no motor
    kodo_Real target;      // rad, rest angle of the spring
    kodo_Real hertz;       // stiffness, as frequency about the anchor; 0: no spring
    kodo_Real damping;     // damping ratio; 1 is critical
    kodo_Real ratchet;     // rad between teeth: the lower limit follows; < 0: the upper; 0: none
} kodo_RevoluteJoint;

typedef struct kodo_FixedJoint {
    kodo_JointEnds ends;
    kodo_Real reference; // rad; relative angle of b
    kodo_Real hertz;     // stiffness, as frequency of the pair; 0: rigid
    kodo_Real damping;   // damping ratio; 1 is critical
} kodo_FixedJoint;

/// A spring, a rod (hertz 0, equal limits), a rope (hertz 0, limits from 0) or a winch (motor).
typedef struct kodo_DistanceJoint {
    kodo_JointEnds ends;
    kodo_Real length;  // m, rest length of the spring
    kodo_Real hertz;   // stiffness, as frequency of the pair; 0: no spring
    kodo_Real damping; // damping ratio; 1 is critical
    bool hasLimits;
    kodo_Range limits;    // m, of the distance
    kodo_Real motorSpeed; // m/s, of the distance
    kodo_Real motorForce; // N, >= 0; 0: no motor
} kodo_DistanceJoint;

/// b slides along an axis fixed to a.
typedef struct kodo_PrismaticJoint {
    kodo_JointEnds ends;
    kodo_Vec2 axis;      // unit, in the frame of a's shape
    kodo_Real reference; // rad; relative angle of b
    bool hasLimits;
    kodo_Range limits;    // m, of anchor b along the axis
    kodo_Real motorSpeed; // m/s
    kodo_Real motorForce; // N, >= 0; 0: no motor
    kodo_Real target;     // m, rest translation of the spring
    kodo_Real hertz;      // stiffness, as frequency of the pair; 0: no spring
    kodo_Real damping;    // damping ratio; 1 is critical
} kodo_PrismaticJoint;

/// Drives b to a position and an angle relative to a. With hertz 0 it brakes alone, as friction.
typedef struct kodo_MotorJoint {
    kodo_JointEnds ends; // anchor b is driven to anchor a
    kodo_Real reference; // rad; target of the relative angle of b
    kodo_Real force;     // N, >= 0; the largest
    kodo_Real torque;    // N m, >= 0; the largest
    kodo_Real hertz;     // stiffness, as frequency of the pair
    kodo_Real damping;   // damping ratio; 1 is critical
} kodo_MotorJoint;

/// Pulls a point of one body towards a target.
typedef struct kodo_MouseJoint {
    kodo_BodyId body;
    kodo_Vec2 anchor;  // m, in the frame of the body's shape
    kodo_Vec2 target;  // m, world
    kodo_Real force;   // N, > 0; the largest
    kodo_Real hertz;   // stiffness, with the body's mass
    kodo_Real damping; // damping ratio; 1 is critical
    uint64_t userData; // for the user
} kodo_MouseJoint;

/// The axle, anchor b, stays on a line through anchor a that is fixed to a.
typedef struct kodo_WheelJoint {
    kodo_JointEnds ends;
    kodo_Vec2 axis; // unit, in the frame of a's shape
    bool hasLimits;
    kodo_Range limits;     // m, of the axle along the axis
    kodo_Real hertz;       // stiffness, as frequency of the pair; 0: no spring
    kodo_Real damping;     // damping ratio; 1 is critical
    kodo_Real motorSpeed;  // rad/s, of b relative to a
    kodo_Real motorTorque; // N m, >= 0; 0: no motor
} kodo_WheelJoint;

/// A rope from anchor a over two points of the world to anchor b.
typedef struct kodo_PulleyJoint {
    kodo_JointEnds ends;
    kodo_Vec2 groundA; // m, world
    kodo_Vec2 groundB; // m, world
    kodo_Real length;  // m, of the rope: that to a + ratio times that to b
    kodo_Real ratio;
} kodo_PulleyJoint;

/// The speed of b is `ratio` times that of a, as seen from the line between the anchors. With a
/// rack, which is fixed to a, b rolls along it by `ratio` (m) per rad.
typedef struct kodo_GearJoint {
    kodo_JointEnds ends;
    kodo_Real ratio; // not 0; negative for teeth, positive for a belt
    bool hasRack;
    kodo_Vec2 rack; // unit, in the frame of a's shape
} kodo_GearJoint;

/// The two bodies do not collide with each other.
typedef struct kodo_FilterJoint {
    kodo_JointEnds ends;
} kodo_FilterJoint;

typedef int32_t kodo_JointKind;
enum {
    KODO_REVOLUTE_JOINT = 0,
    KODO_FIXED_JOINT = 1,
    KODO_DISTANCE_JOINT = 2,
    KODO_PRISMATIC_JOINT = 3,
    KODO_MOTOR_JOINT = 4,
    KODO_MOUSE_JOINT = 5,
    KODO_WHEEL_JOINT = 6,
    KODO_PULLEY_JOINT = 7,
    KODO_GEAR_JOINT = 8,
    KODO_FILTER_JOINT = 9
};

typedef struct kodo_JointDef {
    kodo_Head head;
    kodo_JointKind kind; // which of the following counts
    union {
        kodo_RevoluteJoint revolute;
        kodo_FixedJoint fixed;
        kodo_DistanceJoint distance;
        kodo_PrismaticJoint prismatic;
        kodo_MotorJoint motor;
        kodo_MouseJoint mouse;
        kodo_WheelJoint wheel;
        kodo_PulleyJoint pulley;
        kodo_GearJoint gear;
        kodo_FilterJoint filter;
    };
} kodo_JointDef;

KODO_C_API kodo_Status kodo_initJointDef(kodo_JointDef* def, kodo_Head head, kodo_JointKind kind);
/// A joint of a kind. Of an unknown kind, one that each call refuses.
static inline kodo_JointDef kodo_jointDef(kodo_JointKind kind) {
    kodo_JointDef def;
    kodo_initJointDef(&def, kodo_headOf(sizeof(kodo_JointDef)), kind);
    return def;
}

KODO_C_API kodo_Status kodo_addJoint(kodo_World* world, const kodo_JointDef* def, kodo_JointId* id);
KODO_C_API kodo_Status kodo_removeJoint(kodo_World* world, kodo_JointId id);
KODO_C_API kodo_Status kodo_containsJoint(const kodo_World* world, kodo_JointId id,
                                          bool* contained);
KODO_C_API kodo_Status kodo_joints(const kodo_World* world, kodo_JointId* ids, size_t capacity,
                                   size_t* count);
/// The joints of one body.
KODO_C_API kodo_Status kodo_jointsOf(const kodo_World* world, kodo_BodyId body, kodo_JointId* ids,
                                     size_t capacity, size_t* count);
KODO_C_API kodo_Status kodo_joint(const kodo_World* world, kodo_JointId id, kodo_JointDef* def);
/// Changes the numbers of a joint; kind and bodies must stay.
KODO_C_API kodo_Status kodo_setJoint(kodo_World* world, kodo_JointId id, const kodo_JointDef* def);
/// On body b: mean over the last step in which the joint was awake.
KODO_C_API kodo_Status kodo_jointLoad(const kodo_World* world, kodo_JointId id, kodo_Load* load);

/// Numbers of a spring, as the joints have them.
typedef struct kodo_Spring {
    kodo_Real hertz;
    kodo_Real damping; // damping ratio
} kodo_Spring;

/// Where a joint is, and how it moves: b relative to a.
typedef struct kodo_JointState {
    kodo_Vec2 anchorA;      // m, world; of a mouse joint: the target
    kodo_Vec2 anchorB;      // m, world
    kodo_Real angle;        // rad, from the reference; -pi to pi, or counted
    kodo_Real angularSpeed; // rad/s
    kodo_Real length;       // m, between the anchors; of a pulley: of the taut rope
    kodo_Real lengthSpeed;  // m/s
    kodo_Real translation;  // m, along the axis of a prismatic or wheel joint; else 0
    kodo_Real speed;        // m/s, likewise
} kodo_JointState;

/// The numbers for a spring of that stiffness (N/m, > 0) and damping (N s/m), with the present
/// masses of the bodies; of a revolute joint N m/rad and N m s/rad.
KODO_C_API kodo_Status kodo_springOf(const kodo_World* world, const kodo_JointDef* def,
                                     kodo_Real stiffness, kodo_Real damping, kodo_Spring* spring);
KODO_C_API kodo_Status kodo_jointState(const kodo_World* world, kodo_JointId id,
                                       kodo_JointState* state);

/// A joint that its load broke in the last step. Its id is no longer valid.
typedef struct kodo_BrokenJoint {
    kodo_JointId id;
    kodo_BodyId a;
    kodo_BodyId b;
    kodo_Real force;  // N, mean over the step
    kodo_Real torque; // N m, likewise
} kodo_BrokenJoint;

KODO_C_API kodo_Status kodo_brokenJoints(const kodo_World* world, kodo_BrokenJoint* joints,
                                         size_t capacity, size_t* count);

// Force fields.

typedef struct kodo_Gravity {
    kodo_Vec2 acceleration; // m/s^2
} kodo_Gravity;

/// Drag of a fluid, per width (m) of the disc with the area of the body.
typedef struct kodo_DragLaw {
    kodo_Real linear;    // N per m/s and m
    kodo_Real quadratic; // N per (m/s)^2 and m
} kodo_DragLaw;

typedef struct kodo_Drag {
    kodo_DragLaw law;
    kodo_Vec2 air; // m/s, velocity of the fluid
} kodo_Drag;

typedef struct kodo_Wind {
    kodo_DragLaw law;
    kodo_Vec2 velocity; // m/s
    bool hasRegion;
    kodo_Aabb region; // m, world; else everywhere
} kodo_Wind;

typedef int32_t kodo_AttractorLaw;
enum { KODO_INVERSE_SQUARE = 0, KODO_LINEAR = 1 };

typedef struct kodo_Attractor {
    kodo_AttractorLaw law;
    kodo_Vec2 center;    // m, world
    kodo_Real strength;  // m^3/s^2, or 1/s^2 for the linear law; negative repels
    kodo_Real softening; // m
} kodo_Attractor;

typedef struct kodo_Buoyancy {
    kodo_Real density; // kg/m^2, of the fluid
    kodo_Real drag;    // kg/(m^2 s)
    kodo_Vec2 surface; // m, world; a point of the surface
    kodo_Vec2 gravity; // m/s^2; perpendicular to the surface
} kodo_Buoyancy;

/// The body that a field of the user acts on.
typedef struct kodo_FieldBody {
    kodo_BodyId id;
    kodo_Flags flags;
    kodo_Transform transform;  // of the shape's frame
    kodo_Transform massFrame;  // of the centre of mass
    kodo_Transform midStep;    // of the centre of mass after half a step without forces
    kodo_Vec2 velocity;        // m/s, of the centre of mass
    kodo_Real angularVelocity; // rad/s
    kodo_Real mass;            // kg
    kodo_Real inertia;         // kg m^2
    kodo_Real area;            // m^2
    uint64_t userData;
} kodo_FieldBody;

/// Force and torque of a field on one body in one step; `drag` and `spinDrag` are how much they
/// decrease with the velocities, and are integrated implicitly.
typedef struct kodo_FieldForce {
    kodo_Vec2 force;    // N, at the centre of mass
    kodo_Real torque;   // N m
    kodo_Real drag;     // N s/m, >= 0
    kodo_Real spinDrag; // N m s, >= 0
} kodo_FieldForce;

/// A field of the user. Two of them with the same function and context are one in one World.
typedef struct kodo_OwnField {
    /// Called once per step of dt (s) for each awake dynamic body, on several threads at once. All
    /// numbers of `force` are 0 before. Must depend on its arguments alone.
    void (*at)(void* context, const kodo_FieldBody* body, kodo_Real dt, kodo_FieldForce* force);
    /// Called when the last World or copy lets go of the field; may be null.
    void (*destroy)(void* context);
    void* context;
    bool steady; // the force depends on mass, shape and flags of the body alone
} kodo_OwnField;

typedef int32_t kodo_FieldKind;
enum {
    KODO_OWN_FIELD = 0,
    KODO_GRAVITY = 1,
    KODO_DRAG = 2,
    KODO_WIND = 3,
    KODO_ATTRACTOR = 4,
    KODO_BUOYANCY = 5
};

typedef struct kodo_Field {
    kodo_Head head;
    kodo_Filter which;   // the bodies it acts on
    kodo_FieldKind kind; // which of the following counts
    union {
        kodo_OwnField own;
        kodo_Gravity gravity;
        kodo_Drag drag;
        kodo_Wind wind;
        kodo_Attractor attractor;
        kodo_Buoyancy buoyancy;
    };
} kodo_Field;

KODO_C_API kodo_Status kodo_initField(kodo_Field* field, kodo_Head head, kodo_FieldKind kind);
/// A field of a kind, with all numbers 0. Of an unknown kind, one that each call refuses.
static inline kodo_Field kodo_field(kodo_FieldKind kind) {
    kodo_Field field;
    kodo_initField(&field, kodo_headOf(sizeof(kodo_Field)), kind);
    return field;
}

/// Fields act in the order of their list. A change wakes all bodies. If a call that takes fields is
/// refused, their contexts stay the caller's: `destroy` is not called.
KODO_C_API kodo_Status kodo_addField(kodo_World* world, const kodo_Field* field);
KODO_C_API kodo_Status kodo_setFields(kodo_World* world, const kodo_Field* fields, size_t count);
KODO_C_API kodo_Status kodo_fields(const kodo_World* world, kodo_Field* fields, size_t capacity,
                                   size_t* count);
/// During the next step, on each body that the filter accepts: N at the centre of mass, and N m.
/// `which` may be null: all.
KODO_C_API kodo_Status kodo_applyForceToAll(kodo_World* world, kodo_Vec2 force,
                                            const kodo_Filter* which);
KODO_C_API kodo_Status kodo_applyTorqueToAll(kodo_World* world, kodo_Real torque,
                                             const kodo_Filter* which);

// Steps.

typedef int32_t kodo_StepStage;
enum {
    KODO_STAGE_BROAD = 0,
    KODO_STAGE_NARROW = 1,
    KODO_STAGE_FORCES = 2,
    KODO_STAGE_SOLVE = 3,
    KODO_STAGE_CONTINUOUS = 4,
    KODO_STAGE_RECORD = 5,
    KODO_STAGE_SLEEP = 6
};

typedef struct kodo_StepOptions {
    kodo_Head head;
    kodo_ThreadPool* pool; // may be null: no helpers. The result has the same bits
    /// Called when the step enters a stage and when it leaves the last one; each may be null. After
    /// a C++ exception from one, the step is half done: go back to a copy.
    void (*enterStage)(void* context, kodo_StepStage stage);
    void (*leaveStages)(void* context);
    void* context;
} kodo_StepOptions;

KODO_C_API kodo_Status kodo_initStepOptions(kodo_StepOptions* options, kodo_Head head);
static inline kodo_StepOptions kodo_stepOptions(void) {
    kodo_StepOptions options;
    kodo_initStepOptions(&options, kodo_headOf(sizeof(kodo_StepOptions)));
    return options;
}

/// 0 to 255 helping threads. A pool serves one call at a time.
KODO_C_API kodo_Status kodo_createThreadPool(int32_t helpers, kodo_ThreadPool** pool);
/// Must not be in use.
KODO_C_API kodo_Status kodo_destroyThreadPool(kodo_ThreadPool* pool);

/// Advances by dt (s). `options` may be null. After a C++ exception from a field of the user, the
/// step is done, with a force of 0 where it threw.
KODO_C_API kodo_Status kodo_step(kodo_World* world, kodo_Real dt, const kodo_StepOptions* options);
/// Advances many Worlds, each once, by dt (s). With a pool, which may be null, each World is a task
/// for one thread. An error is that of the first World in the array; the others have advanced.
KODO_C_API kodo_Status kodo_stepWorlds(kodo_World* const* worlds, size_t count, kodo_Real dt,
                                       kodo_ThreadPool* pool);
KODO_C_API kodo_Status kodo_stepCount(const kodo_World* world, uint64_t* count);

/// Work of the last step.
typedef struct kodo_StepStats {
    size_t bodies;          // awake bodies
    size_t contacts;        // visits of contacts by the solver, summed over all passes
    size_t joints;          // joints of awake bodies
    uint32_t mostParts;     // parts of a substep, in the island that needed the most; up to 8
    size_t refinedBodies;   // bodies of islands with more than one part
    size_t pairs;           // pairs of parts near each other, at least one of a body that is awake
    size_t continuousPairs; // pairs whose paths continuous collision compared
    size_t continuousStops; // bodies that it stopped
    uint64_t pairWork;      // pairs of nodes of bounds trees compared, all steps so far
    uint64_t changeVisits;  // bodies and parts visited by calls that concern many, so far
} kodo_StepStats;

KODO_C_API kodo_Status kodo_stepStats(const kodo_World* world, kodo_StepStats* stats);
/// Bodies that the last step stopped, since forces made them too fast or not finite.
KODO_C_API kodo_Status kodo_frozenBodies(const kodo_World* world, kodo_BodyId* ids, size_t capacity,
                                         size_t* count);
/// Equal for Worlds that continue alike; the same on every machine.
KODO_C_API kodo_Status kodo_stateHash(const kodo_World* world, uint64_t* hash);

// Collisions of the last step, in the order of bodies and parts. The first call of each function
// after a step writes the records: not on two threads at once.

typedef int32_t kodo_TouchPhase;
enum { KODO_BEGIN = 0, KODO_PERSIST = 1, KODO_END = 2 };

typedef struct kodo_RecordPoint {
    kodo_Vec2 position;   // m, world
    kodo_Real separation; // m, before the solver; < 0 in overlap
    kodo_Real maxImpulse; // N s; largest normal impulse at this point in one group
} kodo_RecordPoint;

/// Contact of two parts of two bodies. At KODO_END the numbers are 0.
typedef struct kodo_CollisionRecord {
    kodo_BodyId a; // a.index < b.index
    kodo_BodyId b;
    uint16_t partA;
    uint16_t partB;
    kodo_TouchPhase phase;
    int32_t pointCount; // 1 or 2; 0 at KODO_END
    kodo_RecordPoint points[2];
    kodo_Vec2 point;         // m, world; that of the largest impulse, else the deepest one
    kodo_Vec2 normal;        // unit, from a to b
    kodo_Real separation;    // m, before the solver
    kodo_Real approachSpeed; // m/s along the normal before the solver; >= 0
    kodo_Real maxImpulse;    // N s; largest normal impulse of all points in one group
    kodo_Real totalImpulse;  // N s; normal impulses of all points, summed over the step
    /// N s; friction, summed over the step: on b along (-normal.y, normal.x), on a against it
    kodo_Real tangentImpulse;
} kodo_CollisionRecord;

static inline bool kodo_involves(const kodo_CollisionRecord* record, kodo_BodyId body) {
    return kodo_sameBody(record->a, body) || kodo_sameBody(record->b, body);
}
static inline kodo_BodyId kodo_other(const kodo_CollisionRecord* record, kodo_BodyId body) {
    return kodo_sameBody(record->a, body) ? record->b : record->a;
}

KODO_C_API kodo_Status kodo_collisions(const kodo_World* world, kodo_CollisionRecord* records,
                                       size_t capacity, size_t* count);
KODO_C_API kodo_Status kodo_begunCollisions(const kodo_World* world, kodo_CollisionRecord* records,
                                            size_t capacity, size_t* count);
KODO_C_API kodo_Status kodo_endedCollisions(const kodo_World* world, kodo_CollisionRecord* records,
                                            size_t capacity, size_t* count);
/// Impacts with an approachSpeed of at least minSpeed (m/s, >= 0).
KODO_C_API kodo_Status kodo_hits(const kodo_World* world, kodo_Real minSpeed,
                                 kodo_CollisionRecord* records, size_t capacity, size_t* count);
KODO_C_API kodo_Status kodo_collisionsOf(const kodo_World* world, kodo_BodyId id,
                                         kodo_CollisionRecord* records, size_t capacity,
                                         size_t* count);

// Queries: they change nothing, and several threads may query one World at once. Points and
// displacements are in the world (m).

/// Which bodies a query finds. A call that takes one may be given null: all bodies.
typedef struct kodo_Query {
    kodo_Head head;
    kodo_Filter which;
    const kodo_BodyId* except; // bodies to leave out; may be null
    size_t exceptCount;
} kodo_Query;

KODO_C_API kodo_Status kodo_initQuery(kodo_Query* query, kodo_Head head);
static inline kodo_Query kodo_query(void) {
    kodo_Query query;
    kodo_initQuery(&query, kodo_headOf(sizeof(kodo_Query)));
    return query;
}

typedef struct kodo_Ray {
    kodo_Vec2 from;
    kodo_Vec2 to;
} kodo_Ray;

/// A shape at a pose.
typedef struct kodo_PlacedShape {
    const kodo_Shape* shape;
    kodo_Transform at;
} kodo_PlacedShape;

/// The same with the distance at which parts count as near.
typedef struct kodo_NearShape {
    const kodo_Shape* shape;
    kodo_Transform at;
    kodo_Real margin; // m, >= 0
} kodo_NearShape;

typedef struct kodo_QueryHit {
    bool found; // false: nothing was hit, and the rest is 0
    kodo_BodyId body;
    uint16_t part;
    kodo_Real fraction; // 0 to 1 of the ray or displacement
    kodo_Vec2 point;    // m
    kodo_Vec2 normal;   // unit, out of the body; zero for overlap at the start
} kodo_QueryHit;

typedef struct kodo_QueryPoint {
    bool found; // false: no body is as close, and the rest is 0
    kodo_BodyId body;
    uint16_t part;
    kodo_Vec2 point;    // m; the query point itself if it is inside
    kodo_Vec2 normal;   // unit, from the body to the query point; zero inside
    kodo_Real distance; // m; 0 inside
} kodo_QueryPoint;

/// The span of a ray within a part.
typedef struct kodo_RaySpan {
    kodo_QueryHit entry;    // as of kodo_rayCastAll()
    kodo_Real exitFraction; // 0 to 1 of the ray; 1 if it ends within the part
    kodo_Vec2 exitPoint;    // m
    kodo_Vec2 exitNormal;   // unit, out of the body; zero if the ray ends within the part
} kodo_RaySpan;

/// Where a shape touches or nearly touches a part.
typedef struct kodo_QueryContact {
    kodo_BodyId body;
    uint16_t part;
    kodo_Vec2 point;      // m; halfway between the surfaces
    kodo_Vec2 normal;     // unit, out of the body
    kodo_Real separation; // m, along the normal; < 0 in overlap
} kodo_QueryContact;

typedef struct kodo_ClosestPoints {
    kodo_Vec2 onA;      // m
    kodo_Vec2 onB;      // m; equal to onA in overlap
    kodo_Vec2 normal;   // unit, from a to b; zero in overlap
    kodo_Real distance; // m; 0 in overlap
} kodo_ClosestPoints;

/// What a cast does with a part that its shape overlaps or touches at the start.
typedef uint8_t kodo_StartOverlap;
enum {
    KODO_START_REPORT = 0, // a hit with fraction 0 and a zero normal
    KODO_START_NORMAL = 1, // with the normal of least overlap; no hit if it leads outwards
    KODO_START_IGNORE = 2  // no hit: the shape passes
};

/// A shape that moves and turns at constant rates. By default a disc of 0.5 m that rests.
typedef struct kodo_CastDef {
    kodo_Head head;
    kodo_Shape shape;
    kodo_Transform start;
    kodo_Vec2 displacement; // m, of the origin of the shape's frame
    kodo_Real angle;        // rad, about this origin, counter-clockwise; size up to 100
    kodo_StartOverlap atStart;
} kodo_CastDef;

KODO_C_API kodo_Status kodo_initCastDef(kodo_CastDef* def, kodo_Head head);
static inline kodo_CastDef kodo_castDef(void) {
    kodo_CastDef def;
    kodo_initCastDef(&def, kodo_headOf(sizeof(kodo_CastDef)));
    return def;
}

/// Return false to stop the visit. A change of the World from within is refused.
typedef bool (*kodo_VisitHit)(void* context, const kodo_QueryHit* hit);
typedef bool (*kodo_VisitBody)(void* context, kodo_BodyId body);

/// The first part on a ray.
KODO_C_API kodo_Status kodo_rayCast(const kodo_World* world, kodo_Ray ray, const kodo_Query* query,
                                    kodo_QueryHit* hit);
/// All parts on a ray, ordered by fraction, then id, then part.
KODO_C_API kodo_Status kodo_rayCastAll(const kodo_World* world, kodo_Ray ray,
                                       const kodo_Query* query, kodo_QueryHit* hits,
                                       size_t capacity, size_t* count);
/// The same parts with the points where the ray leaves them.
KODO_C_API kodo_Status kodo_raySpans(const kodo_World* world, kodo_Ray ray, const kodo_Query* query,
                                     kodo_RaySpan* spans, size_t capacity, size_t* count);
KODO_C_API kodo_Status kodo_visitRay(const kodo_World* world, kodo_Ray ray, const kodo_Query* query,
                                     kodo_VisitHit visit, void* context);
/// The first part that a shape meets when it moves by a displacement without rotation.
KODO_C_API kodo_Status kodo_shapeCast(const kodo_World* world, const kodo_PlacedShape* start,
                                      kodo_Vec2 displacement, const kodo_Query* query,
                                      kodo_QueryHit* hit);
/// The first part that a shape meets when it moves and turns. With an angle it stops less than a
/// quarter of the slop before the part.
KODO_C_API kodo_Status kodo_castShape(const kodo_World* world, const kodo_CastDef* def,
                                      const kodo_Query* query, kodo_QueryHit* hit);
/// The deepest contact of a shape with each part nearer than the margin, ordered by id and part.
KODO_C_API kodo_Status kodo_collide(const kodo_World* world, const kodo_NearShape* placed,
                                    const kodo_Query* query, kodo_QueryContact* contacts,
                                    size_t capacity, size_t* count);
/// Bodies that overlap or touch a box or a shape, in the order of ids.
KODO_C_API kodo_Status kodo_overlapBox(const kodo_World* world, kodo_Aabb box,
                                       const kodo_Query* query, kodo_BodyId* ids, size_t capacity,
                                       size_t* count);
KODO_C_API kodo_Status kodo_overlapShape(const kodo_World* world, const kodo_PlacedShape* placed,
                                         const kodo_Query* query, kodo_BodyId* ids, size_t capacity,
                                         size_t* count);
KODO_C_API kodo_Status kodo_visitOverlaps(const kodo_World* world, const kodo_PlacedShape* placed,
                                          const kodo_Query* query, kodo_VisitBody visit,
                                          void* context);
/// The closest body within maxDistance (m, >= 0; may be infinite).
KODO_C_API kodo_Status kodo_closestPoint(const kodo_World* world, kodo_Vec2 point,
                                         kodo_Real maxDistance, const kodo_Query* query,
                                         kodo_QueryPoint* closest);
/// The point of one body closest to a point, however far.
KODO_C_API kodo_Status kodo_closestPointOf(const kodo_World* world, kodo_BodyId id, kodo_Vec2 point,
                                           kodo_QueryPoint* closest);
/// The closest points of two bodies.
KODO_C_API kodo_Status kodo_distance(const kodo_World* world, kodo_BodyId a, kodo_BodyId b,
                                     kodo_ClosestPoints* points);
/// The bodies that touched a body in the last step, awake or asleep, in the order of ids. Of a
/// sensor: what it holds. Not on two threads at once.
KODO_C_API kodo_Status kodo_touching(const kodo_World* world, kodo_BodyId id, kodo_BodyId* ids,
                                     size_t capacity, size_t* count);

// Characters, explosions and locks of one axis.

/// Locks the motion of a body along one axis (unit), {1, 0} for x: its centre stays on a line
/// through its present place. The rotation stays free. Adds the static body that has the groove, a
/// point that nothing meets, and writes its id. Removing that body unlocks.
KODO_C_API kodo_Status kodo_lockAxis(kodo_World* world, kodo_BodyId body, kodo_Vec2 axis,
                                     kodo_BodyId* groove);

/// A character that is moved by casts instead of forces. It walks on slopes, climbs steps, stays on
/// the ground over crests, and rides on moving bodies. A value: copy it with the World to go back
/// to both. Corners of a polygon must stay where they are.
typedef struct kodo_Mover {
    kodo_Head head;
    kodo_Shape shape;     // never turns; by default a capsule 1.4 m high; convex, no plane
    kodo_Vec2 position;   // m, world: of the shape's frame; set it to teleport
    kodo_Vec2 up;         // unit
    kodo_Real slopeLimit; // rad, 0 to 1.5: steepest ground that it stands on
    kodo_Real stepHeight; // m: of steps that it climbs, and descends without a fall
    kodo_Real skin;       // m, > 0: gap that it keeps from everything
    kodo_Real pushForce;  // N: largest force on a dynamic body in its way
    kodo_Real weight;     // N, on a dynamic body below it
    kodo_Filter which;    // what blocks it; sensors never do
    kodo_BodyId body;     // a kinematic body that follows, one step late; all zero: none

    // Results of the last move.

    kodo_Vec2 velocity;     // m/s; on the ground relative to it, and across `up`; else in the world
    bool grounded;          // on ground up to slopeLimit, or wedged between steeper slopes
    kodo_Vec2 groundNormal; // unit, out of the ground; zero in the air
    kodo_BodyId groundBody; // all zero in the air
    kodo_Transform groundPose; // of groundBody then
    kodo_Vec2 wallNormal;      // unit, out of what stopped it sideways; zero if nothing did
} kodo_Mover;

KODO_C_API kodo_Status kodo_initMover(kodo_Mover* mover, kodo_Head head);
static inline kodo_Mover kodo_mover(void) {
    kodo_Mover mover;
    kodo_initMover(&mover, kodo_headOf(sizeof(kodo_Mover)));
    return mover;
}
/// Moves for dt (s) after kodo_step(), with a wished velocity (m/s). With a part along `up` the
/// mover jumps, with the velocity of the ground. Else, on the ground, the part across `up` is the
/// speed along the ground. Gravity may be added always.
KODO_C_API kodo_Status kodo_moveMover(kodo_World* world, kodo_Mover* mover, kodo_Vec2 wish,
                                      kodo_Real dt);

/// A blast that pushes the sides of bodies that it sees.
typedef struct kodo_Explosion {
    kodo_Head head;
    kodo_Vec2 center;  // m, world
    kodo_Real radius;  // m, > 0: up to here at full strength; 1 by default
    kodo_Real falloff; // m, >= 0: from there on the strength falls to 0 over this distance
    kodo_Real impulse; // N s for each metre of a side, seen from the centre; < 0 pulls
    kodo_Filter which; // bodies that it pushes; all others but sensors are a cover too
} kodo_Explosion;

/// A body that was pushed.
typedef struct kodo_ExplosionHit {
    kodo_BodyId body;
    kodo_Vec2 point;   // m, world; the closest point that was reached
    kodo_Vec2 impulse; // N s
    kodo_Real width;   // m, across the rays: of what was reached
} kodo_ExplosionHit;

KODO_C_API kodo_Status kodo_initExplosion(kodo_Explosion* explosion, kodo_Head head);
static inline kodo_Explosion kodo_explosion(void) {
    kodo_Explosion explosion;
    kodo_initExplosion(&explosion, kodo_headOf(sizeof(kodo_Explosion)));
    return explosion;
}
/// Pushes all dynamic bodies in reach, and lists them in the order of ids. Each call pushes, also
/// one with capacity 0.
KODO_C_API kodo_Status kodo_explode(kodo_World* world, const kodo_Explosion* explosion,
                                    kodo_ExplosionHit* hits, size_t capacity, size_t* count);

// Drawing.

/// A colour with its opacity; 255 is opaque.
typedef struct kodo_DrawColor {
    uint8_t r;
    uint8_t g;
    uint8_t b;
    uint8_t a;
} kodo_DrawColor;

/// How a figure looks.
typedef struct kodo_DrawStyle {
    kodo_DrawColor line;
    kodo_DrawColor fill; // of circles and polygons; opacity 0: hollow
    kodo_Real width;     // pixels, of lines
} kodo_DrawStyle;

/// Selects what is drawn of a World. A call that takes options may be given null: the defaults.
typedef struct kodo_DrawOptions {
    kodo_Head head;
    bool shapes;                 // default: true
    bool joints;                 // default: true
    bool contacts;               // of the last step: points with their normals
    bool impulses;               // of the last step: arrows along the normals
    bool bounds;                 // axis-aligned, of bodies
    bool velocities;             // arrows, of moving bodies
    bool centers;                // centres of mass of dynamic bodies, as crosses
    bool labels;                 // indices of ids, or what kodo_DebugDraw::label returns
    kodo_Real metresPerImpulse;  // m/(N s); length of these arrows
    kodo_Real secondsOfVelocity; // s; a velocity arrow leads to where a body is then
    bool islands;                // colours tell islands instead of ids
} kodo_DrawOptions;

KODO_C_API kodo_Status kodo_initDrawOptions(kodo_DrawOptions* options, kodo_Head head);
static inline kodo_DrawOptions kodo_drawOptions(void) {
    kodo_DrawOptions options;
    kodo_initDrawOptions(&options, kodo_headOf(sizeof(kodo_DrawOptions)));
    return options;
}

/// A picture that kodo_draw() fills by functions for figures in the world (m). Each function may be
/// null: of the first four, such figures are left out; the next five are made of these then.
typedef struct kodo_DebugDraw {
    kodo_Head head;
    void* context;
    kodo_Aabb view;  // m, world; bodies outside are left out
    kodo_Real pixel; // m, size of a pixel: marks have a fixed size in pixels
    void (*line)(void* context, kodo_Vec2 from, kodo_Vec2 to, const kodo_DrawStyle* style);
    void (*circle)(void* context, kodo_Vec2 center, kodo_Real radius, const kodo_DrawStyle* style);
    /// Convex, corners counter-clockwise.
    void (*polygon)(void* context, const kodo_Vec2* corners, size_t count,
                    const kodo_DrawStyle* style);
    /// One line of UTF-8, centred at a point.
    void (*text)(void* context, kodo_Vec2 middle, const char* utf8, const kodo_DrawStyle* style);
    /// All points within a radius of a convex polygon, or of a line with two corners.
    void (*rounded)(void* context, const kodo_Vec2* corners, size_t count, kodo_Real radius,
                    const kodo_DrawStyle* style);
    void (*halfPlane)(void* context, kodo_Vec2 surface, kodo_Vec2 normal,
                      const kodo_DrawStyle* style);
    void (*point)(void* context, kodo_Vec2 place, const kodo_DrawStyle* style);
    void (*arrow)(void* context, kodo_Vec2 from, kodo_Vec2 to, const kodo_DrawStyle* style);
    void (*spring)(void* context, kodo_Vec2 from, kodo_Vec2 to, const kodo_DrawStyle* style);
    /// Called before the figures of a body, which have this style. May change it.
    void (*begin)(void* context, kodo_BodyId body, kodo_DrawStyle* style);
    /// UTF-8, valid until the next call.
    const char* (*label)(void* context, kodo_BodyId body);
} kodo_DebugDraw;

KODO_C_API kodo_Status kodo_initDebugDraw(kodo_DebugDraw* target, kodo_Head head);
/// A picture without functions, with a pixel of 0.01 m.
static inline kodo_DebugDraw kodo_debugDraw(void) {
    kodo_DebugDraw target;
    kodo_initDebugDraw(&target, kodo_headOf(sizeof(kodo_DebugDraw)));
    return target;
}

/// Draws bodies, joints, and what the last step did.
KODO_C_API kodo_Status kodo_draw(const kodo_World* world, const kodo_DebugDraw* target,
                                 const kodo_DrawOptions* options);
/// Bounds of all bodies with a margin, to be shown. A plane counts as a point.
KODO_C_API kodo_Status kodo_viewOf(const kodo_World* world, kodo_Aabb* view);
/// A World as SVG, 640 pixels wide: `count` bytes of UTF-8, without a zero at the end. `view` may
/// be null: that of kodo_viewOf().
KODO_C_API kodo_Status kodo_svg(const kodo_World* world, const kodo_DrawOptions* options,
                                const kodo_Aabb* view, char* text, size_t capacity, size_t* count);

// Snapshots.

/// A World as bytes: the same on every machine, and those of toBytes() in C++.
KODO_C_API kodo_Status kodo_toBytes(const kodo_World* world, void* bytes, size_t capacity,
                                    size_t* count);

typedef struct kodo_SnapshotDef {
    kodo_Head head;
    const void* bytes;
    size_t byteCount;
    const kodo_Field* ownFields; // as many of KODO_OWN_FIELD as the World had; may be null
    size_t ownFieldCount;
} kodo_SnapshotDef;

KODO_C_API kodo_Status kodo_initSnapshotDef(kodo_SnapshotDef* def, kodo_Head head);
static inline kodo_SnapshotDef kodo_snapshotDef(void) {
    kodo_SnapshotDef def;
    kodo_initSnapshotDef(&def, kodo_headOf(sizeof(kodo_SnapshotDef)));
    return def;
}

/// The World of a snapshot. It accepts ids of any World.
KODO_C_API kodo_Status kodo_fromBytes(const kodo_SnapshotDef* def, kodo_World** world);

#ifdef __cplusplus
}
#endif
