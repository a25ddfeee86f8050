"""Scenarios: several worlds for one program, each with its expectations.

A world is a machine file that adds to the program's own. The scenarios of `pick.mnt` are in the folder
`pick.scenarios` next to it: `late.toml`, `stuck.toml`.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from math import inf

from motionlang.commands.profile.budget import within_budget
from motionlang.commands.quantities import no_cycle_notes, unit_of, values_of
from motionlang.kernel import Run, Source, machine_of, read_machine, run
from motionlang.kernel.failures import ALLOWED, failures
from motionlang.kernel.lang import layered

Entry = Mapping[str, object]

# The default tolerance of a figure.
WITHIN = 1e-6


class Scenario:
    """One world: `settings` on top of the program's, and `expected` entries of both."""

    def __init__(self, program: str, path: str) -> None:
        """Read a scenario.

        Raises OSError if a file cannot be read, ProgramError if the scenario is invalid.
        """
        self.program, self.path = program, path
        below = machine_of(program)
        settings = read_machine(Source.read(below)) if below is not None else {}
        above = read_machine(Source.read(path), is_layer=True)
        # Expectations of the program's own world do not apply to another one.
        self.expected: list[Entry] = above.pop("expect", [])  # type: ignore[assignment]
        settings.pop("expect", None)
        self.settings = layered(settings, above)

    @property
    def name(self) -> str:
        """The name of the scenario: its file name without the suffix."""
        return os.path.splitext(os.path.basename(self.path))[0]

    def run(self) -> Run:
        """Run the program in this world."""
        return within_budget(run(self.program, machine=self.settings))


def scenario_folder(program: str) -> str:
    """Return the folder of a program's scenarios."""
    return os.path.splitext(program)[0] + ".scenarios"


def scenario_files(program: str) -> list[str]:
    """Return the files of a program's scenarios, in order."""
    folder = scenario_folder(program)
    if not os.path.isdir(folder):
        return []
    return [os.path.join(folder, name) for name in sorted(os.listdir(folder)) if name.endswith(".toml")]


def unmet(result: Run, expected: list[Entry]) -> list[str]:
    """Return unmet expectations and unexpected errors of a run, each as a sentence."""
    found = [text for entry in expected if (text := _unmet(result, entry))]
    codes = {entry["diagnostic"] for entry in expected if "diagnostic" in entry}
    stop = result.machine.stop
    if (
        stop is not None
        and result.status != "stopped"
        and not codes
        and not any("status" in e for e in expected)
    ):
        found.append(f"the run {_ended(result)} at {result.time:.6f} s, not stopped by {stop}")
    if codes or not any(entry.get("status") == "fault" for entry in expected):
        kinds = {each["event"] for each in expected if "event" in each} | {stop and stop.event}
        allowed = {name for name, some in ALLOWED.items() if not kinds.isdisjoint(some)}
        for each in failures(result, allowed):
            if each.code not in codes:
                location = f"line {each.line}: " if each.line else ""
                found.append(f"the run had an unexpected error: {location}{each.message} [{each.code}]")
    return found


def _unmet(result: Run, entry: Entry) -> str:
    """Return how a run fails one entry; empty if it does not."""
    if "status" in entry:
        return "" if result.status == entry["status"] else f"the run {_ended(result)}, not {entry['status']}"
    if "diagnostic" in entry:
        codes = list(dict.fromkeys(each.code for each in failures(result)))
        had = f"its errors were {', '.join(codes)}" if codes else "it had none"
        return "" if entry["diagnostic"] in codes else f"the run had no error {entry['diagnostic']}; {had}"
    if "time" in entry:
        what = f"the run {_ended(result)} at {result.time:.6f} s"
        return _off(what, result.time, entry, "time", "s")
    if "quantity" in entry:
        return _unmet_quantity(result, entry)
    if "position" in entry:
        return _unmet_position(result, entry)
    if "event" in entry or "never_event" in entry:
        return _unmet_event(result, entry)
    return _unmet_print(result, entry)


