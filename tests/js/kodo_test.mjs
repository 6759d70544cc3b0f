// SPDX-License-Identifier: MIT
// The package for npm in node: KODO_NPM is its folder. Run by tools/web --check and by ctest.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const kodo = await import(pathToFileURL(`${process.env.KODO_NPM}/kodo.js`).href);
const { World, box, circle, withFriction } = kodo;

const kDt = 1 / 60; // s
const kDown = { x: 0, y: -10 }; // m/s^2

function withGround(width = 20) {
  const world = new World({ gravity: kDown });
  world.add({ shape: box(width, 2), position: { x: 0, y: -1 }, type: kodo.BodyType.Static });
  return world;
}

function stack(count) {
  const world = withGround();
  for (let i = 0; i < count; ++i) {
    world.add({ shape: box(1, 1), position: { x: 0, y: 0.5 + i } });
  }
  return world;
}

function pyramid(rows) {
  const world = withGround(60);
  for (let row = 0; row < rows; ++row) {
    for (let i = row; i < rows; ++i) {
      world.add({ shape: box(1, 1), position: { x: 1.1 * (i - 0.5 * (row + rows - 1)), y: 0.5 + row } });
    }
  }
  return world;
}

/** 64-bit FNV-1a, as kodo::StateHash. */
class StateHash {
  value = 14695981039346656037n;
  #bytes = new DataView(new ArrayBuffer(8));
  #add(count) {
    for (let i = 0; i < count; ++i) {
      const byte = BigInt(this.#bytes.getUint8(i));
      this.value = BigInt.asUintN(64, (this.value ^ byte) * 1099511628211n);
    }
  }
  integer(number, size) {
    this.#bytes.setBigUint64(0, BigInt(number), true);
    this.#add(size);
  }
  real(number) {
    this.#bytes.setFloat32(0, number + 0, true);
    this.#add(4);
  }
}

/** Hashes of golden.txt: of the state and of all records, every 60 steps. */
function hashes(world, steps) {
  const records = new StateHash();
  const found = [];
  for (let step = 1; step <= steps; ++step) {
    world.step(kDt);
    for (const { a, b, partA, partB, phase, pointCount, points, ...record } of world.collisions()) {
      for (const number of [a.index, a.generation, b.index, b.generation, partA, partB]) {
        records.integer(number, 4);
      }
      records.integer(phase, 1);
      records.integer(pointCount, 1);
      const { point, normal, separation, approachSpeed, maxImpulse, totalImpulse } = record;
      [point.x, point.y, normal.x, normal.y, separation, approachSpeed, maxImpulse, totalImpulse]
        .forEach((number) => records.real(number));
      for (const { position, ...one } of points) {
        [position.x, position.y, one.separation, one.maxImpulse].forEach((number) => records.real(number));
      }
    }
    if (step % 60 === 0) {
      const all = Object.assign(new StateHash(), { value: records.value });
      all.integer(world.stateHash(), 8);
      found.push(all.value.toString(16).padStart(16, "0"));
    }
  }
  return found;
}

const golden = readFileSync(new URL("../determinism/golden.txt", import.meta.url), "utf8");
for (const [name, make] of [["stack", () => stack(10)], ["pyramid", () => pyramid(10)]]) {
  test(`${name} has the state hashes and records of the native engine`, () => {
    const expected = golden.split("\n").map((line) => line.split(" "))
      .filter(([scene, precision]) => scene === name && precision === "float")
      .map(([, , , hash]) => hash).slice(0, 5);
    assert.equal(expected.length, 5);
    assert.deepEqual(hashes(make(), 300), expected);
  });
}

test("a World goes back by copy, assign and bytes, and continues with the same bits", () => {
  const world = pyramid(5);
  world.add({ shape: circle(0.5), position: { x: -8, y: 2 }, velocity: { x: 20, y: 0 } });
  for (let i = 0; i < 30; ++i) {
    world.step(kDt);
  }
  const past = world.copy();
  const bytes = world.toBytes();
  const run = (one) => {
    for (let i = 0; i < 60; ++i) {
      one.step(kDt);
    }
    return one.stateHash();
  };
  const expected = run(world);
  assert.equal(run(World.fromBytes(bytes)), expected);
  world.assign(past);
  assert.equal(run(world), expected);
  assert.equal(run(past), expected);
});

