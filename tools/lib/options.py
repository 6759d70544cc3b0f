# SPDX-License-Identifier: MIT
"""Command line options of the Python tools."""
import argparse
import sys


class Options(argparse.ArgumentParser):
    """Reports a wrong option in one line. Option names cannot be abbreviated."""

    def __init__(self, prog, **more):
        super().__init__(prog=prog, allow_abbrev=False, **more)

    def error(self, message):
        sys.stderr.write(f"{self.prog}: {message}. Try {self.prog} --help.\n")
        sys.exit(2)
