# SPDX-License-Identifier: MIT
"""What the tools in Python share."""
import argparse
import sys


class Options(argparse.ArgumentParser):
    """A wrong option is told in one line, and an option's name is not cut short."""

    def __init__(self, prog, **more):
        super().__init__(prog=prog, allow_abbrev=False, **more)

    def error(self, message):
        sys.stderr.write(f"{self.prog}: {message}. Try {self.prog} --help.\n")
        sys.exit(2)
