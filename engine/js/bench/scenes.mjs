// SPDX-License-Identifier: MIT
// Scenes for each engine: bodies { w, h } or { r } with x, y, and joints at points of the world.

/** Numbers in [0, 1), the same each time: a linear congruential generator. */
function dice(seed = 1) {
  return () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}
const fixed = (w, h, x, y, more = {}) => ({ w, h, x, y, type: "static", ...more });
const count = (poses, condition) => poses.filter(condition).length;
const lostBelow = (y) => (poses) => count(poses.slice(1), (pose) => !(pose.y > y));

/** Largest distance (m) between the two anchors of a joint. */
function worstGap(scene, poses) {
  return Math.max(...scene.joints.map(({ a, b, x, y }) => {
    const [p, q] = [a, b].map((i) => {
      const { x: x0, y: y0, angle: start = 0 } = scene.bodies[i];
      const turned = poses[i].angle - start;
      const [dx, dy] = [x - x0, y - y0];
      return [poses[i].x + Math.cos(turned) * dx - Math.sin(turned) * dy,
              poses[i].y + Math.sin(turned) * dx + Math.cos(turned) * dy];
    });
    return Math.hypot(p[0] - q[0], p[1] - q[1]);
  }));
}

function pyramid(rows = 40) {
  const bodies = [fixed(200, 2, 0, -1)];
  for (let row = 0; row < rows; ++row) {
    for (let i = row; i < rows; ++i) {
      bodies.push({ w: 1, h: 1, x: 1.1 * (i - 0.5 * (row + rows - 1)), y: 0.5 + row });
    }
  }
  return { bodies, joints: [], steps: 300, lost: (poses) => count(
    poses, (pose, i) => !(Math.hypot(pose.x - bodies[i].x, pose.y - bodies[i].y) < 0.5)),
    what: "moved by half a box" };
}

function circles(number = 2000) {
  const random = dice(7);
  const bodies = [fixed(42, 2, 0, -1), fixed(2, 200, -21, 99), fixed(2, 200, 21, 99)];
  for (let i = 0; i < number; ++i) {
    bodies.push({ r: 0.15 + 0.15 * random(), x: -19 + 38 * ((i % 60) / 59) + 0.2 * random(),
                  y: 1 + 0.7 * Math.floor(i / 60) });
  }
  return { bodies, joints: [], steps: 300, lost: lostBelow(-0.1), what: "below the floor" };
}

function ragdolls(number = 40) {
  const bodies = [fixed(200, 2, 0, -1)];
  const joints = [];
  for (let i = 0; i < number; ++i) {
    const [x, y] = [4 * (i % 8) - 14, 3 + 4 * Math.floor(i / 8)];
    const at = bodies.length;
    const part = (w, h, dx, dy) => bodies.push({ w, h, x: x + dx, y: y + dy, group: i + 1 }) - 1;
    part(0.5, 0.9, 0, 0);
    const limb = (to, w, h, dx, dy, jx, jy, limit) => joints.push(
      { a: at + to, b: part(w, h, dx, dy), x: x + jx, y: y + jy, lower: -limit, upper: limit });
    limb(0, 0.35, 0.35, 0, 0.68, 0, 0.48, 0.6); // head
    for (const side of [-1, 1]) {
      const upper = bodies.length - at;
      limb(0, 0.5, 0.18, 0.5 * side, 0.35, 0.25 * side, 0.35, 1.4);
      limb(upper, 0.5, 0.16, side, 0.35, 0.75 * side, 0.35, 1.4);
      const thigh = bodies.length - at;
      limb(0, 0.2, 0.55, 0.16 * side, -0.75, 0.16 * side, -0.47, 0.9);
      limb(thigh, 0.18, 0.55, 0.16 * side, -1.3, 0.16 * side, -1.02, 0.9);
    }
  }
  const scene = { bodies, joints, steps: 300, lost: lostBelow(-0.1), what: "below the floor" };
  return Object.assign(scene, { gap: (poses) => worstGap(scene, poses) });
}

function bridge(planks = 80) {
  const bodies = [fixed(2, 2, -planks / 2 - 1, 0), fixed(2, 2, planks / 2 + 1, 0)];
  const joints = [];
  for (let i = 0; i < planks; ++i) {
    bodies.push({ w: 1, h: 0.25, x: i + 0.5 - planks / 2, y: 0 });
    joints.push({ a: i === 0 ? 0 : i + 1, b: i + 2, x: i - planks / 2, y: 0 });
  }
  joints.push({ a: planks + 1, b: 1, x: planks / 2, y: 0 });
  for (let i = 0; i < 60; ++i) {
    bodies.push({ w: 0.8, h: 0.8, x: -15 + (i % 20) * 1.5, y: 3 + Math.floor(i / 20), density: 2 });
  }
  const scene = { bodies, joints, steps: 300, what: "below the bridge",
                  lost: (poses) => count(poses.slice(planks + 2), ({ y }) => !(y > -40)) };
  return Object.assign(scene, { gap: (poses) => worstGap(scene, poses) });
}

function tumbler(number = 800) {
  const drum = { x: 0, y: 0, type: "dynamic", density: 5, boxes: [
    { w: 1, h: 20, x: 10, y: 0 }, { w: 1, h: 20, x: -10, y: 0 },
    { w: 20, h: 1, x: 0, y: 10 }, { w: 20, h: 1, x: 0, y: -10 }] };
  const bodies = [fixed(0.1, 0.1, 0, 0, { ghost: true }), drum];
  for (let i = 0; i < number; ++i) {
    bodies.push({ w: 0.4, h: 0.4, x: -7.5 + 0.5 * (i % 31), y: -7.5 + 0.5 * Math.floor(i / 31) });
  }
  const joints = [{ a: 0, b: 1, x: 0, y: 0, motorSpeed: 0.3, motorTorque: 1e6 }];
  return { bodies, joints, steps: 300, what: "out of the drum", lost: (poses) => count(
    poses, ({ x, y }) => !(Math.hypot(x, y) < 15)) };
}

function bullets(number = 200) {
  const random = dice(3);
  const bodies = [fixed(0.05, 60, 10, 30), fixed(80, 2, 0, -1)];
  for (let i = 0; i < number; ++i) {
    bodies.push({ r: 0.1, x: -5 - 0.5 * (i % 10), y: 1 + 0.5 * Math.floor(i / 10), bullet: true,
                  vx: 120 + 80 * random(), vy: 4 * random() });
  }
  return { bodies, joints: [], steps: 120, what: "through the wall", lost: (poses) => count(
    poses.slice(2), ({ x }) => !(x < 10)) };
}

export const scenes = { pyramid, circles, ragdolls, bridge, tumbler, bullets };
