"""Writes the tables of docs/machine-file.md from the vocabulary of the machine file: `python -m tests.machine_page`."""

from __future__ import annotations

from pathlib import Path

from motionlang.lang.machine.keys import KEYS, REQUIRED, TABLES
from motionlang.servo.settings import PLANT as PLANT_KEYS
from motionlang.servo.settings import SERVO as SERVO_KEYS
from motionlang.servo.settings import Key

PAGE = Path(__file__).parent.parent / "docs" / "machine-file.md"
FROM = "## Keys\n"
SENTENCES = {
    "input": "Digital inputs: by time, by the position of an axis, or behind an output. One entry is one way in "
    "which the channel is set; several may speak of the same one.",
    "analogue": "Analogue inputs, likewise.",
    "remote": "Remote nodes on a bus: their inputs, encoders and comms arrays, the objects of their dictionaries, and "
    "whether they live. A node that no entry speaks of lives and holds zeros.",
    "bus": "What becomes of a bus, for `BUSEVENT` and `BUSSTATE`; while it is off no node answers.",
    "pdo": "Process data that nodes send, for `REMOTEPDOIN`.",
    "modbus.server": "Modbus servers that the program reaches as a client, with `MODBUSTCP16` and its like. Where the "
    "file names none, every server exists and holds zeros; the report says so.",
    "modbus.register": "What changes in their registers. Of two registers the lower one has the lower half.",
    "coil": "What a Modbus client writes into the coils of the controller.",
    "encoder": "Encoders that something outside of the controller turns, such as the conveyor that a program follows.",
    "fault": "Faults of an axis, of its drive or of the controller: at a time, at a position, or when the program "
    "comes to a line for the first time. What the axis then does is the program's choice (`FOLERRORMODE`, "
    "`ERRORINPUTMODE`, `LIMITMODE`); a drive goes off.",
    "key": "Keys that the operator presses.",
    "answer": "Lines that the operator types, one for each `INPUT`.",
    "serial": "What comes in at serial ports, for `SERIALCHAR` and the event `SERIALRECEIVE`.",
    "comms": "What the host writes into the comms array of a Mint controller; it raises the events of the elements.",
    "dpr": "The same for the dual-port RAM of a controller on a PC's bus; it raises nothing.",
    "netdata": "The same for NetData.",
    "expect": "What `motionlang verify` expects of the run, in the machine file and in scenarios "
    "([scenarios.md](scenarios.md)); each entry expects one thing.",
}

SERVO = {
    "plant": (
        "The motor of an axis. With one key of it the axis is where its motor is: "
        "[servo.md](servo.md#a-run-with-motors).",
        PLANT_KEYS,
    ),
    "servo": ("The loop of that motor, as far as the program's own gains do not say otherwise.", SERVO_KEYS),
}


def written() -> str:
    """The page as it must be: what was written by hand, and the tables."""
    text = PAGE.read_text(encoding="utf-8")
    parts = [text.partition(FROM)[0] + FROM, _table({key: help for key, (_, help) in KEYS.items()})]
    parts.append("`N` is the number of an axis, as the language numbers them.\n")
    for section, (sentence, keys) in SERVO.items():
        parts.append(f"## `[axis.N.{section}]`\n\n{sentence}\n\n{_servo_table(keys)}")
    for name, rows in TABLES.items():
        needed = REQUIRED[name]
        shown = {key: help + (" Needed." if key in needed else "") for key, (_, help) in rows.items()}
        parts.append(f"## `[[{name}]]`\n\n{SENTENCES[name]}\n\n{_table(shown)}")
    return "\n".join(parts)


def _servo_table(keys: dict[str, Key]) -> str:
    rows = {}
    for name, key in keys.items():
        default = str(key.default).lower() if key.kind == "flag" else f"{key.default}"
        rows[name] = f"{key.help} Default {default}."
    return _table(rows)


def _table(rows: dict[str, str]) -> str:
    return "".join(["| key | |\n|---|---|\n", *(f"| `{key}` | {help} |\n" for key, help in rows.items())])


if __name__ == "__main__":
    PAGE.write_text(written(), encoding="utf-8")
