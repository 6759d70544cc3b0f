#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// Time and outcome of Kodo beside other engines for npm, in node. In a folder of its own:
//   npm install @dimforge/rapier2d-simd-compat planck matter-js
//   node .../engine/js/bench/bench.mjs .../build/web/npm [scene...]
// Prints CPU time (ms) of a step, what was lost, and the largest gap of a joint. Engines take turns in
// processes of their own; the best of three runs counts.
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";

import { engines } from "./engines.mjs";
import { scenes } from "./scenes.mjs";

const kRuns = 3;

async function run(folder, name, engine) {
  const make = await engines[engine](folder);
  const scene = scenes[name]();
  const warm = make(scene); // until the engine of JavaScript has compiled all
  for (let step = 0; step < scene.steps; ++step) {
    warm.step();
  }
  const world = make(scene);
  const begin = process.cpuUsage();
  for (let step = 0; step < scene.steps; ++step) {
    world.step();
  }
  const { user, system } = process.cpuUsage(begin);
  const poses = world.poses();
  return { ms: (user + system) / 1000 / scene.steps, lost: scene.lost(poses), gap: scene.gap?.(poses) };
}

function row(folder, name) {
  const best = {};
  for (let i = 0; i < kRuns; ++i) {
    for (const engine of Object.keys(engines)) {
      const done = spawnSync(process.execPath, [fileURLToPath(import.meta.url), folder, name, engine],
                             { encoding: "utf8", timeout: 300_000 });
      const result = done.status === 0 ? JSON.parse(done.stdout) : { ms: Infinity, lost: NaN };
      if (done.status !== 0) {
        process.stderr.write(done.stderr);
      }
      best[engine] = !best[engine] || result.ms < best[engine].ms ? result : best[engine];
    }
  }
  const text = ({ ms, lost, gap }) => (ms === Infinity ? "gave up"
    : `${ms.toPrecision(2)}, ${lost}${gap === undefined ? "" : `, ${(1000 * gap).toPrecision(2)} mm`}`);
  return `| ${name} | ${scenes[name]().what} | ${Object.keys(engines).map((each) => text(best[each])).join(" | ")} |`;
}

const [folder, ...names] = process.argv.slice(2);
if (names.length === 2 && engines[names[1]]) {
  process.stdout.write(JSON.stringify(await run(folder, ...names)));
} else {
  process.stdout.write(`| scene | lost: | ${Object.keys(engines).join(" | ")} |\n`);
  for (const name of names.length > 0 ? names : Object.keys(scenes)) {
    process.stdout.write(`${row(folder, name)}\n`);
  }
}
