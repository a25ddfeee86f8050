"""`motionlang init`: write a draft machine file for an existing program."""

from __future__ import annotations

import argparse
import os
import sys

from motionlang.analysis.guesses import Entry, Guesses, answer_entry, branches, guessed
from motionlang.analysis.guesses.file import also_fitting, inline, machine_text, scenario_name, scenario_text
from motionlang.analysis.scenarios import FOLDER_SUFFIX
from motionlang.cli.complaints import complain, no_dialect, unreadable, unwritten
from motionlang.cli.dialect_option import add_dialect
from motionlang.cli.format_options import add_format
from motionlang.cli.numbers import machine_time
from motionlang.cli.options import REPORTS, Options
from motionlang.cli.parser import Commands, add_command, arrange
from motionlang.cli.program_files import programs
from motionlang.cli.run import run_command
from motionlang.cli.signals import SIGNALS
from motionlang.errors import Diagnostic, count_of
from motionlang.execution import MACHINE_SUFFIX, language_of
from motionlang.files import create
from motionlang.lang.dialect import Dialect
from motionlang.lang.loop_dependencies import InputRead
from motionlang.lang.machine.entries import WrongEntry, entries
from motionlang.source import STDIN, Source

# The time limit of the machine file, s: a production loop has no end of its own.
UNTIL = 300.0
EPILOG = """\
init runs the program and finds where it waits for its machine: for an input, for an answer to INPUT, for a key, in a
homing. It guesses what lets the program continue, writes the guesses into FILE.machine.toml next to the program, and
runs it. On a terminal it asks about each guess; Enter keeps it. A file that exists is never overwritten. If the program
has menus, init makes every choice, and writes a scenario into FILE.scenarios for each one that moves an axis.

exit status: 0 the file is written and the program ran; 1 the file exists, or the program has an error or a fault

examples:
  motionlang init packer.prg
  motionlang init old --format none        every program of the folder old
"""


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang init` and its options."""
    parser = add_command(commands, "init", summary, init_command, EPILOG)
    parser.add_argument("file", metavar="FILE", help="the program, or a folder with programs")
    add_dialect(parser)
    parser.add_argument(
        "--until",
        type=machine_time,
        default=UNTIL,
        metavar="S",
        help=f"the time limit of the machine file, in seconds of machine time ({UNTIL:.10g})",
    )
    add_format(parser, REPORTS, "what follows the program's own output, as in run")
    arrange(parser, {"program": "dialect until", "report": "format quiet output"})


def init_command(arguments: argparse.Namespace) -> int:
    """Write the machine file of a program and run it, or those of a whole folder.

    Returns the exit status.
    """
    if not os.path.isdir(arguments.file):
        return _init(arguments, arguments.file)
    found = programs([arguments.file])
    if not found:
        sys.stderr.write(f"no programs in {arguments.file}\n")
        return 1
    return max([_init(arguments, each) for each in found])


def _init(arguments: argparse.Namespace, file: str) -> int:
    language = language_of(arguments.dialect, file)
    path = os.path.splitext(file)[0] + MACHINE_SUFFIX
    if file == STDIN:
        hint = "save the program, then motionlang init FILE"
        complain(
            [Diagnostic("file", "init writes a file next to the program, not next to -", hint=hint)],
            None,
            file,
        )
        return 2
    if language is None:
        complain([no_dialect(file)], None, file)
        return 2
    if os.path.lexists(path):
        hint = f"motionlang run {file} runs the program with it"
        complain([Diagnostic("file", f"{path} exists, and is not overwritten", hint=hint)], None, file)
        return 1
    try:
        source = Source.read(file)
    except OSError as error:
        complain([unreadable(file, error)], None, file)
        return 1
    mistakes = [each for each in language.check(source, {}) if each.severity == "error"]
    if mistakes:
        complain(mistakes, source, file)
        return 1
    target = language.written_for(source)
    board: dict[str, object] = {"controller.model": target.model} if target.model else {}
    fixed = dict(board)
    reads = language.input_reads(source)
    guesses, result = guessed(source, language, arguments.until, fixed, reads)
    SIGNALS.end_with(result)
    if guesses.count and sys.stdin is not None and sys.stdin.isatty() and sys.stdout.isatty():
        given = _ask(source, guesses, reads)
        if given:
            fixed = board | given
            guesses, result = guessed(source, language, arguments.until, fixed, reads)
            SIGNALS.end_with(result)
    try:
        create(path, machine_text(source, guesses, reads, result, arguments.until, target).encode())
    except OSError as error:
        complain([unwritten(path, error)], None, file)
        return 1
    sys.stdout.write(f"{path}: written, {count_of(guesses.count, 'guess', 'guesses')}\n")
    if target.others:
        sys.stdout.write(f"controller.model is {target.model}; {also_fitting(target)}\n")
    try:
        _write_scenarios(file, source, language, arguments.until, guesses, reads)
    except OSError as error:
        complain([unwritten(error.filename, error)], None, file)
        return 1
    options = Options(file)
    options.dialect, options.report, options.machine = arguments.dialect, arguments.format, path
    options.given = arguments.given
    return run_command(options)


def _write_scenarios(
    file: str, source: Source, language: Dialect, until: float, guesses: Guesses, reads: list[InputRead]
) -> None:
    """Write a scenario for each path through the menus that moves an axis; existing files stay."""
    folder = os.path.splitext(file)[0] + FOLDER_SUFFIX
    count = 0
    for branch, result in branches(source, language, until, guesses.fixed, reads):
        SIGNALS.end_with(result)
        os.makedirs(folder, exist_ok=True)
        path = os.path.join(folder, f"{scenario_name(branch)}.toml")
        if not os.path.lexists(path):
            create(path, scenario_text(source, branch, result, until, guesses).encode())
            count += 1
    if count:
        sys.stdout.write(f"{folder}: {count_of(count, 'scenario')} written\n")


def _ask(source: Source, guesses: Guesses, reads: list[InputRead]) -> dict[str, object]:
    """Ask the user about each guess and return the settings that they gave.

    The result is empty if they pressed Enter each time.
    """
    fixed: dict[str, list[Entry]] = {}
    print(
        f"{count_of(guesses.count, 'guess', 'guesses')}. Enter keeps a guess, Ctrl-D keeps all that are left."
    )
    try:
        for channel, entry in sorted(guesses.inputs.items()):
            lines = dict.fromkeys(each.line for each in reads if each.channel == channel and each.is_input)
            for line in lines:
                print(f"  line {line}: {source.line(line).strip()}")
            given = _ask_input(channel, entry)
            if given:
                fixed.setdefault("input", []).extend(given)
        for question, texts in guesses.answers.items():
            name = f'answer to "{question}"' if question else "answer"
            answer = input(f"{name}: {texts[0]}, or type a line: ").strip()
            if answer:
                fixed.setdefault("answer", []).append(answer_entry(question, answer))
    except EOFError:
        print()
    return dict(fixed)


def _ask_input(channel: int, guess: Entry) -> list[Entry]:
    """Ask about one input until the answer is empty or valid."""
    while True:
        line = input(f"input {channel}: {inline(guess)}, or type 1@0.5 or out4+0.3: ").strip()
        if not line:
            return []
        try:
            found: list[Entry] = entries({}, inputs=f"{channel}={line}")["input"]  # type: ignore[assignment]
            return found
        except WrongEntry as error:
            print(f"  {error.message}")  # the question has the forms
