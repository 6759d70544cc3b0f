#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles and runs the C++ blocks of Markdown pages.

    page_blocks.py generate SOURCE PAGE...  writes one C++ source with a function for each ```cpp block
    page_blocks.py check PROGRAM PAGE       runs the blocks of a page and compares the outputs
    page_blocks.py update PROGRAM PAGE      runs the blocks of a page and writes the outputs into it

A block with main() is a whole program. Any other block is the body of a function after
#include <kodo/kodo.hpp> and some headers of the standard library. Its own #include lines are moved
to the top of the source. Comments in front of a block, on a line of their own:

    <!-- continue -->    the block continues the function of the block before
    <!-- shared -->      the block stands outside of functions, for all blocks of the page behind it
    <!-- skip -->        the block is not compiled

A ```text block that follows with nothing but blank lines between is the expected output. Without
one the output is ignored; what such a block shows, it asserts: assert() counts in every build.
Exit code 0: equal, 1: different or failed."""
import pathlib
import re
import subprocess
import sys

HEADERS = ["kodo/kodo.hpp", "algorithm", "array", "cassert", "cmath", "cstddef", "cstdint", "cstdio", "memory",
           "map", "optional", "string", "utility", "vector"]
MARK = "\x1e"  # in front of the output of a block
MARK_IN_C = "\\036"


class Block:
    def __init__(self, line, text):
        self.line = line  # of the first line of code
        self.text = text
        self.expected = None
        self.shared = False

    def is_program(self):
        return re.search(r"^\s*(int|auto)\s+main\s*\(", self.text, re.M) is not None


def blocks_of(page):
    """Groups of blocks; each group is one function, and all but the first block continue it."""
    groups, last, comment = [], None, ""
    lines = pathlib.Path(page).read_text(encoding="utf-8").splitlines()
    i = 0
    while i < len(lines):
        opening = re.match(r"^(`{3,}|~{3,})\s*(\S*)\s*$", lines[i].strip())
        if opening is None:
            if lines[i].strip():
                comment, last = lines[i].strip(), None
            i += 1
            continue
        fence, language = opening.groups()
        first = i + 1
        i = first
        while i < len(lines) and lines[i].strip() != fence:
            i += 1
        text = "\n".join(lines[first:i]) + "\n"
        i += 1
        if language == "text" and last is not None:
            last.expected = text
        last = None
        if language == "cpp" and comment != "<!-- skip -->":
            last = Block(first + 1, text)
            last.shared = comment == "<!-- shared -->"
            if comment == "<!-- continue -->" and groups:
                groups[-1].append(last)
            else:
                groups.append([last])
        comment = ""
    return groups


def split_includes(block):
    """Include lines, and the code without them; the number of lines stays."""
    includes, code = [], []
    for line in block.text.splitlines():
        is_include = re.match(r"^\s*#\s*include\b", line) is not None
        includes += [line.strip()] if is_include else []
        code.append("" if is_include else line)
    return includes, "\n".join(code)


def functions_of(page, includes):
    """The functions of a page, and the lines that call them; adds to the includes."""
    name = pathlib.Path(page).name
    functions, calls = [], []
    for number, group in enumerate(blocks_of(page)):
        body = []
        for block in group:
            found, code = split_includes(block)
            includes += [line for line in found if line not in includes]
            begin = f'std::printf("{MARK_IN_C}{block.line}\\n");\n'
            place = f'#line {block.line} "{name}"\n'
            if block.shared:
                functions.append(f"{place}{code}\n")
            elif block.is_program():  # main() of a namespace needs its return
                code = "return 0;\n}".join(code.rsplit("}", 1))
                body = [f"namespace block_{number} {{\n{place}{code}\n}}\n",
                        f"void run_{number}() {{\n{begin}"
                        f'if (block_{number}::main() != 0) {{ std::printf("{MARK_IN_C}failed\\n"); }}\n}}\n']
            else:
                body.append(f"{begin}{place}{code}\n")
        if group[0].shared:
            continue
        if not group[0].is_program():
            body = [f"void run_{number}() {{\n", *body, "}\n"]
        functions += body
        calls.append(f"        run_{number}();\n")
    return functions, calls


def source_of(pages):
    """One program; its argument is the number of the page whose blocks run."""
    includes = [f"#include <{header}>" for header in HEADERS]
    text, choice = [], []
    for number, page in enumerate(pages):
        functions, calls = functions_of(page, includes)
        text += [f"namespace page_{number} {{\nnamespace {{\n", *functions, "}\nvoid run() {\n", *calls, "}\n}\n"]
        choice.append(f'        if (page == "{pathlib.Path(page).resolve()}") {{ page_{number}::run(); }}\n')
    return ("// Made by page_blocks.py.\n" + "\n".join(includes) + "\n#include <exception>\n#include <string_view>\n"
            + "".join(text) + "int main(int, char** arguments) {\n    std::setvbuf(stdout, nullptr, _IOLBF, 0); // an assertion ends the program\n    try {\n"
            + "        const std::string_view page = arguments[1];\n" + "".join(choice)
            + "    } catch (const std::exception& error) {\n"
            + f'        std::printf("{MARK_IN_C}failed\\n%s\\n", error.what());\n'
            + "        return 1;\n    }\n}\n")


def outputs_of(program, page):
    """Outputs by the line of their block, and what went wrong."""
    result = subprocess.run([program, str(pathlib.Path(page).resolve())], capture_output=True, text=True, timeout=60, check=False)
    outputs, failure = {}, ""
    for part in result.stdout.split(MARK)[1:]:
        head, _, text = part.partition("\n")
        if head == "failed":
            failure = f"failed: {text.strip()}"
        else:
            outputs[int(head)] = text
    if result.returncode and not failure:
        failure = f"exit code {result.returncode}: {result.stderr.strip()}"
    return outputs, failure


def check(page, program):
    outputs, failure = outputs_of(program, page)
    groups = blocks_of(page)
    compared, wrong = 0, 0
    for block in (block for group in groups for block in group):
        found = outputs.get(block.line)
        if block.shared:
            continue
        if found is None:
            failure = failure or f"line {block.line}: did not run"
        elif block.expected is not None:
            compared += 1
            if found != block.expected:
                wrong += 1
                print(f"{page}:{block.line}: prints\n{found}instead of\n{block.expected}")
    if failure:
        ran = max(outputs, default=0)
        print(f"{page}: after line {ran}: {failure}")
    print(f"{page}: {sum(map(len, groups))} blocks, {compared} outputs compared, {wrong} different")
    return 1 if wrong or failure else 0


def update(page, program):
    outputs, failure = outputs_of(program, page)
    path = pathlib.Path(page)
    lines = path.read_text(encoding="utf-8").splitlines()
    blocks = [block for group in blocks_of(page) for block in group]
    for block in reversed([each for each in blocks if each.expected is not None]):
        first = lines.index("```text", block.line) + 1
        last = lines.index("```", first)
        lines[first:last] = outputs.get(block.line, block.expected).splitlines()
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    if failure:
        print(f"{page}: {failure}")
    return 1 if failure else 0


def main():
    if len(sys.argv) < 4 or sys.argv[1] not in ("generate", "check", "update"):
        print(__doc__)
        return 2
    command, target, *pages = sys.argv[1:]
    if command != "generate":
        return (check if command == "check" else update)(pages[0], target)
    pathlib.Path(target).write_text(source_of(pages), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
