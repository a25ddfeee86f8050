"""Writer of tests/spec/mint/README.md, the table of contents of the Mint manual.

The chapters are listed here; the subject of a page is the first
sentence of its initial comment.
"""

from __future__ import annotations

import re
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "tests" / "spec" / "mint"
INDEX = FOLDER / "README.md"

INTRODUCTION = """\
# Mint by example

Each page is a program that runs, with its results beside it in comments ([the marks](../README.md#marks)). The keywords
are in [docs/keywords/mint.md](../../../docs/keywords/mint.md), the assumptions where sources are silent in
[docs/contributing/assumptions.md](../../../docs/contributing/assumptions.md).
"""

# Titles of chapters, each with its pages in reading order.
CHAPTERS = {
    "The language": "first_program style_separators style_lines variables style_names shadows startup",
    "Types": "numbers style_numbers casting overflow strings arrays records style_types time_variables constants",
    "Operators": "arithmetic precedence style_not functions",
    "Control flow": (
        "if select style_select loops exits labels labels_in_blocks style_jumps style_deep style_ends"
        " several_at_once"
    ),
    "Subs and functions": "subs by_reference array_parameters recursion style_functions",
    "Time and tasks": "time tasks priorities semaphore",
    "Events": "events masked_events machine/urgency style_events machine/input_events",
    "Printing and the operator": ("print using style_print screen operator machine/keys machine/terminals"),
    "Errors": (
        "onerror onerror_registers onerror_at_the_end reading_errors machine/error_numbers machine/error_lines"
        " machine/enable_input machine/never"
    ),
    "Axes and moves": (
        "axes omitted_values style_motion motion machine/axis_state machine/stopping jog restoring"
        " machine/handshakes machine/holding"
    ),
    "Units and wraps": "units machine/wraps machine/compensation",
    "The move buffer": "buffer machine/buffer_status machine/buffer_entries machine/triggers",
    "Profiles": "rates machine/sramp machine/feedrate speed_in_motion",
    "Paths": "machine/paths machine/splines",
    "Gearing and cams": "machine/following machine/offsets machine/cams machine/master_encoders",
    "Homing": "machine/homing machine/homing_types machine/homing_by_input machine/homing_without_switch",
    "Limits": "machine/soft_limits machine/limit_switches machine/axis_inputs machine/stop_inputs",
    "Inputs and outputs": (
        "machine/digital_inputs machine/edges machine/debounce machine/outputs machine/signals machine/pulses"
        " machine/analogue"
    ),
    "Latches": "machine/latches machine/wrapped_latch machine/latch_settings machine/index_marks",
    "Motors": "machine/servo machine/torque",
    "Communication": (
        "machine/comms machine/packed_texts machine/comms_esb machine/modbus_client"
        " machine/modbus_unknown machine/remote machine/bus_events"
    ),
    "Memory that outlives the run": "nv_data",
    "The controller itself": "machine/identity machine/readings",
    "Older Mint": "style_v4 style_v4_names older_words onerror_v4 machine/can_events_v4",
    "Known, not simulated": "machine/not_simulated machine/kept_settings",
}


def pages() -> list[str]:
    """Return the names of the pages that exist, spelled as in the chapters."""
    return sorted(str(path.relative_to(FOLDER).with_suffix("")) for path in FOLDER.rglob("*.mnt"))


def heading(text: str) -> str:
    """Return the initial comment of a page, up to its first blank line, or ""."""
    lines = []
    for line in text.split("\n"):
        if not line.startswith("' "):
            break
        lines.append(line[2:].strip())
    return " ".join(lines)


def first_sentence(text: str) -> str:
    """Return the first sentence of a page's heading, with its full stop."""
    return re.split(r"(?<! p)\. ", heading(text))[0].rstrip(".") + "."


def row(page: str) -> str:
    """Return a page's line in the contents."""
    sentence = first_sentence((FOLDER / f"{page}.mnt").read_text(encoding="utf-8"))
    name = page.rpartition("/")[2]
    title = name.removeprefix("style_").replace("_", " ") + ", all styles" * name.startswith("style_")
    return f"* [{title}]({page}.mnt): {sentence}"


def contents() -> str:
    """Return the complete table of contents."""
    chapters = (
        f"\n## {title}\n\n" + "\n".join(map(row, names.split())) + "\n" for title, names in CHAPTERS.items()
    )
    return INTRODUCTION + "".join(chapters)


def files() -> dict[Path, str]:
    return {INDEX: contents()}
