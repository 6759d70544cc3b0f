// SPDX-License-Identifier: MIT
// The buttons of the page of examples: each runs its program here, and compares what it prints with
// the text on the page, which the native program has printed.
"use strict";

const lines = []; // of the present run
let program = null; // a promise

function load() {
  program ??= new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = "examples.js";
    script.onload = () => resolve(loadExamples({ print: (line) => lines.push(line) }));
    script.onerror = () => reject(new Error("The program cannot be loaded."));
    document.head.append(script);
  });
  return program;
}

/** Runs an example: what it prints, and its picture if it draws one. */
async function run(name) {
  const { ccall, FS } = await load();
  lines.length = 0;
  const picture = "picture.svg";
  if (FS.analyzePath(picture).exists) {
    FS.unlink(picture);
  }
  const start = performance.now();
  const code = ccall("runExample", "number", ["string", "boolean"], [name, false]);
  const time = performance.now() - start; // ms
  const text = lines.join("\n");
  ccall("runExample", "number", ["string", "boolean"], [name, true]);
  if (code !== 0) {
    throw new Error(`The example ended with ${code}.`);
  }
  const drawn = FS.analyzePath(picture).exists ? FS.readFile(picture, { encoding: "utf8" }) : "";
  return { text, picture: drawn, time };
}

for (const button of document.querySelectorAll("button[data-run]")) {
  const box = document.getElementById(`box-${button.dataset.run}`);
  const told = box.querySelector("output");
  const printed = box.querySelector("pre.printed");
  const native = printed.textContent.trimEnd();
  button.onclick = async () => {
    told.textContent = "Running\u2026";
    try {
      const { text, picture, time } = await run(button.dataset.run);
      const same = native === text.trimEnd();
      printed.textContent = text;
      const image = box.querySelector("img");
      if (image !== null && picture !== "") {
        image.src = URL.createObjectURL(new Blob([picture], { type: "image/svg+xml" }));
      }
      told.textContent = `${time.toFixed(0)} ms. ${
        same ? "The same" : "Another"} text ${same ? "as" : "than"} the native program printed.`;
    } catch (error) {
      told.textContent = error.message;
    }
  };
}
