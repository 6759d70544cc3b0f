// SPDX-License-Identifier: MIT
// The tower of the start page, by the package for npm.
import { BodyType, CanvasDraw, World, box, circle, withFriction } from "./kodo/kodo.js";

const kSteps = 60; // per second
const canvas = document.getElementById("canvas");
const context = canvas.getContext("2d");
const view = { lower: { x: -14, y: -0.5 }, upper: { x: 10, y: 11 } }; // m

function tower() {
  const made = new World({ gravity: { x: 0, y: -10 } });
  made.add({ shape: box(200, 2), position: { x: 0, y: -1 }, type: BodyType.Static });
  for (let floor = 0; floor < 6; ++floor) {
    for (const x of [1, 3, 5]) {
      made.add({ shape: box(0.5, 1.2), position: { x, y: 0.6 + 1.5 * floor } });
    }
    made.add({ shape: box(5, 0.3), position: { x: 3, y: 1.35 + 1.5 * floor } });
  }
  return made;
}

let world = tower();
let past = []; // copies, one each half second
let picture = null;

function resize() {
  const [width, height] = [canvas.clientWidth, canvas.clientHeight].map(
    (pixels) => Math.round(pixels * window.devicePixelRatio));
  if (picture === null || canvas.width !== width || canvas.height !== height) {
    Object.assign(canvas, { width, height });
    picture = new CanvasDraw(context, view);
  }
}

/** A ball from the left that flies at the place of the tower next to a point (m). */
function shoot(point) {
  const x = Math.min(Math.max(point.x, 0.5), 5.5);
  const y = Math.min(Math.max(point.y, 0.5), 8.5);
  const from = { x: -13, y: 2 };
  const time = Math.max(0.3, Math.hypot(x - from.x, y - from.y) / 25); // s
  world.add({ shape: circle(0.6), position: from, density: 4, material: withFriction(0.5, 0.2),
              velocity: { x: (x - from.x) / time, y: (y - from.y) / time + 5 * time } });
}

function step() {
  if (world.stepCount() % 30 === 0) {
    past.push(world.copy());
    if (past.length > 5) {
      past.shift().destroy();
    }
  }
  world.step(1 / kSteps);
}

let last = performance.now();
let owed = 0; // ms
function frame(now) {
  resize();
  owed = Math.min(owed + now - last, 100);
  last = now;
  for (; owed > 1000 / kSteps; owed -= 1000 / kSteps) {
    step();
  }
  picture.clear();
  world.draw(picture);
  requestAnimationFrame(frame);
}

const told = document.getElementById("told");
canvas.onpointerdown = ({ offsetX, offsetY }) => {
  const density = window.devicePixelRatio;
  shoot(picture.toWorld({ x: offsetX * density, y: offsetY * density }));
};
canvas.onkeydown = (event) => {
  if (event.key === "Enter" || event.key === " ") {
    event.preventDefault();
    shoot({ x: 3, y: 5 });
  }
};
document.getElementById("again").onclick = () => {
  past.forEach((each) => each.destroy());
  past = [];
  world.destroy();
  world = tower();
  told.textContent = "";
};
document.getElementById("undo").onclick = () => {
  if (past.length > 0) {
    world.assign(past[0]);
    past.splice(1).forEach((each) => each.destroy());
    const seconds = (world.stepCount() / kSteps).toFixed(1);
    told.textContent = `Back at ${seconds} seconds: all is exactly as it was then.`;
  }
};
window.start = { get world() { return world; } }; // for tests
requestAnimationFrame(frame);
