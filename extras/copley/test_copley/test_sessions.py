"""Profile position, profile velocity and homing, as a master on the bus sees them: `sessions.txt`.

`== title` begins a session with one drive, `; ` a comment with the figures by hand. A line is what the master does, and
behind `->` what it sees: the position that is read at a time, a word of status, a code of refusal. Speeds are written
in 0.1 counts/s and rates in 10 counts/s². At power-up they are 10 000 counts/s and 100 000 counts/s², so a ramp takes
0.1 s and 500 counts. `pytest --update` rewrites what is seen.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang_copley.switches import Switches
from test_copley.bus import Master, SdoAbort

FILE = Path(__file__).with_name("sessions.txt")
MODES = {"": 0, "PP": 1, "PV": 3, "HM": 6}
OBJECTS = {
    "CONTROL": 0x6040, "STATUS": 0x6041, "MODE": 0x6060, "POSITION": 0x6064, "VELOCITY": 0x606C, "TARGET": 0x607A,
    "SPEED": 0x6081, "ACCEL": 0x6083, "DECEL": 0x6084, "TARGET_VELOCITY": 0x60FF, "METHOD": 0x6098,
    "HOMING_ACCEL": 0x609A, "HOME_OFFSET": 0x607C, "QUICK_STOP": 0x605A,
}  # fmt: skip
STATES = {
    0x40: "disabled", 0x21: "ready", 0x23: "on", 0x27: "enabled", 0x07: "stopping", 0x08: "fault", 0x0F: "faulting",
}  # fmt: skip
BITS = {0x0400: "reached", 0x0800: "limit", 0x1000: "bit 12", 0x2000: "bit 13"}


def done(axis: Master, words: list[str]) -> str | None:
    """Do what the words of a line say, and return what is seen."""
    verb, *rest = words
    if verb == "at":
        return str(axis.at(float(rest[0])))
    if verb in ("write", "read"):
        name, _, sub = rest[0].partition(":")
        index = OBJECTS[name] if name in OBJECTS else int(name, 0)
        if verb == "read":
            return str(axis.read(index, int(sub or 0)))
        try:
            axis.write(index, MODES[rest[1]] if rest[1] in MODES else int(rest[1]), int(sub or 0))
        except SdoAbort as refused:
            return f"abort 0x{refused.args[0]:08X}"
        return None
    if verb == "status":
        word = axis.read(OBJECTS["STATUS"])
        state = next(name for bits, name in STATES.items() if word & (0x6F if bits & 0x20 else 0x4F) == bits)
        assert word & ~(0x6F | sum(BITS)) == 0x0210  # there is voltage, and the drive is remote
        return ", ".join([state, *(name for bit, name in BITS.items() if word & bit)])
    if verb == "drive":
        value = getattr(axis.drive, rest[0])
        return value if isinstance(value, str) else f"{value + 0.0:.7g}"
    if verb == "move":
        axis.move(*(int(each, 0) for each in rest))
    elif verb == "control":
        axis.write(OBJECTS["CONTROL"], int(rest[0], 0))
    elif verb == "datum":
        axis.drive.shift(-float(rest[0]))
        axis.drive.datum = 0.0
    elif verb == "trip":
        axis.node.objects.trip(int(rest[0], 0))
    elif verb == "send":
        axis.send(*map(int, rest))
    elif verb == "errors":
        return " ".join(f"0x{code:04X}" for code in axis.errors)
    elif verb == "complaints":
        return "; ".join(axis.complaints)
    else:
        raise ValueError(verb)
    return None


def replayed(session: str) -> str:
    """Return a session with what its master sees now."""
    axis, shown = None, []
    for line in session.splitlines():
        words = line.partition(" ->")[0].split()
        seen = None
        if words and words[0] == "on":
            mode, *places = [each for each in words[1:] if "=" not in each] or [""]
            if axis is not None:
                axis.close()
            given = dict(each.split("=") for each in words[1:] if "=" in each)
            axis = Master(MODES[mode], Switches(**{name: float(place) for name, place in given.items()}))
        elif axis is not None:
            seen = done(axis, words)
        shown.append(line if seen is None else f"{line.partition(' ->')[0]} -> {seen}".rstrip())
    if axis is not None:
        axis.close()
    return "\n".join(shown) + "\n"


SESSIONS = [part for part in re.split("^(?===)", FILE.read_text("utf-8"), flags=re.MULTILINE) if part]


@pytest.mark.parametrize("session", SESSIONS, ids=lambda each: each.partition("\n")[0][3:])
def test_a_master_sees_what_is_written(
    session: str, update: bool, golden: Callable[[Path, str], None]
) -> None:
    if update:
        golden(FILE, "".join(map(replayed, SESSIONS)))
    else:
        assert replayed(session) == session
