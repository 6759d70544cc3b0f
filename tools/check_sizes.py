#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks sizes against the limits: header 250 lines (public ones 300, that in C 1500), source 400,
test 500; function 60 lines (80 outside engine/ and game/apart/core); line 100 columns; 6
parameters; class of engine/ and game/ 25 data members and 50 functions (not counted: friends,
constants, types, and what is defaulted or deleted). Prints the lines of code of engine/src and engine/include, without
blank lines and comments: at most MAX_ENGINE_LINES, and 15 % of them in one folder of engine/src.

Run it from any folder: tools/check_sizes.py. It reads engine/, game/, tests/ and tools/.
Functions are found by brace depth in formatted code, without a compiler."""
import argparse
import pathlib
import re
import sys

MAX_COLUMNS = 100
MAX_PARAMETERS = 6
MAX_DATA_MEMBERS = 25
MAX_MEMBER_FUNCTIONS = 50
MAX_HEART_LINES = 24_310  # of code; lowered when the engine has become smaller, never raised
MAX_FEATURE_LINES = 2_500  # for what users of other engines look for: joints, parts, drawing, casts
MAX_ENGINE_LINES = MAX_HEART_LINES + MAX_FEATURE_LINES
MAX_FOLDER_SHARE = 0.15  # of these lines

TOKEN = re.compile(
    r"""(?P<comment>//(?:\\\n|[^\n])*|/\*.*?\*/)
      | (?P<raw>\bR"(?P<mark>[^()\s\\]{0,16})\(.*?\)(?P=mark)")
      | (?P<string>"(?:\\.|[^"\\\n])*")
      | (?P<char>(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+')""",
    re.DOTALL | re.VERBOSE,
)
PREPROCESSOR = re.compile(r"^[ \t]*#(?:\\\n|[^\n])*", re.MULTILINE)
# What may follow the parameters before the body.
SPECIFIERS = re.compile(
    r"(?:\s*(?:const|volatile|noexcept(?:\s*\([^()]*(?:\([^()]*\)[^()]*)*\))?"
    r"|override|final|mutable|constexpr|try|&&?|requires\b.*|->.*))*\s*$",
    re.DOTALL,
)
ACCESS = re.compile(r"\s*(public|private|protected)\s*")
CONSTRUCTOR = re.compile(r"\)\s*(?:noexcept\s*)?:(?!:)")
NOT_A_NAME = {"decltype", "noexcept", "explicit", "alignas", "requires", "__attribute__", "sizeof"}


def blank_comments_and_strings(text):
    """Blanks comments and strings; lines and columns stay. The names of includes stay too."""

    def blank(match):
        before = text[max(0, match.start() - 20) : match.start()]
        if match.lastgroup == "string" and re.search(r"#\s*include\s*$", before):
            return match.group(0)
        body = re.sub(r"[^\n]", " ", match.group(0))
        return body if match.group("comment") else '""' + body[2:]

    return TOKEN.sub(blank, text)


def split_at_commas(text):
    """Splits at commas of bracket depth 0."""
    parts, depth, start = [], 0, 0
    for i, c in enumerate(text):
        if c in "(<[{":
            depth += 1
        elif c in ")]}" or (c == ">" and text[i - 1] != "-"):
            depth -= 1
        elif c == "," and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    parts.append(text[start:])
    return [part for part in parts if part.strip()]


def parameters_of(head):
    """(name, number of parameters) of the function that `head` declares, or None."""
    head = re.sub(r"\[\[.*?\]\]", " ", head, flags=re.DOTALL)
    name = r"(operator\s*(?:\(\s*\)|[^\s\w(]+|\w+)|~?[A-Za-z_]\w*)\s*\("
    for match in re.finditer(name, head):
        before = head[: match.start()]
        if match.group(1) in NOT_A_NAME or before.count("(") != before.count(")"):
            continue
        depth, i = 0, match.end() - 1
        for i in range(match.end() - 1, len(head)):
            depth += {"(": 1, ")": -1}.get(head[i], 0)
            if depth == 0:
                break
        return match.group(1), len(split_at_commas(head[match.end() : i]))
    return None


def is_body(head):
    """True if the brace after this text opens the body of a function."""
    if CONSTRUCTOR.search(head):  # a: m_{...}, n_(...) {   only the last brace follows ) or }
        return head.rstrip()[-1:] in ")}"
    depth = 0
    for i, c in enumerate(head):
        depth += {"(": 1, ")": -1}.get(c, 0)
        if c == ")" and depth == 0 and SPECIFIERS.fullmatch(head[i + 1 :]):
            return True
    return False


def is_scope(head):
    """True if the brace after this text opens a namespace or a type."""
    noise = r"\btemplate\s*<.*?>|\balignas\s*\(.*?\)|\[\[.*?\]\]"
    head = re.sub(noise, " ", head, flags=re.DOTALL)
    if re.match(r'\s*(inline\s+)?namespace\b|\s*extern\s*""\s*$', head):
        return True
    return re.search(r"\b(class|struct|union)\b[^()=]*$", head) is not None


def is_declaration(head):
    """True if the semicolon after this text ends the declaration of a function."""
    outside, depth = "", 0
    for c in head:
        depth -= c == ")"
        outside += c if depth == 0 else ""
        depth += c == "("
    outside = re.sub(r"operator\s*[^\s\w(]+|=\s*(0|default|delete)\s*$", "", outside)
    return re.search(r"\w\s*\(\)|^\s*\(\)", outside) is not None and "=" not in outside


def class_name(head):
    """The name of the type whose brace follows, or None for a namespace."""
    head = re.sub(r"\balignas\s*\(.*?\)|\[\[.*?\]\]", " ", head, flags=re.DOTALL)
    match = re.search(r"\b(?:class|struct|union)\b\s*(?:[A-Z_]+_API\s+)?(\w*)[^()=]*$", head)
    return match and (match.group(1) or "a type without a name")


class Class:
    """Counts the members of a type."""

    def __init__(self, position, name):
        self.position, self.name = position, name
        self.data = self.functions = 0

    def add_declaration(self, head):
        """Of a member without a body."""
        head = head.strip()
        if re.search(r"=\s*(default|delete)$", head) or re.match(
            r"(template\s*<[^;]*>\s*)?(using|friend|typedef|static_assert|enum|class|struct|union"
            r"|static\s+constexpr|static\s+const|inline\s+static\s+const\w*)\b[^;]*$",
            head,
        ):
            return
        head = re.sub(r"^template\s*<.*?>\s*(?=\w)", "", head, flags=re.DOTALL)
        if is_declaration(head):
            self.functions += len(split_at_commas(head))
        elif head:
            self.data += len(split_at_commas(head))


class Scanner:
    """Collects the functions of namespaces and types from code without comments."""

    def __init__(self, text):
        self.code = PREPROCESSOR.sub(
            lambda match: re.sub(r"[^\n]", " ", match.group(0)), blank_comments_and_strings(text)
        )
        self.functions = []  # (begin, end, name, parameters); begin = end: a declaration
        self.classes = []  # Class, in the order of their names in the code
        self.scopes = []  # the Class of each open brace; None: a namespace

    def line(self, position):
        return self.code.count("\n", 0, position) + 1

    def past_brace(self, i):
        """The position after the brace that matches the one at i."""
        depth = 0
        while i < len(self.code):
            depth += {"{": 1, "}": -1}.get(self.code[i], 0)
            i += 1
            if depth == 0:
                break
        return i

    def open_scope(self, start, head):
        name = class_name(head)
        self.scopes.append(name and Class(start + len(head) - len(head.lstrip()), name))
        if name:
            self.classes.append(self.scopes[-1])

    def member_of(self):
        """The innermost type that is open, or in a namespace an unlisted one, which is discarded."""
        return (self.scopes and self.scopes[-1]) or Class(0, "")

    def add(self, start, end, head):
        first = start + len(head) - len(head.lstrip())
        name, parameters = parameters_of(head) or ("a lambda", 0)
        self.functions.append((first, max(first, end), name, parameters))

    def scan(self):
        i, start, head, paren = 0, 0, "", 0
        while i < len(self.code):
            c = self.code[i]
            paren += {"(": 1, ")": -1}.get(c, 0)
            end = i + 1
            starts_anew = False
            if c == "{" and paren == 0 and is_scope(head):
                starts_anew = True
                self.open_scope(start, head)
            elif c == "{":
                end = self.past_brace(i)
                starts_anew = paren == 0 and is_body(head)
                if starts_anew:
                    self.add(start, end, head)
                    self.member_of().functions += not re.match(r"\s*friend\b", head)
            elif paren == 0 and c == ";":
                starts_anew = True
                self.member_of().add_declaration(head)
                if is_declaration(head):
                    self.add(start, start, head)
            elif c == "}" or (c == ":" and ACCESS.fullmatch(head)):
                starts_anew = True
                if c == "}" and self.scopes:
                    self.scopes.pop()
            if starts_anew:
                start, head = end, ""
            else:
                head += "{}" if c == "{" else c
            i = end
        return self.functions


def functions_of(scanner):
    """Yields (first line, number of lines, name, parameters); 0 lines for a declaration."""
    for first, end, name, parameters in scanner.functions:
        begin = scanner.line(first)
        yield begin, (scanner.line(end - 1) - begin + 1 if end > first else 0), name, parameters


def check_classes(scanner):
    """Yields (line number, message)."""
    for found in scanner.classes:
        if found.data > MAX_DATA_MEMBERS:
            yield scanner.line(found.position), (
                f"{found.name} has {found.data} data members; a class has at most"
                f" {MAX_DATA_MEMBERS}"
            )
        if found.functions > MAX_MEMBER_FUNCTIONS:
            yield scanner.line(found.position), (
                f"{found.name} has {found.functions} functions; a class has at most"
                f" {MAX_MEMBER_FUNCTIONS}"
            )


def check_file(path, name):
    """Yields (line number, message)."""
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    if name.parts[0] == "tests":
        kind, limit = "test", 500
    elif name.as_posix().startswith("engine/include/"):
        kind, limit = "public header", 300  # each is one page of the reference
    elif name.suffix == ".h":
        kind, limit = "header in C", 1500  # the whole interface, for other languages to read
    elif name.suffix == ".hpp":
        kind, limit = "header", 250
    else:
        kind, limit = "source", 400
    if len(lines) > limit:
        yield 1, f"{len(lines)} lines; a {kind} has at most {limit}"
    for number, line in enumerate(lines, 1):
        if len(line) > MAX_COLUMNS:
            yield number, f"{len(line)} columns; a line has at most {MAX_COLUMNS}"
    longest = 60 if name.as_posix().startswith(("engine/", "game/apart/core/")) else 80
    scanner = Scanner(text)
    scanner.scan()
    if name.parts[0] in ("engine", "game"):
        yield from check_classes(scanner)
    for first, count, function, parameters in functions_of(scanner):
        if count > longest:
            yield first, f"{function} has {count} lines; here a function has at most {longest}"
        if parameters > MAX_PARAMETERS:
            yield first, (
                f"{function} has {parameters} parameters;"
                f" more than {MAX_PARAMETERS} become a struct"
            )


def cpp_files():
    """Yields (path, path relative to the root of the repository) of every C++ and C file."""
    root = pathlib.Path(__file__).resolve().parent.parent
    for top in ("engine", "game", "tests", "tools"):
        for path in sorted((root / top).rglob("*.*")):
            if path.suffix in (".hpp", ".cpp", ".inl", ".h", ".c"):
                yield path, path.relative_to(root)


def run(what, check, description):
    """The main function of a check: prints the messages of check(path, name); true if there are
    any."""
    argparse.ArgumentParser(
        description=description, formatter_class=argparse.RawDescriptionHelpFormatter
    ).parse_args()
    files = list(cpp_files())
    bad = [
        f"{name}:{line}: {sentence}"
        for path, name in files
        for line, sentence in sorted(check(path, name))
    ]
    print("\n".join(bad) or f"{what}: ok, {len(files)} files")
    return bool(bad)


def code_lines(path):
    """The number of lines that are neither blank nor comment."""
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"/\*.*?\*/", lambda c: "\n" * c[0].count("\n"), text, flags=re.DOTALL)
    return sum(bool(re.sub(r"//.*", "", line).strip()) for line in text.splitlines())


def check_engine():
    """Prints the lines of code of the engine; true if they or those of a folder are too many."""
    folders, total = {}, 0
    for path, name in cpp_files():
        if name.parts[:2] in (("engine", "src"), ("engine", "include")):
            lines = code_lines(path)
            total += lines
            if name.parts[1] == "src" and len(name.parts) > 3:
                folders[name.parts[2]] = folders.get(name.parts[2], 0) + lines
    by_size = sorted(folders.items(), key=lambda item: -item[1])
    shares = ", ".join(f"{folder} {lines / total:.1%}" for folder, lines in by_size)
    print(f"lines of code of the engine: {total}; at most {MAX_ENGINE_LINES}: {shares}")
    large = [folder for folder, lines in by_size if lines > MAX_FOLDER_SHARE * total]
    for folder in large:
        print(f"engine/src/{folder}: has more than {MAX_FOLDER_SHARE:.0%} of the lines of code")
    if total > MAX_ENGINE_LINES:
        print(f"engine: has {total - MAX_ENGINE_LINES} lines of code too many")
    return bool(large) or total > MAX_ENGINE_LINES


if __name__ == "__main__":
    results = [run("sizes", check_file, __doc__), check_engine()]
    sys.exit(any(results))
