"""Budgets of the machine file: `[budget]` limits the time of a run by component."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from motionlang.commands.profile.critical_path import Link
from motionlang.commands.profile.profile import TimeProfile
from motionlang.kernel import Diagnostic, Run


def category_of(link: Link) -> str:
    """Return the budget key, in addition to `time`, that a link counts towards."""
    if link.is_motion:
        return "motion"
    return link.cause if link.cause in ("dwell", "computing", "settling") else "waiting"


def within_budget(run: Run) -> Run:
    """Return a run with a diagnostic for each budget of its machine file that it exceeds."""
    budgets = {key: value for key, value in run.machine.settings.items() if key.startswith("budget.")}
    if run.status == "ended" and budgets:
        run.diagnostics += _over_budget(run, budgets)
    return run


def _over_budget(run: Run, budgets: Mapping[str, object]) -> Iterator[Diagnostic]:
    """Yield a diagnostic for each exceeded budget, at the line that contributes most."""
    made = TimeProfile(run)
    for key, allowed in budgets.items():
        assert isinstance(allowed, (int, float))
        category = key.removeprefix("budget.")
        links = [link for link in made.links if category in ("time", category_of(link))]
        taken = run.time if category == "time" else made.total(links)
        if taken > allowed:
            lines = made.shares_of(links)
            line, seconds = next(((share.line, share.seconds) for share in lines), (0, 0.0))
            what = "the run" if category == "time" else category
            yield Diagnostic(
                "budget",
                f"{what} took {taken:.6g} s, {taken - allowed:.6g} s over the budget of {allowed:.10g} s",
                line,
                hint=f"line {line} took {seconds:.6g} s of it; motionlang profile shows all lines"
                if line
                else "",
            )
