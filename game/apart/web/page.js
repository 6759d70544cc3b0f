// SPDX-License-Identifier: MIT
// Prepares what the game needs of the page: typefaces, the player's files, links, buttons.
//
// A link may name what to start with: #level=NAME, #daily, #daily=2026-11-26 or #replay=DATA. DATA is
// a packed replay (replay_link.hpp) or, in older links, its text, compressed by raw deflate; as base64
// for URLs.
"use strict";

const news = document.getElementById("news");
const canvas = document.getElementById("canvas");
const folder = "/player";
const levels = folder + "/apart/levels"; // of the player
const builtIn = "/assets/levels";
const lastGame = folder + "/apart/last.replay";
const packedMark = 7;
const toLock = 500; // ms
const toRead = 5000; // ms
const largestReplay = 1 << 24; // bytes; kLargestReplay
const longest = 300; // letters of a message: a link may hold any text
let started = false;

function tell(sentence) {
    const cut = sentence.length > longest;
    news.textContent = cut ? sentence.slice(0, sentence.lastIndexOf(" ", longest)) + " \u2026" : sentence;
    news.hidden = sentence === "";
}

function fromLink(text) {
    const raw = atob(text.replace(/-/g, "+").replace(/_/g, "/"));
    return Uint8Array.from(raw, (letter) => letter.charCodeAt(0));
}

