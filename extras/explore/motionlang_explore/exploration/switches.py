"""The switches of axes that home for ever, and encoders that something turns: what leaves no choice.

The home switch is put a second ahead of the axis, and then index marks on its encoder. An encoder that a task waits
for, or that the program reads and that is none of an axis that it commands, turns from power-up on.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from math import inf

from motionlang.kernel import Run
from motionlang.kernel.controller import AUXILIARY
from motionlang_explore.identification import Entry

# The home switch lies so many seconds of homing ahead, and a tenth of that is its length.
HOME_AHEAD = 1.0
SWITCHES = ("home_switch", "index_every")
# The speed of an encoder that something turns, counts/s.
TURNING = 1000.0


class FoundSwitches:
    """The switches that were put where an axis looked for them, by axis and key, and the encoders that turn.

    Settings of the keys that are given stay as they are.
    """

    def __init__(self, given: Collection[str]) -> None:
        self._given = given
        self.axes: dict[int, dict[str, object]] = {}
        self.encoders: list[Entry] = []

    @property
    def settings(self) -> dict[str, object]:
        """The settings of a machine file with the switches."""
        put = {f"axis.{axis}.{key}": value for axis, keys in self.axes.items() for key, value in keys.items()}
        return {**put, **({"encoder": self.encoders} if self.encoders else {})}

    def add_for_homing(self, result: Run) -> bool:
        """Put a switch where an axis of a run homes for ever, until the program gives up; False if none does."""
        homing = [
            number
            for number, axis in result.controller.axes.items()
            if axis.homing is not None and axis.homing.endless_motion
        ]
        put = [self._put(number, result, SWITCHES) for number in homing]
        return any(put)

    def add(self, result: Run) -> bool:
        """Put a switch where an axis of a run homes or waits for one that never comes; False if none does."""
        added = [self.add_for_homing(result)]
        scheduler = result.machine.scheduler
        for task in scheduler.tasks if scheduler is not None and not any(added) else ():
            wait = scheduler.wait_of(task)  # type: ignore[union-attr]  # it has tasks
            if task.done or wait is None or wait.due() < inf:
                continue
            for key in result.dialect.driven_by(wait.why):
                if key == "encoder":
                    added.append(self.turn(_read_at(result, task.at)))
                if key.startswith("axis."):
                    _, number, setting = key.split(".")
                    added.append(self._put(int(number), result, (setting,)))
        return any(added)

    def turn(self, channels: Iterable[int]) -> bool:
        """Turn some encoders; False if they turn."""
        new: list[Entry] = [{**encoder_entry(each), "velocity": TURNING} for each in sorted(channels)]
        new = [each for each in new if each not in self.encoders and "encoder" not in self._given]
        self.encoders = [*self.encoders, *new]
        return bool(new)

    def _put(self, number: int, result: Run, wanted: tuple[str, ...]) -> bool:
        """Put the first missing one of the wanted switches; False if the axis is at rest or has them."""
        axis = result.controller.axes[number]
        velocity = axis.profiles[-1].end_velocity / axis.scale.counts if axis.profiles else 0.0
        if not velocity:
            return False
        keys = self.axes.get(number, {})
        left = [each for each in wanted if each not in keys and f"axis.{number}.{each}" not in self._given]
        ahead = velocity * HOME_AHEAD
        if left:
            self.axes[number] = keys
        if "home_switch" in left:
            low, high = sorted((_rounded(ahead), _rounded(1.1 * ahead)))
            keys["home_switch"] = [low, high]
            return True
        if "index_every" in left:
            keys["index_every"] = _rounded(abs(ahead) / 5)
            return True
        return False


def _read_at(result: Run, at: int) -> list[int]:
    """Return the encoders that the wait at a source offset reads."""
    assert result.program is not None
    found = result.program.structure.waits.at(at)
    read = [number or 0 for kind, number in (found.leaves if found else ()) if kind == "encoder"]
    used = result.controller.encoders
    return [AUXILIARY + each if AUXILIARY + each in used else each for each in read]


def encoder_entry(channel: int) -> Entry:
    """Return the keys of an entry that name an encoder of the controller."""
    return {"aux": channel - AUXILIARY} if channel >= AUXILIARY else {"channel": channel}


def _rounded(value: float) -> float:
    """Return a figure with two significant digits, as a person would guess it."""
    return float(f"{value:.2g}")
