"""Settings of axes, stored by keyword and axis: read, write, reset by DEFAULT."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeVar

from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.controller.scale import Scale
from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.runtime.binding import Maker, Operation, scale_of, to_each_axis
from motionlang.kernel.mint.runtime.environment import Environment

Value = TypeVar("Value")


class StoredSettings:
    """The settings that a program has written, by keyword and axis.

    A setting that was not written has its value in `defaults`; a keyword that is not in `defaults` has the value
    `otherwise`. If a family is `in_counts`, settings in user units are stored in counts. If it is `unsigned`, they
    are stored without their sign.
    """

    defaults: Mapping[str, float] = {}
    otherwise = 0.0
    in_counts = unsigned = False

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        self._settings: dict[tuple[str, int], float] = {}

    @property
    def controller(self) -> Controller:
        return self.environment.controller

    def setting(self, name: str, axis: int) -> float:
        return self._settings.get((name, axis), self.defaults.get(name, self.otherwise))

    def set(self, name: str, axis: int, value: float) -> None:
        self._settings[name, axis] = value

    def scale(self, axis: int) -> Scale:
        return self.controller.axes[axis].scale

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        forget(self._settings, axis)


def setting_reader(kind: type[StoredSettings]) -> Maker:
    """Make an operation that reads a setting of a family in the unit of its keyword.

    The value is an int if the keyword is of type Integer.
    """

    def bound(environment: Environment, row: Keyword) -> Callable[[int], Operation]:
        settings, name, whole = environment.component(kind), row.name, row.is_whole
        unit = row.unit if settings.in_counts else ""

        def to_axis(axis: int) -> Operation:
            scale = scale_of(environment, axis)

            def read() -> float:
                value = scale.to_user(settings.setting(name, axis), unit)
                return int(value) if whole else value

            return read

        return to_axis

    return to_each_axis(bound)


def setting_writer(kind: type[StoredSettings]) -> Maker:
    """Make an operation that writes a setting of a family."""

    def bound(environment: Environment, row: Keyword) -> Callable[[int], Operation]:
        settings, name = environment.component(kind), row.name
        unit = row.unit if settings.in_counts else ""

        def to_axis(axis: int) -> Operation:
            scale = scale_of(environment, axis)

            def write(value: float) -> None:
                value = scale.to_counts(value, unit)
                settings.set(name, axis, abs(value) if settings.unsigned else value)

            return write

        return to_axis

    return to_each_axis(bound)


def forget(settings: dict[tuple[str, int], Value], axis: int) -> None:
    """Discard all settings of an axis."""
    for key in [key for key in settings if key[1] == axis]:
        del settings[key]
