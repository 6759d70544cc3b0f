#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures frame times with 500 bodies on a virtual screen, without a graphics card:

    frames.py build/release/bin/apart assets [frames]

The level has motors and hanging blocks with two bodies each; the bot adds shards. The script
prints frame times, but fails only if no frame was measured: times depend on the machine.
Exit code: 0: measured, 1: failed, 77: a tool is missing."""
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from virtual_screen import Screen, skip_without_tools  # noqa: E402

BODIES = 500


def level():
    rows = [("m" if row % 2 == 0 else "h") * 15 for row in range(15)]
    return ("format = 1\ntitle = \"Crowd\"\nidea = \"Five hundred bodies.\"\nball-speed = 20000\n"
            "lives = 9\ngrid = '''\n" + "\n".join(rows) + "\n'''\n"
            "[legend.m]\nobstruction = \"motor\"\nsize = 400\nspeed = 1000\n"
            "[legend.h]\nstuff = \"glass\"\nhold = \"hanging\"\narm = 400\n")


def main():
    apart, assets = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    frames = sys.argv[3] if len(sys.argv) > 3 else "3600"
    skip_without_tools()
    with tempfile.TemporaryDirectory() as folder, Screen() as screen:
        levels = pathlib.Path(folder) / "levels"
        levels.mkdir()
        (levels / "crowd.toml").write_text(level())
        (pathlib.Path(folder) / "fonts").symlink_to(assets / "fonts")
        screen.env["APART_ASSETS"] = folder
        result = screen.run(str(apart), "--level", "crowd", "--frames", frames, "--crowd", str(BODIES),
                            seconds=600)
        print(result.stdout + result.stderr, end="")
        return 0 if result.returncode == 0 and " bodies: mean" in result.stdout else 1


if __name__ == "__main__":
    sys.exit(main())