test("an error is an exception with the sentence of the engine", () => {
  const world = withGround();
  const before = world.stateHash();
  assert.throws(() => world.add({ shape: circle(-1) }), (error) =>
    error instanceof kodo.BadDefinition && error instanceof kodo.KodoError
    && error.message === "shape.radius: must be greater than 0 m, but is -1");
  const ball = world.add({});
  ball.remove();
  assert.throws(() => ball.state(), kodo.BadBodyId);
  assert.throws(() => World.fromBytes(new Uint8Array(9)), kodo.BadSnapshot);
  assert.throws(() => world.add({ shape: { circle: { radus: 1 } } }),
                /^TypeError: body\.shape\.circle\.radus: Circle has no such property$/);
  assert.throws(() => world.add({ position: { x: "1" } }), /body\.position\.x: must be a number/);
  assert.equal(world.copy().bodyCount(), 1);
  assert.equal(typeof before, "bigint");
  world.destroy();
  assert.throws(() => world.step(kDt), kodo.WrongUse);
});

test("all shapes collide with a ball that falls on them", () => {
  const shapes = [
    circle(1), box(2, 2, { angle: Math.PI / 2, radius: 0.1 }),
    kodo.polygon([{ x: -1, y: -1 }, { x: 1, y: -1 }, { x: 1, y: 1 }, { x: -1, y: 1 }]),
    kodo.compound([box(1, 2, { center: { x: -0.5, y: 0 } }), box(1, 2, { center: { x: 0.5, y: 0 } })]),
    kodo.segment({ x: -1, y: 1 }, { x: 1, y: 1 }), kodo.plane({ x: 0, y: 1 }, 1),
    kodo.heightmap(1, [1, 1, 1], { origin: { x: -1, y: 0 } }),
    kodo.chain([{ x: -1, y: 1 }, { x: 0, y: 1 }, { x: 1, y: 1 }], { materials: [{}, withFriction(1)] }),
    kodo.capsule({ x: -1, y: 0 }, { x: 1, y: 0 }, 1),
    kodo.compound(kodo.decompose(
      [{ x: -2, y: -1 }, { x: 2, y: -1 }, { x: 2, y: 1 }, { x: 0.5, y: 1 }, { x: 0, y: 0.9 },
       { x: -0.5, y: 1 }, { x: -2, y: 1 }])),
  ];
  for (const shape of shapes) {
    const world = new World({ gravity: kDown });
    world.add({ shape, type: kodo.BodyType.Static });
    const ball = world.add({ position: { x: 0, y: 3 } });
    for (let i = 0; i < 90; ++i) {
      world.step(kDt);
    }
    // Half a metre above the top, at 1 m, or 0.1 m beside; 5 mm of overlap.
    assert.ok(Math.abs(ball.position.y - 1.5) < 0.12, `${JSON.stringify(shape)}: ${ball.position.y}`);
  }
  assert.deepEqual(kodo.convexHull([{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0.25, y: 0.25 }, { x: 0, y: 1 }]),
                   [{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0, y: 1 }]);
});

test("only a body whose continuous mode says so tunnels", () => {
  const { ContinuousNever, ContinuousStatic, ContinuousAll } = kodo.ContinuousMode;
  for (const continuousMode of [ContinuousNever, ContinuousStatic, ContinuousAll]) {
    const world = new World();
    world.add({ shape: box(0.02, 9), position: { x: 5, y: 0 }, type: kodo.BodyType.Static });
    const ball = world.add({ shape: circle(0.1), velocity: { x: 400, y: 0 }, continuousMode });
    assert.equal(ball.state().continuousMode, continuousMode);
    world.step(kDt);
    assert.equal(ball.position.x > 5, continuousMode === ContinuousNever);
    ball.setContinuousMode(ContinuousAll);
    assert.equal(ball.state().continuousMode, ContinuousAll);
  }
});

