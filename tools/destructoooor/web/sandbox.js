// SPDX-License-Identifier: MIT
// The page of the sandbox: panel and picture. Scenes, dials and hands come from the program.
import { loadWasm } from "./wasm.js";

const kStep = 1 / 60; // s
const kMostSteps = 4; // per frame; beyond that, the simulation runs slower
const kDrag = 0;
const kDrop = 1;
const kLooks = ["Joints", "Contacts", "Impulses", "Bounds", "Velocities", "Centres of mass", "Ids",
                "Colours of islands"];
const kMeasurePause = 200; // ms
const kLargestWorld = 64e6; // bytes, of a link; kMostBytes of page.cpp
const kLongest = 300; // letters of a name that is told: a link may hold any text

const kodo = await loadWasm(new URL("./sandbox.wasm", import.meta.url), {});
const textAt = (at) => {
  const bytes = new Uint8Array(kodo.memory.buffer, at);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
};
const registry = JSON.parse(textAt(kodo.sandbox_registry()));
const element = (id) => document.getElementById(id);
const canvas = element("canvas");

/** True if the browser has no graphics card: a canvas that it "reads frequently" is then cheaper, since it
 *  is drawn by the processor at once, without a detour by OpenGL. */
function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

const context = canvas.getContext("2d", { willReadFrequently: drawsInSoftware() });

const state = { scene: 0, tour: -1, stop: 0, file: false, // no tour: -1; a World that was loaded
                judgedAt: 0, // steps
                hand: kDrag, thing: 0, size: 1, paused: false, owed: 0, last: performance.now() };
const view = { x: 0, y: 0, height: 16 }; // m
let cursor = null; // m, of the keyboard
let held = false; // by the keyboard

/** Adds an element with properties and children. */
function add(parent, tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  parent.append(made);
  return made;
}

/** Tells a tip; or, by its kind, what is "done", or an "error". */
function say(text, kind = "tip") {
  element("message").textContent = text;
  element("message").className = kind;
}

/** A choice among some, as radio buttons. */
function choices(parent, name, items, chosen, act) {
  items.forEach((item, i) => {
    const label = add(parent, "label", { className: "choice", title: item.what ?? "" });
    const input = add(label, "input", { type: "radio", name, value: i, checked: i === chosen });
    input.onchange = () => act(i);
    label.append(item.name ?? item);
  });
}
function choose(name, value) {
  const input = document.querySelector(`input[name=${name}][value="${value}"]`);
  input.checked = true;
}

// Scenes.

function fillScenes() {
  let group = add(element("scene"), "optgroup", { label: "Guided tours" });
  registry.tours.forEach(({ name }, i) => add(group, "option", { value: `tour ${i}` }, name));
  registry.scenes.forEach((scene, i) => {
    if (group?.label !== scene.group) {
      group = add(element("scene"), "optgroup", { label: scene.group });
    }
    add(group, "option", { value: i }, scene.name);
  });
}

function open(scene) {
  state.scene = (scene + registry.scenes.length) % registry.scenes.length;
  state.tour = -1;
  const { name, question, expectation, seconds } = registry.scenes[state.scene];
  kodo.sandbox_open(state.scene);
  element("scene").value = state.scene;
  arrive(name, encodeURIComponent(name), question, `Expected: ${expectation}`, seconds);
}

/** Goes to a stop of a guided tour. */
function visit(tour, stop) {
  const { name, stops } = registry.tours[tour];
  state.tour = tour;
  state.stop = Math.min(Math.max(stop, 0), stops.length - 1);
  const { scene, text, look, seconds } = stops[state.stop];
  state.scene = registry.scenes.findIndex((each) => each.name === scene);
  kodo.sandbox_visit(tour, state.stop);
  element("scene").value = `tour ${tour}`;
  element("stop").textContent = `${name}, ${state.stop + 1} of ${stops.length}`;
  element("stop-back").disabled = state.stop === 0;
  element("stop-next").disabled = state.stop + 1 === stops.length;
  arrive(name, `tour=${encodeURIComponent(name)}&stop=${state.stop + 1}`, text, `Look at: ${look}`,
         seconds);
}

