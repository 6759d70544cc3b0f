// SPDX-License-Identifier: MIT
// Kodo, a 2D rigid-body engine. kodo.d.ts describes what this module exports.
import * as layout from "./layout.js";
import {
  allocate, bytesAt, call, check, checkNumber, data, drawWith, floats, handleOf, initialise, made, read, readMany,
  room, sizeOf, wasm, within, write, writeMany,
} from "./memory.js";

export {
  BadBodyId, BadDefinition, BadSnapshot, KodoError, NoMemory, OtherError, WrongUse,
} from "./memory.js";
export const {
  ShapeKind, BodyType, ContinuousMode, MixRule, SolverKind, Features, Profile, JointKind, AttractorLaw, FieldKind,
  StartOverlap, StepStage, TouchPhase, Flags,
} = layout;

export const version = wasm.kodo_version();

// Definitions.

export const circle = (radius, more = {}) => ({ circle: { radius, ...more } });
export const box = (width, height, { angle = 0, ...more } = {}) =>
  ({ box: { width, height, rotation: rotation(angle), ...more } });
export const polygon = (corners, more = {}) => ({ polygon: { corners, ...more } });
export const compound = (parts) => ({ compound: { parts } });
export const point = (position = { x: 0, y: 0 }) => ({ point: { position } });
export const segment = (from, to, more = {}) => ({ segment: { from, to, ...more } });
export const plane = (normal = { x: 0, y: 1 }, offset = 0) => ({ plane: { normal, offset } });
export const heightmap = (spacing, heights, more = {}) =>
  ({ heightmap: { spacing, heights, ...more } });
export const chain = (points, more = {}) => ({ chain: { points, ...more } });
export const capsule = (from, to, radius) => ({ capsule: { from, to, radius } });

export const withFriction = (friction, restitution = 0) =>
  ({ staticFriction: friction, kineticFriction: friction, restitution });

export const settings = (profile) => within(() => {
  const at = room(sizeOf("Settings"));
  initialise("Settings", at, [checkNumber("i32", profile, "profile")]);
  return read("Settings", at);
});

export const rotation = (radians) => within(() => {
  const at = room(sizeOf("Rot"));
  wasm.kodo_rotation(at, checkNumber("f32", radians, "angle"));
  return read("Rot", at);
});
export const angleOf = (rotation) => within(() => wasm.kodo_angle(made("Rot", rotation, "rotation")));

export const convexHull = (points) => call("convexHull", layout.calls.convexHull, [points]);

export function decompose(outline) {
  return within(() => {
    const [points, length] = writeMany("Vec2", outline, "outline");
    const most = 3 * length; // a division into triangles has fewer corners
    const at = room(sizeOf("Polygons"));
    const [corners, sizes] = [room(most * sizeOf("Vec2")), room(4 * length)];
    [corners, most, 0, sizes, length, 0].forEach(
      (value, i) => data().setUint32(at + 4 * i, value, true));
    check(wasm.kodo_decompose(points, length, at));
    let from = corners;
    return readMany("u32", sizes, data().getUint32(at + 20, true)).map((count) => {
      const part = polygon(readMany("Vec2", from, count));
      from += count * sizeOf("Vec2");
      return part;
    });
  });
}

// Worlds.

const kAdopt = Symbol("a World of the engine that is there");
const forgotten = new FinalizationRegistry((handle) => wasm.kodo_destroyWorld(handle));
const kBody = ["in", "BodyId", "body"];
const kJoint = ["in", "JointId", "joint"];

/** The World that a function of the engine writes to an address. */
function adopted(make) {
  return new World(kAdopt, within(() => {
    const at = room(4);
    check(make(at));
    return data().getUint32(at, true);
  }));
}

export class World {
  constructor(def = {}, handle = 0) {
    if (def !== kAdopt) {
      handle = within(() => {
        const at = room(4);
        check(wasm.kodo_createWorld(made("WorldDef", def, "world"), at));
        return data().getUint32(at, true);
      });
    }
    this.handle = handle;
    forgotten.register(this, handle, this);
  }

