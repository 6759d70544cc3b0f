#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that each source file of the engine, of the game core and of apart-headless includes what
it needs: it compiles alone, with warnings as errors, where SFML is missing. Only the syntax is
checked.

Configures the preset headless and runs its compile commands with -fsyntax-only. Run it from any
folder: tools/check_includes.py. Exit code: 0 all compile, 1 one does not, 2 CMake fails."""
import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/headless"
FOLDERS = ("engine/src", "game/apart/core", "game/apart/headless")


def run(command, folder=ROOT):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def syntax_check(entry):
    """(file, messages); without messages if the file compiles."""
    words = shlex.split(entry["command"])
    if pathlib.Path(words[0]).name == "ccache":  # it does not cache a syntax check
        del words[0]
    place = words.index("-o")
    words[place : place + 2] = ["-fsyntax-only"]
    done = run(words, entry["directory"])
    return entry["file"], "" if done.returncode == 0 else done.stderr


def main():
    done = run(["cmake", "--preset", "headless"])
    if done.returncode != 0:
        print(done.stdout + done.stderr, file=sys.stderr)
        return 2
    entries = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
    folders = tuple(f"{ROOT / name}/" for name in FOLDERS)
    alone = [entry for entry in entries if entry["file"].startswith(folders)]
    if not alone:
        print("The preset headless compiles no file alone.", file=sys.stderr)
        return 1
    jobs = int(os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", os.cpu_count() or 2))
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as workers:
        for file, messages in workers.map(syntax_check, alone):
            if messages:
                failed += 1
                print(f"{file} does not compile alone:\n{messages}", file=sys.stderr)
    print(f"includes: {f'{failed} failed' if failed else 'ok'}, {len(alone)} files")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
