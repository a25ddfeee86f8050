"""Snapshots of runs and bare controllers: each return ends as the undisturbed run, to the last bit."""

from __future__ import annotations

import ast
from array import array
from collections import deque
from collections.abc import Callable, Collection, Iterator, Mapping
from functools import partial
from io import BytesIO, StringIO
from pathlib import Path
from random import Random
from types import CellType, FunctionType
from typing import Any

import pytest

from motionlang.kernel import (
    Controller,
    Hook,
    Machine,
    Scheduler,
    Source,
    Steps,
    Stuck,
    dialect_for,
    settings_next_to,
)
from motionlang.kernel.lang import Snapshot
from tests.golden.test_gallery import PROGRAMS

# Snapshots of a run, and its end if the program has none, s.
COUNT, UNTIL = 8, 120.0


class Observed:
    """A run in which snapshots are taken at statement numbers: the first round from each on."""

    def __init__(self, source: Source, settings: Mapping[str, object], at: list[int]) -> None:
        language = dialect_for(source, None)
        self.hook = Hook(lambda task, time, offset: None, between=self._between)
        self.machine = Machine(settings, first_axis=language.first_axis, hook=self.hook)
        parent = language.program(source, dict(settings), is_debug=True).start(self.machine)
        self.scheduler = self.machine.scheduler = Scheduler(
            self.machine.controller, parent, hook=self.machine.hook
        )
        self._left = at
        self.taken: list[tuple[int, Snapshot]] = []
        self._arm()

    def _arm(self) -> None:
        self.hook.round_at = self._left[0] if self._left else 1 << 62

    def _between(self) -> None:
        count = self.hook.count
        if count >= self.hook.round_at:
            self.taken.append((count, Snapshot(self.scheduler)))
            self._left = [each for each in self._left if each > count]
            self._arm()

    def finish(self) -> list[str]:
        """Run to the end; return everything that the run has recorded."""
        try:
            how = self.scheduler.run(UNTIL)
        except Stuck as stuck:
            how = str(stuck)
        machine = self.machine
        return [how, machine.terminal.begun, *map(repr, machine.diagnostics), *recorded(machine.controller)]


def recorded(controller: Controller) -> Iterator[str]:
    """Yield all that is in the log of a controller, to the last bit."""
    yield repr(controller.clock.now)
    for stream in controller.log.streams():
        for each in stream:
            if hasattr(each, "command"):
                curve = each.profile and each.profile.curve
                yield repr(
                    (each.axis, each.command, each.line, each.target, each.ended, each.start_time, curve)
                )
            else:
                yield repr(each)
    for a in (*controller.axes.values(), *controller.encoders.values()):
        track = a
        yield repr((list(track.starts), [profile.curve for profile in track.profiles]))
        yield repr(a.feedback and (a.feedback.position, a.feedback.changes))


