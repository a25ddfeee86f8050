"""`motionlang check`: errors and warnings of every file, without a run."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, ClassVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain, no_dialect, unwritten
from motionlang.cli.option_groups import Findings, Jobs, OnMachine, read
from motionlang.cli.program_files import PATHS, programs
from motionlang.commands.check import check as check_program
from motionlang.commands.check.findings import Found, written
from motionlang.commands.check.fix import Fixed, Unfixable, fix, fix_once
from motionlang.commands.check.listing import render_steps, render_tree, steps_table
from motionlang.kernel import (
    DEFAULT_AXES,
    STDIN,
    STDIN_NAME,
    Diagnostic,
    Dialect,
    Program,
    ProgramError,
    Source,
    depended_on,
    dialect,
    language_of,
    machine_of,
    missing_axes,
    name_of,
    read_machine,
    unknown_model,
)
from motionlang.kernel.lang import ListedUnit, Literal, listed_units, one_sentence
from motionlang.kernel.mccl import MODELS
from motionlang.processes.parallel import in_parallel
from motionlang.views.diagnostics import diagnostics_table, tally
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import printable, styled, wants_colour, width_of

if TYPE_CHECKING:
    from motionlang.commands.evidence.assumption import Assumption


@dataclass
class CheckedFile:
    """A file as far as it has been checked, with what else was asked for.

    `language` is "" if it is unknown. `source` is the file that the diagnostics are about: the program or its machine
    file.
    """

    language: str
    source: Source | None = None
    diagnostics: Sequence[Diagnostic] = ()
    fixed: Sequence[Fixed] = ()
    fixable: int = 0
    notes: Sequence[str] = ()
    literals: Sequence[Literal] = ()
    tree: str | None = None
    steps: Sequence[ListedUnit] = ()
    assumptions: Sequence[str] | None = None


@dataclass
class _Shown:
    """The results for the files, each with its name, for a document."""

    files: list[dict[str, object]] = field(default_factory=list)
    fixed: list[tuple[str, Fixed]] = field(default_factory=list)
    literals: list[tuple[str, Literal]] = field(default_factory=list)
    steps: list[tuple[str, Sequence[ListedUnit]]] = field(default_factory=list)
    assumptions: list[tuple[dict[str, object], Assumption]] = field(default_factory=list)


@dataclass
class Check(Findings, Jobs, OnMachine):
    """Find the errors and warnings of programs without running them."""

    title: ClassVar[str] = "checks"
    epilog: ClassVar[str] = """\
Warnings point out code that compiles but is probably a mistake: a move that
no GO starts, a wait that nothing can end. docs/diagnostics.md explains them.
A comment with `lint: ignore CODE` silences a warning on its line.

exit status: 0 no errors; 1 a file has an error (with --strict, or a warning);
2 the command line is invalid

examples:
  motionlang check pick.mnt --machine cell.toml
  motionlang check old.prg --model mintmt