/// What comes out of a stream. It ends a little after `most` bytes: a short link may become gigabytes.
async function through(stream, bytes, most) {
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

/// What the link of the page asks for.
async function wishes() {
    const asked = new URLSearchParams(location.hash.slice(1));
    const day = asked.get("daily");
    const daily = day === null ? "" : day === "" ? "daily" : "daily-" + day;
    const wish = { level: asked.get("level") || daily, replay: "" };
    const own = levels + "/" + wish.level + ".toml";
    if (asked.has("level") && FS.analyzePath(own).exists) {
        wish.level = own; // its errors are told by line
    }
    if (asked.has("replay")) {
        const data = fromLink(asked.get("replay"));
        const packed = data[0] === packedMark;
        wish.replay = "/link.replay";
        const text = () => through(new DecompressionStream("deflate-raw"), data, largestReplay);
        FS.writeFile(wish.replay, packed ? data : await text());
    }
    return wish;
}

async function copyLink() {
    if (!started) {
        return;
    }
    const data = Module.ccall("linkOfLastGame", "string", ["string"], [lastGame]);
    if (data === "") {
        return flash("There is no game to link to yet.");
    }
    if (await copyText(data)) {
        flash("The link to your last game is copied.");
    }
}

/// Copies a text whose link begins at #replay=. A browser that refuses shows it, to be copied there.
async function copyText(text) {
    const whole = text.replace("#replay=", location.href.split("#")[0] + "#replay=");
    try {
        await navigator.clipboard.writeText(whole);
        return true;
    } catch (error) {
        window.prompt("Copy this:", whole.replace("\n", " "));
        return false;
    }
}

/// A level that is dropped on the page becomes one of the player's, and is played.
async function takeLevel(file) {
    if (!started) {
        return;
    }
    if (!file || !file.name.toLowerCase().endsWith(".toml")) {
        return flash("A level is a file whose name ends in .toml.");
    }
    const name = file.name.slice(0, -".toml".length);
    const tried = builtIn + "/" + name + ".toml";
    if (FS.analyzePath(tried).exists) {
        return flash("The game has a level " + name + ": rename the file.", toRead);
    }
    try {
        const bytes = new Uint8Array(await file.arrayBuffer());
        FS.writeFile(tried, bytes);
        const problem = Module.ccall("problemOfLevel", "string", ["string"], [tried]);
        FS.unlink(tried);
        if (problem) {
            return flash(plain(problem), toRead);
        }
        FS.mkdirTree(levels);
        FS.writeFile(levels + "/" + name + ".toml", bytes);
    } catch (error) {
        return flash("The file " + file.name + " cannot be read.", toRead);
    }
    if (!await Module.keepFiles()) {
        return flash(Module.notKept, toRead);
    }
    history.replaceState(null, "", "#level=" + encodeURIComponent(name));
    location.reload();
}

/// True if the page turns the picture clockwise by a quarter: see index.html.
function turned() {
    return matchMedia("(orientation: portrait) and (pointer: coarse) and (max-width: 600px)").matches;
}

let flashes = 0;
function flash(sentence, duration = 2500) {
    tell(sentence);
    const mine = ++flashes;
    setTimeout(() => { if (mine === flashes) { tell(""); } }, duration);
}

/// True once no other tab of the game keeps files: what two of them keep would overwrite each other.
function ownFiles() {
    if (!navigator.locks) {
        return Promise.resolve(true);
    }
    const signal = AbortSignal.timeout(toLock); // a page that is left lets go a little later
    return new Promise((done) => navigator.locks.request("aPart" + location.pathname, { signal }, () => {
        done(true);
        return new Promise(() => {}); // until the page is left
    }).catch(() => done(false)));
}

/// Reads the player's files, and resolves to why they are not kept, or "".
async function openFiles() {
    if (!window.indexedDB) {
        return "This browser keeps no files: scores and levels last as long as the page.";
    }
    const own = await ownFiles(); // first: what another tab kept last is read, too
    FS.mount(IDBFS, {}, folder);
    const read = new Promise((done) => FS.syncfs(true, (error) => done(!error)));
    const waited = new Promise((done) => setTimeout(() => done(false), toRead));
    if (!await Promise.race([read, waited])) {
        return "This browser refuses to keep files: scores and levels last as long as the page.";
    }
    if (!own) {
        return "The game is open in another tab, which keeps the scores: this one keeps none.";
    }
    Module.keepFiles = () => new Promise((done) => FS.syncfs(false, (problem) => done(!problem)));
    return "";
}

/// A browser may forbid gamepads by an exception, in each frame.
function probePads() {
    try {
        navigator.getGamepads?.();
    } catch (error) {
        console.warn("No gamepads: " + error);
        navigator.getGamepads = () => [];
    }
}

/// Draws one letter with the typefaces of the page: its advance, offset x, offset y, width and
/// height go to `metrics`, its opacities, row by row, to `opacities`.
let letters = null;
function drawLetter(bold, height, letter, metrics, opacities, largest) {
    if (!letters) {
        const sheet = document.createElement("canvas");
        sheet.width = sheet.height = largest;
        letters = sheet.getContext("2d", { willReadFrequently: true });
    }
    letters.font = (bold ? "bold " : "") + height + "px apart, sans-serif";
    letters.fillStyle = "#fff";
    const text = String.fromCodePoint(letter);
    const size = letters.measureText(text);
    const blank = text.trim() === "";
    const left = Math.floor(-size.actualBoundingBoxLeft) - 1;
    const top = Math.floor(-size.actualBoundingBoxAscent) - 1;
    const extent = (far, near) => blank ? 0 : Math.min(Math.ceil(far) + 1 - near, largest);
    const width = extent(size.actualBoundingBoxRight, left);
    const rows = extent(size.actualBoundingBoxDescent, top);
    HEAPF32.set([Math.round(size.width), left, top, width, rows], metrics >> 2);
    if (width > 0 && rows > 0) {
        letters.clearRect(0, 0, largest, largest);
        letters.fillText(text, -left, -top);
        const pixels = letters.getImageData(0, 0, width, rows).data;
        for (let i = 0; i < width * rows; ++i) {
            HEAPU8[opacities + i] = pixels[4 * i + 3];
        }
    }
}

/// A sentence without the folders of this page's own file system.
function plain(sentence) {
    return sentence.replaceAll(levels + "/", "").replaceAll(builtIn + "/", "").replaceAll("/link.replay", "the link");
}

/// The script processor renders on the page's own thread, where the mixer lives. Worklets need
/// shared memory, and so headers that a static server does not send.
let sound = null;
function openSound(rate, frames, mixer) {
    try {
        sound = new (window.AudioContext || window.webkitAudioContext)({ sampleRate: rate });
        const node = sound.createScriptProcessor(frames, 0, 2);
        node.onaudioprocess = (event) => {
            const samples = Module._renderSound(mixer, frames) >> 2;
            const left = event.outputBuffer.getChannelData(0);
            const right = event.outputBuffer.getChannelData(1);
            for (let i = 0; i < frames; ++i) {
                left[i] = HEAPF32[samples + 2 * i];
                right[i] = HEAPF32[samples + 2 * i + 1];
            }
        };
        node.connect(sound.destination);
        sound.node = node; // so that it is not collected
        return 1;
    } catch (error) {
        console.warn("aPart is silent: " + error);
        return 0;
    }
}

function setSound(on) {
    if (sound) {
        (on ? sound.resume() : sound.suspend()).catch((error) => console.warn("aPart is silent: " + error));
    }
}

var Module = {
    turned,
    drawLetter,
    openSound,
    setSound,
    canvas,
    noInitialRun: false,
    print: (line) => console.log(line),
    printErr: (line) => console.warn(line),
    complain: tell,
    copyText,
    keepFiles: async () => false, // resolves to true once the browser has the files
    notKept: "", // why no files are kept
    preRun: [() => {
        // Private windows refuse storage: the files then last as long as the page.
        FS.mkdir(folder);
        addRunDependency("storage");
        openFiles().catch((error) => "Scores are not kept: " + error).then((problem) => {
            Module.notKept = problem;
            removeRunDependency("storage");
        });
    }],
    onRuntimeInitialized: () => setTimeout(start, 0), // after main()
    onAbort: (reason) => tell("The game stopped: " + reason),
};

async function start() {
    probePads();
    await Promise.allSettled([document.fonts.load("16px apart"), document.fonts.load("bold 16px apart")]);
    let wish = { level: "", replay: "" };
    let problem = "";
    try {
        wish = await wishes();
    } catch (error) {
        problem = "The replay of this link is damaged.";
    }
    tell("");
    started = true;
    problem = plain(Module.ccall("startGame", "string", ["string", "string"], [wish.level, wish.replay])) || problem;
    if (problem || Module.notKept) {
        flash(problem || Module.notKept, toRead);
    }
    canvas.focus();
}

/// What goes wrong before the game runs is told in place of it: a file that is missing, for instance.
function failed(reason) {
    if (!started) {
        tell("The game could not be loaded: " + reason);
    }
}

const buttons = document.querySelector("nav");
document.addEventListener("pointerlockchange", () => {
    buttons.hidden = document.pointerLockElement !== null; // no pointer could reach them
});
document.getElementById("pause").onclick = () => {
    if (started) {
        Module._pressButton(0);
    }
    canvas.focus();
};
document.getElementById("link").onclick = () => { copyLink(); canvas.focus(); };
document.getElementById("full").onclick = () => {
    document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen();
    canvas.focus();
};
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
window.addEventListener("dragover", (event) => event.preventDefault());
window.addEventListener("drop", (event) => {
    event.preventDefault();
    takeLevel(event.dataTransfer.files[0]);
});
window.addEventListener("hashchange", () => location.reload());
window.addEventListener("unhandledrejection", (event) => failed(event.reason));
window.addEventListener("error", (event) =>
    failed(event.message || (event.target.src || event.target.href) + " is missing"), true);
