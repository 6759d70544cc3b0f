# SPDX-License-Identifier: MIT
"""Finds and loads the C interface, and calls it."""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import pathlib
import re
import sys

from .errors import ERRORS, OtherError


def _candidates() -> list[str]:
    """Names to try: KODO_LIBRARY, the folder of this module, lib/ of the installed tree that has it
    as lib/python3/dist-packages/kodo, then what the system finds."""
    if given := os.environ.get("KODO_LIBRARY"):
        return [given]
    suffix = {"win32": "dll", "darwin": "dylib"}.get(sys.platform, "so")
    here = pathlib.Path(__file__).resolve().parent
    found = [
        str(path)
        for folder in (here, *here.parents[2:3])
        for path in sorted(folder.glob(f"*kodo_c.*{suffix}*") if folder.is_dir() else ())
    ]
    names = (ctypes.util.find_library("kodo_c"), f"libkodo_c.{suffix}")
    return found + [name for name in names if name]


def _load() -> ctypes.CDLL:
    sentences = []
    for name in _candidates():
        try:
            return ctypes.CDLL(name)
        except OSError as error:
            sentences.append(str(error))
    raise ImportError(
        "the library kodo_c was not found: set KODO_LIBRARY to its file, put it beside the module"
        " kodo, or install it. Tried: " + "; ".join(sentences)
    )


library = _load()
library.kodo_errorText.restype = ctypes.c_char_p
library.kodo_version.restype = ctypes.c_uint32
library.kodo_realSize.restype = ctypes.c_uint32

#: Number of bytes of a number of the library: 4 (kodo_c) or 8 (kodo_c64).
REAL_SIZE: int = library.kodo_realSize()
#: The type of a number: ctypes.c_float or ctypes.c_double.
Real = ctypes.c_float if REAL_SIZE == 4 else ctypes.c_double
#: Type code of a number for the modules array and struct, and for NumPy.
REAL_CODE: str = "f" if REAL_SIZE == 4 else "d"


_ADVICE = {"use Rot::from_angle(radians); ": "", ": use normalize()": ": divide it by its length"}
_CONSTANT = re.compile(r"\bk(?=[A-Z])(\w+)")
_NAME = re.compile(r"\b[a-z]+(?:[A-Z][a-z]*)+\b")
_HUMP = re.compile(r"(?<=[a-z])(?=[A-Z])")


def in_python(sentence: str) -> str:
    """A sentence of the engine with its names as this module writes them: motor_speed, LOCK_MOVE."""
    sentence = _CONSTANT.sub(lambda k: _HUMP.sub("_", k[1]).upper(), sentence)
    sentence = _NAME.sub(lambda name: _HUMP.sub("_", name[0]).lower(), sentence)
    for cpp, python in _ADVICE.items():
        sentence = sentence.replace(cpp, python)
    return sentence.replace("::", ".")


def check(status: int) -> None:
    """Raises the exception of a status, with the sentence of the library."""
    if status != 0:
        text = in_python(library.kodo_errorText().decode("utf-8", "replace"))
        raise ERRORS.get(status, OtherError)(text)


def call(name: str, *arguments: object) -> None:
    """Calls a function of the library. Its status becomes an exception."""
    check(getattr(library, name)(*arguments))
