"""`motionlang check`: errors and warnings of every file, without a run."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from functools import partial

from motionlang.cli.complaints import complain, no_dialect, unreadable, unwritten
from motionlang.cli.dialect_option import add_dialect
from motionlang.cli.findings_options import add_form
from motionlang.cli.fix import Fixed, fix
from motionlang.cli.input_files import read_source
from motionlang.cli.parallel import add_jobs, in_parallel
from motionlang.cli.parser import Commands, add_all, add_command, arrange, flag, option
from motionlang.cli.program_files import programs
from motionlang.errors import Diagnostic, ProgramError
from motionlang.execution import language_of, machine_of
from motionlang.lang.dialect import dialect, unknown_model
from motionlang.lang.foreign import one_sentence
from motionlang.lang.machine.axes import missing_axes
from motionlang.lang.machine.file import read_machine
from motionlang.lang.machine.machine import DEFAULT_AXES
from motionlang.mccl.models import MODELS
from motionlang.record import record
from motionlang.source import STDIN, STDIN_NAME, Source, name_of
from motionlang.views.diagnostics import tally
from motionlang.views.findings import Found, written
from motionlang.views.terminal import printable, styled, wants_colour, width_of

SCHEMA = "motionlang.check/3"
GROUPS = {
    "program": "dialect machine model",
    "checks": "strict fix evidence literals steps",
    "report": "format quiet output jobs",
}
EPILOG = """\
Warnings point out code that compiles but is probably a mistake: a move that no GO starts, a wait that nothing can
end. docs/lint.md explains each warning. A comment with `lint: ignore CODE` silences a warning on its line.

exit status: 0 no errors; 1 a file has an error (with --strict, or a warning); 2 the command line is invalid

examples:
  motionlang check pick.mnt --machine cell.toml      find moves beyond the travel of the machine
  motionlang check old.prg --model mintmt            find what MintMT does not accept
"""


@record
class CheckOptions:
    """The options of a check.

    `strict` counts warnings as errors, `evidence` lists open assumptions. `literals` lists the numbers of each
    program by address, `steps` its steps. `fix` writes unambiguous fixes. `quiet` prints the diagnostics only. `form`
    is one of `views.findings.FORMATS`, `jobs` the number of processes, 0 for the number of cores.
    """

    dialect: str | None = None
    form: str = "text"
    jobs: int = 0
    machine: str | None = None
    model: str | None = None
    strict: bool = False
    evidence: bool = False
    fix: bool = False
    literals: bool = False
    steps: bool = False
    quiet: bool = False


_OPTIONS = (
    option("files", "FILE", "programs, or folders of programs; default: this folder; - reads standard input",
           nargs="*", default=["."]),
    option("--machine", "M.toml", "the machine file; default: pick.machine.toml next to pick.mnt, if it exists"),
    option("--model", "MODEL", "the controller model: mint4, mintmt or a product name such as NextMove ESB; for MCCL "
           f"one of {', '.join(MODELS)}"),
    flag("--strict", "treat warnings as errors"),
    flag("--evidence", "list the unconfirmed assumptions that each program depends on, and the evidence for each"),
    flag("--literals", "list the numbers of each program by the addresses that --set and --vary take, such as "
         "SPEED[0]@12"),
    flag("--steps", "print the steps that a run takes beside the lines of each program that has no error"),
    flag("--fix", "fix what has only one possible fix, in the files, then report the rest"),
)  # fmt: skip


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang check` and its options."""
    parser = add_command(commands, "check", summary, _check_files, EPILOG)
    add_dialect(parser)
    add_all(parser, _OPTIONS)
    add_form(parser, "print the diagnostics only")
    add_jobs(parser)
    arrange(parser, GROUPS)


def _check_files(arguments: argparse.Namespace) -> int:
    options = CheckOptions(
        arguments.dialect,
        form=arguments.format,
        jobs=arguments.jobs,
        machine=arguments.machine,
        model=arguments.model,
        strict=arguments.strict,
        evidence=arguments.evidence,
        literals=arguments.literals,
        steps=arguments.steps,
        fix=arguments.fix,
        quiet=arguments.quiet,
    )
    _check_model(arguments)
    return check_command(arguments.files, options)


def _check_model(arguments: argparse.Namespace) -> None:
    """End the command with status 2 if the model is one of no language of the files."""
    if arguments.model is None:
        return
    languages = dict.fromkeys(language_of(arguments.dialect, file) for file in programs(arguments.files))
    problems = [unknown_model(arguments.model, each) for each in languages]
    if problems and all(problems):
        problem = problems[0] if len(problems) == 1 else unknown_model(arguments.model)
        assert problem is not None
        arguments.parser.error(f"argument --model: {'; '.join(problem)}")


