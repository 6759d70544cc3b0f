#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the layers: an include must point to a lower layer. The engine and the game core must not
use anything whose result depends on the machine, the clock or the standard library.

Run it from any folder: tools/check_layers.py. It reads engine/, game/, tests/ and tools/."""
import re
import sys

sys.dont_write_bytecode = True  # leave no __pycache__ beside the tools
from check_sizes import blank_comments_and_strings, run  # noqa: E402

# Folders of engine/src, lowest first: each may include the folders before it.
ENGINE = (
    "base math shapes broad collide bodies lanes contacts joints impacts soft propagation"
    " continuous sleep world draw helpers"
).split()

# Folders of game/apart/stage, lowest first: each may include the folders before it. The files
# beside them, the application itself, may include all.
STAGE = "canvas controls effects sound painters records play screens".split()

# Public headers, engine/include/kodo/NAME.hpp, by the layer that they belong to. A folder of the
# engine may include those of its own layer and of lower ones.
PUBLIC = {
    "base": "real version export error executor state_hash step_stats",
    "math": "math",
    "shapes": "material shape convex_shape mass measure ray geometry",
    "bodies": "filter body force_field settings collision_record joint",
    "world": "world query snapshot kodo",
    "draw": "debug_draw",
    "helpers": "mover explosion axis_lock",
}
LAYER_OF = {name: layer for layer, names in PUBLIC.items() for name in names.split()}

# Folder: layers that it may include beside itself. "public": the headers <kodo/...>.
MAY_USE = {f"engine/src/{name}": ENGINE[:i] for i, name in enumerate(ENGINE)}
MAY_USE["engine/src/broad"] = ["base", "math"]  # works on bounds, not on shapes
MAY_USE["engine/src/draw"] = []  # uses the public headers alone
MAY_USE["engine/src/helpers"] = []  # likewise
MAY_USE["engine/include/kodo"] = ["public"]
MAY_USE["engine/c/kodo_c"] = ["public"]
MAY_USE["engine/c/examples"] = []
MAY_USE["engine/c"] = []
MAY_USE["engine/js"] = []
MAY_USE["engine/sfml/kodo_draw"] = ["public"]
MAY_USE["engine/sfml/kodo_sfml"] = ["public", "kodo_draw"]
MAY_USE["engine/docs/pictures"] = ["public"]
MAY_USE["engine/examples"] = ["public", "kodo_draw", "kodo_sfml"]
MAY_USE["game/apart/core"] = ["public"]
MAY_USE["game/apart/stage"] = ["public", "apart/core"]
MAY_USE["game/apart/headless"] = ["public", "apart/core"]
MAY_USE["game/apart/front"] = ["public", "kodo_draw", "apart/core", "apart/stage"]
MAY_USE["game/apart/sfml"] = [
    "public",
    "kodo_draw",
    "kodo_sfml",
    "apart/core",
    "apart/stage",
    "apart/front",
]
MAY_USE["game/apart/web"] = ["public", "kodo_draw", "apart/core", "apart/stage", "apart/front"]

# Third-party library: the only folders that may include it.
DOORS = {
    "SFML/": (
        "engine/sfml",
        "engine/examples",
        "game/apart/sfml",
        "tests/display",
        "tools/destructoooor",
    ),
    "imgui": ("tools/destructoooor",),
    "box2d/": ("tests/",),
    "gtest/": ("tests/",),
    "gmock/": ("tests/",),
    "rapidcheck": ("tests/",),
    "emscripten": ("game/apart/web",),
    "GLES3/": ("game/apart/web",),
    "CLI/": ("game/apart/sfml", "game/apart/headless", "tests/", "tools/"),
}

# In engine/src, engine/include and game/apart/core: forbidden pattern, and the message.
LIBM = (
    "sin cos tan asin acos atan atan2 sinh cosh tanh exp exp2 expm1 log log2 log10 log1p"
    " pow cbrt hypot fmod remainder fma"
).replace(" ", "|")
OWN_MATH = "libm differs between systems: use the functions of math/trig.hpp"
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
    (r"\bstd::(bit_cast|format|pmr|jthread)\b", "missing in some supported standard libraries"),
    (r"\bstd::c(out|err|log)\b|#\s*include\s*<iostream>", "a library must not print"),
]
# Folders of the engine whose code must not call what lies above it by a stored function.
NO_CALLBACKS = ("engine/src/contacts/", "engine/src/lanes/")
CALLBACK = re.compile(r"\bstd::(move_only_)?function\b")
SORTS = re.compile(r"\bstd::(sort|partial_sort|nth_element|make_heap|sort_heap)\b")
TOTAL_ORDER = re.compile(r"//.*total order", re.IGNORECASE)

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def owner_of(folder):
    """The entry of MAY_USE that contains this folder, or None."""
    while folder not in MAY_USE and "/" in folder:
        folder = folder.rpartition("/")[0]
    return folder if folder in MAY_USE else None


def check_public(owner, mark, include):
    """The message for a forbidden include of <kodo/...> in the engine itself, or None."""
    name = include.removeprefix("kodo/").removesuffix(".hpp")
    own = owner.rpartition("/")[2]
    if name not in LAYER_OF:
        return f"<{include}> is not in the table PUBLIC of tools/check_layers.py"
    if own in ENGINE and ENGINE.index(LAYER_OF[name]) > ENGINE.index(own):
        return f"{own} must not include <{include}>, a header of {LAYER_OF[name]}"
    return None if mark == "<" else f'"{include}": write <{include}>'


def check_engine(owner, mark, include):
    """The message for a forbidden include of the engine, or None."""
    own = owner.rpartition("/")[2]
    layer = include.partition("/")[0]
    if include.startswith("kodo/"):
        return check_public(owner, mark, include)
    if mark == "<":
        other = re.search(r"[/.]", include)
        return f"<{include}>: Kodo may use only the C++ standard library" if other else None
    if own not in ENGINE:
        return f'"{include}": a public header includes <kodo/...> and the standard library alone'
    if layer not in ENGINE or "/" not in include:
        return f'"{include}": include by the path below engine/src, as in "math/trig.hpp"'
    allowed = layer == own or layer in MAY_USE[owner]
    return None if allowed else f"{own} must not include {layer}"


def check_user(owner, mark, include):
    """The message for a forbidden include of what uses the engine, or None."""
    own = owner.partition("/")[2]
    if mark == '"':
        return f'"{include}": include by full path, as in <kodo/world.hpp>'
    for layer in ("kodo_c", "kodo_sfml", "apart/core", "apart/stage", "apart/headless", "apart/sfml"):
        allowed = layer in MAY_USE[owner] or own.endswith(layer)
        if include.startswith(f"{layer}/") and not allowed:
            return f"{own} must not include {layer}"
    return None


def check_stage(folder, include):
    """The message for a forbidden include within game/apart/stage, or None."""
    folders = [re.match(r"(?:game/)?apart/stage/(\w*)", path) for path in (folder, include)]
    own, other = (match and match[1] for match in folders)
    if not own or other is None or other in STAGE[: STAGE.index(own) + 1]:
        return None
    return f"{own} must not include <{include}>"


def check_include(folder, mark, include):
    """The message for a forbidden include, or None."""
    if sentence := check_stage(folder, include):
        return sentence
    owner = owner_of(folder)
    if owner is not None:
        engine = owner.startswith(("engine/src/", "engine/include/"))
        if sentence := (check_engine if engine else check_user)(owner, mark, include):
            return sentence
    for door, folders in DOORS.items():
        if include.startswith(door) and not f"{folder}/".startswith(folders):
            return f"{door.rstrip('/')} only in {' and '.join(folders)}"
    return None


def check_same_bits(raw, code):
    """Yields (line number, message)."""
    for number, line in enumerate(code, 1):
        for pattern, sentence in SAME_BITS:
            if match := re.search(pattern, line):
                yield number, f"{match.group(0).strip()}: {sentence}"
        if match := SORTS.search(line):
            beside = raw[max(number - 2, 0) : number]
            if not any(TOTAL_ORDER.search(text) for text in beside):
                yield number, (
                    f"{match.group(0)}: the order of equal keys is undefined. If no keys are equal,"
                    " give the reason in a comment '// total order: ...' on this line or the line"
                    " before"
                )


def check_callbacks(code):
    """Yields (line number, message)."""
    for number, line in enumerate(code, 1):
        if match := CALLBACK.search(line):
            yield number, f"{match.group(0).strip()}: no calls upwards; pass what is needed"


def check_precision(text):
    """The message for a file without the macro of its inline namespace, or None. Such a file
    compiles, and its functions have names that no other file can link."""
    if re.search(r"^#include [<\"](?!kodo/export)\w+/", text, re.MULTILINE):
        return None
    return "uses KODO_PRECISION without an include that defines it: <kodo/real.hpp> at least"


def check_file(path, name):
    """Yields (line number, message)."""
    folder = name.parent.as_posix()
    text = path.read_text(encoding="utf-8")
    if folder.startswith("engine/") and "namespace KODO_PRECISION" in text:
        if name.name != "real.hpp" and (sentence := check_precision(text)):
            yield 1, sentence
    owner = owner_of(folder)
    if owner is None and folder.startswith(("engine", "game")):
        yield 1, f"the folder {folder} is not in the table of tools/check_layers.py"
    raw = text.split("\n")
    code = blank_comments_and_strings(text).split("\n")
    for number, line in enumerate(raw, 1):
        if (match := INCLUDE.match(line)) and code[number - 1].strip():
            if sentence := check_include(folder, match.group(1), match.group(2)):
                yield number, sentence
    if f"{folder}/".startswith(("engine/src/", "engine/include/", "game/apart/core/")):
        yield from check_same_bits(raw, code)
    if f"{folder}/".startswith(NO_CALLBACKS):
        yield from check_callbacks(code)


if __name__ == "__main__":
    sys.exit(run("layers", check_file, __doc__))