test("joints are read as they were given", () => {
  const world = withGround();
  const [a, b, c] = [0, 2, 4].map((x) => world.add({ shape: box(1, 1), position: { x, y: 2 } }));
  const given = {
    revolute: { limits: { lower: -1, upper: 1 }, motorSpeed: 2, motorTorque: 5 },
    fixed: { hertz: 2 },
    distance: { length: 2, hertz: 3, damping: 0.5 },
    prismatic: { axis: { x: 0, y: 1 }, limits: { lower: 0, upper: 2 } },
    motor: { force: 10, torque: 5, hertz: 5, damping: 1 },
    wheel: { axis: { x: 0, y: 1 }, hertz: 4 },
    pulley: { groundA: { x: 0, y: 9 }, groundB: { x: 2, y: 9 }, length: 14, ratio: 2 },
    gear: { ratio: -2, rack: { x: 1, y: 0 } },
    filter: {},
  };
  for (const [kind, numbers] of Object.entries(given)) {
    const id = world.addJoint({ [kind]: { a, b, ...numbers } });
    const read = world.joint(id)[kind];
    assert.deepEqual(read.a, a.id);
    assert.equal(read.breakForce, Infinity);
    for (const [name, value] of Object.entries(numbers)) {
      assert.deepEqual(read[name], value, `${kind}.${name}`);
    }
    if (kind === "revolute") {
      world.setJoint(id, { revolute: { motorSpeed: -1 } });
      assert.equal(world.joint(id).revolute.motorSpeed, -1);
      assert.deepEqual(world.joint(id).revolute.limits, numbers.limits);
      assert.equal(world.jointState(id).angle, 0);
    }
    world.removeJoint(id);
  }
  const held = world.addJoint({ mouse: { body: c, target: { x: 5, y: 5 }, force: 100 } });
  assert.ok(world.containsJoint(held));
  assert.deepEqual(world.jointsOf === undefined, true); // a method of a body
  assert.deepEqual(c.jointsOf(), [held]);
});

test("queries and records name bodies", () => {
  const world = withGround();
  const ball = world.add({ position: { x: 0, y: 2 }, userData: 7 });
  const ray = { from: { x: 0, y: 9 }, to: { x: 0, y: -9 } };
  assert.deepEqual(world.rayCast(ray).body, ball.id);
  assert.equal(world.rayCast(ray, { except: [ball] }).body.index, 0);
  assert.equal(world.rayCastAll(ray).length, 2);
  assert.deepEqual(world.overlapBox({ lower: { x: -1, y: 1 }, upper: { x: 1, y: 3 } }), [ball.id]);
  assert.equal(world.closestPoint({ x: 3, y: 2 }, 10).distance, 2);
  const start = { shape: circle(0.5), at: { position: { x: 3, y: 2 } } };
  assert.equal(world.shapeCast(start, { x: -4, y: 0 }).fraction, 0.5);
  let hit;
  for (let i = 0; i < 60 && hit === undefined; ++i) {
    world.step(kDt);
    [hit] = world.hits(1);
  }
  assert.deepEqual([hit.a.index, hit.b.index, hit.phase], [0, 1, kodo.TouchPhase.Begin]);
  assert.equal(world.body(hit.b).state().userData, 7);
});

test("views have the poses of a list of bodies and of those that moved", () => {
  const world = stack(40);
  const bodies = world.bodies();
  const loose = world.list(bodies.slice(1));
  loose.setVelocities(Float32Array.from({ length: 120 }, (_, i) => (i % 3 === 0 ? 1 : 0)));
  world.step(kDt);
  const { ids, poses } = world.movedPoses();
  assert.ok(poses instanceof Float32Array);
  assert.equal(ids.length, 3 * 40);
  assert.deepEqual([...poses], [...loose.poses()]);
  const first = world.body(bodies[1]);
  assert.deepEqual([poses[0], poses[1]], [first.position.x, first.position.y]);
  assert.ok(loose.velocities()[0] > 0.5);
  assert.throws(() => loose.applyLoads([1]), RangeError);
});

