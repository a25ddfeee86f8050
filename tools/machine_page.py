"""Writer of the tables of docs/machine-file.md."""

from __future__ import annotations

from pathlib import Path

from motionlang.kernel.lang.machine.keys import KEYS, REQUIRED, TABLES
from motionlang.kernel.servo.settings import PLANT as PLANT_KEYS
from motionlang.kernel.servo.settings import SERVO as SERVO_KEYS
from motionlang.kernel.servo.settings import Key

PAGE = Path(__file__).parent.parent / "docs" / "machine-file.md"
FROM = "## Keys\n"
SENTENCES = {
    "input": "Digital inputs: set by time, by the position of an axis, or by an output. Several entries may set the "
    "same channel.",
    "analogue": "Analogue inputs: set by time or by the position of an axis.",
    "remote": "Remote nodes on a bus: their inputs and state. A node "
    "without an entry is live and holds zeros.",
    "bus": "The state of a bus, for `BUSEVENT`. While it is off, no node answers.",
    "modbus.server": "Modbus servers that the program uses as a client, with keywords such as `MODBUSTCP16`. If the "
    "file names none, every server exists and holds zeros, and the report says so.",
    "modbus.register": "Changes of registers of a Modbus server. Of two registers, the lower one has the lower half.",
    "encoder": "Encoders that something outside the controller turns, such as a conveyor that a program follows.",
    "fault": "Faults of an axis, of its drive or of the controller: at a time, at a position, or when the program "
    "reaches a line for the first time. The program chooses how the axis reacts (`FOLERRORMODE`, `ERRORINPUTMODE`, "
    "`LIMITMODE`); a drive that faults switches off.",
    "key": "Keys that the operator presses.",
    "answer": "Lines that the operator types, one for each `INPUT`.",
    "comms": "Values that the host writes into the comms array of a Mint controller; they raise the events of the "
    "elements.",
    "netdata": "Values that the host writes into NetData; they raise the events of the elements.",
    "expect": "Expectations that `motionlang verify` checks after the run, in the machine file and in scenarios "
    "([scenarios.md](scenarios.md)). Each entry expects one thing.",
}

SERVO = {
    "plant": (
        "The motor of an axis. With any key of this section, the position of the axis is that of its motor: "
        "[servo.md](servo.md#a-run-with-motors).",
        PLANT_KEYS,
    ),
    "servo": ("The servo loop of that motor. Gains that the program sets take precedence.", SERVO_KEYS),
}


def written() -> str:
    """Return the page as it has to be: its handwritten text, and the tables."""
    text = PAGE.read_text(encoding="utf-8")
    sections = [text.partition(FROM)[0] + FROM, _table({key: help for key, (_, help) in KEYS.items()})]
    sections.append("`N` is the number of an axis as the language numbers it.\n")
    for section, (sentence, keys) in SERVO.items():
        sections.append(f"## `[axis.N.{section}]`\n\n{sentence}\n\n{_servo_table(keys)}")
    for name, rows in TABLES.items():
        needed = REQUIRED[name]
        shown = {key: help + (" Required." if key in needed else "") for key, (_, help) in rows.items()}
        sections.append(f"## `[[{name}]]`\n\n{SENTENCES[name]}\n\n{_table(shown)}")
    return "\n".join(sections)


def _servo_table(keys: dict[str, Key]) -> str:
    rows = {}
    for name, key in keys.items():
        default = str(key.default).lower() if key.kind == "flag" else f"{key.default}"
        rows[name] = f"{key.help} Default {default}."
    return _table(rows)


def _table(rows: dict[str, str]) -> str:
    return "".join(["| key | |\n|---|---|\n", *(f"| `{key}` | {help} |\n" for key, help in rows.items())])


def files() -> dict[Path, str]:
    return {PAGE: written()}