/** The next scene or stop, or the one before. */
function go(by) {
  if (state.tour < 0) {
    open(state.scene + by);
  } else {
    visit(state.tour, state.stop + by);
  }
}

/** Shows what has been opened: its name, the end of its link, its texts, and when it is judged. */
function arrive(name, link, question, expectation, seconds) {
  state.file = false;
  state.judgedAt = seconds / kStep;
  element("tour").hidden = state.tour < 0;
  element("question").textContent = question;
  element("expectation").textContent =
    `${expectation} Judged after ${seconds.toFixed(1)} s, if nothing is touched.`;
  document.title = `${name} - Destructoooor!`;
  history.replaceState(null, "", `#${link}`);
  held = false;
  say("");
  showScene();
  refresh();
}

function showScene() {
  const [left, bottom, right, top] = [0, 1, 2, 3].map((side) => kodo.sandbox_view(side));
  view.x = (left + right) / 2;
  view.y = (bottom + top) / 2;
  view.height = Math.max(top - bottom, (right - left) * canvas.height / Math.max(1, canvas.width));
}

// Dials.

const dials = []; // { refresh } of each

/** A control of one dial: refresh() shows its value. */
function dialControl(parent, dial, i) {
  const set = (value) => {
    say(textAt(kodo.sandbox_setDial(i, value)), "error");
    refresh();
  };
  const what = `dial-${i}`;
  const box = add(parent, "div", { className: "dial" });
  const small = () => add(box, "small", { id: what }, `${dial.what}${dial.price && ` Cost: ${dial.price}`}`);
  const shown = () => (box.hidden = !kodo.sandbox_dialShown(i));
  if (dial.words.join() === "off,on") {
    const label = add(box, "label", { className: "choice" });
    const input = add(label, "input", { type: "checkbox" });
    input.setAttribute("aria-describedby", what);
    input.onchange = () => set(input.checked ? 1 : 0);
    label.append(dial.name);
    small();
    return () => { shown(); input.checked = kodo.sandbox_dial(i) > 0; };
  }
  if (dial.words.length > 0) {
    const group = add(box, "div", { className: "row", role: "radiogroup", ariaLabel: dial.name });
    choices(group, what, dial.words, -1, set);
    small();
    return () => { shown(); choose(what, kodo.sandbox_dial(i)); };
  }
  const label = add(box, "label", { htmlFor: `${what}-input` }, dial.name);
  const output = add(label, "output");
  const input = add(box, "input", { type: "range", id: `${what}-input`, min: dial.low, max: dial.high,
                                    step: dial.stride });
  input.setAttribute("aria-describedby", what);
  input.oninput = () => set(Number(input.value));
  small();
  return () => {
    shown();
    const value = kodo.sandbox_dial(i);
    input.value = value;
    output.textContent = value <= dial.low && dial.lowest || Number(value.toFixed(2));
    input.setAttribute("aria-valuetext", output.textContent);
  };
}

function fillDials() {
  let group = null;
  registry.dials.forEach((dial, i) => {
    if (group?.dataset.name !== dial.group) {
      group = add(element("dials"), "fieldset");
      add(group, "legend", {}, dial.group);
      group.dataset.name = dial.group;
    }
    dials.push(dialControl(group, dial, i));
  });
}

const measures = []; // { unit, value, graph } of each, then of the stages

/** Draws a graph from 0, or from the least value, to the greatest one. */
function drawGraph({ graph }, which) {
  const count = kodo.sandbox_history(which);
  const values = new Float32Array(kodo.memory.buffer, kodo.sandbox_figures(), count);
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
  const { width, height } = graph.canvas;
  graph.clearRect(0, 0, width, height);
  graph.strokeStyle = "#8fb4ff";
  graph.lineWidth = 1.5;
  graph.beginPath();
  values.forEach((value, i) => graph.lineTo(
    width * i / Math.max(1, count - 1), height - 1 - (height - 2) * (value - low) / (high - low || 1)));
  graph.stroke();
}

