// SPDX-License-Identifier: MIT
// The sandbox of the page in node: KODO_SANDBOX is its folder. Run by tools/web --check.
import assert from "node:assert/strict";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const folder = process.env.KODO_SANDBOX;

async function load() {
  const { loadWasm } = await import(pathToFileURL(`${folder}/wasm.js`).href);
  const kodo = await loadWasm(pathToFileURL(`${folder}/sandbox.wasm`), {});
  const bytes = new Uint8Array(kodo.memory.buffer, kodo.sandbox_registry());
  return { kodo, ...JSON.parse(new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)))) };
}

/** The verdict after the time of a scene or stop: 1 as expected. */
function verdict(kodo, seconds) {
  for (let step = 0; step <= 60 * seconds && kodo.sandbox_verdict() < 0; ++step) {
    kodo.sandbox_step();
  }
  return kodo.sandbox_verdict();
}

test("each scene of the page is judged as expected", { skip: folder === undefined }, async () => {
  const { kodo, scenes, dials } = await load();
  assert.ok(scenes.length >= 73 && dials.length >= 20);
  const wrong = scenes.filter(({ seconds }, i) => {
    kodo.sandbox_open(i);
    return verdict(kodo, seconds) !== 1;
  });
  assert.deepEqual(wrong.map(({ name }) => name), []);
});

test("each stop of a guided tour is judged as expected", { skip: folder === undefined }, async () => {
  const { kodo, tours } = await load();
  assert.equal(tours.length, 2);
  tours.forEach(({ name, stops }, tour) => stops.forEach(({ seconds }, stop) => {
    kodo.sandbox_visit(tour, stop);
    assert.equal(verdict(kodo, seconds), 1, `${name}, stop ${stop + 1}`);
  }));
});