test("a field of the user acts, and its exception is thrown after the step", () => {
  const world = new World();
  const ball = world.add({ mass: { mass: 2 } });
  const push = (body) => ({ force: { x: 3 * body.mass, y: 0 } });
  world.addField({ own: push });
  world.step(0.5);
  assert.equal(ball.velocity.x, 1.5);
  const copy = World.fromBytes(world.toBytes(), [push]);
  copy.step(0.5);
  assert.equal(copy.body(ball).velocity.x, 3);
  world.setFields([{ own: () => { throw new Error("no force"); } }, { gravity: { acceleration: kDown } }]);
  assert.throws(() => world.step(0.5), /no force/);
  assert.equal(ball.velocity.y, -5);
});

test("a mover walks to a wall, goes back with its World, and jumps", () => {
  const world = withGround();
  world.add({ shape: box(1, 4), position: { x: 4, y: 2 }, type: kodo.BodyType.Static });
  const mover = new kodo.Mover({ shape: circle(0.5), position: { x: 0, y: 0.6 } });
  const walk = (one, place, steps) => {
    for (let i = 0; i < steps; ++i) {
      place.step(kDt);
      one.move(place, { x: 3, y: one.velocity.y + kDown.y * kDt }, kDt);
    }
    return one.position;
  };
  walk(mover, world, 30);
  assert.ok(mover.grounded);
  assert.deepEqual([mover.groundBody.index, mover.groundNormal.y], [0, 1]);
  const [past, copy] = [world.copy(), new kodo.Mover(mover)];
  const end = walk(mover, world, 60);
  assert.ok(Math.abs(end.x - (3.5 - 0.5 - mover.skin)) < 1e-5, `${end.x}`); // m: some roundings
  assert.equal(mover.wallNormal.x, -1);
  assert.deepEqual(walk(copy, past, 60), end);
  mover.move(world, { x: 0, y: 5 }, kDt);
  assert.ok(!mover.grounded && mover.position.y > end.y + 0.05);
  mover.position = { x: -3, y: 0.6 }; // a teleport
  mover.move(world, { x: 0, y: 0 }, kDt);
  assert.equal(mover.position.x, -3);
  assert.throws(() => new kodo.Mover({ skin: 0 }).move(world, { x: 0, y: 0 }, kDt), kodo.BadDefinition);
  assert.throws(() => new kodo.Mover({ speed: 1 }), /mover\.speed: Mover has no such property/);
});

test("an explosion pushes each body in reach once, and lists all", () => {
  const world = new World();
  const count = 40; // more than a list has room for at first
  const balls = Array.from({ length: count }, (_, i) => {
    const [x, y] = [Math.cos(2 * Math.PI * i / count), Math.sin(2 * Math.PI * i / count)];
    return world.add({ shape: circle(0.1), position: { x: 3 * x, y: 3 * y }, mass: { mass: 2 } });
  });
  const far = world.add({ shape: circle(0.1), position: { x: 9, y: 0 } });
  const hits = world.explode({ radius: 4, impulse: 10 });
  assert.deepEqual(hits.map(({ body }) => body), balls.map(({ id }) => id));
  for (const [i, { impulse, width }] of hits.entries()) {
    assert.ok(Math.abs(width - 0.2) < 0.02, `${width}`); // m: the diameter, by rays
    const { x, y } = balls[i].velocity;
    assert.ok(Math.hypot(x - impulse.x / 2, y - impulse.y / 2) < 1e-6); // J = m v
    assert.ok(x * balls[i].position.x + y * balls[i].position.y > 0);
  }
  assert.deepEqual(far.velocity, { x: 0, y: 0 });
  assert.throws(() => world.explode({ radius: 0 }), kodo.BadDefinition);
});

test("a picture has figures for bodies and joints", () => {
  const world = stack(2);
  const [, a, b] = world.bodies();
  world.addJoint({ distance: { a, b, hertz: 1, length: 1 } });
  const figures = [];
  const note = (name) => (...given) => figures.push([name, ...given]);
  world.draw({ view: world.viewOf(), pixel: 0.01, line: note("line"), circle: note("circle"),
               polygon: note("polygon"), text: note("text") }, { labels: true });
  assert.ok(figures.filter(([name]) => name === "polygon").length >= 3);
  assert.ok(figures.some(([name, , text]) => name === "text" && text === "1"));
  assert.match(world.svg(), /^<svg/);
});