function profileButtons(id, what, names, act) {
  names.forEach((name, i) => {
    const button = add(element(id), "button", { ariaLabel: `${what} ${name}` }, name);
    button.onclick = () => { act(i); refresh(); };
  });
}

/** Presses the buttons of the present profiles; the last one to compare with is none. */
function showProfiles() {
  for (const [id, second] of [["profiles", false], ["compare", true]]) {
    const present = kodo.sandbox_profile(second);
    element(id).querySelectorAll("button").forEach((button, i) => button.setAttribute(
      "aria-pressed", String(i === (present === -2 ? registry.profiles.length : present))));
  }
}

function fillPanel() {
  choices(element("hands"), "hand", registry.hands, kDrag, setHand);
  choices(element("things"), "thing", registry.things, 0, (thing) => {
    state.thing = thing;
    kodo.sandbox_setDropped(thing, state.size);
  });
  profileButtons("profiles", "Profile", registry.profiles,
                 (i) => say(textAt(kodo.sandbox_setProfile(i)), "error"));
  profileButtons("compare", "Compare with", [...registry.profiles, "none"],
                 (i) => kodo.sandbox_compare(i < registry.profiles.length ? i : -1));
  add(element("compare"), "output", { id: "difference" });
  kLooks.forEach((name, i) => {
    const label = add(element("look"), "label", { className: "choice" });
    const input = add(label, "input", { type: "checkbox", checked: i === 0 });
    label.append(name);
    input.onchange = () => kodo.sandbox_look([...element("look").querySelectorAll("input")].reduce(
      (bits, each, bit) => bits | (each.checked ? 1 << bit : 0), 0));
  });
  const stages = registry.stages.map((name) => ({ name, unit: "us" }));
  [...registry.measures, ...stages].forEach(({ name, unit }, i) => {
    const list = element(i < registry.measures.length ? "measures" : "stages");
    add(list, "dt", {}, name);
    const value = add(list, "dd");
    const graph = add(list, "canvas", { width: 300, height: 28, role: "img",
                                        ariaLabel: `${name} over the last ten seconds` });
    measures.push({ unit, value, graph: graph.getContext("2d", { willReadFrequently: true }) });
  });
}

function setHand(hand) {
  state.hand = hand;
  choose("hand", hand);
  element("things").hidden = hand !== kDrop;
  say(`${registry.hands[hand].name}: ${registry.hands[hand].what}`);
}

function setPaused(paused) {
  state.paused = paused;
  element("pause").textContent = paused ? "Play" : "Pause";
  element("pause").setAttribute("aria-pressed", String(paused));
}

/** Shows all values that a change may have changed. */
function refresh() {
  dials.forEach((show) => show());
  showProfiles();
  showTime();
  showMeasures();
}

const kNotJudged = 2;
const kVerdicts = { [-1]: "", 0: "Not as expected.", 1: "As expected.",
                    [kNotJudged]: "Not judged, since something was touched. Restart, to have it judged." };
const kLate = 5; // steps after the one that is judged
let shownVerdict = -1;
let measuresAt = 0; // ms, when they were shown
function showTime() {
  const [tick, first, last] = [kodo.sandbox_tick(), kodo.sandbox_firstTick(), kodo.sandbox_lastTick()];
  const time = element("time");
  time.min = first;
  time.max = Math.max(last, tick, 1);
  time.value = tick;
  time.setAttribute("aria-valuetext", `${(tick * kStep).toFixed(2)} seconds`);
  element("seconds").textContent = `${(tick * kStep).toFixed(2)} s`;
  const late = !state.file && tick > state.judgedAt + kLate;
  const verdict = kodo.sandbox_verdict() < 0 && late ? kNotJudged : kodo.sandbox_verdict();
  if (verdict !== shownVerdict) {
    shownVerdict = verdict;
    element("verdict").className = ["failed", "held"][verdict] ?? "";
    element("verdict").textContent = kVerdicts[verdict];
  }
}

function showMeasures() {
  measuresAt = performance.now();
  measures.forEach(({ unit, value }, i) => {
    value.textContent = `${Number(kodo.sandbox_measure(i).toPrecision(4))} ${unit}`;
  });
  measures.forEach(drawGraph);
  const apart = kodo.sandbox_difference();
  element("difference").textContent = apart > 0 ? `Red outlines: apart by ${apart.toPrecision(3)} m` : "";
}

