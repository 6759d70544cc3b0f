// SPDX-License-Identifier: MIT
// Calls of the C interface: errors, memory, and objects as structs by layout.js.
import * as layout from "./layout.js";
import { loadWasm } from "./wasm.js";

const { structs } = layout;

// Errors, by the status of the C interface.

export class KodoError extends Error {
  get name() {
    return this.constructor.name;
  }
}
export class BadDefinition extends KodoError {}
export class BadBodyId extends KodoError {}
export class BadSnapshot extends KodoError {}
export class WrongUse extends KodoError {}
export class NoMemory extends KodoError {}
export class OtherError extends KodoError {}
const kErrors = [, BadDefinition, BadBodyId, BadSnapshot, WrongUse, NoMemory, OtherError];

// Functions that the engine calls. An exception from one is thrown after the call of the engine.

const ownFields = [null]; // functions of fields; a number of kodo_OwnField names one
let figures = null; // target of the present draw()
let thrown = null;
let nested = 0; // calls of such functions, one within the other
const kMostNested = 64; // the stack of the module, once too deep, stays so: each later call would fail

function guarded(work) {
  ++nested;
  try {
    if (nested > kMostNested) {
      throw new WrongUse(`a function that the engine calls: more than ${kMostNested} within each other`);
    }
    work();
  } catch (error) {
    thrown ??= { error };
  } finally {
    --nested;
  }
}

export const wasm = await loadWasm(new URL("./kodo.wasm", import.meta.url), {
  kodo: {
    field: (number, body, dt, force) =>
      guarded(() => write("FieldForce", force, ownFields[number](read("FieldBody", body), dt) ?? {},
                          "force")),
    line: (_, from, to, style) =>
      guarded(() => figures.line(read("Vec2", from), read("Vec2", to), read("DrawStyle", style))),
    circle: (_, center, radius, style) =>
      guarded(() => figures.circle(read("Vec2", center), radius, read("DrawStyle", style))),
    polygon: (_, corners, count, style) =>
      guarded(() => figures.polygon(readMany("Vec2", corners, count), read("DrawStyle", style))),
    text: (_, middle, utf8, style) =>
      guarded(() => figures.text(read("Vec2", middle), textAt(utf8), read("DrawStyle", style))),
  },
});

export function check(status) {
  if (thrown !== null) {
    const { error } = thrown;
    thrown = null;
    throw error;
  }
  if (status !== 0) {
    throw new (kErrors[status] ?? OtherError)(textAt(wasm.kodo_errorText()));
  }
}

// Memory of the module. It moves when it grows, so each use asks for its view.