def _unmet_position(result: Run, entry: Entry) -> str:
    axis, at = entry["axis"], entry.get("at", result.time)
    assert isinstance(axis, int)
    assert isinstance(at, (int, float))
    a = result.controller.axes[axis]
    motor = a.feedback
    if at > result.time:
        where = f"axis {axis} is expected at {entry['position']} at {at} s"
        return f"{where}, and the run {_ended(result)} at {result.time:.6f} s"
    counts = a.position(at) if motor is None or at < result.time else motor.position
    position = a.scale.position_to_user(counts)
    return _off(f"axis {axis} is at {position:.6f} at {at:.6f} s", position, entry, "position", "uu")


def _unmet_quantity(result: Run, entry: Entry) -> str:
    name = str(entry["quantity"])
    try:
        found = values_of(result, [name])[name]
    except ValueError as error:
        return str(error)
    if not isinstance(found, (int, float)):
        return "; ".join(no_cycle_notes(result, {name: found})) or f"{name} has no number in this run"
    if "value" in entry and (text := _off(f"{name} is {found:.6g}", found, entry, "value", unit_of(name))):
        return text
    low, high = entry.get("at_least", -inf), entry.get("at_most", inf)
    assert isinstance(low, (int, float))
    assert isinstance(high, (int, float))
    if found < low:
        return f"{name} is {found:.6g}, below {low:.10g}"
    return f"{name} is {found:.6g}, above {high:.10g}" if found > high else ""


def _off(what: str, found: float, entry: Entry, name: str, unit: str) -> str:
    wanted, within = entry[name], entry.get("within", WITHIN)
    assert isinstance(wanted, (int, float))
    assert isinstance(within, (int, float))
    if abs(found - wanted) <= within:
        return ""
    return f"{what}, not at {wanted:.10g} {unit}: {found - wanted:+g} {unit}, allowed {within:.10g}"


def _unmet_print(result: Run, entry: Entry) -> str:
    wanted = entry.get("prints", entry.get("never_prints"))
    assert isinstance(wanted, str)
    times = [each.time for each in result.machine.log.prints if wanted in each.text]
    last = f"the last line was {result.output[-1]!r}" if result.output else "nothing was"
    return _untimely(repr(wanted), "was printed", times, entry, "never_prints" in entry, last)


def _unmet_event(result: Run, entry: Entry) -> str:
    wanted, axis = entry.get("event", entry.get("never_event")), entry.get("axis")
    events = [each for each in result.machine.log.events if axis is None or each.axis == axis]
    times = [each.time for each in events if each.kind == wanted]
    had = ", ".join(dict.fromkeys(each.kind for each in events)) or "nothing did"
    what = f"an event {wanted!r}" if axis is None else f"an event {wanted!r} of axis {axis}"
    return _untimely(what, "happened", times, entry, "never_event" in entry, had)


def _untimely(what: str, did: str, times: list[float], entry: Entry, never: bool, instead: str) -> str:
    """Return how the times of an event violate an entry with a time window.

    The event is expected, or forbidden with `never`, between two times. `instead` describes the actual
    events.
    """
    low, high = entry.get("after", 0.0), entry.get("before", inf)
    assert isinstance(low, (int, float))
    assert isinstance(high, (int, float))
    inside = [time for time in times if low <= time <= high]
    if never:
        return f"{what} {did} at {inside[0]:.6f} s" if inside else ""
    if inside:
        return ""
    when = f" from {low:.10g} to {high:.10g} s"
    if high == inf:
        when = f" after {low:.10g} s" if low else ""
    elif not low:
        when = f" before {high:.10g} s"
    if times:
        return f"{what} {did} at {times[0]:.6f} s, not{when}"
    never_did = did.replace("was ", "was not ") if did.startswith("was ") else "did not happen"
    return f"{what} {never_did}{when}; {instead}"


def _ended(result: Run) -> str:
    return {
        "ended": "ended",
        "until": "was still running",
        "stopped": "was stopped",
        "fault": "stopped with an error",
    }.get(result.status, result.status)