function rewind(tick) {
  setPaused(true);
  kodo.sandbox_rewind(Math.max(0, tick));
  refresh();
}

// Picture.

const metre = () => canvas.height / view.height; // pixels of the canvas
const toWorld = (x, y) => ({ x: view.x + (x - canvas.width / 2) / metre(),
                             y: view.y - (y - canvas.height / 2) / metre() });

function resize() {
  const density = window.devicePixelRatio;
  const { clientWidth, clientHeight } = canvas;
  if (canvas.width !== Math.round(clientWidth * density)
      || canvas.height !== Math.round(clientHeight * density)) {
    canvas.width = Math.round(clientWidth * density);
    canvas.height = Math.round(clientHeight * density);
    showScene();
  }
}

const css = (bytes, at) =>
  `rgb(${bytes[at]} ${bytes[at + 1]} ${bytes[at + 2]} / ${bytes[at + 3] / 255})`;

/** Plays the figures of a picture: see Figures in page.cpp. */
function draw() {
  const density = window.devicePixelRatio;
  const scale = metre();
  const [left, top] = [view.x - canvas.width / 2 / scale, view.y + canvas.height / 2 / scale];
  const count = kodo.sandbox_draw(left, view.y - canvas.height / 2 / scale,
                                  view.x + canvas.width / 2 / scale, top, density / scale);
  const at = kodo.sandbox_figures();
  const numbers = new Float32Array(kodo.memory.buffer, at, count);
  const bytes = new Uint8Array(kodo.memory.buffer, at, 4 * count);
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.lineJoin = "round";
  for (let i = 0; i < count;) {
    const [kind, fill] = [numbers[i], bytes[4 * i + 11] > 0];
    const [from, to] = [i + 5, i + 5 + numbers[i + 4]];
    context.strokeStyle = css(bytes, 4 * i + 4);
    context.lineWidth = numbers[i + 3] * density;
    context.beginPath();
    if (kind === 3) {
      context.fillStyle = context.strokeStyle;
      context.font = `${12 * density}px sans-serif`;
      context.textAlign = "center";
      context.fillText(String.fromCharCode(...numbers.subarray(from + 2, to)),
                       (numbers[from] - left) * scale, (top - numbers[from + 1]) * scale);
    } else if (kind === 2) {
      context.arc((numbers[from] - left) * scale, (top - numbers[from + 1]) * scale,
                  numbers[from + 2] * scale, 0, 2 * Math.PI);
    } else {
      for (let k = from; k < to; k += 2) {
        context.lineTo((numbers[k] - left) * scale, (top - numbers[k + 1]) * scale);
      }
      if (kind === 1) {
        context.closePath();
      }
    }
    if (fill && kind !== 3) {
      context.fillStyle = css(bytes, 4 * i + 8);
      context.fill();
    }
    context.stroke();
    i = to;
  }
  if (cursor !== null) {
    const [x, y] = [(cursor.x - left) * scale, (top - cursor.y) * scale];
    context.strokeStyle = held ? "#ffdc5a" : "#ffffff";
    context.lineWidth = 2 * density;
    context.strokeRect(x - 6 * density, y - 6 * density, 12 * density, 12 * density);
  }
}

function frame(now) {
  resize();
  state.owed = state.paused ? 0 : Math.min(state.owed + (now - state.last) / 1000, kMostSteps * kStep);
  state.last = now;
  const steps = Math.floor(state.owed / kStep + 1e-6);
  for (let i = 0; i < steps; ++i) {
    kodo.sandbox_step();
  }
  state.owed = Math.max(0, state.owed - steps * kStep);
  draw();
  if (steps > 0) {
    showTime();
    if (performance.now() - measuresAt > kMeasurePause) {
      showMeasures();
    }
  }
  requestAnimationFrame(frame);
}

// Mouse and touch.

const fingers = new Map(); // pointers that are down, in pixels of the canvas
let panning = false;

