"""`motionlang init`: write a draft machine file for an existing program."""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass
from errno import ENOENT
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import no_dialect, unreadable, unwritten
from motionlang.cli.option_groups import Language, Output, forms, read
from motionlang.cli.program_files import programs
from motionlang.cli.readers import machine_time, wall_time
from motionlang.cli.signals import SIGNALS
from motionlang.commands.init import Guesses, answer_entry, branches, guessed, small_program
from motionlang.commands.init.file import also_fitting, inline, machine_text, scenario_name, scenario_text
from motionlang.commands.init.summary import motionless, notes
from motionlang.commands.run.command import Run
from motionlang.commands.scenarios import FOLDER_SUFFIX
from motionlang.commands.worlds import Entry, Worlds
from motionlang.kernel import (
    MACHINE_SUFFIX,
    STDIN,
    Diagnostic,
    Source,
    WrongEntry,
    dialect_of,
    entries,
    language_of,
)
from motionlang.kernel.files import create
from motionlang.kernel.lang import InputRead
from motionlang.kernel.tools import count_of, nearest

# The time limit of the machine file, s: a production loop has no end of its own.
UNTIL = 300.0
# The time limit of the search, s.
SECONDS = 10.0


@dataclass
class Init(Output, Language):
    """Write a first machine file for a program, mark the guesses, and run it."""

    title: ClassVar[str] = "program"
    epilog: ClassVar[str] = """\
init runs the program and finds where it waits for its machine: for an input,
for an answer to INPUT, for a key, in a homing. It guesses what lets the
program continue, writes the guesses into FILE.machine.toml next to the
program, and runs it. On a terminal it asks about each guess; Enter keeps it.
A file that exists is never overwritten. If the program has menus, init makes
every choice, and writes a scenario into FILE.scenarios for each one that
moves an axis.

The last lines say which input ended which wait, which outputs were never
switched on, how many cycles ran, which lines command motion and moved no
axis, which channels only a comment names, and whether no axis moved.

exit status: 0 the file is written and the program ran; 1 the file exists, the
program has an error or a fault, or it commands motion and no axis moved

examples:
  motionlang init packer.prg
  motionlang init old --format none   every program of the folder old
  motionlang init --new feed          write feed.mnt and feed.machine.toml
  motionlang init --new feed.mcl      the same in MCCL
"""
    file: str = argument("FILE", "the program, or a folder with programs")
    format: str = forms(
        "text", "json", "csv", "none", what="what follows the program's own output, as in run"
    )
    new: bool = flag("write a small program with its machine file; FILE without an extension is Mint")
    until: float = option(
        "S",
        f"the time limit of the machine file, in seconds of machine time ({UNTIL:.10g})",
        read=machine_time,
        default=UNTIL,
    )
    seconds: float = option(
        "S",
        f"search for at most S seconds ({SECONDS:.10g})",
        read=wall_time,
        default=SECONDS,
    )

    def check(self) -> None:
        super().check()
        if self.new and (self.typed & {"until", "seconds"} or self.format != "text"):
            raise WrongOption("--new runs nothing: it takes no --until, --seconds or --format")

    def run(self) -> int:
        """Write the machine file of a program and run it, or those of a whole folder; return the exit status."""
        if self.file == STDIN:
            hint = "save the program, then motionlang init FILE"
            found = Diagnostic("file", "init writes a file next to the program, not next to -", hint=hint)
            raise Refused([found], status=2)
        if self.new:
            small_program.write(self.file, self.lang)
            return 0
        if not os.path.isdir(self.file):
            return self._init(self.file)
        files = programs([self.file])
        if not files:
            sys.stderr.write(f"no programs in {self.file}\n")
            return 1
        return max(map(self._status, files))

    def _status(self, file: str) -> int:
        """Return the exit status of one program; the others of its folder still follow."""
        try:
            return self._init(file)
        except Refused as refused:
            return self.refuse(refused)

    def _init(self, file: str) -> int:
        if not os.path.lexists(file):
            raise Refused([_missing(file)], file=file)
        language = language_of(self.lang, file)
        path = os.path.splitext(file)[0] + MACHINE_SUFFIX
        if language is None:
            raise Refused([no_dialect(file)], file=file, status=2)
        if os.path.lexists(path):
            hint = f"motionlang run {file} runs the program with it"
            exists = Diagnostic("file", f"{path} exists, and is not overwritten", hint=hint)
            raise Refused([exists], file=file)
        source = read(file)
        program = language.program(source, is_debug=True)
        if program.errors:
            raise Refused(program.errors, source=source, file=file)
        target = program.target
        board: dict[str, object] = {"controller.model": target.model} if target.model else {}
        fixed = dict(board)
        worlds = Worlds(program, language, self.seconds)
        reads = worlds.reads
        guesses, result = guessed(worlds, self.until, fixed)
        SIGNALS.end_with(result)
        if guesses.count and sys.stdin is not None and sys.stdin.isatty() and sys.stdout.isatty():
            given = _ask(source, guesses, reads)
            if given:
                fixed = board | given
                worlds = Worlds(program, language, self.seconds)
                guesses, result = guessed(worlds, self.until, fixed)
                SIGNALS.end_with(result)
        try:
            create(path, machine_text(program, guesses, reads, result, self.until, target).encode())
        except OSError as error:
            raise Refused([unwritten(path, error)], file=file) from None
        sys.stdout.write(f"{path}: written, {count_of(guesses.count, 'guess', 'guesses')}\n")
        if target.others:
            sys.stdout.write(f"controller.model is {target.model}; {also_fitting(target)}\n")
        try:
            _write_scenarios(file, worlds, self.until, guesses)
        except OSError as error:
            raise Refused([unwritten(error.filename, error)], file=file) from None
        run = Run(file=file, lang=self.lang, format=self.format, machine=path)
        run.given = self.given
        status = run.start()
        structure = program.on(board).structure
        sys.stderr.writelines(f"note: {each}\n" for each in notes(structure, guesses, worlds, result))
        return max(status, int(motionless(structure, result)))


def _missing(file: str) -> Diagnostic:
    """Return the diagnostic of a file that does not exist, with the nearest program of its folder."""
    folder, name = os.path.split(file)
    try:
        near = nearest(name, [each for each in os.listdir(folder or ".") if dialect_of(each) is not None])
    except OSError:
        near = None
    hints = [f"did you mean {os.path.join(folder, near)}?"] if near else []
    if dialect_of(file) is not None or not os.path.splitext(file)[1]:
        hints.append(f"motionlang init --new {file} writes a small program")
    found = unreadable(file, FileNotFoundError(ENOENT, os.strerror(ENOENT)))
    found.hint = " ".join(hints)
    return found


def _write_scenarios(file: str, worlds: Worlds, until: float, guesses: Guesses) -> None:
    """Write a scenario for each path through the menus that moves an axis; existing files stay."""
    folder = os.path.splitext(file)[0] + FOLDER_SUFFIX
    count = 0
    for branch, result in branches(worlds, until, guesses.fixed):
        SIGNALS.end_with(result)
        os.makedirs(folder, exist_ok=True)
        path = os.path.join(folder, f"{scenario_name(branch)}.toml")
        if not os.path.lexists(path):
            create(path, scenario_text(worlds.source, branch, result, until, guesses).encode())
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
