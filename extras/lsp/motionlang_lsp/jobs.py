"""The jobs of a language server's worker: the names, checks and runs of one text.

A job and its result are plain data, so a job can go to another process.
"""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.kernel import Diagnostic, Source, dialect
from motionlang.kernel.lang import Names
from motionlang_lsp.editor.diagnostics import decoded, findings, settings_of
from motionlang_lsp.editor.page import Page
from motionlang_lsp.editor.times import Times, times

CHECK, NAMES, TIMES = "check", "names", "times"
Result = list[Diagnostic] | Names | Times


@dataclass(eq=False, slots=True)
class Job:
    """A job of the worker for a text.

    `language` is "" for a machine file. `machine` is the text of the machine file next to the program,
    None if there is none; `machine_name` is its file name.
    """

    what: str
    name: str
    text: str
    language: str
    machine: str | None
    machine_name: str


def work(job: Job) -> Result:
    """Carry out a job and return its result."""
    language = dialect(job.language) if job.language else None
    source = Source(job.name, job.text)
    if language is None:
        return decoded(source, settings_of(source, None)[1], "machine-file")
    machine = None if job.machine is None else Source(job.machine_name, job.machine)
    settings, wrong = settings_of(machine, language) if machine is not None else ({}, [])
    page = Page(source, language, settings)
    if job.what == TIMES:
        return times(page)
    if job.what == NAMES:
        return page.names
    found = findings(page)
    if wrong:
        message = f"{job.machine_name} is invalid, and the program is checked without it: {wrong[0].message}"
        found.insert(0, Diagnostic("machine-file", message, 1, 1, severity="warning"))
    return found