const placeOf = ({ offsetX, offsetY }) => ({ x: offsetX * window.devicePixelRatio,
                                             y: offsetY * window.devicePixelRatio });
const [kPressed, kMoved, kReleased, kAbandoned] = [0, 1, 2, 3];
function pointer(phase, { x, y }) {
  const sentence = textAt(kodo.sandbox_pointer(phase, state.hand, x, y));
  if (sentence !== "") {
    say(sentence, "error");
  }
  if (phase >= kReleased) {
    refresh();
  }
}

canvas.onpointerdown = (event) => {
  canvas.setPointerCapture(event.pointerId);
  cursor = null;
  fingers.set(event.pointerId, placeOf(event));
  if (fingers.size > 1 && !panning) {
    pointer(kAbandoned, { x: 0, y: 0 });
  }
  panning = fingers.size > 1 || event.button > 0;
  if (!panning) {
    const { x, y } = placeOf(event);
    pointer(kPressed, toWorld(x, y));
  }
};
canvas.onpointermove = (event) => {
  const before = fingers.get(event.pointerId);
  if (before === undefined) {
    return;
  }
  const now = placeOf(event);
  fingers.set(event.pointerId, now);
  if (!panning) {
    pointer(kMoved, toWorld(now.x, now.y));
    return;
  }
  view.x -= (now.x - before.x) / metre() / fingers.size;
  view.y += (now.y - before.y) / metre() / fingers.size;
  const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
  if (other !== undefined) {
    const distance = (place) => Math.hypot(place.x - other.x, place.y - other.y);
    zoom(distance(before) / Math.max(1, distance(now)));
  }
};
canvas.onpointerup = canvas.onpointercancel = (event) => {
  if (!fingers.delete(event.pointerId)) {
    return;
  }
  if (!panning) {
    const { x, y } = placeOf(event);
    pointer(event.type === "pointerup" ? kReleased : kAbandoned, toWorld(x, y));
  }
  panning = panning && fingers.size > 0;
};
canvas.oncontextmenu = () => false;
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  if (event.deltaY === 0) {
    return; // it turns to the side
  }
  if (state.hand === kDrop) {
    state.size = Math.min(4, Math.max(0.2, state.size - 0.1 * Math.sign(event.deltaY)));
    kodo.sandbox_setDropped(state.thing, state.size);
    say(`Size ${state.size.toFixed(1)} m.`);
  } else {
    zoom(event.deltaY > 0 ? 1 / 0.9 : 0.9);
  }
}, { passive: false });

function zoom(factor) {
  view.height = Math.min(400, Math.max(1, view.height * factor));
}

// Keys.

const actions = {
  " ": () => setPaused(!state.paused),
  n: () => { setPaused(true); kodo.sandbox_step(); refresh(); },
  b: () => rewind(kodo.sandbox_tick() - 1),
  r: restart,
  PageUp: () => go(-1),
  PageDown: () => go(1),
  Home: showScene,
  e: () => setHand(10),
  0: () => setHand(9),
};
for (let i = 1; i <= 9; ++i) {
  actions[i] = () => setHand(i - 1);
}
const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function canvasKey(event) {
  if (event.key in kArrows) {
    const stride = event.shiftKey ? 0.1 : 0.5; // m
    cursor ??= { x: view.x, y: view.y };
    cursor.x += stride * kArrows[event.key][0];
    cursor.y += stride * kArrows[event.key][1];
    if (held) {
      pointer(kMoved, cursor);
    }
  } else if (event.key === "Enter") {
    cursor ??= { x: view.x, y: view.y };
    held = !held;
    pointer(held ? kPressed : kReleased, cursor);
    say(held ? "Pressed: arrows move, enter releases." : "Released.");
  } else if (event.key === "+" || event.key === "-") {
    zoom(event.key === "+" ? 0.9 : 1 / 0.9);
  } else {
    return false;
  }
  return true;
}

