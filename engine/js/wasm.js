// SPDX-License-Identifier: MIT
// Loads a module that emscripten has made without JavaScript of its own.

const kNotSupported = 52; // ENOSYS of WASI

/** Bytes of a file beside this module, in a browser or in node. */
async function bytesOf(url) {
  if (url.protocol === "file:") {
    const files = "node:fs/promises"; // a name in a variable: bundlers leave it alone
    return (await import(/* @vite-ignore */ /* webpackIgnore: true */ files)).readFile(url);
  }
  const answer = await fetch(url);
  if (!answer.ok) {
    throw new Error(`${url} cannot be loaded: ${answer.status} ${answer.statusText}`);
  }
  return answer.arrayBuffer();
}

/** Loads and starts a module. What it imports and `imports` does not have, does nothing.
 * @param {URL} url
 * @param {Record<string, Record<string, Function>>} imports
 * @returns {Promise<Record<string, any>>} what it exports */
export async function loadWasm(url, imports) {
  const module = await WebAssembly.compile(await bytesOf(url));
  let memory = null;
  const system = {
    clock_time_get(_clock, _precision, at) {
      const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
      new DataView(memory.buffer).setBigUint64(at, nanoseconds, true);
      return 0;
    },
    proc_exit(code) {
      throw new Error(`${url}: the program ended with ${code}`);
    },
  };
  const all = {};
  for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
    all[from] ??= {};
    all[from][name] =
      imports[from]?.[name] ?? system[name] ?? (kind === "function" ? () => kNotSupported : 0);
  }
  const { exports } = await WebAssembly.instantiate(module, all);
  memory = exports.memory;
  exports._initialize();
  return exports;
}
