# SPDX-License-Identifier: MIT
"""Settings of a World."""
from __future__ import annotations

import dataclasses
import enum
from typing import Any, List, Union

from . import _structs as c


class Feature(enum.IntFlag):
    """Features that a step can leave out."""

    FRICTION = 1
    ROLLING_RESISTANCE = 2
    RESTITUTION = 4
    CONTINUOUS_COLLISION = 8  #: without it fast bodies can tunnel
    RECORDS = 16  #: World.collisions()
    SLEEP = 32
    ROTATION = 64
    COLLISION = 128  #: without it nothing touches, and queries visit all parts


@dataclasses.dataclass
class SoftSettings:
    """Substeps of soft contacts."""

    substeps: int  #: 1 to 64
    impact_passes: int  #: 0 to 1000
    contact_hertz: float  #: > 0, up to 1e9
    contact_damping: float  #: > 0, up to 1e6; 1 is critical
    joint_hertz: float  #: > 0, up to 1e9
    joint_damping: float  #: > 0, up to 1e6
    push_speed: float  #: > 0, up to 1e7; length units/s
    joint_gap: float  #: 1e-4 to 1e4; share of the smaller body's size


@dataclasses.dataclass
class PropagationSettings:
    """The solver of the thesis, with shock propagation."""

    substeps: int  #: 1 to 64
    impact_passes: int  #: 0 to 1000
    contact_passes: int  #: 1 to 1000
    shock_passes: int  #: 0 to 1000; 0: no shock propagation
    joint_hertz: float
    joint_damping: float
    push_speed: float


@dataclasses.dataclass
class Settings:
    """How a World steps. fast(), balanced(), accurate() and thesis2006() make them."""

    solver: Union[SoftSettings, PropagationSettings]
    sleep_steps: int = 30  #: 1 to 1000000; calm steps before an island falls asleep
    leave_out: int = 0  #: of Feature


def _values(struct: Any) -> List[Any]:
    return [getattr(struct, name) for name, _ in struct._fields_]


def from_settings(made: c.Settings) -> Settings:
    solver: Union[SoftSettings, PropagationSettings]
    if made.solver == 0:
        solver = SoftSettings(*_values(made.soft))
    else:
        solver = PropagationSettings(*_values(made.propagation))
    return Settings(solver, made.sleepSteps, made.leaveOut)


def to_settings(settings: Settings) -> c.Settings:
    made = c.initialised(c.Settings, 1)
    numbers = dataclasses.astuple(settings.solver)
    if isinstance(settings.solver, SoftSettings):
        made.solver, made.soft = 0, c.SoftSettings(*numbers)
    else:
        made.solver, made.propagation = 1, c.PropagationSettings(*numbers)
    made.sleepSteps = settings.sleep_steps
    made.leaveOut = int(settings.leave_out)
    return made


def _profile(number: int) -> Settings:
    return from_settings(c.initialised(c.Settings, number))


def fast() -> Settings:
    """For many bodies without close inspection."""
    return _profile(0)


def balanced() -> Settings:
    """The defaults: for a game, as a rule."""
    return _profile(1)


def accurate() -> Settings:
    """For measurements, nets under load, and columns under a thousandfold weight."""
    return _profile(2)


def thesis2006() -> Settings:
    """The solver of the thesis."""
    return _profile(3)