window.onkeydown = (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) {
    return;
  }
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const target = event.target;
  const typing = target instanceof HTMLSelectElement
    || (target instanceof HTMLInputElement && !/^[nrbe]$/.test(key))
    || (target instanceof HTMLButtonElement && key === " ") || target.tagName === "SUMMARY";
  const done = target === canvas && canvasKey(event);
  if (!done && (typing || !(key in actions))) {
    return;
  }
  if (!done) {
    actions[key]();
  }
  event.preventDefault();
};

// Links: #NAME of a scene, or #tour=NAME&stop=2, or #scene=DATA, a World as bytes, compressed by raw
// deflate, as base64 for URLs; then &name=NAME of the scene that it was, and &view=X,Y,HEIGHT in metres.

/** What comes out of a stream. It ends a little after `most` bytes: a short link may become gigabytes. */
async function through(stream, bytes, most = Infinity) {
  let left = most;
  const limit = new TransformStream({ transform(part, out) {
    out.enqueue(part);
    left -= part.length;
    if (left < 0) {
      out.terminate();
    }
  } });
  const all = new Blob([bytes]).stream().pipeThrough(stream).pipeThrough(limit);
  return new Uint8Array(await new Response(all).arrayBuffer());
}

async function linkToWorld() {
  const size = kodo.sandbox_save();
  const bytes = new Uint8Array(kodo.memory.buffer, kodo.sandbox_bytes(), size).slice();
  const small = await through(new CompressionStream("deflate-raw"), bytes);
  const letters = btoa(Array.from(small, (byte) => String.fromCharCode(byte)).join(""));
  const data = letters.replace(/\+/g, "-").replace(/\//g, "_").replace(/=/g, "");
  const place = [view.x, view.y, view.height].map((number) => number.toFixed(2)).join();
  const name = encodeURIComponent(registry.scenes[state.scene].name);
  return `${location.href.split("#")[0]}#scene=${data}&name=${name}&view=${place}`;
}

/** Throws an error with a sentence if the program has no room for as many bytes. */
function reserve(size) {
  const sentence = textAt(kodo.sandbox_reserve(Math.min(size, 2 ** 32 - 1)));
  if (sentence !== "") {
    throw new Error(sentence);
  }
}
/** Gives bytes to the program. */
function give(bytes) {
  reserve(bytes.length);
  new Uint8Array(kodo.memory.buffer, kodo.sandbox_bytes(), bytes.length).set(bytes);
}

/** Takes the World of a link; throws an error with a sentence. */
async function takeWorld(data) {
  let bytes = null;
  try {
    const letters = atob(data.replace(/-/g, "+").replace(/_/g, "/"));
    const small = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    bytes = await through(new DecompressionStream("deflate-raw"), small, kLargestWorld);
  } catch {
    throw new Error("The link is damaged.");
  }
  give(bytes);
  const sentence = textAt(kodo.sandbox_take());
  if (sentence !== "") {
    throw new Error(sentence);
  }
}

/** Starts what is open again, from its start. */
function restart() {
  if (!state.file) {
    go(0);
    return;
  }
  kodo.sandbox_restart();
  refresh();
}

/** Shows a World that was loaded: its heading, and what was expected of the scene that it was. */
function showLoaded(heading, name) {
  state.tour = -1;
  state.file = true;
  element("tour").hidden = true;
  element("scene").selectedIndex = -1;
  const scene = registry.scenes.find((each) => each.name === name);
  element("question").textContent = heading;
  element("expectation").textContent = scene === undefined ? "What was loaded is not judged."
    : `Expected of ${name}: ${scene.expectation} What was loaded is not judged.`;
  document.title = `${heading.replace(/\.$/, "")} - Destructoooor!`;
}

// Scene files.

/** Takes a scene file; a mistake is told, and nothing is lost. */
async function takeFile(file) {
  try {
    reserve(file.size); // before a large file is read
    give(new Uint8Array(await file.arrayBuffer()));
  } catch (error) {
    say(`${file.name} cannot be read. ${error.message}`, "error");
    return;
  }
  const mistakes = textAt(kodo.sandbox_takeText());
  if (mistakes !== "") {
    say(mistakes.replaceAll("the file", file.name), "error");
    return;
  }
  const title = textAt(kodo.sandbox_title());
  history.replaceState(null, "", location.pathname);
  showLoaded(title, title);
  held = false;
  showScene();
  refresh();
  say(`Loaded ${file.name}.`, "done");
}

function saveFile() {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([textAt(kodo.sandbox_text())], { type: "application/toml" }));
  link.download = "scene.toml";
  link.click();
  URL.revokeObjectURL(link.href);
  const lacking = textAt(kodo.sandbox_notHeld());
  say(`Saved as scene.toml.${lacking === "" ? "" : ` Not held: ${lacking}.`}`, "done");
}

