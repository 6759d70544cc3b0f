# SPDX-License-Identifier: MIT
"""Runs a program on a virtual screen of its own, and ends with its exit code:

    with_screen.py PROGRAM [ARGUMENT...]

The server accepts clients before the program starts, and is not reset when its last client leaves.
With xvfb-run a window sometimes could not be opened."""
import subprocess
import sys

sys.dont_write_bytecode = True

from virtual_screen import Screen  # noqa: E402

with Screen() as screen:
    sys.exit(subprocess.run(sys.argv[1:], env=screen.env, timeout=110, check=False).returncode)
