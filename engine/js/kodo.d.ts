// SPDX-License-Identifier: MIT
// Kodo, a 2D rigid-body engine. SI units; x to the right, y up, angles counter-clockwise.
import type {
  Aabb, BodyCalls, BodyDef, BodyId, BodyState, DrawOptions, DrawStyle, Explosion, ExplosionHit,
  Field, FieldBody, FieldForce, JointDef, JointId, Material, Mover as MoverNumbers, Part, Profile,
  Rot, Settings, Shape, Vec2, WorldCalls, WorldDef,
} from "./layout.js";
export * from "./layout.js";

/** A definition of which every property may be left out: the engine's default. */
export type Input<T> = T extends BodyId
  ? BodyLike
  : T extends (infer Item)[]
    ? Input<Item>[]
    : T extends (...given: never[]) => unknown
      ? T
      : T extends object
        ? { [Key in keyof T]?: Input<T[Key]> }
        : T;
/** A handle or an id names a body. */
export type BodyLike = Body | BodyId;

/** Any error of the engine, with its sentence. Nothing has changed then. */
export class KodoError extends Error {}
/** A value that cannot be used, or an unknown joint. */
export class BadDefinition extends KodoError {}
/** An unknown body: removed, never added, or of another World. */
export class BadBodyId extends KodoError {}
/** Bytes that are no snapshot. */
export class BadSnapshot extends KodoError {}
/** A change within a step or a visit, or a World that was destroyed. */
export class WrongUse extends KodoError {}
export class NoMemory extends KodoError {}
export class OtherError extends KodoError {}

/** As KODO_VERSION: 1.3.5 is 10305. */
export const version: number;

// Shapes, in the frame of the body (m). Properties beside those named: see the interfaces.

export function circle(radius: number, more?: { center?: Vec2 }): Input<Shape>;
/** Full width and height; angle: rad. */
export function box(
  width: number, height: number, more?: { center?: Vec2; angle?: number; radius?: number },
): Input<Shape>;
/** Counter-clockwise, strictly convex. */
export function polygon(corners: Vec2[], more?: { radius?: number }): Input<Shape>;
export function compound(parts: Input<Shape>[]): Input<Shape>;
/** A particle; the number given as density is its mass (kg). */
export function point(position?: Vec2): Input<Shape>;
export function segment(
  from: Vec2, to: Vec2, more?: { oneSided?: boolean; radius?: number },
): Input<Shape>;
/** The points p with dot(normal, p) <= offset; static and kinematic bodies only. */
export function plane(normal?: Vec2, offset?: number): Input<Shape>;
export function heightmap(spacing: number, heights: number[], more?: { origin?: Vec2 }): Input<Shape>;
export function chain(
  points: Vec2[], more?: { closed?: boolean; oneSided?: boolean; materials?: Input<Material>[] },
): Input<Shape>;
export function capsule(from: Vec2, to: Vec2, radius: number): Input<Shape>;
/** The corners of the smallest convex polygon around points in any order. */
export function convexHull(points: Vec2[]): Vec2[];
/** Divides a concave outline, in either direction, into convex polygons: parts of a compound. */
export function decompose(outline: Vec2[]): Input<Shape>[];

export function withFriction(friction: number, restitution?: number): Input<Material>;
/** All settings of a profile. */
export function settings(profile: Profile): Settings;
/** The rotation by an angle (rad), and the angle of a rotation: the same bits on every machine. */
export function rotation(radians: number): Rot;
export function angleOf(rotation: Rot): number;

/** A force field of the user: called for each awake dynamic body with dt (s). What it leaves out is
 * 0. An exception is thrown after the step. `steady`: the force depends on mass, shape and flags of
 * the body alone. */
export type OwnFieldFunction =
  ((body: FieldBody, dt: number) => Input<FieldForce> | undefined) & { steady?: boolean };

/** Bodies, joints, force fields and their simulation. */
export class World {
  constructor(def?: Input<WorldDef>);
  /** Frees its memory at once, instead of some time after its last use. */
  destroy(): void;
  /** Another World with the same state and ids: a snapshot in memory. */
  copy(): World;
  /** Becomes equal to another World, without a new one. */
  assign(other: World): void;
  /** The World of a snapshot; `ownFields` are those that it had, in their order. */
  static fromBytes(bytes: Uint8Array, ownFields?: OwnFieldFunction[]): World;
  /** Advances by dt (s); a fixed dt is best. */
  step(dt: number): void;

  readonly settings: Settings;
  /** Changes those that are given. Another solver: the other numbers are its defaults. */
  setSettings(settings: Input<Settings>): void;
  /** Only bodies whose bounds meet it (m, world) are simulated. undefined: all. */
  region: Aabb | undefined;

