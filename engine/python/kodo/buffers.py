# SPDX-License-Identifier: MIT
"""Arrays that the library fills: of NumPy, if it is installed, else of the module array."""
from __future__ import annotations

import array
import ctypes
from typing import Any, Optional, Sequence, Tuple

from ._library import REAL_CODE, REAL_SIZE

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]


def new_array(shape: Tuple[int, ...]) -> Any:
    """An array of zeros: numpy.ndarray, or a memoryview with the same shape."""
    if numpy is not None:
        return numpy.zeros(shape, dtype=REAL_CODE)
    count = 1
    for size in shape:
        count *= size
    flat = memoryview(array.array(REAL_CODE, bytes(max(count, 1) * REAL_SIZE)))[:count]
    return flat.cast("B").cast(REAL_CODE, shape=shape) if count else flat


def _address(view: memoryview) -> ctypes.Array[ctypes.c_char]:
    return (ctypes.c_char * view.nbytes).from_buffer(view.cast("B"))


def writable(out: Optional[Any], shape: Tuple[int, ...]) -> Tuple[Any, Any]:
    """The array that a call fills, and its memory. An array of the caller needs the type of the
    library's numbers and as many of them; it is filled without a copy."""
    given: Any = new_array(shape) if out is None else out
    view = memoryview(given)
    _require(view, shape)
    if view.readonly:
        raise ValueError("out must be writable")
    return given, _address(view) if view.nbytes else None


def readable(values: Any, shape: Tuple[int, ...]) -> Any:
    """The memory of numbers to read: of an array of the right type, or a copy of a sequence."""
    try:
        view = memoryview(values)
    except TypeError:
        if numpy is not None:
            rows: Any = numpy.ascontiguousarray(values, dtype=REAL_CODE)
            view = memoryview(rows)
        else:
            view = memoryview(array.array(REAL_CODE, _flat(values)))
    _require(view, shape)
    if view.readonly:
        view = memoryview(bytearray(view.cast("B"))).cast(REAL_CODE)
    return _address(view) if view.nbytes else None


def _flat(values: Sequence[Any]) -> Any:
    if not isinstance(values, Sequence) or isinstance(values, str):
        raise TypeError(f"an array must hold numbers, but holds {values!r}")
    for value in values:
        if isinstance(value, (int, float)):
            yield value
        else:
            yield from _flat(value)


def _require(view: memoryview, shape: Tuple[int, ...]) -> None:
    count = 1
    for size in shape:
        count *= size
    if view.format != REAL_CODE or not view.c_contiguous or view.nbytes != count * REAL_SIZE:
        raise ValueError(
            f"an array must hold {' x '.join(map(str, shape))} numbers of the type"
            f" '{REAL_CODE}' without gaps, but has the type '{view.format}' and the shape"
            f" {view.shape}"
        )
