#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails when an include points up or sideways, or when the engine or the game core uses what would
make a result depend on the machine, the clock or the standard library.

Run it from anywhere: tools/check_layers.py. It looks at engine/, game/, tests/ and tools/."""
import re
import sys

sys.dont_write_bytecode = True  # leave no __pycache__ beside the tools
from check_sizes import blank_comments_and_strings, run  # noqa: E402

# The folders of the engine, lowest first: each may use those before it.
ENGINE = "base math shapes broad collide bodies contacts joints solve world".split()
KODO = ["kodo", *(f"kodo/{name}" for name in ENGINE)]

# Folder: what it may include beside itself and the standard library. "kodo" is engine/kodo/*.hpp.
MAY_USE = {f"engine/kodo/{name}": KODO[1 : i + 1] for i, name in enumerate(ENGINE)}
MAY_USE["engine/kodo/broad"] = ["kodo/base", "kodo/math"]  # knows bounds, not shapes
MAY_USE["engine/kodo"] = KODO
MAY_USE["engine/kodo_sfml"] = KODO
MAY_USE["game/apart/core"] = KODO
MAY_USE["game/apart/stage"] = [*KODO, "apart/core"]
MAY_USE["game/apart/headless"] = [*KODO, "apart/core"]
MAY_USE["game/apart/sfml"] = [*KODO, "kodo_sfml", "apart/core", "apart/stage"]

# A library from outside stays behind its door.
DOORS = {
    "SFML/": ("engine/kodo_sfml", "game/apart/sfml", "tests/display", "tools/destructoooor"),
    "imgui": ("tools/destructoooor",),
    "box2d/": ("tests/",),
    "gtest/": ("tests/",),
    "gmock/": ("tests/",),
    "rapidcheck": ("tests/",),
    "CLI/": ("game/apart/sfml", "game/apart/headless", "tests/", "tools/"),
}

# In engine/kodo and game/apart/core: pattern, then the sentence.
LIBM = (
    "sin cos tan asin acos atan atan2 sinh cosh tanh exp exp2 expm1 log log2 log10 log1p"
    " pow cbrt hypot fmod remainder fma"
).replace(" ", "|")
OWN_MATH = "libm differs between systems: use the functions of kodo/math"
RANDOM = "no std random: results differ between libraries"
UNORDERED = "no unordered containers: their order differs between libraries"
RANGES = "no ranges algorithms or views: clang 14 and emscripten lack them"
SAME_BITS = [
    (r"#\s*include\s*<(chrono|ctime|time\.h)>", "no clock: time is counted in steps and ticks"),
    (r"#\s*include\s*<random>|\brandom_device\b", RANDOM),
    (r"#\s*include\s*<unordered_(map|set)>|\bunordered_(multi)?(map|set)\b", UNORDERED),
    (rf"\bstd::({LIBM})[fl]?\b", OWN_MATH),
    (rf"(?<![\w.>:])({LIBM})f\(", OWN_MATH),
    (r"\bstd::(ranges|views)::|#\s*include\s*<ranges>", RANGES),
    (r"\bstd::(bit_cast|format|pmr|jthread)\b", "not in every library Kodo is built with"),
    (r"\bstd::c(out|err|log)\b|#\s*include\s*<iostream>", "a library prints nothing"),
]
SORTS = re.compile(r"\bstd::(sort|partial_sort|nth_element|make_heap|sort_heap)\b")
TOTAL_ORDER = re.compile(r"//.*total order", re.IGNORECASE)

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def layer_of(include):
    """'kodo/math/vec2.hpp' -> 'kodo/math'; None for what is not ours."""
    parts = include.split("/")
    if parts[0] == "kodo_sfml":
        return "kodo_sfml"
    if parts[0] not in ("kodo", "apart") or len(parts) == 1:
        return None
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def owner_of(folder):
    """The entry of MAY_USE that holds this folder, or None."""
    while folder not in MAY_USE and "/" in folder:
        folder = folder.rpartition("/")[0]
    return folder if folder in MAY_USE else None


def check_include(folder, mark, include):
    """The sentence that is wrong with this include, or None."""
    owner = owner_of(folder)
    layer = layer_of(include)
    if folder.startswith(("engine", "game")):
        if mark == '"' and layer is None:
            return f'"{include}": include by full path, as in <kodo/math/vec2.hpp>'
        if owner is not None and layer is not None:
            own = owner.partition("/")[2]
            if layer != own and layer not in MAY_USE[owner]:
                return f"{own} must not include {layer}"
        if owner is not None and owner.startswith("engine/kodo") and owner != "engine/kodo_sfml":
            if layer is None and re.search(r"[/.]", include):
                return f"<{include}>: Kodo needs the C++ standard library and nothing else"
    for door, folders in DOORS.items():
        if include.startswith(door) and not f"{folder}/".startswith(folders):
            return f"{door.rstrip('/')} only in {' and '.join(folders)}"
    return None


def check_same_bits(raw, code):
    """Yields (line number, sentence)."""
    for number, line in enumerate(code, 1):
        for pattern, sentence in SAME_BITS:
            if match := re.search(pattern, line):
                yield number, f"{match.group(0).strip()}: {sentence}"
        if match := SORTS.search(line):
            beside = raw[max(number - 2, 0) : number]
            if not any(TOTAL_ORDER.search(text) for text in beside):
                yield number, (
                    f"{match.group(0)}: equal keys come out in any order. If no keys are equal, say"
                    " why in a comment '// total order: ...' on this line or the one before"
                )


def check_file(path, name):
    """Yields (line number, sentence)."""
    folder = name.parent.as_posix()
    text = path.read_text(encoding="utf-8")
    owner = owner_of(folder)
    unknown = owner is None or owner == "engine/kodo" != folder
    if unknown and folder.startswith(("engine", "game")):
        yield 1, f"the folder {folder} is not in the table of tools/check_layers.py"
    raw = text.split("\n")
    code = blank_comments_and_strings(text).split("\n")
    for number, line in enumerate(raw, 1):
        if (match := INCLUDE.match(line)) and code[number - 1].strip():
            if sentence := check_include(folder, match.group(1), match.group(2)):
                yield number, sentence
    if f"{folder}/".startswith(("engine/kodo/", "game/apart/core/")):
        yield from check_same_bits(raw, code)


if __name__ == "__main__":
    sys.exit(run("layers", check_file, __doc__))