  add(def: Input<BodyDef>): Body;
  /** The handle of a body, also for an id or a handle of a copy. */
  body(body: BodyLike): Body;
  contains(body: BodyLike): boolean;
  /** Bodies whose numbers are read and written in one call. */
  list(bodies: BodyLike[]): BodyList;
  /** The bodies that moved or fell asleep in the last step: index, generation and World of each id,
   * and x, y (m), cosine and sine of each angle. Both are views that the next call may change. */
  movedPoses(): { ids: Uint32Array; poses: Float32Array };

  addJoint(def: Input<JointDef>): JointId;
  joint(id: JointId): JointDef;
  /** Changes the numbers that are given; kind and bodies must stay. */
  setJoint(id: JointId, def: Input<JointDef>): void;

  /** Fields act in the order of their list. A change wakes all bodies. */
  addField(field: Input<Field>): void;
  setFields(fields: Input<Field>[]): void;

  /** Pushes all dynamic bodies in reach, and lists them in the order of ids. */
  explode(explosion: Input<Explosion>): ExplosionHit[];

  /** Draws bodies, joints, and what the last step did. */
  draw(target: DebugDraw, options?: Input<DrawOptions>): void;
}
export interface World extends WorldCalls {}

/** A handle of a body: its World and its id, which also names the body in copies. */
export class Body {
  readonly world: World;
  readonly id: BodyId;
  /** All that can be read of it, in one call. */
  state(): BodyState;
  /** m, world: origin of the frame of its shape. */
  position: Vec2;
  /** rad */
  angle: number;
  /** m/s, of the centre of mass */
  velocity: Vec2;
  /** rad/s */
  angularVelocity: number;
  /** m, world: centre of mass */
  readonly center: Vec2;
  /** kg */
  readonly mass: number;
  readonly isAsleep: boolean;
  /** One convex part; `state().partCount` is their number. */
  part(index: number): Part;
}
export interface Body extends BodyCalls {}

/** A character that is moved by casts instead of forces. It walks on slopes, climbs steps, stays on
 * the ground over crests, and rides on moving bodies. A value: `new Mover(mover)` copies it. */
export class Mover {
  constructor(def?: Input<MoverNumbers>);
  /** Moves for dt (s) after World.step(), with a wished velocity (m/s). With a part along `up` the
   * mover jumps, with the velocity of the ground. Else, on the ground, the part across `up` is the
   * speed along the ground. Gravity may be added always. */
  move(world: World, wish: Vec2, dt: number): void;
}
export interface Mover extends MoverNumbers {}

/** Some bodies of a World. Views are of the memory of the engine: read them before the next call. */
export class BodyList {
  readonly length: number;
  /** Frees its memory at once, instead of some time after its last use. */
  destroy(): void;
  /** x, y (m), cosine and sine of the angle of each body. */
  poses(): Float32Array;
  /** x, y (m/s, of the centre of mass) and angular velocity (rad/s) of each body. */
  velocities(): Float32Array;
  /** As velocities() gives them. */
  setVelocities(velocities: ArrayLike<number>): void;
  /** x, y of a force (N) at the centre of mass, and a torque (N m), during the next step. */
  applyLoads(loads: ArrayLike<number>): void;
}

/** A picture that World.draw() fills by figures in the world (m). */
export interface DebugDraw {
  /** m, world; bodies outside are left out */
  view: Aabb;
  /** m, size of a pixel: marks have a fixed size in pixels */
  pixel: number;
  line(from: Vec2, to: Vec2, style: DrawStyle): void;
  circle(center: Vec2, radius: number, style: DrawStyle): void;
  /** Convex, corners counter-clockwise. */
  polygon(corners: Vec2[], style: DrawStyle): void;
  /** One line, centred at a point. */
  text(middle: Vec2, text: string, style: DrawStyle): void;
}

/** Draws on a canvas. The view is centred, and grows to the shape of the canvas. */
export class CanvasDraw implements DebugDraw {
  constructor(context: CanvasRenderingContext2D, view: Aabb);
  readonly view: Aabb;
  readonly pixel: number;
  /** Between pixels of the canvas, y down, and the world (m). */
  toWorld(pixel: Vec2): Vec2;
  toCanvas(place: Vec2): Vec2;
  clear(): void;
  line(from: Vec2, to: Vec2, style: DrawStyle): void;
  circle(center: Vec2, radius: number, style: DrawStyle): void;
  polygon(corners: Vec2[], style: DrawStyle): void;
  text(middle: Vec2, text: string, style: DrawStyle): void;
}