def check(source: Source, settings: Mapping[str, object]) -> list[Snapshot]:
    """Go back to some snapshots of a run, the last one first."""
    plain = Observed(source, settings, [])
    expected, count = plain.finish(), plain.hook.count
    run = Observed(source, settings, [count * k // COUNT for k in range(COUNT)])
    assert run.finish() == expected
    assert run.taken
    for _, snapshot in reversed(run.taken):
        snapshot.restore()
        assert run.finish() == expected
    return [snapshot for _, snapshot in run.taken]


# Programs of which many snapshots are taken.
SLOW = ("old-grinder", "override-panel", "pick-cycle", "press-force")


def marked(paths: list[Path]) -> list[Any]:
    return [pytest.param(each, marks=pytest.mark.slow) if each.stem in SLOW else each for each in paths]


@pytest.mark.parametrize("path", marked(PROGRAMS), ids=lambda path: path.stem)
def test_a_program_of_the_gallery_ends_the_same_after_going_back(path: Path) -> None:
    check(Source.read(str(path)), settings_next_to(str(path)))


def test_a_run_goes_on_from_the_snapshot_at_which_its_time_was_up() -> None:
    """The task makes no round of the scheduler in a wait, but one at the end of the run."""
    source, settings = Source("dwell.mcl", "1MN,1MR1000,1WS,WA5,1MR-1000,1WS\n"), {"controller.axes": 1}
    expected, run = Observed(source, settings, []).finish(), Observed(source, settings, [])
    taken: list[Snapshot] = []

    def between() -> None:
        if run.machine.clock.now >= 3.0 and not taken:
            taken.append(Snapshot(run.scheduler))

    run.hook.between = between
    assert run.scheduler.run(3.0) == "until"
    for _ in range(2):
        taken[0].restore()
        assert run.machine.clock.now == 3.0
        assert run.finish() == expected


HANDSHAKE = """\
Dim n As Integer
For n = 1 To 20
  OUTX(1) = _ON
  PAUSE COMMS(1) = 5
  COMMS(1) = 0
  PAUSE INX(3)
  PAUSE Not INX(3)
  PAUSE INKEY = 82
  OUTX(1) = _OFF
  PAUSE MODBUSTCP16(4, 8) = n Mod 2
  PRINT n, " ", TIME
Next
"""


def test_what_answers_an_output_or_repeats_goes_back() -> None:
    settings = {
        "comms": [{"element": 1, "value": 5, "output": 1, "delay": 0.1}],
        "input": [{"channel": 3, "output": 1, "delay": 0.15, "for": 0.2}],
        "key": [{"text": "R", "at": 0.3, "every": 0.7}],
        "modbus.register": [
            {"server": 4, "register": 8, "value": value, "at": value, "every": 2.0} for value in (0, 1)
        ],
    }
    assert check(Source("handshake.mnt", HANDSHAKE), settings)


ASKED = """\
Dim n As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Run Other
For n = 1 To 10
  PAUSE INX(3)
  MOVER(0) = 5 : GO(0) : PAUSE IDLE(0)
  Repeat : WAIT = 20 : Until Not INX(3)
  While NETINTEGER(0) = 0 : End While
  NETINTEGER(0) = 0
  While INKEY <> 82 : End While
  PAUSE ADC(0) > 50
  While ADC(0) > 50 : End While
  PRINT n, " ", TIME
Next
Task Other
  Loop
    PAUSE INX(3) And INX(4)
    PAUSE Not INX(4)
  End Loop
End Task
"""


def test_what_answers_when_asked_goes_back() -> None:
    settings = {
        "input": [{"channel": 3, "asked": 0.15}, {"channel": 4, "asked": 0.2, "for": 0.3}],
        "key": [{"text": "R", "asked": 0.3}],
        "netdata": [{"element": 0, "value": 1, "asked": 0.1}],
        "analogue": [{"channel": 0, "value": 80.0, "asked": 0.1}],
    }
    assert check(Source("asked.mnt", ASKED), settings)


def test_an_entry_that_is_added_after_a_snapshot_goes_with_it() -> None:
    """Registers belong to a component of the program, which takes entries like the machine's own."""
    program = "PAUSE MODBUSTCP16(4, 8) = 3\nPAUSE INX(3)\nPRINT TIME\nWAIT(9000)\n"
    run, ends = Observed(Source("waits.mnt", program), {}, [0]), []
    run.finish()
    for delay in (0.5, 1.0):
        run.taken[0][1].restore()
        run.machine.add_entries(
            {
                "modbus.register": [{"server": 4, "register": 8, "value": 3, "at": 2 * delay}],
                "input": [{"channel": 3, "at": 3 * delay}],
            }
        )
        run.finish()
        ends.append(run.machine.terminal.lines)
    assert ends == [["1500"], ["3000"]]


PULSES = {"input": [{"channel": 1, "value": 1, "every": 0.01, "for": 0.004}]}
PROGRAMS_OF_STATE = {
    # Arguments of events: each pulse of an input schedules the next one.
    "pulses": ("WN1, WF1, RP50\n", PULSES),
    # Lists: points that are recorded while an axis moves.
    "points": ("1MN,1SV1000,1SA10000,1DS10000\n1PR50,1MR50,1WS,1DO3,1DR2,RP5\n", {}),
    # Sets and dicts: macros, tasks, what is defined and ended in the run.
    "tasks": ("MD1,AL5,AR10,WA0.01,RP20\nMD2,WA0.003,RP30\nGT1\nGT2\nWA0.1\nTR10\nMD1,NO\nMC1\n", {}),
    "registers": ("AL0,AR11\nRA11,AA1,AR11,WA0.001,RP99\n", {}),
}


@pytest.mark.parametrize("name", PROGRAMS_OF_STATE)
def test_small_programs_end_the_same_after_going_back(name: str) -> None:
    text, settings = PROGRAMS_OF_STATE[name]
    check(Source(f"{name}.mcl", text), settings)


def test_a_snapshot_does_not_grow_with_the_run() -> None:
    """Anything that grows is in the log, or cut to its length."""
    source = Source(
        "many.mcl", "1MN, 1SV1000000, 1SA1000000000, 1DS1000000000\n1MR1000, 1WS, 1MR-1000, 1WS, RP5100\n"
    )
    run = Observed(source, {"controller.axes": 2}, [500, 20_000, 20_100])
    run.finish()
    sizes = [snapshot.size for _, snapshot in run.taken]
    assert max(sizes) - min(sizes) <= 8
    assert len(run.machine.log.moves) > 10_000


class Whole(Snapshot):
    """A snapshot that includes steps and whatever only they reach; `owners` has the files of cells."""

    constant = ()

    def __init__(self, root: object) -> None:
        self.owners: dict[int, str] = {}
        super().__init__(root)

    def _held(self, x: Any, kind: type) -> Collection[Any]:
        if kind is FunctionType:
            self.owners |= {id(cell): Path(x.__code__.co_filename).name for cell in x.__closure__ or ()}
        return super()._held(x, kind)


def contents(snapshot: Snapshot) -> dict[int, tuple[object, str]]:
    """Return each object and its contents as text."""
    stored: list[Any] = snapshot._contents
    return {id(each.args[0]): (each.args[0], str(each.args[1])) for each in stored}


@pytest.mark.parametrize("path", marked(PROGRAMS[1::4]), ids=lambda path: path.stem)
def test_a_step_has_no_memory(path: Path) -> None:
    """What a run changes and only steps reach is the cache of a reader."""
    run = Observed(Source.read(str(path)), settings_next_to(str(path)), [])
    wholes: list[Whole] = []

    def between() -> None:
        if run.hook.count >= run.hook.round_at:
            wholes.append(Whole(run.scheduler))
            run.hook.round_at += 25

    run.hook.round_at, run.hook.between = 5, between
    run.finish()
    wholes.append(Whole(run.scheduler))
    assert len(wholes) > 1
    reached, last = contents(Snapshot(run.scheduler)), contents(wholes[-1])
    # What loops do with variables is worked out once.
    loops = {id(x.bodies) for x, _ in last.values() if isinstance(x, Steps)}
    for whole in wholes[:-1]:
        for key, (x, text) in contents(whole).items():
            if key in last and key not in reached and text != last[key][1]:
                assert isinstance(x, CellType | Steps) or key in loops, (x, text)
                assert not isinstance(x, CellType) or whole.owners[key] == "readers.py"


def test_only_caches_are_in_variables_of_functions() -> None:
    """A cache compares what it was read from, by identity, so a run can go back without it."""
    package = Path(__file__).parents[3] / "motionlang"
    found = {
        path.relative_to(package).as_posix()
        for name in ("controller", "lang", "log", "mccl", "mint", "planners", "servo")
        for path in (package / "kernel" / name).rglob("*.py")
        if "nonlocal" in (text := path.read_text(encoding="utf-8"))
        and any(isinstance(node, ast.Nonlocal) for node in ast.walk(ast.parse(text)))
    }
    assert found == {"kernel/controller/readers.py"}


# --------------------------------------------------------------------------------------------- bare controllers


def test_a_controller_in_motion_goes_back() -> None:
    controller = Controller(2)
    controller.configure(0, "speed", 10.0)
    seen: list[float] = []
    controller.move_to(0, 100.0)
    controller.clock.at(2.0, lambda: seen.append(controller.position(0)))
    controller.clock.advance(1.0)
    snapshot = Snapshot([controller, seen])
    ends = []
    for _ in range(3):
        controller.clock.advance(3.0)
        controller.stop(0)
        controller.clock.advance(50.0)
        ends.append((list(recorded(controller)), list(seen)))
        snapshot.restore()
        assert controller.clock.now == 1.0
        assert seen == []
    assert ends[0] == ends[1] == ends[2]


# -------------------------------------------------------------------------------------------------- contents


def counter() -> tuple[Callable[[], int], Callable[[], int]]:
    """Return a function that counts in a cell, and one that reads it."""
    count = 0

    def more() -> int:
        nonlocal count
        count += 1
        return count

    return more, lambda: count


def test_contents_are_put_back_into_the_same_objects() -> None:
    more, read = counter()
    text = StringIO()
    text.write("one")
    things = {
        "list": [1, [2]], "deque": deque([1, 2]), "set": {1, 2}, "array": array("d", [1.0, 2.0]),
        "text": text, "random": Random(1), "bytes": bytearray(b"ab"), "function": partial(more), "pair": (read, [3]),
    }  # fmt: skip
    snapshot = Snapshot(things)
    drawn = things["random"].random()  # type: ignore[attr-defined]
    inner, pair = things["list"][1], things["pair"][1]  # type: ignore[index]
    more()
    inner.append(9)
    pair.clear()
    things["list"].clear()  # type: ignore[attr-defined]
    things["deque"].popleft()  # type: ignore[attr-defined]
    things["set"].add(3)  # type: ignore[attr-defined]
    things["array"].append(3.0)  # type: ignore[attr-defined]
    text.write(" two")
    things["bytes"][0] = 0  # type: ignore[index]
    del things["function"]
    things["new"] = 1
    snapshot.restore()
    assert list(things) == ["list", "deque", "set", "array", "text", "random", "bytes", "function", "pair"]
    assert things["list"] == [1, [2]]
    assert things["list"][1] is inner
    assert (things["deque"], things["set"]) == (deque([1, 2]), {1, 2})
    assert (things["array"], things["bytes"]) == (array("d", [1.0, 2.0]), bytearray(b"ab"))
    assert text.getvalue() == "one"
    assert things["random"].random() == drawn  # type: ignore[attr-defined]
    assert (read(), pair) == (0, [3])


@pytest.mark.parametrize("thing", [iter([1]), (k for k in range(1)), BytesIO(), object()], ids=type)
def test_what_hides_its_state_is_refused(thing: object) -> None:
    with pytest.raises(TypeError, match=r"no snapshot can store a .*, held by list of dict$"):
        Snapshot({"holder": [thing]})
