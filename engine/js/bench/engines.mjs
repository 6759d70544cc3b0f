// SPDX-License-Identifier: MIT
// One World of each engine from a scene: step(), and poses() of all bodies in the scene's order.
// Default settings; friction 0.6; bullets as each engine has them.
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const kDt = 1 / 60; // s
const kFriction = 0.6;
const packages = createRequire(pathToFileURL(`${process.cwd()}/`));
const load = async (name) => import(pathToFileURL(packages.resolve(name)).href);

async function kodo(folder) {
  const { World, BodyType, Flags, box, circle, compound } =
    await import(pathToFileURL(`${folder}/kodo.js`).href);
  return (scene) => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const bodies = scene.bodies.map((body) => world.add({
      shape: body.boxes ? compound(body.boxes.map(({ w, h, x, y }) => box(w, h, { center: { x, y } })))
             : body.r ? circle(body.r) : box(body.w, body.h),
      position: { x: body.x, y: body.y }, velocity: { x: body.vx ?? 0, y: body.vy ?? 0 }, density: body.density ?? 1,
      type: body.type === "static" ? BodyType.Static : BodyType.Dynamic,
      flags: body.ghost ? Flags.Disabled : 0,
    }));
    for (const { a, b, x, y, lower, upper, motorSpeed = 0, motorTorque = 0 } of scene.joints) {
      const [anchorA, anchorB] = [a, b].map(
        (i) => ({ x: x - scene.bodies[i].x, y: y - scene.bodies[i].y }));
      world.addJoint({ revolute: { a: bodies[a], b: bodies[b], anchorA, anchorB, motorSpeed, motorTorque,
                                   limits: lower === undefined ? undefined : { lower, upper } } });
    }
    const list = world.list(bodies);
    return {
      step: () => world.step(kDt),
      poses: () => {
        const numbers = list.poses();
        return bodies.map((_, i) => ({ x: numbers[4 * i], y: numbers[4 * i + 1],
                                       angle: Math.atan2(numbers[4 * i + 3], numbers[4 * i + 2]) }));
      },
    };
  };
}

async function rapier() {
  const { default: R } = await load("@dimforge/rapier2d-simd-compat");
  await R.init();
  return (scene) => {
    const world = new R.World({ x: 0, y: -10 });
    world.timestep = kDt;
    const bodies = scene.bodies.map((body) => {
      const def = body.type === "static" ? R.RigidBodyDesc.fixed() : R.RigidBodyDesc.dynamic();
      const made = world.createRigidBody(def.setTranslation(body.x, body.y)
        .setLinvel(body.vx ?? 0, body.vy ?? 0).setCcdEnabled(body.bullet ?? false));
      for (const { r, w, h, x = 0, y = 0 } of body.boxes ?? [{ ...body, x: 0, y: 0 }]) {
        const collider = (r ? R.ColliderDesc.ball(r) : R.ColliderDesc.cuboid(w / 2, h / 2))
          .setTranslation(x, y).setDensity(body.density ?? 1).setFriction(kFriction)
          .setSensor(body.ghost ?? false);
        world.createCollider(collider, made);
      }
      return made;
    });
    for (const { a, b, x, y, lower, upper, motorSpeed, motorTorque } of scene.joints) {
      const at = (i) => ({ x: x - scene.bodies[i].x, y: y - scene.bodies[i].y });
      const joint = world.createImpulseJoint(
        R.JointData.revolute(at(a), at(b)), bodies[a], bodies[b], true);
      joint.setContactsEnabled(false);
      if (lower !== undefined) {
        joint.setLimits(lower, upper);
      }
      if (motorSpeed !== undefined) {
        joint.configureMotorVelocity(motorSpeed, motorTorque);
      }
    }
    return {
      step: () => world.step(),
      poses: () => bodies.map((body) => ({ ...body.translation(), angle: body.rotation() })),
    };
  };
}

async function planck() {
  const module = await load("planck");
  const pl = module.default ?? module; // of a package in CommonJS
  return (scene) => {
    const world = new pl.World({ gravity: pl.Vec2(0, -10) });
    const bodies = scene.bodies.map((body) => {
      const made = world.createBody({ type: body.type ?? "dynamic", position: pl.Vec2(body.x, body.y),
        linearVelocity: pl.Vec2(body.vx ?? 0, body.vy ?? 0), bullet: body.bullet ?? false });
      for (const { r, w, h, x = 0, y = 0 } of body.boxes ?? [{ ...body, x: 0, y: 0 }]) {
        made.createFixture({ shape: r ? pl.Circle(r) : pl.Box(w / 2, h / 2, pl.Vec2(x, y)),
          density: body.density ?? 1, friction: kFriction, isSensor: body.ghost ?? false });
      }
      return made;
    });
    for (const { a, b, x, y, lower, upper, motorSpeed, motorTorque } of scene.joints) {
      world.createJoint(pl.RevoluteJoint({ enableLimit: lower !== undefined, lowerAngle: lower,
        upperAngle: upper, enableMotor: motorSpeed !== undefined, motorSpeed,
        maxMotorTorque: motorTorque }, bodies[a], bodies[b], pl.Vec2(x, y)));
    }
    return {
      step: () => world.step(kDt),
      poses: () => bodies.map((body) => ({ ...body.getPosition(), angle: body.getAngle() })),
    };
  };
}

async function matter() {
  const { default: M } = await load("matter-js");
  const kScale = 50; // pixels of a metre: the engine's tolerances are pixels
  return (scene) => {
    const engine = M.Engine.create();
    engine.gravity.y = -1;
    engine.gravity.scale = 10 * kScale / 1e6; // pixels/ms^2
    const bodies = scene.bodies.map((body) => {
      const options = { isStatic: body.type === "static", friction: kFriction,
                        density: (body.density ?? 1) / kScale ** 2, isSensor: body.ghost ?? false };
      const one = ({ r, w, h, x, y }) => r
        ? M.Bodies.circle(kScale * x, kScale * y, kScale * r, options)
        : M.Bodies.rectangle(kScale * x, kScale * y, kScale * w, kScale * h, options);
      const made = body.boxes ? M.Body.create({ parts: body.boxes.map(one), ...options }) : one(body);
      if (body.group) {
        made.collisionFilter.group = -body.group;
      }
      M.Body.setVelocity(made, { x: kScale * (body.vx ?? 0) / 60, y: kScale * (body.vy ?? 0) / 60 });
      M.Composite.add(engine.world, made);
      return made;
    });
    for (const { a, b, x, y } of scene.joints) { // without limits and motors, which it lacks
      const at = (i) => ({ x: kScale * (x - scene.bodies[i].x), y: kScale * (y - scene.bodies[i].y) });
      M.Composite.add(engine.world, M.Constraint.create({ bodyA: bodies[a], bodyB: bodies[b],
        pointA: at(a), pointB: at(b), length: 0, stiffness: 1 }));
    }
    const turned = scene.joints.find(({ motorSpeed }) => motorSpeed !== undefined);
    return {
      step: () => {
        if (turned) {
          M.Body.setAngularVelocity(bodies[turned.b], turned.motorSpeed / 60);
        }
        M.Engine.update(engine, 1000 / 60);
      },
      poses: () => bodies.map(({ position, angle }) =>
        ({ x: position.x / kScale, y: position.y / kScale, angle })),
    };
  };
}

export const engines = { kodo, rapier, planck, matter };