  destroy() {
    check(wasm.kodo_destroyWorld(handleOf(this)));
    forgotten.unregister(this);
    this.handle = 0;
    this.moved?.destroy();
  }

  copy() {
    return adopted((at) => wasm.kodo_copyWorld(handleOf(this), at));
  }

  assign(other) {
    check(wasm.kodo_assignWorld(handleOf(this), handleOf(other)));
  }

  static fromBytes(bytes, ownFields = []) {
    const fields = ownFields.map((own) => ({ own }));
    return adopted((at) => wasm.kodo_fromBytes(
      made("SnapshotDef", { bytes, ownFields: fields }, "snapshot"), at));
  }

  step(dt) {
    check(wasm.kodo_step(handleOf(this), checkNumber("f32", dt, "dt"), 0));
  }

  get settings() {
    return this.#read("Settings", "worldSettings");
  }

  setSettings(settings) {
    this.#change("Settings", "worldSettings", "setSettings", [], settings);
  }

  get region() {
    return within(() => {
      const [box, set] = [room(sizeOf("Aabb")), room(1)];
      check(wasm.kodo_region(handleOf(this), box, set));
      return data().getUint8(set) !== 0 ? read("Aabb", box) : undefined;
    });
  }

  set region(box) {
    within(() => {
      const at = box === undefined ? 0 : made("Aabb", box, "region");
      check(wasm.kodo_setRegion(handleOf(this), at));
    });
  }

  /** Reads a struct by a function of the C interface. */
  #read(type, name, id) {
    return within(() => read(type, this.#get(type, name, id)));
  }

  #get(type, name, id = []) {
    const at = room(sizeOf(type));
    check(wasm[`kodo_${name}`](handleOf(this), ...id, at));
    return at;
  }

