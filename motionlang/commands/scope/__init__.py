"""The run as an interactive page: `--plot OUT.html`, one file without network use.

The page contains the pieces of the motion instead of samples and draws the visible window, so zoom is unlimited.
`model.js` evaluates the motion and does not depend on a page. `panels.js` defines the panels, `draw.js` and
`path.js` draw them, `tools.js` searches and exports, and `script.js` handles mouse and keyboard.

The pieces are plain numbers, so a page without motors and recordings needs no numpy, which is not available when
Python runs in a browser.
"""

from __future__ import annotations

import json
from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from importlib.resources import files
from math import copysign, isfinite, isnan
from operator import itemgetter, sub, truediv
from string import Template
from sys import float_info
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from motionlang.commands.profile.critical_path import Link
from motionlang.commands.profile.profile import TimeProfile
from motionlang.commands.profile.source_positions import SourcePositions
from motionlang.kernel import Controller, Run
from motionlang.kernel.files import replacing
from motionlang.kernel.log import GRAVE
from motionlang.kernel.planners import Plain, pieces_of, recentred
from motionlang.kernel.report import events as events_of
from motionlang.kernel.report import finite
from motionlang.kernel.report import moves as moves_of
from motionlang.kernel.tracks import axes_of
from motionlang.kernel.version import __version__
from motionlang.views.figure import Curve, Panel
from motionlang.views.formatting import dialect_name, figure, outcome
from motionlang.views.lanes import lanes
from motionlang.views.quantities import PHASES, UNITS
from motionlang.views.terminal import printable
from motionlang.views.window import WHOLE, Window

if TYPE_CHECKING:
    from motionlang.commands.compare.comparison import Comparison
    from motionlang.kernel.servo import ServoTrace
    from motionlang.kernel.tracks import Array

Row = dict[str, Any]

SCRIPTS = ("model", "panels", "draw", "path", "tools", "script")
# The largest number of records on a page: moves, waits, events, channel changes.
MAX_RECORDS = 200_000
# The largest number of characters of a program line shown next to the cursor.
MAX_LINE = 120
# A shorter block of the critical path, s, is only a rounding error.
SHORTEST = 1e-12


def write_scope(
    run: Run,
    path: str,
    servos: Mapping[int, ServoTrace] = MappingProxyType({}),
    window: Window = WHOLE,
    against: Run | None = None,
) -> None:
    """Write the page that `page` returns.

    Raises OSError, and ValueError if the window is empty.
    """
    text = page(run, servos, window, against)
    with replacing(path) as file:
        file.write(text.encode("utf-8"))


def write_comparison(made: Comparison, path: str) -> None:
    """Write the page of a run with the measured curves drawn over it; raise OSError."""
    measured = [(each.axis, each.quantity, each.times - made.delay, each.values) for each in made.found]
    assert made.baseline.run is not None
    text = page(made.baseline.run, measured=measured)
    with replacing(path) as file:
        file.write(text.encode("utf-8"))


def page(
    run: Run,
    servos: Mapping[int, ServoTrace] = MappingProxyType({}),
    window: Window = WHOLE,
    against: Run | None = None,
    measured: Sequence[tuple[int, str, Array, Array]] = (),
) -> str:
    """Return the whole page; the same run always gives the same text.

    `servos` has the simulated motion of the motors, by axis. The page initially shows `window` and also contains
    the rest of the run. The axes of the run `against` are drawn behind those with the same numbers. The `measured`
    curves are drawn in front: axis, quantity, times (s) and values. Raises ValueError for more than `MAX_RECORDS`
    records.
    """
    records = max(_records(each) for each in (run, against) if each is not None)
    if records > MAX_RECORDS:
        raise ValueError(
            f"the run has {records} records, but a page holds at most {MAX_RECORDS}; end the run sooner with --until"
        )
    name = printable(run.source.name)
    return Template(_asset("page.html")).substitute(
        generator=f"motionlang {__version__}",
        title=name.replace("&", "&amp;").replace("<", "&lt;"),
        style=_asset("style.css"),
        data=_embedded(_data(run, servos, window, against, measured)),
        **{script: _asset(f"{script}.js") for script in SCRIPTS},
    )


def _records(run: Run) -> int:
    """Return the number of records that the page of a run would have."""
    log = run.controller.log
    records = len(log.moves) + len(log.waits) + len(log.events)
    return records + len(log.inputs) + len(log.outputs) + len(log.slices)


