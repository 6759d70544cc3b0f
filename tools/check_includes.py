#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles each source of the engine by itself, without code: it includes what it uses. Unity builds
would hide a missing include.

tools/check_includes.py [--compiler clang++] [--jobs N]
With clang, a large header that a source includes anyway, perhaps through others, is precompiled.
Exit code: 0 all compile, 1 a source does not, 2 wrong use or no compiler."""
import argparse
import concurrent.futures
import functools
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = (ROOT / "engine/src", ROOT / "engine/include")
INCLUDE = re.compile(r'^#include ["<]([\w/.]+)[">]', re.MULTILINE)
# The first one that a source includes is precompiled for it.
LARGE = ("world/world_impl.hpp", "contacts/contact_set.hpp", "bodies/bodies.hpp", "kodo/body.hpp",
         "kodo/math.hpp")


@functools.cache
def headers_of(path):
    """The headers of the project that a file includes, also through others."""
    found = set()
    for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
        for folder in FOLDERS:
            if (folder / name).is_file():
                found |= {name} | headers_of(folder / name)
    return found


def is_avx2(source):
    return source.stem.endswith("_avx2") and platform.machine() in ("x86_64", "AMD64")


class Compiler:
    def __init__(self, program, folder):
        self.folder = pathlib.Path(folder)
        self.command = [program, "-std=c++20", "-w", "-DKODO_ENABLE_ASSERTS",
                        *[f"-I{path}" for path in FOLDERS], f"-I{folder}"]
        (self.folder / "kodo").mkdir()
        export = self.folder / "kodo/export.hpp"  # otherwise made by CMake
        export.write_text("#pragma once\n#define KODO_API\n", encoding="utf-8")
        self.precompiled = {}
        for name in LARGE if "clang" in program else ():
            header = self.folder / f"{name.replace('/', '_')}"
            header.write_text(f'#include "{name}"\n', encoding="utf-8")
            made = header.with_suffix(".pch")
            subprocess.run([*self.command, "-x", "c++-header", header, "-o", made], check=True)
            self.precompiled[name] = made

    def errors_of(self, source):
        """Empty: none."""
        command = [*self.command, "-fsyntax-only"]
        if is_avx2(source):
            command.append("-mavx2")
        else:
            headers = headers_of(source)
            large = [made for name, made in self.precompiled.items() if name in headers]
            command += ["-include-pch", large[0]] if large else []
        done = subprocess.run([*command, source], capture_output=True, text=True, check=False)
        return done.stderr if done.returncode != 0 else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("--compiler", default="clang++" if shutil.which("clang++") else "g++")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 2)
    options = parser.parse_args()
    if options.jobs < 1:
        parser.error("--jobs must be at least 1")
    if shutil.which(options.compiler) is None:
        print(f"{options.compiler} is missing.", file=sys.stderr)
        return 2
    sources = sorted((ROOT / "engine/src").rglob("*.cpp"))
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        compiler = Compiler(options.compiler, folder)
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for source, text in zip(sources, pool.map(compiler.errors_of, sources)):
                if text:
                    failed += 1
                    print(f"{source.relative_to(ROOT)} does not compile alone:\n{text}")
    if not failed:
        print(f"Each of {len(sources)} sources of the engine compiles alone.")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
