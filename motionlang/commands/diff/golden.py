"""Golden files: the expected result of a program, next to it.

`pick.mnt` has its report in `pick.golden.json` and its printed output in `pick.golden.txt`. Texts must be
equal. Numbers may differ by one part in a billion, so that a different mathematical library causes no failure.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from math import inf
from typing import Any

from motionlang.comparison.acts import ComparedAct, PlayedWay, compared, occurred, switched, written
from motionlang.comparison.tolerance import Tolerance
from motionlang.kernel import Run
from motionlang.kernel.files import replacing
from motionlang.kernel.report import SCHEMA, text
from motionlang.views.differences import grouped_words

MAX_DIFFERENCES = 8
# Fields that are no result: a program may get lines, and new assumptions.
PLACES = frozenset(("line", "column", "program", "schema", "assumptions"))
EXACT = Tolerance()
# Reports of these schemas have no outputs.
OLD_SCHEMAS = ("motionlang.report/1", "motionlang.report/2")
# The lists of a report whose rows are acts.
ACTS = ("moves", "printed", "switched", "analogue_outputs", "written")


def golden_files(program: str) -> tuple[str, str]:
    """Return the paths of a program's golden report and golden printed output."""
    stem = os.path.splitext(program)[0]
    return f"{stem}.golden.json", f"{stem}.golden.txt"


def differences(program: str, result: Run) -> list[str]:
    """Return how a program's run differs from its golden files: A is the golden file, B the run.

    Raises OSError if one of them cannot be read, ValueError if it is not a report.
    """
    report, printed = golden_files(program)
    with open(report, encoding="utf-8") as file:
        expected = json.load(file)
    units = () if result.program is None else result.program.structure.units
    has_tasks = any(each.kind in ("task", "event", "macro") for each in units)
    found = _words(expected, json.loads(text(result, whole=False)), has_tasks)
    if os.path.exists(printed) or result.output:
        with open(printed, encoding="utf-8", newline="") as file:
            lines = file.read().replace("\r\n", "\n")  # which Git for Windows writes
        if lines != _lines(result.output).replace("\r\n", "\n") and expected.get("output") == result.output:
            found.append(f"the printed output differs from {os.path.basename(printed)}")
    return found


def update(program: str, result: Run) -> bool:
    """Rewrite a program's golden files if the run differs.

    Returns True if they were rewritten. An OSError names the file.
    """
    try:
        if not differences(program, result):
            return False
    except (OSError, ValueError):
        pass  # A file is missing or is not JSON.
    _write(program, text(result, whole=False), result.output)
    return True


def _write(program: str, report: str, output: Sequence[str]) -> None:
    """Write both golden files of a program, or neither; an OSError names the file."""
    path, printed = golden_files(program)
    with replacing(path, only_copy=True) as file:
        file.write(report.encode())
        file.flush()  # it is on the disk before the other one exists
        os.fsync(file.fileno())
        if output:
            with replacing(printed, only_copy=True) as other:
                other.write(_lines(output).encode())
        elif os.path.exists(printed):
            os.remove(printed)


def _lines(output: Sequence[str]) -> str:
    return "".join(line + "\n" for line in output)


def _words(expected: Any, now: Mapping[str, Any], has_tasks: bool) -> list[str]:
    """Return the differences of two reports: what is done, then the figures that this does not show."""
    if not isinstance(expected, dict) or not str(expected.get("schema", "")).startswith("motionlang.report/"):
        raise ValueError("it is not a report of a run")
    if expected["schema"] != SCHEMA:
        lacks = ", which has no outputs" if expected["schema"] in OLD_SCHEMAS else f" and not {SCHEMA}"
        raise ValueError(f"it is {expected['schema']}{lacks}; --update writes it again")
    sides = [dict(_flat(each)) for each in (expected, now)]
    old, new = sides
    changed = [
        path for path in {**old, **new} if not (path in old and path in new and same(old[path], new[path]))
    ]
    if not changed:
        return []
    try:
        acts = compared(_way(expected, has_tasks), _way(now, has_tasks), EXACT)
    except (KeyError, TypeError) as error:
        raise ValueError(f"it lacks {error}") from None
    lines = grouped_words(acts.differences, acts.later)
    is_shown = tuple(f"{name}[" for name in ("output", *ACTS)) if lines else ()
    others = [path for path in changed if not path.startswith(is_shown)] if is_shown else changed
    lines += (f"{path}: {_shown(old.get(path))} → {_shown(new.get(path))}" for path in others)
    left = len(lines) - MAX_DIFFERENCES
    return lines[:MAX_DIFFERENCES] + ([f"and {left} more"] if left > 0 else [])


def _way(report: Mapping[str, Any], has_tasks: bool) -> PlayedWay:
    """Return what a report says that a program did, in user units.

    It does not say which task did it, so if there may be several, the acts of each axis and output have their order.
    """
    printed = {k: (each["time"], each["line"]) for k, each in enumerate(report["printed"])}
    acts = [
        ComparedAct(time, time, at, "", text)
        for k, text in enumerate(report["output"])
        for time, at in [printed.get(k, (report["time"], 0))]
    ]
    for each in report["moves"]:
        end = each.get("end")
        words = f"{each['command']}" + ("" if end is None else f" to {end:.6g}")
        duration, ended, speed = each["duration"] or 0.0, each.get("ended", ""), each.get("peak_speed") or 0.0
        words += f" at {speed:.6g}" if speed else ""
        acts.append(
            ComparedAct(
                each["start_time"],
                each["start_time"] + duration,
                each["line"],
                f"axis {each['axis']}",
                words,
                (each["command"], ended),
                end,
                speed,
            )
        )
    acts += (switched(*_fields(each, "channel")) for each in report["switched"])
    for each in report["analogue_outputs"]:
        time, at, channel, value = _fields(each, "channel")
        acts.append(written(time, at, f"analogue output {channel}", value))
    acts += (written(*_fields(each, "target")) for each in report["written"])
    acts += (occurred(each["time"], 0, each.get("axis"), each["kind"]) for each in report["events"])
    acts.sort(key=lambda act: act.begin)
    streams: dict[str, list[ComparedAct]] = {}
    for act in acts:
        streams.setdefault(act.subject if has_tasks else "", []).append(act)
    status, time = report["status"], report["time"]
    until = time if status == "until" else inf
    return PlayedWay(streams, status, time, until, {}, [], 0.0, frozenset(), frozenset(), {})


def _fields(row: Mapping[str, Any], name: str) -> tuple[float, int, Any, float]:
    return row["time"], row["line"], row[name], row["value"]


def _shown(value: object) -> str:
    return f"{value:.9g}" if isinstance(value, float) else "none" if value is None else str(value)


def _flat(value: object, path: str = "") -> Iterator[tuple[str, object]]:
    """Yield each figure and text of a report, with its path."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key not in PLACES:
                yield from _flat(inner, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for number, inner in enumerate(value):
            yield from _flat(inner, f"{path}[{number}]")
    else:
        yield path, value


def same(expected: object, found: object) -> bool:
    """True if two values are equal, figures within a billionth."""
    if isinstance(expected, float) and isinstance(found, float):
        return expected == found or abs(expected - found) <= EXACT.of("", expected, found)
    return expected == found and type(expected) is type(found)