"""
    files: list[str] = argument("FILE", f"{PATHS}; - reads standard input", many=True, default=["."])
    model: str | None = option(
        "MODEL",
        "the controller model: mint4, mintmt or a product name such as NextMove ESB; for MCCL one of "
        f"{', '.join(MODELS)}",
    )
    strict: bool = flag("treat warnings as errors")
    fix: bool = flag("fix what has only one possible fix, in the files, then report the rest")
    evidence: bool = flag(
        "list the unconfirmed assumptions that each program depends on, and the evidence for each"
    )
    literals: bool = flag("list the numbers of each program by the addresses that --set and --vary take")
    steps: bool = flag("print the steps that a run takes beside the lines of each program without errors")
    tree: bool = flag("print the syntax tree of each program without syntax errors")

    _shown: _Shown = field(default_factory=_Shown, init=False, repr=False)

    def check(self) -> None:
        """Raise WrongOption if the model is one of no language of the files."""
        super().check()
        if self.model is None:
            return
        languages = dict.fromkeys(language_of(self.lang, file) for file in programs(self.files))
        problems = [unknown_model(self.model, each) for each in languages]
        if problems and all(problems):
            problem = problems[0] if len(problems) == 1 else unknown_model(self.model)
            assert problem is not None
            raise WrongOption(f"argument --model: {'; '.join(problem)}")

    def run(self) -> int:
        """Check files and the programs of folders; 1 if any has an error.

        Diagnostics and one line per file go to standard output.
        """
        files = programs(self.files)
        if not files:
            sys.stderr.write(f"no programs in {', '.join(self.files)}\n")
            return 1
        findings: list[Found] = []
        jobs = 1 if STDIN in files else self.jobs
        work = partial(_checked_and_fixed, replace(self))  # a copy without its parser, for other processes
        for file, checked in zip(files, in_parallel(work, files, jobs), strict=True):
            findings.append(_found(self, file, checked))
            self._report(checked, findings[-1])
        if self.format in ("json", "csv"):
            self.show(self._document(findings), "")
        elif self.format not in ("text", "none"):
            sys.stdout.write(written(findings, self.format, "check"))
        return 1 if any(each.is_wrong for each in findings) else 0

    def _report(self, checked: CheckedFile, found: Found) -> None:
        """Print what is known of a file, or keep it for the document."""
        source, text = checked.source, self.format == "text"
        notes = list(checked.notes)
        row: dict[str, object] = {
            "file": found.file,
            "dialect": checked.language,
            "notes": notes,
            "tree": checked.tree,
        }
        self._shown.files.append(row)
        self._shown.fixed += [(found.file, each) for each in checked.fixed]
        if text:
            sys.stdout.write("".join(f"{printable(f'{found.file}:{each}')}\n" for each in checked.fixed))
            complain(checked.diagnostics, source, found.path, sys.stdout)
            if not self.quiet:
                note = styled("note:", "note", wants_colour(sys.stdout))
                sys.stdout.write("".join(f"{note} {each}\n" for each in notes))
                sys.stdout.write(f"{found.file}: {self._tally(checked)}\n")
        self._show(checked, found.file)

    def _show(self, checked: CheckedFile, file: str) -> None:
        """Print what else was asked for, or keep it for the document."""
        text, colour = self.format == "text", wants_colour(sys.stdout)
        self._shown.literals += [(file, each) for each in checked.literals]
        self._shown.steps.append((file, checked.steps))
        if text and checked.source is not None:
            sys.stdout.writelines(_literal_lines(checked.source, checked.literals))
            sys.stdout.write(checked.tree or "")
        if text and checked.steps:
            sys.stdout.writelines(render_steps(dialect(checked.language), checked.steps, colour=colour))
        if checked.assumptions is not None:
            from motionlang.commands.evidence.entries import assumptions
            from motionlang.commands.evidence.view import listing

            known = assumptions()
            open_ones = [known[name] for name in checked.assumptions]
            self._shown.assumptions += [({"file": file}, each) for each in open_ones]
            sys.stdout.write(listing(open_ones, width=width_of(sys.stdout), colour=colour) if text else "")

    def _document(self, findings: Sequence[Found]) -> Document:
        """Return the findings, and the tables that are asked for."""
        from motionlang.commands.evidence.view import assumptions_table

        shown = self._shown
        about = [(each.file, diagnostic) for each in findings for diagnostic in each.diagnostics]
        names = ("file", "dialect", "notes", *(["tree"] if self.tree else []))
        tables = [diagnostics_table(about), Table("files", list(map(Column, names)), shown.files)]
        asked = {
            "fix": _by_file("fixed", ("line", "column", "code", "before", "after"), shown.fixed),
            "literals": _by_file("literals", ("address", "line", "text"), shown.literals),
            "steps": steps_table(shown.steps),
            "evidence": assumptions_table(shown.assumptions, ["file"]),
        }
        return Document([*(table for option, table in asked.items() if getattr(self, option)), *tables])

    def _tally(self, checked: CheckedFile) -> str:
        """Return the number of findings of a file, and what the option for fixes would correct."""
        fixed = f"{len(checked.fixed)} fixed, " if checked.fixed else ""
        text = f"{fixed}{tally(checked.diagnostics) or 'no problems'}"
        count = checked.fixable
        if not count:
            return text
        among = len(checked.diagnostics)
        return f"{text}; --fix corrects {'it' if among == 1 else count if count < among else 'all'}"


def findings_of(file: str) -> Found:
    """Return the errors and warnings of a program on the machine of the file next to it."""
    options = Check()
    return _found(options, file, _checked(options, file)[0])


def _found(options: Check, file: str, checked: CheckedFile) -> Found:
    """Return the findings about a file, which are possibly about its machine file."""
    name = STDIN_NAME if file == STDIN else file
    is_about_machine = checked.source is not None and checked.source.name != name_of(file)
    path = (machine_of(file, options.machine) or name) if is_about_machine else name
    return Found(name, checked.diagnostics, checked.source, path, options.strict)


def _by_file(name: str, keys: Sequence[str], found: Sequence[tuple[str, object]]) -> Table:
    """Return records, each with its file, as data."""
    rows = [{"file": file, **{key: getattr(each, key) for key in keys}} for file, each in found]
    return Table(name, list(map(Column, ("file", *keys))), rows)


def _literal_lines(source: Source, literals: Sequence[Literal]) -> Iterator[str]:
    """Return a line for each literal: its address, its number, and its line of the program."""
    width = max((len(each.address) for each in literals), default=0)
    values = max((len(each.text) for each in literals), default=0)
    for each in literals:
        line = printable(source.line(each.line).strip())
        yield f"  {each.address.ljust(width)}  {each.text.rjust(values)}  {line}\n"


def _checked_and_fixed(options: Check, file: str) -> CheckedFile:
    """Return what is known of a file after its fixes."""
    checked, program = _checked(options, file)
    if file == STDIN or program is None:
        return checked
    name, before, language = program.source.name, program, dialect(program.language)

    def made(text: str) -> Program:
        return language.program(Source(name, text), before.settings)

    def check(text: str) -> list[Diagnostic]:
        return check_program(made(text))

    def differences(text: str) -> list[Diagnostic]:
        return language.port_differences(before, made(text))

    if not options.fix:
        checked.fixable = len(fix_once(before.source.text, checked.diagnostics, check)[1])
        return checked
    try:
        fixed = fix(file, checked.diagnostics, check, differences)
        if not fixed:
            return checked
        left = _left_of_port(options, language, file, before)
    except Unfixable as reason:
        message = f"{file} is not fixed: {reason}"
        problem = Diagnostic("file", message, hint="save it in UTF-8, as lines of text", severity="warning")
        return replace(checked, diagnostics=[*checked.diagnostics, problem])
    except OSError as error:
        return replace(checked, diagnostics=[*checked.diagnostics, unwritten(file, error)])
    done, _ = _checked(options, file)
    return replace(done, fixed=fixed, diagnostics=[*done.diagnostics, *left])


def _left_of_port(options: Check, language: Dialect, file: str, before: Program) -> list[Diagnostic]:
    """Return the differences of a ported program that no fix removes, and a model of the machine file that is old."""
    now = Source.read(file)
    found = language.port_differences(before, language.program(now, before.settings))
    path = machine_of(file, options.machine)
    own = {} if path is None else read_machine(Source.read(path), language=language)
    model = own.get("controller.model", "")
    if options.model is not None and any(
        each.code == "model" for each in check_program(language.program(now, own))
    ):
        message = f'{path} is still for another controller: controller.model = "{model}"'
        hint = f'write controller.model = "{options.model}"'
        found.append(Diagnostic("model", message, hint=hint, severity="warning"))
    return found


def _checked(options: Check, file: str) -> tuple[CheckedFile, Program | None]:
    """Return what is known of a file, and its program if that could be checked."""
    language = language_of(options.lang, file)
    if language is None:
        return CheckedFile("", diagnostics=[no_dialect(file)]), None
    path = machine_of(file, options.machine)
    settings: dict[str, object] = {}
    try:
        source = read(file)
        machine = None if path is None else read(path)
    except Refused as refused:
        return CheckedFile(language.name, diagnostics=refused.diagnostics), None
    if machine is not None:
        try:
            settings = read_machine(machine, language=language)
        except ProgramError as error:
            return CheckedFile(language.name, machine, error.diagnostics), None
        axes: int = settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
        wrong = missing_axes(settings, axes, language.first_axis)
        if wrong:
            return CheckedFile(language.name, machine, wrong), None
    if options.model is not None:
        settings["controller.model"] = options.model
    program = language.program(source, settings)
    found = one_sentence(language, source, check_program(program))
    checked = CheckedFile(language.name, source, found, notes=program.notes)
    if options.literals:
        checked.literals = program.literals
    if options.evidence:
        checked.assumptions = depended_on(language, source.text, settings)
    try:
        if options.tree:
            checked.tree = render_tree(program.tree)
        if options.steps:
            checked.steps = listed_units(program.source, program.graph)
    except ProgramError:  # its errors are among the findings
        pass
    return checked, program
