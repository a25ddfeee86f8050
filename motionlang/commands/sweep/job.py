"""A sweep for its workers: the program, its results, and the run of a variant.

A job is sent to other processes and machines; each of them computes the expensive derived data once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from hashlib import sha256
from time import perf_counter
from typing import Any

from motionlang.commands.certify import certificate, missing_limits, violations
from motionlang.commands.certify.motion import verify_motion
from motionlang.commands.profile.budget import within_budget
from motionlang.commands.quantities import ResultValue, quantity
from motionlang.commands.sweep.space import Value
from motionlang.kernel import Diagnostic, Program, ProgramError, Run, Source, dialect, run
from motionlang.kernel.failures import failures
from motionlang.kernel.lang import is_key_of_entries, layered, with_key_of_entries
from motionlang.kernel.tools import missing

# A variant by its number and its values; a row by its number, its results, and its error.
Variant = tuple[int, tuple[Value, ...]]
Problem = dict[str, object]
Result = tuple[int, tuple[ResultValue, ...], Problem | None]

# Names of a variant that represent complete machine files.
MACHINE, SCENARIO = "machine", "scenario"
# Programs that a process caches: their settings decide how they are compiled.
MAX_PROGRAMS = 32


class SweepJob:
    """The common data of the variants of a sweep, as plain data that can be sent.

    `worlds` has the settings of complete machine files by the names of variants: `{"machine": {"old": …}}`.
    """

    def __init__(
        self,
        source: Source,
        dialect: str,
        names: Sequence[str],
        keep: Sequence[str],
        settings: Mapping[str, object],
        overrides: Mapping[str, float | str],
        worlds: Mapping[str, Mapping[str, Mapping[str, object]]],
        until: float | None,
        certify: bool = False,
        allow: Iterable[str] = (),
    ) -> None:
        self.name, self.text, self.dialect = source.name, source.text, dialect
        self.names, self.keep = tuple(names), tuple(keep)
        self.settings, self.overrides = dict(settings), dict(overrides)
        self.worlds = {kind: {n: dict(s) for n, s in some.items()} for kind, some in worlds.items()}
        self.until, self.certify, self.allow = until, certify, sorted(allow)
        self._digest = ""

    @property
    def digest(self) -> str:
        """A digest of the sweep without its variants, the same in all processes."""
        if not self._digest:
            fields = [repr(value) for name, value in sorted(vars(self).items()) if name != "_digest"]
            self._digest = sha256("\n".join(fields).encode("utf-8", "surrogatepass")).hexdigest()
        return self._digest

    def of(self, values: Sequence[Value]) -> tuple[dict[str, object], dict[str, float | str]]:
        """Return the settings and the overrides of a variant."""
        settings, overrides = self.settings, dict(self.overrides)
        for name, value in zip(self.names, values, strict=True):
            if name in self.worlds:
                world = self.worlds[name][str(value)]
                settings = dict(world) if name == MACHINE else layered(settings, world)
        for name, value in zip(self.names, values, strict=True):
            if is_key_of_entries(name):
                settings = with_key_of_entries(settings, name, value)
            elif "." in name:
                settings = {**settings, name: value}
            elif name not in self.worlds:
                overrides[name] = value if isinstance(value, str) else float(value)  # type: ignore[arg-type]
        return settings, overrides


class SweepWorker:
    """A job in one process, with its compiled programs."""

    def __init__(self, job: SweepJob) -> None:
        self.job, self.source = job, Source(job.name, job.text)
        self._dialect = dialect(job.dialect)
        self._readers = [quantity(name) for name in job.keep]
        self._text = self._dialect.program(self.source, job.settings)
        # The programs as they are written, and those for the names and addresses of the variants.
        self._programs: dict[str, Program] = {self._deciding(job.settings): self._text}
        self._compiled: dict[str, Program] = {}

    def result(self, variant: Variant) -> Result:
        """Return the row of one variant, including its error, if any."""
        index, values = variant
        try:
            found = self.run(values)
            results = tuple(self._read(found, *reader) for reader in self._readers)
            return index, results, self._problem(found)
        except ProgramError as error:
            return index, (None,) * len(self._readers), problem_of(error.diagnostics)
        except (ValueError, KeyError) as error:
            return index, (None,) * len(self._readers), problem_of([Diagnostic("machine-file", str(error))])

    def run(self, values: Sequence[Value]) -> Run:
        """Return the run of a variant."""
        settings, given = self.job.of(values)
        return self.run_given(given, settings)

    def run_given(
        self, given: Mapping[str, float | str], settings: Mapping[str, object] | None = None
    ) -> Run:
        """Return the run with values of literals and names, in the settings of the job or others."""
        settings = self.job.settings if settings is None else settings
        found = self._run(settings, given, self.compiled(settings, given))
        if given and found.status == "fault":  # run again, since a run by itself reports the error
            variant = self.program(settings).with_values(given)
            variant.places  # noqa: B018 - it raises the error of a text in place of a number
            found = self._run(settings, given, variant)
        return found

    def _run(self, settings: Mapping[str, object], given: Mapping[str, float | str], program: Program) -> Run:
        found = run(
            program,
            machine=settings,
            until=self.job.until,
            overrides=given,
            keep_crash=True,
        )
        if found.status == "interrupted":
            raise KeyboardInterrupt
        return within_budget(found)

    def program(self, settings: Mapping[str, object]) -> Program:
        """Return the program as it is written, for a machine.

        One program is for all machines whose settings agree in the keys that compiled code depends on.
        """
        key = self._deciding(settings)
        found = self._programs.get(key)
        if found is None:
            if len(self._programs) >= MAX_PROGRAMS:
                self._programs.clear()
                self._compiled.clear()
            found = self._programs[key] = self._text.on(settings)
        return found

    def compiled(self, settings: Mapping[str, object], given: Mapping[str, float | str]) -> Program:
        """Return the program for runs with values of some names and addresses, for a machine."""
        key = self._deciding(settings)
        found = self._compiled.get(key)
        if found is None:
            found = self._compiled[key] = self.program(settings).for_values(given)
        return found

    def _deciding(self, settings: Mapping[str, object]) -> str:
        deciding = {key: value for key, value in settings.items() if self._dialect.compiled_in(key)}
        return repr(sorted(deciding.items()))

    @staticmethod
    def _read(found: Run, row: Any, number: int) -> ResultValue:
        try:
            results: ResultValue = row.read(found, number)
        except KeyError:  # no such axis
            return None
        return results

    def _problem(self, found: Run) -> Problem | None:
        """Return the first reason why a run is not good, or None."""
        diagnostics = failures(found, self.job.allow)
        if found.crash is not None:
            diagnostics.append(_failed(found.crash))
        elif self.job.certify:
            lines = certificate(found.controller, found.machine.settings, found.time)
            diagnostics += verify_motion(found.controller, lines, found.time).violations
            diagnostics += violations(found, lines, partial(missing_limits, "", "the machine file"))
        return problem_of(diagnostics) if diagnostics else None


def _failed(error: Exception) -> Diagnostic:
    """Return the message for an unexpected error of a run, or for a missing library."""
    lacking = missing(error, "this run")
    if lacking is not None:
        return Diagnostic("extra", lacking.message, hint=lacking.hint)
    return Diagnostic("crash", f"internal error: {type(error).__name__}: {error}")


def problem_of(diagnostics: Sequence[Diagnostic]) -> Problem:
    """Return the first diagnostic as plain data, with the number of `more` of them."""
    first = diagnostics[0]
    return {**first.as_dict(), "length": first.length, "more": len(diagnostics) - 1}


# The workers of this process, by their jobs; a pool that is used for several sweeps has several.
_WORKERS: dict[str, SweepWorker] = {}
MAX_WORKERS = 8


def worker_of(job: SweepJob) -> SweepWorker:
    """Return the worker of a job in this process."""
    found = _WORKERS.get(job.digest)
    if found is None:
        while len(_WORKERS) >= MAX_WORKERS:
            _WORKERS.pop(next(iter(_WORKERS)), None)
        found = _WORKERS.setdefault(job.digest, SweepWorker(job))
    return found


def work(job: SweepJob, variants: Sequence[Variant]) -> tuple[float, list[Result]]:
    """Run some variants; return the time taken in s, and the rows.

    This is the function that a pool calls.
    """
    worker = worker_of(job)
    began = perf_counter()
    rows = [worker.result(each) for each in variants]
    return perf_counter() - began, rows