/** The name of a scene that is all of a link. */
function nameIn(link) {
  try {
    return decodeURIComponent(link);
  } catch {
    return link; // no name has such letters
  }
}

/** Opens what the link of the page names; what it names in vain is told. */
async function enter() {
  const wanted = location.hash;
  const asked = new URLSearchParams(wanted.slice(1));
  const data = asked.get("scene");
  const tour = registry.tours.findIndex(({ name }) => name === asked.get("tour"));
  if (tour >= 0) {
    const stop = Math.trunc(asked.get("stop") ?? 1);
    visit(tour, stop >= 1 ? stop - 1 : 0);
    if (!(stop >= 1 && stop <= registry.tours[tour].stops.length)) {
      say(`The tour has no stop ${asked.get("stop")}.`, "error");
    }
    return;
  }
  const name = data === null ? nameIn(wanted.slice(1)) : asked.get("name");
  const scene = registry.scenes.findIndex((each) => each.name === name);
  open(Math.max(0, scene));
  if (data === null) {
    if (scene < 0 && name !== "") {
      say(`The link names no scene: ${name.slice(0, kLongest)}. This is the first one.`, "error");
    }
    return;
  }
  try {
    await takeWorld(data);
  } catch (error) {
    say(error.message, "error");
    return;
  }
  const place = (asked.get("view") ?? "").split(",").map(Number);
  if (place.length === 3 && place.every(Number.isFinite) && place[2] > 0) {
    [view.x, view.y, view.height] = place;
  }
  history.replaceState(null, "", wanted);
  showLoaded("A World of a link, which goes on where it was copied.", name);
  refresh();
}

/** Copies a text to the clipboard, and says so; a browser that refuses shows it, to be copied there. */
async function copy(text, done) {
  try {
    await navigator.clipboard.writeText(text);
    say(done, "done");
  } catch {
    say(`The browser refuses its clipboard. Copy this:\n${text}`);
  }
}

// Start.

fillScenes();
fillPanel();
fillDials();
element("scene").onchange = () => {
  const [kind, tour] = element("scene").value.split(" ");
  if (kind === "tour") {
    visit(Number(tour), 0);
  } else {
    open(Number(kind));
  }
};
element("previous").onclick = element("stop-back").onclick = () => go(-1);
element("next").onclick = element("stop-next").onclick = () => go(1);
element("leave").onclick = () => open(state.scene);
element("pause").onclick = actions[" "];
element("step").onclick = actions.n;
element("back").onclick = actions.b;
element("restart").onclick = actions.r;
element("time").oninput = () => rewind(Number(element("time").value));
element("copy").onclick = () =>
  copy(textAt(kodo.sandbox_code()), "The settings are in the clipboard.");
element("share").onclick = async () => {
  const link = await linkToWorld();
  await copy(link, `A link of ${(link.length / 1000).toFixed(1)} kB is in the clipboard.`);
};
element("save").onclick = saveFile;
element("load").onclick = () => element("file").click();
element("file").onchange = async () => {
  const [file] = element("file").files;
  if (file) {
    await takeFile(file);
  }
  element("file").value = "";
};
document.ondragover = (event) => event.preventDefault();
document.ondrop = async (event) => {
  event.preventDefault();
  const [file] = event.dataTransfer.files;
  if (file) {
    await takeFile(file);
  }
};
window.onhashchange = enter;
resize();
await enter();
setPaused(matchMedia("(prefers-reduced-motion: reduce)").matches);
window.sandbox = { kodo, registry, state, draw, ready: performance.now() }; // for tests
requestAnimationFrame(frame);