let view = new DataView(wasm.memory.buffer);
export function data() {
  if (view.buffer !== wasm.memory.buffer) {
    view = new DataView(wasm.memory.buffer);
  }
  return view;
}
export const floats = (at, count) => new Float32Array(wasm.memory.buffer, at, count);
export const bytesAt = (at, count) => new Uint8Array(wasm.memory.buffer, at, count);
function textAt(at) {
  const bytes = new Uint8Array(wasm.memory.buffer, at);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

export function allocate(size) {
  const at = size < 2 ** 31 ? wasm.malloc(size) : 0;
  if (at === 0) {
    throw new NoMemory("memory: exhausted");
  }
  return at;
}

// Arguments of a call lie in one block, as on a stack; what does not fit gets memory of its own.
const kBlock = 1 << 16; // bytes
const block = allocate(kBlock);
const extra = [];
let used = 0;

export function room(size) {
  const start = (used + 7) & ~7;
  if (start + size <= kBlock) {
    used = start + size;
    return block + start;
  }
  const at = allocate(size);
  extra.push(at);
  return at;
}

/** Runs work that uses room(), and frees it. */
export function within(work) {
  const before = used;
  const kept = extra.length;
  try {
    return work();
  } finally {
    used = before;
    while (extra.length > kept) {
      wasm.free(extra.pop());
    }
  }
}

// Values between objects and structs, by layout.js.

const kBits = { i32: 32, u32: 32, u16: 16, u8: 8, u64: 64 };

/** Refuses what would become another number. Negative ones are masks too, as ~flag. */
export function checkNumber(type, value, path) {
  if (typeof value !== "number") {
    throw new TypeError(`${path}: must be a number, but is ${String(value)}`);
  }
  const bits = kBits[type];
  if (bits !== undefined
      && !(Number.isInteger(value) && value >= -(2 ** (bits - 1)) && value < 2 ** bits)) {
    throw new RangeError(`${path}: must be a whole number of ${bits} bits, but is ${value}`);
  }
  return value;
}
const number = (type, set) => (at, value, path) => set(at, checkNumber(type, value, path));
const kScalars = {
  f32: { size: 4, get: (at) => data().getFloat32(at, true),
         set: number("f32", (at, value) => data().setFloat32(at, value, true)) },
  i32: { size: 4, get: (at) => data().getInt32(at, true),
         set: number("i32", (at, value) => data().setInt32(at, value, true)) },
  u32: { size: 4, get: (at) => data().getUint32(at, true),
         set: number("u32", (at, value) => data().setUint32(at, value, true)) },
  u16: { size: 2, get: (at) => data().getUint16(at, true),
         set: number("u16", (at, value) => data().setUint16(at, value, true)) },
  u8: { size: 1, get: (at) => data().getUint8(at),
        set: number("u8", (at, value) => data().setUint8(at, value)) },
  b: { size: 1, get: (at) => data().getUint8(at) !== 0,
       set: (at, value) => data().setUint8(at, value ? 1 : 0) },
  u64: { size: 8, get: (at) => Number(data().getBigUint64(at, true)),
         set: number("u64", (at, value) => data().setBigUint64(at, BigInt(value), true)) },
};
export const sizeOf = (type) => (kScalars[type] ?? structs[type]).size;

export function readMany(type, at, count) {
  return Array.from({ length: count }, (_, i) => read(type, at + i * sizeOf(type)));
}

export function read(type, at) {
  const scalar = kScalars[type];
  if (scalar !== undefined) {
    return scalar.get(at);
  }
  const { fields, choices, tag, union } = structs[type];
  const made = {};
  for (const [name, offset, kind, how, other] of fields) {
    if (how === "items") {
      made[name] = readMany(kind, data().getUint32(at + offset, true),
                            data().getUint32(at + other, true));
    } else if (how === "row") {
      made[name] = readMany(kind, at + offset, other);
    } else if (how === "value" || (how === "optional" && kScalars.b.get(at + other))) {
      made[name] = read(kind, at + offset);
    }
  }
  if (choices !== undefined) {
    const [name, kind] = choices[data().getInt32(at + tag, true)];
    made[name] = kind === "OwnField" ? ownFields[wasm.kodo_js_numberOf(at + union)]
                                     : read(kind, at + union);
  }
  return made;
}

/** What a function for defaults takes beside the head: the kind, or the profile of a solver. */
function kindOf(type, choice) {
  const profile = choice === 0 ? layout.Profile.Balanced : layout.Profile.Thesis2006;
  return { Settings: [profile], JointDef: [choice], Field: [choice] }[type] ?? [];
}

/** Writes the head of a definition and the defaults of the engine. */
export function initialise(type, at, kind = kindOf(type, 0)) {
  const head = room(sizeOf("Head"));
  write("Head", head, { size: sizeOf(type), version: layout.cVersion, realSize: 4 }, type);
  check(wasm[`kodo_init${type}`](at, head, ...kind));
}

let material = null; // that of a body by default

/** What a struct holds before an object is written over it. */
function prefill(type, at) {
  const struct = structs[type];
  if (struct === undefined) {
    return;
  }
  if (struct.init) {
    initialise(type, at);
    return;
  }
  bytesAt(at, struct.size).fill(0);
  if (type === "Rot") {
    data().setFloat32(at, 1, true);
  } else if (type === "Material") {
    material ??= within(() => {
      const def = room(sizeOf("BodyDef"));
      initialise("BodyDef", def);
      const [, offset] = structs.BodyDef.fields.find(([name]) => name === "material");
      return bytesAt(def + offset, sizeOf("Material")).slice();
    });
    bytesAt(at, struct.size).set(material);
  } else {
    for (const [, offset, kind] of struct.fields.filter(([, , , how]) => how !== "items")) {
      prefill(kind, at + offset);
    }
  }
}

function writeChoice(type, at, value, path) {
  const { choices, tag, union, init } = structs[type];
  const choice = choices.findIndex(([name]) => value[name] !== undefined);
  if (choice < 0) {
    return [];
  }
  const [name, kind] = choices[choice];
  if (data().getInt32(at + tag, true) !== choice || !init) {
    if (init) {
      initialise(type, at, kindOf(type, choice));
    }
    data().setInt32(at + tag, choice, true);
    if (!init) {
      prefill(kind, at + union);
    }
  }
  if (kind === "OwnField") {
    if (typeof value.own !== "function") {
      throw new TypeError(`${path}.own: must be a function, but is ${String(value.own)}`);
    }
    const known = ownFields.indexOf(value.own);
    const place = known > 0 ? known : ownFields.push(value.own) - 1;
    wasm.kodo_js_setField(at + union, place, value.own.steady ? 1 : 0);
  } else {
    write(kind, at + union, value[name], `${path}.${name}`);
  }
  return [name];
}

/** Writes the properties of an object over what is there. */
export function write(type, at, value, path) {
  const scalar = kScalars[type];
  if (scalar !== undefined) {
    scalar.set(at, value, path);
    return;
  }
  if (typeof value !== "object" || value === null) {
    throw new TypeError(`${path}: must be an object, but is ${String(value)}`);
  }
  const struct = structs[type];
  const given = type === "BodyId" && value.id !== undefined ? value.id : value; // a Body
  const known = struct.choices ? writeChoice(type, at, given, path) : [];
  for (const [name, offset, kind, how, other] of struct.fields) {
    known.push(name);
    const one = given[name];
    if (one === undefined) {
      continue;
    }
    if (how === "items") {
      const [items, count] = writeMany(kind, one, `${path}.${name}`);
      data().setUint32(at + offset, items, true);
      data().setUint32(at + other, count, true);
    } else if (how === "pointer") {
      data().setUint32(at + offset, writeMany(kind, [one], `${path}.${name}`)[0], true);
    } else {
      if (how === "optional") {
        kScalars.b.set(at + other, true);
      }
      write(kind, at + offset, one, `${path}.${name}`);
    }
  }
  const unknown = Object.keys(given).find((name) => !known.includes(name));
  if (unknown !== undefined) {
    throw new TypeError(`${path}.${unknown}: ${type} has no such property`);
  }
}

/** Writes an array into memory of the present call; returns its address and length. */
export function writeMany(type, values, path) {
  const count = values?.length; // once: a getter in the array may make it longer
  if (typeof values !== "object" || !Number.isInteger(count) || count < 0) {
    throw new TypeError(`${path}: must be an array, but is ${String(values)}`);
  }
  const size = sizeOf(type);
  const at = room(Math.max(1, count * size));
  if (values instanceof Uint8Array && type === "u8") {
    bytesAt(at, count).set(values);
    return [at, count];
  }
  for (let i = 0; i < count; ++i) {
    prefill(type, at + i * size);
    write(type, at + i * size, values[i], `${path}[${i}]`);
  }
  return [at, count];
}

/** A struct in memory of the present call: the defaults, and an object over them. */
export function made(type, value, path) {
  const at = room(sizeOf(type));
  prefill(type, at);
  write(type, at, value, path);
  return at;
}

// Calls.

const listSizes = {}; // items that a list had last

/** Calls a function of the C interface: parameters as layout.js lists them, and their values. */
export function call(name, parameters, values) {
  return within(() => {
    const results = [];
    const given = [...values];
    const list = parameters.find(([how]) => how === "list");
    let capacity = listSizes[name] ?? 16;
    const fixed = [];
    const handles = []; // taken last: a getter of an argument may destroy a World
    for (const [how, type, label] of parameters) {
      if (how === "handle") {
        handles.push([fixed.length, given.shift()]);
        fixed.push(0);
      } else if (how === "number") {
        const value = checkNumber(type, given.shift(), label);
        fixed.push(type === "u64" ? BigInt(value) : value);
      } else if (how === "in" || how === "maybe") {
        const value = given.shift();
        fixed.push(how === "maybe" && value === undefined ? 0 : made(type, value, label));
      } else if (how === "array") {
        fixed.push(...writeMany(type, given.shift(), label));
      } else if (how === "out") {
        const at = room(sizeOf(type));
        bytesAt(at, sizeOf(type)).fill(0);
        results.push(() => label === "hash" ? data().getBigUint64(at, true) : read(type, at));
        fixed.push(at);
      }
    }
    handles.forEach(([i, world]) => { fixed[i] = handleOf(world); });
    if (list === undefined) {
      check(wasm[`kodo_${name}`](...fixed));
      return results[0]?.();
    }
    const [, type, label] = list;
    const count = room(4);
    for (;;) {
      const items = room(Math.max(1, capacity * sizeOf(type)));
      check(wasm[`kodo_${name}`](...fixed, items, capacity, count));
      const found = data().getUint32(count, true);
      if (found <= capacity) {
        listSizes[name] = Math.max(16, found);
        return type !== "u8" ? readMany(type, items, found)
             : label === "text" ? new TextDecoder().decode(bytesAt(items, found))
             : bytesAt(items, found).slice();
      }
      capacity = found;
    }
  });
}

export function handleOf(world) {
  if (typeof world?.handle !== "number" || world.handle === 0) {
    throw new WrongUse("world: must be a World that was not destroyed");
  }
  return world.handle;
}

/** Draws by functions of JavaScript. */
export function drawWith(target, work) {
  const outer = figures;
  figures = target;
  try {
    work();
  } finally {
    figures = outer;
  }
}

