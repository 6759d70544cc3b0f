# SPDX-License-Identifier: MIT
"""Many Worlds, stepped in one call: for training of agents."""
from __future__ import annotations

import ctypes
from ctypes import c_size_t
from typing import Any, List, Optional, Sequence

from . import _structs as c
from . import fields as _fields
from ._library import Real, call
from .buffers import readable, writable
from .errors import BadBodyId
from .values import to_array
from .world import BodyLike, ThreadPool, World, id_of


class Worlds:
    """Copies of one World. `bodies` names the bodies that are observed and moved; arrays are
    worlds x bodies x numbers, in this order.

    With a pool, each World of a step is a task for one thread; the bits are the same."""

    def __init__(self, world: World, count: int, bodies: Sequence[BodyLike],
                 pool: Optional[ThreadPool] = None) -> None:
        if count < 1:
            raise ValueError(f"count: must be at least 1, but is {count}")
        for body in bodies:
            if body not in world:
                raise BadBodyId(f"bodies: {body!r} is not in this World")
        self.start = world.copy()  #: what reset() goes back to
        self.worlds: List[World] = [world.copy() for _ in range(count)]
        self.pool = pool
        self._ids = to_array(c.BodyId, [id_of(body) for body in bodies])
        self._handles = (ctypes.c_void_p * count)(*(each.handle for each in self.worlds))

    def __len__(self) -> int:
        return len(self.worlds)

    def __getitem__(self, index: int) -> World:
        return self.worlds[index]

    def step(self, dt: float, count: int = 1) -> None:
        """Advances each World by `count` steps of dt (s). An error is that of the first World in
        the list; the others have advanced."""
        pool = None if self.pool is None else self.pool.handle
        for _ in range(count):
            call("kodo_stepWorlds", self._handles, c_size_t(len(self)), Real(dt), pool)
            _fields.raise_errors()

    def reset(self, index: int, to: Optional[World] = None) -> None:
        """Makes one World equal to `start`, or to another World."""
        self.worlds[index].assign(self.start if to is None else to)

    def poses(self, out: Optional[Any] = None) -> Any:
        """x, y (m), cosine and sine of the angle: worlds x bodies x 4. `out` is filled without a
        copy, as in World.poses()."""
        return self._read("kodo_poses", 4, out)

    def velocities(self, out: Optional[Any] = None) -> Any:
        """x and y of the velocity (m/s), angular velocity (rad/s): worlds x bodies x 3."""
        return self._read("kodo_velocities", 3, out)

    def apply_loads(self, loads: Any) -> None:
        """x and y of a force (N) and a torque (N m) in the next step: worlds x bodies x 3."""
        self._call("kodo_applyLoads", readable(loads, (len(self), len(self._ids), 3)))

    def set_velocities(self, velocities: Any) -> None:
        """x and y of the velocity (m/s), angular velocity (rad/s): worlds x bodies x 3."""
        self._call("kodo_setVelocities", readable(velocities, (len(self), len(self._ids), 3)))

    def _read(self, name: str, width: int, out: Optional[Any]) -> Any:
        made, memory = writable(out, (len(self), len(self._ids), width))
        self._call(name, memory)
        return made

    def _call(self, name: str, memory: Any) -> None:
        if memory is not None:
            call(name, self._handles, c_size_t(len(self)), self._ids, c_size_t(len(self._ids)),
                 memory)
