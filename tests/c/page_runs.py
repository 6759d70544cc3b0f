#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the first C or Python block of a page and compares its output with the text block that
follows.

  page_runs.py PAGE c --compiler cc --include DIR --library FILE
  page_runs.py PAGE python --module DIR --library FILE

Exit code: 0 equal, 1 different or failed."""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("language", choices=("c", "python"))
    parser.add_argument("--library", type=pathlib.Path, required=True)
    for name in ("compiler", "include", "module"):
        parser.add_argument(f"--{name}")
    given = parser.parse_args()
    text = given.page.read_text(encoding="utf-8")
    found = re.search(rf"```{given.language}\n(.*?)```\n\n```text\n(.*?)```", text, re.DOTALL)
    if found is None:
        sys.exit(f"{given.page} has no block of {given.language} with a text block")
    code, expected = found.groups()
    variables = dict(os.environ)
    with tempfile.TemporaryDirectory(prefix="kodo-page-") as work:
        source = pathlib.Path(work) / f"page.{given.language}"
        source.write_text(code)
        if given.language == "c":
            program = [str(source.with_suffix(""))]
            folder = given.library.parent
            command = [given.compiler, "-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
            command += [f"-I{given.include}", source, given.library, f"-Wl,-rpath,{folder}"]
            subprocess.run([*command, "-o", program[0]], check=True)
        else:
            program = [sys.executable, "-B", str(source)]
            variables |= {"PYTHONPATH": given.module, "KODO_LIBRARY": str(given.library)}
        done = subprocess.run(program, env=variables, capture_output=True, text=True, check=False)
    if done.returncode != 0 or done.stdout != expected:
        sys.exit(f"{given.page}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
