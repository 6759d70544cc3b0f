# SPDX-License-Identifier: MIT
"""Exceptions: one for each status of the C interface, with the sentence of the engine."""
from __future__ import annotations


class KodoError(Exception):
    """Any error of the engine. Nothing has changed, unless the documentation of a call says so."""


class BadDefinition(KodoError, ValueError):
    """A value that cannot be used, or an unknown joint."""


class BadBodyId(KodoError, LookupError):
    """An unknown body: removed, never added, or of another World."""


class BadSnapshot(KodoError, ValueError):
    """Bytes that are no snapshot, or not of this library."""


class WrongUse(KodoError, RuntimeError):
    """A change within a step, a pool in use, a World twice in a list."""


class NoMemory(KodoError, MemoryError):
    """The memory is exhausted. The World of the call may only be deleted or assigned to."""


class OtherError(KodoError, RuntimeError):
    """No threads are left."""


#: Status of the C interface: exception.
ERRORS: dict[int, type[KodoError]] = {
    1: BadDefinition,
    2: BadBodyId,
    3: BadSnapshot,
    4: WrongUse,
    5: NoMemory,
    6: OtherError,
}
