"""What a master on the bus sees: the modes of operation in `modes.txt`, frames in `frames.txt`.

`== title` begins a session, `; ` a comment with the figures by hand. A line is what the master does, and behind `->`
what it sees: the position that is read at a time, a word of status, a code of refusal, an answer, frames. Speeds are
written in 0.1 counts/s and rates in 10 counts/s². At power-up they are 10 000 counts/s and 100 000 counts/s², so a ramp
takes 0.1 s and 500 counts. `pytest --update` rewrites what is seen.
"""

from __future__ import annotations

from itertools import groupby
from pathlib import Path

from motionlang_copley.switches import Switches
from test_copley.bus import Bus, Master, SdoAbort
from tests.cases import repeat, sessions

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
    if verb == "points":
        entries = axis.drive.buffer.entries
        shown = [
            f"{e.position} {'-' if e.velocity is None else e.velocity} {e.microseconds}" for e in entries
        ]
        return "; ".join(shown)
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


def on_the_bus(bus: Bus, words: list[str]) -> str | None:
    """Do the same with frames: `send` of an identifier and bytes, `ask` of a node by SDO, `until` a time."""
    verb, *rest = words
    if verb == "send":
        bus.send(int(rest[0], 16), *(int(each, 16) for each in rest[1:]))
    elif verb == "ask":
        return bus.ask(int(rest[0]), *(int(each, 16) for each in rest[1:])).hex(" ")
    elif verb == "time":
        bus.time = float(rest[0])
    elif verb == "complaints":
        return "; ".join(bus.complaints)
    elif verb in ("until", "frames"):
        frames = [f"{can_id:03x}:{data.hex()}" for can_id, data in getattr(bus, verb)(*map(float, rest))]
        counts = [(frame, len(list(same))) for frame, same in groupby(frames)]
        return " ".join(frame + f"×{count}" * (count > 1) for frame, count in counts)
    else:
        raise ValueError(verb)
    return None


def switches(text: str) -> Switches:
    """Return the switches of a text such as `negative=-2000,home=800`."""
    pairs = (each.split("=") for each in text.split(","))
    return Switches(**{name: float(place) for name, place in pairs})


def replayed(session: str) -> str:
    """Return a session with what its master sees now."""
    bus: Bus | None = None
    shown = []
    for line in session.splitlines():
        verb, *rest = line.partition(" ->")[0].split()
        seen = None
        if verb in ("on", "bus"):
            if bus is not None:
                bus.close()
            places = [switches(each) for each in rest if "=" in each and not each.startswith("factor")]
            if verb == "on":
                mode = rest[0] if rest and "=" not in rest[0] else ""
                bus = Master(MODES[mode], places[0] if places else None)
            else:
                factor = next((float(each[7:]) for each in rest if each.startswith("factor")), 1.0)
                bus = Bus(factor, places)
        elif isinstance(bus, Master):
            seen = done(bus, [verb, *rest])
        elif bus is not None:
            seen = on_the_bus(bus, [verb, *rest])
        shown.append(line if seen is None else f"{line.partition(' ->')[0]} -> {seen}".rstrip())
    if bus is not None:
        bus.close()
        assert isinstance(bus, Master) or bus.complaints == [] or "complaints" in session
    return "\n".join(shown) + "\n"


@sessions(*sorted(Path(__file__).parent.glob("*.txt")))
def test_a_master_sees_what_is_written(path: Path, session: str, update: bool) -> None:
    repeat(path, session, replayed, update)