def _asset(name: str) -> str:
    return files(__name__).joinpath(name).read_text(encoding="utf-8").rstrip("\n")


def _embedded(data: Row) -> str:
    """Return JSON that cannot end the script element that contains it."""
    return json.dumps(finite(data), separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def _data(
    run: Run,
    servos: Mapping[int, ServoTrace],
    window: Window,
    against: Run | None,
    measured: Sequence[tuple[int, str, Array, Array]],
) -> Row:
    controller = run.controller
    end, axes = controller.clock.now, axes_of(controller)
    rows: list[Row] = list(moves_of(run))
    cycle, profile, happened = run.cycle, TimeProfile(run), [_event(row) for row in events_of(run)]
    lines = sorted(
        {row["line"] for row in rows}
        | {link.position.line for link in profile.links}
        | {event["line"] for event in happened} - {0}
    )
    return {
        "program": printable(run.source.name),
        "outcome": f"{dialect_name(run.dialect.name)} · {outcome(run)}"
        + (f" · cycle {cycle}" if cycle else ""),
        "end": end,
        "quantities": list(UNITS.items()),
        "phases": list(PHASES),
        "source": {line: printable(run.source.line(line).strip())[:MAX_LINE] for line in lines},
        "first": _first(window, axes, end),
        "against": None if against is None else _against(against),
        "events": happened,
        "bands": _bands(run, profile),
        "lines": _by_line(profile),
        "axes": [_axis(run, axis, rows, servos.get(axis)) for axis in axes],
        "measured": [
            {
                "axis": f"axis {axis}",
                "quantity": quantity,
                "times": _numbers(times.tolist()),
                "values": _numbers(values.tolist()),
            }
            for axis, quantity, times, values in measured
        ],
        "lanes": [
            {"name": lane.name, "digital": lane.is_digital, "times": lane.times, "values": lane.values}
            for lane in lanes(controller)
        ],
    }


def _event(row: Row) -> Row:
    """Return an event as page data: its text and whether it is a fault."""
    about = [row["kind"]]
    if "axis" in row:
        about.append(f"of axis {row['axis']}")
    if row["kind"] == "velocity jump":
        about.append(f"from {figure(row['value'])} to {figure(row['limit'])}")
    elif "limit" in row:
        about.append(f"at {figure(row['value'])}, limit {figure(row['limit'])}")
    elif "value" in row:
        about.append(f"at {figure(row['value'])}")
    text = " ".join(about) + (f": {printable(row['text'])}" if "text" in row else "")
    return {
        "time": row["time"],
        "kind": row["kind"],
        "line": row["line"],
        "text": text,
        "grave": row["kind"] in GRAVE,
    }


def _bands(run: Run, profile: TimeProfile) -> list[Row]:
    """Return lanes of blocks: the critical path of a run and the waits of each task."""
    chain = [
        [link.begin, link.end, _stretch(link), link.position.line]
        for link in profile.links
        if link.duration > SHORTEST
    ]
    bands: list[Row] = [{"name": "critical path", "spans": chain}]
    positions = SourcePositions(run)
    for task, waits in profile.waits().items():
        spans = [
            [since, until, why or f"for {until - since:.6g} s", positions.of(at, callers).line]
            for _, at, since, until, _, _, why, callers in waits
        ]
        bands.append({"name": task, "spans": spans})
    return bands


def _stretch(link: Link) -> str:
    return f"{link.cause}, axis {', '.join(map(str, link.axes))}" if link.axes else link.cause


def _by_line(profile: TimeProfile) -> list[Row]:
    """Return the lines by their total time, longest first, each with its first start."""
    first: dict[int, float] = {}
    for link in profile.links:
        first.setdefault(link.position.line, link.begin)
    return [
        {"line": share.line, "seconds": share.seconds, "time": first[share.line]}
        for share in profile.lines()
        if share.line and share.seconds
    ]


def _first(window: Window, axes: Sequence[int], last: float) -> Row:
    """Return the initial view of the page; the run ended at `last` (s)."""
    begin, end = window.span(last)
    shown = window.of(axes)
    path = [f"axis {axis}" for axis in window._replace(axes=window.path).of(axes)] if window.path else []
    hidden = [f"axis {axis}" for axis in axes if axis not in shown]
    return {"begin": begin, "end": None if window.end is None else end, "hidden": hidden, "path": path}


def _against(run: Run) -> Row:
    """Return the motion of the other run, to be drawn in the background."""
    return {
        "program": printable(run.source.name),
        "outcome": outcome(run),
        "end": run.controller.clock.now,
        "axes": [_axis(run, axis, (), None) for axis in axes_of(run.controller)],
    }


def _axis(run: Run, axis: int, rows: Sequence[Row], servo: ServoTrace | None) -> Row:
    track, jerks = _track(run.controller, axis)
    made: Row = {"name": f"axis {axis}", "track": track, "jerks": jerks}
    made["moves"] = _moves([row for row in rows if row["axis"] == axis])
    drawn = _motor_panels(run, axis, servo)
    if drawn:
        made["motor"] = _series(drawn[0].curves[0])
    made["servo"] = [
        {"quantity": panel.label, "unit": panel.unit, **_series(panel.curves[0])}
        for panel in drawn
        if panel.label not in UNITS
    ]
    return made


def _motor_panels(run: Run, axis: int, servo: ServoTrace | None) -> list[Panel]:
    if servo is None or not len(servo):
        return []
    from motionlang.views.panels import panels

    return panels(run.trace, axis, servo)


def _track(controller: Controller, axis: int) -> tuple[Row, bool]:
    """Return the pieces of an axis in user units, and whether any has jerk.

    Each piece has its start, its cubic, and its wave if it has one.
    """
    a = controller.axes[axis]
    starts, pieces = pieces_of(a.starts, a.profiles)
    used = max(1, bisect_right(starts, controller.clock.now))
    track = list(zip(starts[:used], pieces[:used], strict=True))
    for since, _, _ in a.scales[1:]:  # a piece is in one unit
        index = bisect_right(starts, since) - 1
        track.append((since, recentred(pieces[index], since - starts[index])))
    track.sort(key=itemgetter(0))
    starts, pieces = map(list, zip(*track, strict=True))
    counts, zeros = zip(*map(a.scale_at, starts), strict=True)
    positions, *others, amplitudes, _, _ = zip(*pieces, strict=True)
    cubic = [_in_units(map(sub, positions, zeros), counts), *(_in_units(values, counts) for values in others)]
    return {
        "starts": _packed(starts),
        "c": [_packed(row) for row in cubic],
        "waves": {
            str(i): _numbers(_wave(pieces[i], counts[i])) for i, height in enumerate(amplitudes) if height
        },
    }, any(amplitudes) or any(cubic[3])


def _in_units(values: Iterable[float], counts: Sequence[float]) -> Sequence[float]:
    return list(map(truediv, values, counts))


def _wave(piece: Plain, counts: float) -> tuple[float, float, float]:
    return piece[4] / counts, piece[5], piece[6]


def _moves(rows: Sequence[Row]) -> Row:
    """Return the start of each move of an axis and its index in `kinds`.

    A move that repeats in each cycle is described once.
    """
    kinds: dict[str, int] = {}
    which = [kinds.setdefault(json.dumps(_kind(row)), len(kinds)) for row in rows]
    return {
        "kinds": [json.loads(kind) for kind in kinds],
        "which": which,
        "starts": _numbers(row["start_time"] for row in rows),
    }


def _kind(row: Row) -> Row:
    return {
        "command": printable(row["command"] or "move"),
        "line": row["line"],
        "duration": row["duration"],
        "phases": [[phase["name"], phase["duration"]] for phase in row["phases"]],
    }


def _series(curve: Curve) -> Row:
    return {"times": _numbers(curve.x), "values": _numbers(curve.y)}


def _packed(values: Sequence[float]) -> Row | list[float | int]:
    """Return the numbers, or distinct ones (`of`) and indexes (`at`) if many repeat.

    The distinct ones are in the order of occurrence, so that frequent ones have shorter indexes.
    """
    index: dict[float, int] = {}
    at = [index.setdefault(value, len(index)) for value in values]
    if 2 * len(index) > len(values):
        return _numbers(values)
    return {"of": _numbers(index), "at": at}


def _numbers(values: Iterable[float]) -> list[float | int]:
    """Return numbers for JSON: integers without a point, and no NaN or infinity."""
    return [_number(value) for value in values]


def _number(value: float) -> float | int:
    if not isfinite(value):
        return 0 if isnan(value) else copysign(float_info.max, value)
    return int(value) if abs(value) < 1e15 and value == int(value) else value