  /** Writes properties over what the engine has. */
  #change(type, get, set, id, value) {
    within(() => {
      const at = this.#get(type, get, id);
      write(type, at, value, type);
      check(wasm[`kodo_${set}`](handleOf(this), ...id, at));
    });
  }

  // Bodies.

  add(def) {
    return new Body(this, within(() => {
      const [id, at] = [room(sizeOf("BodyId")), made("BodyDef", def, "body")];
      check(wasm.kodo_addBody(handleOf(this), at, id));
      return read("BodyId", id);
    }));
  }

  body(id) {
    return new Body(this, id.id ?? id);
  }

  contains(body) {
    return call("containsBody", [["handle", "World", "world"], kBody, ["out", "b", "contained"]],
                [this, body]);
  }

  list(bodies) {
    return new BodyList(this, bodies);
  }

  movedPoses() {
    this.moved ??= new BodyList(this, []);
    return this.moved.takeMoved();
  }

  // Joints.

  addJoint(def) {
    return within(() => {
      const [id, at] = [room(sizeOf("JointId")), made("JointDef", def, "joint")];
      check(wasm.kodo_addJoint(handleOf(this), at, id));
      return read("JointId", id);
    });
  }

  joint(id) {
    return within(() => read("JointDef", this.#get("JointDef", "joint", [made(kJoint[1], id, "id")])));
  }

  setJoint(id, def) {
    within(() => this.#change("JointDef", "joint", "setJoint", [made(kJoint[1], id, "id")], def));
  }

  // Fields.

  addField(field) {
    within(() => {
      const at = made("Field", field, "field");
      check(wasm.kodo_addField(handleOf(this), at));
    });
  }

  setFields(fields) {
    within(() => {
      const [at, count] = writeMany("Field", fields, "fields");
      check(wasm.kodo_setFields(handleOf(this), at, count));
    });
  }

  // Explosions.

  explode(explosion) {
    return within(() => {
      const at = made("Explosion", explosion, "explosion");
      const most = this.bodyCount(); // a second call for a longer list would push again
      const [hits, count] = [room(Math.max(1, most * sizeOf("ExplosionHit"))), room(4)];
      check(wasm.kodo_explode(handleOf(this), at, hits, most, count));
      return readMany("ExplosionHit", hits, data().getUint32(count, true));
    });
  }

  // Pictures.

  draw(target, options = {}) {
    within(() => {
      const picture = made("DebugDraw", { view: target.view, pixel: target.pixel }, "target");
      wasm.kodo_js_setFigures(picture);
      const look = made("DrawOptions", options, "options");
      drawWith(target, () => check(wasm.kodo_draw(handleOf(this), picture, look)));
    });
  }
}

export class Body {
  constructor(world, id) {
    this.world = world;
    this.id = id;
  }

  state() {
    return call("bodyState", [["handle", "World", "world"], kBody, ["out", "BodyState", "state"]],
                [this.world, this]);
  }

  get position() {
    return this.state().transform.position;
  }
  set position(place) {
    this.setPosition(place);
  }

  get angle() {
    return angleOf(this.state().transform.rotation);
  }
  set angle(radians) {
    this.setRotation(rotation(radians));
  }

  get velocity() {
    return this.state().velocity;
  }
  set velocity(velocity) {
    this.setVelocity(velocity);
  }

  get angularVelocity() {
    return this.state().angularVelocity;
  }
  set angularVelocity(speed) {
    this.setAngularVelocity(speed);
  }

  get center() {
    return this.state().massFrame.position;
  }
  get mass() {
    return this.state().mass;
  }
  get isAsleep() {
    return this.state().isAsleep;
  }

  part(index) {
    return within(() => {
      const [part, id] = [room(sizeOf("Part")), made("BodyId", this, "body")];
      const [world, most] = [handleOf(this.world), 1024];
      const corners = room(most * sizeOf("Vec2"));
      check(wasm.kodo_part(world, id, checkNumber("u32", index, "index"), part, corners, most));
      return read("Part", part);
    });
  }
}

/** Functions of the C interface as methods. */
function addMethods(owner, calls, nameOf, first) {
  for (const [name, parameters] of Object.entries(calls)) {
    owner.prototype[nameOf(name)] = function (...values) {
      return call(name, parameters, [...first(this), ...values]);
    };
  }
}
addMethods(World, layout.worldCalls, (name) => name, (world) => [world]);
addMethods(Body, layout.bodyCalls, (name) => name.replace("Body", ""), (body) => [body.world, body]);

// Characters.

export class Mover {
  constructor(def = {}) {
    Object.assign(this, within(() => read("Mover", made("Mover", def, "mover"))));
  }

  move(world, wish, dt) {
    within(() => {
      const [at, velocity] = [made("Mover", this, "mover"), made("Vec2", wish, "wish")];
      check(wasm.kodo_moveMover(handleOf(world), at, velocity, checkNumber("f32", dt, "dt")));
      Object.assign(this, read("Mover", at));
    });
  }
}

// Many bodies.

const kId = sizeOf("BodyId"); // bytes
const kPose = 4; // numbers of a pose: x, y, cosine, sine
const kVelocity = 3; // x, y, angular

export class BodyList {
  #length = 0;

  constructor(world, bodies) {
    this.world = world;
    this.memory = { at: 0, capacity: 0 };
    freed.register(this, this.memory);
    const given = [...bodies];
    this.#reserve(given.length);
    this.#length = given.length;
    bytesAt(this.memory.at, given.length * kId).fill(0);
    given.forEach((body, i) => write("BodyId", this.memory.at + i * kId, body, `bodies[${i}]`));
  }

  get length() {
    return this.#length;
  }

  destroy() {
    wasm.free(this.memory.at);
    Object.assign(this.memory, { at: 0, capacity: 0 });
    this.#length = 0;
  }

  /** The World's address, ids, poses and velocities lie one after the other. */
  #reserve(count) {
    if (count > this.memory.capacity || this.memory.at === 0) {
      const capacity = Math.max(16, 2 * count);
      wasm.free(this.memory.at);
      this.memory.at = 0;
      this.memory.at = allocate(capacity * (kId + 4 * kPose + 4 * kVelocity));
      this.memory.capacity = capacity;
    }
  }

  get #poses() {
    return this.memory.at + this.memory.capacity * kId;
  }
  get #velocities() {
    return this.#poses + this.memory.capacity * 4 * kPose;
  }

  #call(name, at) {
    within(() => {
      const world = room(4);
      data().setUint32(world, handleOf(this.world), true);
      check(wasm[`kodo_${name}`](world, 1, this.memory.at, this.length, at));
    });
  }

  poses() {
    this.#call("poses", this.#poses);
    return floats(this.#poses, kPose * this.length);
  }

  velocities() {
    this.#call("velocities", this.#velocities);
    return floats(this.#velocities, kVelocity * this.length);
  }

  setVelocities(velocities) {
    this.#give("setVelocities", velocities);
  }

  applyLoads(loads) {
    this.#give("applyLoads", loads);
  }

  #give(name, numbers) {
    if (numbers.length !== kVelocity * this.length) {
      throw new RangeError(`${name}: must have ${kVelocity * this.length} numbers, but has `
                           + `${numbers.length}`);
    }
    floats(this.#velocities, numbers.length).set(numbers);
    this.#call(name, this.#velocities);
  }

  /** Becomes the list of the bodies that moved in the last step. */
  takeMoved() {
    within(() => {
      const count = room(4);
      const take = () => check(wasm.kodo_movedBodies(
        handleOf(this.world), this.memory.at, this.memory.capacity, count));
      take();
      const moved = data().getUint32(count, true);
      if (moved > this.memory.capacity) {
        this.#reserve(moved);
        take();
      }
      this.#length = moved;
    });
    const poses = this.poses();
    return { ids: new Uint32Array(wasm.memory.buffer, this.memory.at, 3 * this.length), poses };
  }
}
const freed = new FinalizationRegistry((memory) => wasm.free(memory.at));

// Canvas.

const css = ({ r, g, b, a }) => `rgb(${r} ${g} ${b} / ${a / 255})`;

export class CanvasDraw {
  constructor(context, view) {
    const { width, height } = context.canvas;
    const scale = Math.min(width / (view.upper.x - view.lower.x),
                           height / (view.upper.y - view.lower.y));
    this.context = context;
    this.pixel = 1 / scale;
    const middle = { x: (view.lower.x + view.upper.x) / 2, y: (view.lower.y + view.upper.y) / 2 };
    this.view = {
      lower: { x: middle.x - width / 2 / scale, y: middle.y - height / 2 / scale },
      upper: { x: middle.x + width / 2 / scale, y: middle.y + height / 2 / scale },
    };
  }

  toWorld({ x, y }) {
    return { x: this.view.lower.x + x * this.pixel, y: this.view.upper.y - y * this.pixel };
  }
  toCanvas({ x, y }) {
    return { x: (x - this.view.lower.x) / this.pixel, y: (this.view.upper.y - y) / this.pixel };
  }

  clear() {
    const { canvas } = this.context;
    this.context.clearRect(0, 0, canvas.width, canvas.height);
  }

  line(from, to, style) {
    this.#path([from, to], style);
    this.context.stroke();
  }

  polygon(corners, style) {
    this.#path(corners, style);
    this.context.closePath();
    this.#paint(style);
  }

  circle(center, radius, style) {
    this.#path([], style);
    const { x, y } = this.toCanvas(center);
    this.context.arc(x, y, radius / this.pixel, 0, 2 * Math.PI);
    this.#paint(style);
  }

  text(middle, text, style) {
    const { x, y } = this.toCanvas(middle);
    this.context.fillStyle = css(style.line);
    this.context.textAlign = "center";
    this.context.textBaseline = "middle";
    this.context.fillText(text, x, y);
  }

  #path(points, style) {
    this.context.beginPath();
    this.context.lineWidth = style.width;
    this.context.strokeStyle = css(style.line);
    for (const each of points) {
      const { x, y } = this.toCanvas(each);
      this.context.lineTo(x, y);
    }
  }

  #paint(style) {
    if (style.fill.a > 0) {
      this.context.fillStyle = css(style.fill);
      this.context.fill();
    }
    this.context.stroke();
  }
}
