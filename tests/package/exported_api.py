# SPDX-License-Identifier: MIT
"""Compares what a shared library exports with what the public headers declare."""
import json
import pathlib
import re
import subprocess

FUNCTIONS = (
    "FunctionDecl CXXMethodDecl CXXConstructorDecl CXXDestructorDecl CXXConversionDecl".split()
)
ELSEWHERE = ("isImplicit", "pure", "explicitlyDeleted", "explicitlyDefaulted")


def has_body(function):
    return any(below.get("kind") == "CompoundStmt" for below in function.get("inner", []))


class Declared:
    """What clang's syntax tree of the headers declares in namespace kodo."""

    def __init__(self):
        self.functions = set()  # mangled names; the body is in the library
        self.templates = set()  # qualified names of function templates; likewise
        self.classes = set()  # qualified names

    def walk(self, node, scope=""):
        kind, name, inner = node.get("kind"), node.get("name"), node.get("inner", [])
        qualified = f"{scope}::{name}" if scope else name
        if kind == "FunctionTemplateDecl":
            if not any(has_body(below) for below in inner):
                self.templates.add(qualified)
        elif kind in FUNCTIONS:
            if not has_body(node) and not any(word in node for word in ELSEWHERE):
                self.functions.add(node["mangledName"])
        elif kind in ("NamespaceDecl", "CXXRecordDecl") and name:
            if kind == "CXXRecordDecl":
                self.classes.add(qualified)
            for below in inner:
                self.walk(below, qualified)


def declared(include, definitions, work):
    source = work / "api.cpp"
    headers = sorted(pathlib.Path(include).glob("kodo/*.hpp"))
    source.write_text("".join(f"#include <kodo/{header.name}>\n" for header in headers))
    command = ["clang++", "-std=c++20", "-fsyntax-only", f"-I{include}", *definitions]
    command += ["-Xclang", "-ast-dump=json", "-Xclang", "-ast-dump-filter=kodo", str(source)]
    dump = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    result, at = Declared(), 0
    while match := re.compile(r"\s*(?=\S)").match(dump, at):
        node, at = json.JSONDecoder().raw_decode(dump, match.end())
        result.walk(node)
    return result


def demangled(names):
    text = "\n".join(sorted(names))
    done = subprocess.run(["c++filt"], input=text, capture_output=True, text=True, check=True)
    return set(done.stdout.splitlines())


def belongs(symbol, api):
    """Typeinfo, vtables and private parts of public classes; instances of public templates."""
    about = re.fullmatch(r"(?:typeinfo|typeinfo name|vtable) for (.*)", symbol)
    if about:
        return about.group(1) in api.classes
    instance = re.match(r"[^(]* (kodo::\w+::\w+)<", symbol)
    if instance:
        return instance.group(1) in api.templates
    member = re.match(r"((?:\w+::)+)~?\w+\(", symbol)
    return bool(member) and member.group(1).removesuffix("::") in api.classes


def differences(library, include, definitions, work):
    """Sentences; none if the library exports the public API alone, and all of it."""
    api = declared(include, definitions, work)
    functions = demangled(api.functions)
    command = ["nm", "-DC", "--defined-only", str(library)]
    lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    exported = {line.split(" ", 2)[2] for line in lines}
    if len(functions) < 100:
        yield f"only {len(functions)} functions were found in the headers"
    for name in sorted(functions - exported):
        yield f"{library.name} does not export {name}"
    instances = [f"{name}<{real}>" for name in api.templates for real in ("float", "double")]
    for name in sorted(instances):
        if not any(f" {name}(" in symbol for symbol in exported):
            yield f"{library.name} does not export {name}"
    for name in sorted(exported - functions):
        if not belongs(name, api):
            yield f"{library.name} exports {name}"
