"""The run as a page to look around in: `--plot OUT.html`, one file that needs no network.

The page has the pieces of the motion, not samples, and draws what is looked at, so that it can be zoomed into without
end. `model.js` is the motion without a page, `script.js` the page.
"""

from __future__ import annotations

import json
from importlib.resources import files
from string import Template
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from motionlang import __version__
from motionlang.files import replacing
from motionlang.report import finite
from motionlang.report import moves as moves_of
from motionlang.views.lanes import lanes
from motionlang.views.panels import UNITS, panels
from motionlang.views.plot_panel import PHASES
from motionlang.views.terminal import printable
from motionlang.views.words import dialect_name, outcome

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from motionlang.controller.record.trace import Array, Trace
    from motionlang.controller.servo.trace import ServoTrace
    from motionlang.result import Run
    from motionlang.views.panels import Curve

    Row = dict[str, Any]

LONGEST_LINE = 120
"""Characters of a program's line that are shown beside the cursor."""


def write_scope(run: Run, path: str, servos: Mapping[int, ServoTrace] = MappingProxyType({})) -> None:
    """Write the page; `servos` has what the motors did, by axis, where that was simulated. Raises OSError."""
    with replacing(path) as file:
        file.write(page(run, servos).encode("utf-8"))


def page(run: Run, servos: Mapping[int, ServoTrace] = MappingProxyType({})) -> str:
    """The whole page; the same text for the same run."""
    name = printable(run.source.name)
    return Template(_part("page.html")).substitute(
        generator=f"motionlang {__version__}",
        title=name.replace("&", "&amp;").replace("<", "&lt;"),
        style=_part("style.css"),
        model=_part("model.js"),
        script=_part("script.js"),
        data=_embedded(_data(run, servos)),
    )


def _part(name: str) -> str:
    return files(__name__).joinpath(name).read_text(encoding="utf-8").rstrip("\n")


def _embedded(data: Row) -> str:
    """JSON that cannot end the script element it stands in."""
    return json.dumps(finite(data), separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def _data(run: Run, servos: Mapping[int, ServoTrace]) -> Row:
    trace = run.trace
    rows: list[Row] = list(moves_of(run))
    lines = sorted({row["line"] for row in rows if row["line"]})
    return {
        "program": printable(run.source.name),
        "outcome": f"{dialect_name(run.dialect.name)} · {outcome(run)}",
        "end": trace.end,
        "quantities": list(UNITS.items()),
        "phases": list(PHASES),
        "source": {line: printable(run.source.line(line).strip())[:LONGEST_LINE] for line in lines},
        "axes": [_axis(trace, axis, rows, servos.get(axis)) for axis in trace.axes],
        "lanes": [
            {"name": lane.name, "digital": lane.is_digital, "times": lane.times, "values": lane.values}
            for lane in lanes(run.controller)
        ],
    }


def _axis(trace: Trace, axis: int, rows: Sequence[Row], servo: ServoTrace | None) -> Row:
    track = _track(trace, axis)
    made: Row = {"name": f"axis {axis}", "track": track, "jerks": bool(track["waves"] or any(track["c"][3]))}
    made["moves"] = [_move(row) for row in rows if row["axis"] == axis]
    drawn = panels(trace, axis, servo) if servo is not None and len(servo) else []
    if drawn:
        made["motor"] = _series(drawn[0].curves[0])
    made["servo"] = [
        {"quantity": panel.quantity, "unit": panel.unit, **_series(panel.curves[0])}
        for panel in drawn
        if panel.quantity not in UNITS
    ]
    return made


def _track(trace: Trace, axis: int) -> Row:
    """The pieces of an axis in user units: when each begins, its cubic, and the waves there are, by piece."""
    table = trace.table(axis)
    used = max(1, int(np.searchsorted(table.origins, trace.end, "right")))
    starts, columns = table.origins[:used], table.columns[:, :used].copy()
    trace.to_user(axis, "position", columns[0])
    for row in (*columns[1:4], columns[4]):
        trace.to_user(axis, "velocity", row)
    waves = np.flatnonzero(columns[4])
    return {
        "starts": _numbers(starts),
        "c": [_numbers(row) for row in columns[:4]],
        "waves": {str(i): _numbers(columns[4:7, i]) for i in waves.tolist()},
    }


def _move(row: Row) -> Row:
    phases = [[phase["name"], phase["duration"]] for phase in row["phases"]]
    return {
        "command": printable(row["command"] or "move"),
        "line": row["line"],
        "start": row["start_time"],
        "duration": row["duration"],
        "phases": phases,
    }


def _series(curve: Curve) -> Row:
    return {"times": _numbers(curve.times), "values": _numbers(curve.values)}


def _numbers(values: Array) -> list[float | int]:
    """Numbers as JSON has them: whole ones without a point, and nothing that JSON has no number for."""
    plain = np.nan_to_num(values).tolist()
    return [int(value) if value == int(value) and abs(value) < 1e15 else value for value in plain]