def check_command(files: Sequence[str], options: CheckOptions) -> int:
    """Check files and the programs of folders; 1 if any has an error.

    Diagnostics and one line per file go to standard output.
    """
    rows: list[dict[str, object]] = []
    wrong = False
    found_files = programs(files)
    if not found_files:
        sys.stderr.write(f"no programs in {', '.join(files)}\n")
        return 1
    document: list[Found] = []
    jobs = 1 if STDIN in found_files else options.jobs
    for file, (language, source, settings, diagnostics, fixed) in zip(
        found_files, in_parallel(partial(_checked_and_fixed, options=options), found_files, jobs), strict=True
    ):
        wrong = wrong or any(options.strict or each.severity == "error" for each in diagnostics)
        name = STDIN_NAME if file == STDIN else file
        is_about_machine = source is not None and source.name != name_of(file)
        path = (machine_of(file, options.machine) or name) if is_about_machine else name
        if options.form not in ("text", "json"):
            document.append(Found(name, diagnostics, source, path, options.strict))
            continue
        remarks: list[str] = []
        if source is not None and settings is not None:
            remarks = dialect(language).remarks(source, settings)
        if fixed and options.form == "text":
            sys.stdout.write("".join(f"{printable(f'{name}:{each}')}\n" for each in fixed))
        if options.form == "text":
            complain(diagnostics, source, path, sys.stdout)
            for remark in () if options.quiet else remarks:
                sys.stdout.write(f"{styled('note:', 'note', wants_colour(sys.stdout))} {remark}\n")
        found = [each.as_dict() for each in diagnostics]
        rows.append({"program": name, "dialect": language, "diagnostics": found})
        if remarks:
            rows[-1]["notes"] = remarks
        if options.fix:
            rows[-1]["fixed"] = [each._asdict() for each in fixed]
        if options.form == "text" and not options.quiet:
            fixes = f"{len(fixed)} fixed, " if fixed else ""
            fixable = "" if options.fix or file == STDIN else _fixable(diagnostics)
            sys.stdout.write(f"{name}: {fixes}{tally(diagnostics) or 'no problems'}{fixable}\n")
        if options.literals and source is not None and language:
            _list_literals(language, source, rows[-1], options.form == "json")
        if options.steps and source is not None and settings is not None:
            _list_steps(language, source, settings, rows[-1], options.form == "json")
        if options.evidence and settings is not None and source is not None:
            _report_evidence(language, source, settings, rows[-1], options.form == "json")
    if options.form == "json":
        import json

        sys.stdout.write(json.dumps({"schema": SCHEMA, "files": rows}, indent=1) + "\n")
    elif options.form != "text":
        sys.stdout.write(written(document, options.form, "check"))
    return 1 if wrong else 0


def _fixable(diagnostics: Sequence[Diagnostic]) -> str:
    """Return what `--fix` would correct, or ""."""
    count = len([each for each in diagnostics if each.fix])
    if not count:
        return ""
    return (
        f"; --fix corrects {'it' if len(diagnostics) == 1 else count if count < len(diagnostics) else 'all'}"
    )


def _list_literals(language: str, source: Source, row: dict[str, object], as_json: bool) -> None:
    """Print the literals of a program, or put them into its row."""
    from motionlang.lang.literals import literals

    found = literals(source, dialect(language))
    if as_json:
        row["literals"] = [{"address": each.address, "line": each.line, "value": each.text} for each in found]
        return
    width = max((len(each.address) for each in found), default=0)
    values = max((len(each.text) for each in found), default=0)
    for each in found:
        sys.stdout.write(
            f"  {each.address.ljust(width)}  {each.text.rjust(values)}  {printable(source.line(each.line).strip())}\n"
        )


def _list_steps(
    language: str, source: Source, settings: dict[str, object], row: dict[str, object], as_json: bool
) -> None:
    """Print the steps of a program without errors beside its lines, or put them into its row."""
    from motionlang.views.steps import render_steps, steps_as_dicts

    try:
        units = dialect(language).step_list(source, settings)
    except ProgramError:  # its errors are among the findings
        return
    if as_json:
        row["steps"] = steps_as_dicts(units)
    else:
        sys.stdout.writelines(render_steps(dialect(language), units, colour=wants_colour(sys.stdout)))


def _report_evidence(
    language: str, source: Source, settings: dict[str, object], row: dict[str, object], as_json: bool
) -> None:
    """Print a program's open assumptions with their evidence, or add them to its row."""
    from motionlang.assumptions.entries import assumptions
    from motionlang.assumptions.used import depended_on
    from motionlang.views.assumptions import as_dict, listing

    known = assumptions()
    found = [known[name] for name in depended_on(dialect(language), source.text, settings)]
    if as_json:
        row["assumptions"] = [as_dict(each) for each in found]
    else:
        sys.stdout.write(listing(found, width=width_of(sys.stdout), colour=wants_colour(sys.stdout)))


def _checked_and_fixed(
    file: str, options: CheckOptions
) -> tuple[str, Source | None, dict[str, object] | None, list[Diagnostic], list[Fixed]]:
    """Return the findings of `_check`, and the fixes that `--fix` made beforehand."""
    found = _check(file, options)
    language, source, settings, diagnostics = found
    if not options.fix or file == STDIN or settings is None or source is None:
        return (*found, [])
    name = source.name

    def check(text: str) -> list[Diagnostic]:
        return dialect(language).check(Source(name, text), settings)

    try:
        fixed = fix(file, diagnostics, check)
    except OSError as error:
        return (*found[:3], [*found[3], unwritten(file, error)], [])
    return (*(_check(file, options) if fixed else found), fixed)


def _check(
    file: str, options: CheckOptions
) -> tuple[str, Source | None, dict[str, object] | None, list[Diagnostic]]:
    """Return language, source, machine settings and diagnostics of a program.

    The source is the file that the diagnostics are about: the program or its machine file. The settings are None
    if the program could not be checked.
    """
    language = language_of(options.dialect, file)
    if language is None:
        return "", None, None, [no_dialect(file)]
    try:
        source = read_source(file)
    except OSError as error:
        return language.name, None, None, [unreadable(file, error)]
    path = machine_of(file, options.machine)
    settings: dict[str, object] = {}
    if path is not None:
        try:
            machine = Source.read(path)
        except OSError as error:
            return language.name, None, None, [unreadable(path, error)]
        try:
            settings = read_machine(machine, language=language)
        except ProgramError as error:
            return language.name, machine, None, error.diagnostics
        axes: int = settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
        wrong = missing_axes(settings, axes, language.first_axis)
        if wrong:
            return language.name, machine, None, wrong
    if options.model is not None:
        settings["controller.model"] = options.model
    found = one_sentence(language, source, language.check(source, settings))
    return language.name, source, settings, found