test("values of a wrong kind are refused, instead of taken as others", () => {
  const world = withGround();
  const ball = world.add({ position: { x: 0, y: 5 } });
  for (const type of [NaN, 1.5, 2 ** 32 + 2]) {
    assert.throws(() => world.add({ type }), /^RangeError: body\.type: must be a whole number of 32 bits/);
    assert.throws(() => ball.setType(type), RangeError);
  }
  assert.throws(() => ball.setUserData(2 ** 70), RangeError);
  ball.setGroup(-1);
  for (const wrong of ["0.1", undefined, [0.1], null]) {
    assert.throws(() => world.step(wrong), /^TypeError: dt: must be a number/);
    assert.throws(() => kodo.rotation(wrong), TypeError);
    assert.throws(() => kodo.settings(wrong), TypeError);
  }
  for (const heights of [new Set([1, 2]), "12", null, 7, { length: -1 }, { length: 2.5 }]) {
    assert.throws(() => world.add({ shape: kodo.heightmap(1, heights) }),
                  /^TypeError: body\.shape\.heightmap\.heights: must be an array/);
  }
  assert.throws(() => world.add({ shape: kodo.heightmap(1, { length: 2 ** 30 + 2 }) }), kodo.NoMemory);
  assert.throws(() => World.fromBytes(world.toBytes().buffer), /snapshot\.bytes: must be an array/);
  for (const own of [null, 5, {}]) {
    assert.throws(() => world.addField({ own }), /^TypeError: field\.own: must be a function/);
  }
  assert.equal(world.list(new Set(world.bodies())).poses()[5], 5);
  world.list([ball, ball, ball, ball]).destroy();
  assert.throws(() => world.list([{ index: 1 }]).poses(), kodo.BadBodyId); // the rest is 0
  assert.throws(() => { world.list([ball]).length = 1000; }, TypeError);
  assert.equal(world.bodyCount(), 2);
});

test("getters in a definition may add to it and destroy its World", () => {
  const world = withGround();
  const points = [0, 1].map((x) => ({ x, get y() { return points.push({ x: points.length, y: 0 }) && 0; } }));
  const chain = world.add({ shape: kodo.chain(points), type: kodo.BodyType.Static });
  assert.equal(points.length, 4);
  assert.equal(chain.state().partCount, 1);
  const last = (name) => ({ get [name]() { world.copy(); gone.destroy(); return undefined; } });
  let gone;
  for (const use of [(one) => one.add(last("position")), (one) => one.addField(last("which")),
                     (one) => one.explode(last("center")), (one) => one.rayCast({}, last("which")),
                     (one) => one.applyForceToAll(last("x"))]) {
    gone = withGround();
    assert.throws(() => use(gone), kodo.WrongUse);
  }
  world.step(kDt);
});

test("functions that the engine calls within each other end before the stack does", () => {
  const world = stack(2);
  let deepest = 0, depth = 0;
  const picture = { view: world.viewOf(), pixel: 0.01, line() {}, circle() {}, text() {}, polygon() {
    deepest = Math.max(deepest, ++depth);
    try {
      world.draw(picture);
    } finally {
      --depth;
    }
  } };
  assert.throws(() => world.draw(picture), kodo.WrongUse);
  assert.equal(deepest, 64);
  world.step(kDt);
});

test("kodo.d.ts names what the module exports", () => {
  const types = ["kodo.d.ts", "layout.d.ts"]
    .map((name) => readFileSync(`${process.env.KODO_NPM}/${name}`, "utf8")).join("");
  const named = [...types.matchAll(/^export (?:declare )?(?:class|const|function) (\w+)/gm)];
  assert.deepEqual(named.map(([, name]) => name).sort(), Object.keys(kodo).sort());
});

test("a World that is left is freed", () => {
  const before = new World();
  before.destroy();
  for (let i = 0; i < 200; ++i) {
    const world = pyramid(10);
    world.destroy();
  }
});

test("kodo.wasm has less than 400 kB by gzip", () => {
  // The zlib of node makes it 0.5 % larger.
  const size = execFileSync("gzip", ["-9c", `${process.env.KODO_NPM}/kodo.wasm`]).length;
  assert.ok(size < 400e3, `${size} bytes`);
});
