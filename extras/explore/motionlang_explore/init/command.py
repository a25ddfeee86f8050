"""`motionlang init`: write a draft machine file for an existing program."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import unified_diff
from errno import ENOENT
from functools import partial
from typing import TYPE_CHECKING, ClassVar, TypeVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain, no_dialect, unreadable, unwritten
from motionlang.cli.option_groups import Language, OutputOptions, forms, read
from motionlang.cli.program_files import programs
from motionlang.cli.readers import machine_time, whole
from motionlang.cli.signals import SIGNALS
from motionlang.commands.compare.options import mapped, recorded
from motionlang.commands.run.command import RunCommand
from motionlang.commands.scenarios import scenario_folder
from motionlang.kernel import (
    MACHINE_SUFFIX,
    STDIN,
    Diagnostic,
    Program,
    ProgramError,
    Source,
    WrongEntry,
    dialect_of,
    entries,
    language_of,
    read_machine,
)
from motionlang.kernel.files import create, replacing
from motionlang.kernel.tools import count_of, nearest, need
from motionlang_explore.exploration import PIECE, Entry, Exploration, explore
from motionlang_explore.init import Draft, choices, cycle_text, draft, small_program
from motionlang_explore.init.file import also_fitting, leading, machine_text, path_text
from motionlang_explore.init.summary import motionless, notes
from motionlang_explore.playing import play_time, played_lines, playing, seconds_option
from motionlang_explore.scenario_text import inline

if TYPE_CHECKING:  # which need numpy
    from motionlang.commands.recording import Mapped
    from motionlang_explore.init.recorded.drafting import Measured
    from motionlang_explore.init.recorded.recording import MeasuredRecording

# The time limit of the machine file, s: a production loop has no end of its own.
UNTIL = 300.0
# So many cycles are asked about.
MAX_ASKED = 3

Answer = TypeVar("Answer")


@dataclass
class Init(OutputOptions, Language):
    """Write a first machine file for a program, mark the guesses, and run it."""

    title: ClassVar[str] = "program"
    epilog: ClassVar[str] = f"""\
init plays the program: where it waits, each input, key, answer, analogue
level and number of a host that it reads is changed once, to see what leads
on. It writes the world in which the likeliest cycle runs into
FILE.machine.toml next to the program, and runs it. On a terminal it asks
about the cycle and about each guess; Enter keeps it. A file that exists is
never overwritten. If the program has menus, a scenario in FILE.scenarios has
each choice that moves an axis.

The last lines say which input leads on from where, which outputs were never
switched on, the cycle, which lines command motion and moved no axis, and
which channels only a comment names. If no axis moved, they say where the
program waits, and what was tried there.

exit status: 0 the file is written and the program made a good piece in it;
1 the file exists or cannot be written, the program has an error, or its run is
none that run calls good: it ends with an error, or has a limit, a following
error or a fault; no axis moved, or only homed, though the program commands
more; or no good piece was found: it prints, in words or on the condition of an
alarm, that something is wrong, switches on an alarm by its name, prints
nothing, switches no output, or only jogs. 2 the command line is invalid

{played_lines()}
examples:
  motionlang init packer.prg
  motionlang init packer.prg --cycle 2   the world of the next likeliest cycle
  motionlang init old --format none   every program of the folder old
  motionlang init packer.prg --recording log.csv   measured rules, not guesses
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
    recording: str | None = option(
        "REC",
        "a recording of the machine, as CSV or Parquet: its inputs, outputs and positions replace guesses by "
        "measured rules",
    )
    map: list[Mapped] = option(
        "WHAT=COLUMN",
        "assign a column of the recording, by name or number, to input.3, output.1, analogue.0, position.0 or time; "
        "may be repeated",
        read=mapped,
        many=True,
    )
    update: bool = flag(
        "print what a recording, or a search with what a person has corrected, changes in the machine file that "
        "exists, as patch takes it"
    )
    write: bool = flag("with --update: write the machine file, too")
    cycle: int | None = option(
        "N",
        "write the world of the N-th cycle that the head of the file names",
        read=whole("a number of a cycle, from 1", 1, 1000),
    )
    seconds: float | None = seconds_option(PIECE)

    def check(self) -> None:
        super().check()
        if self.new and (self.typed & {"until", "seconds", "cycle", "recording"} or self.format != "text"):
            raise WrongOption(
                "--new runs nothing: it takes no --until, --seconds, --cycle, --recording or --format"
            )
        if self.update and self.recording is not None and "seconds" in self.typed:
            raise WrongOption(
                "--seconds limits a search, and --update with --recording takes what was measured"
            )
        if self.write and not self.update:
            raise WrongOption("--write writes what --update prints: give --update, too")
        if self.map and self.recording is None:
            raise WrongOption("--map assigns the columns of a recording: give --recording REC")
        if self.recording is not None and os.path.isdir(self.file):
            raise WrongOption(f"--recording is that of one program, and {self.file} is a folder")

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
        if self.update:
            return self._update(language.program(read(file), is_debug=self.recording is None), path)
        if os.path.lexists(path):
            hint = f"motionlang run {file} runs the program with it"
            if self.recording is not None:
                hint = "--update prints what the recording changes in it"
            exists = Diagnostic("file", f"{path} exists, and is not overwritten", hint=hint)
            raise Refused([exists], file=file)
        source = read(file)
        program = language.program(source, is_debug=True)
        if program.errors:
            raise Refused(program.errors, source=source, file=file)
        target = program.target
        board: dict[str, object] = {"controller.model": target.model} if target.model else {}
        measured: Measured | None = None
        if self.recording is None:
            found = self._drafted(program, board)
        else:
            measured = self._measured(program, language.program(program.source), board)
            found = measured.draft
        interrupted = found.exploration.interrupted
        if (
            interrupted is None
            and self.recording is None
            and sys.stdin is not None
            and sys.stdin.isatty()
            and sys.stdout.isatty()
        ):
            given = _ask(source, found)
            if given:
                found = self._drafted(program, board | given)
        try:
            create(path, machine_text(found, self.until, target).encode())
        except OSError as error:
            raise Refused([unwritten(path, error)], file=file) from None
        sys.stdout.write(f"{path}: written, {count_of(found.count, 'guess', 'guesses')}\n")
        if target.others:
            sys.stdout.write(f"controller.model is {target.model}; {also_fitting(target)}\n")
        if interrupted is not None:
            sys.stderr.write(f"note: cut off after {count_of(found.exploration.trials, 'trial')}\n")
            SIGNALS.end_with(interrupted)
        try:
            _write_scenarios(file, found, self.until)
        except OSError as error:
            raise Refused([unwritten(error.filename, error)], file=file) from None
        run = RunCommand(file=file, lang=self.lang, format=self.format, machine=path)
        run.given = self.given
        status = run.start()
        structure = program.on(board).structure
        sentences = [] if measured is None else measured.sentences
        sys.stderr.writelines(f"note: {each}\n" for each in [*sentences, *notes(structure, found)])
        is_bad = motionless(structure, found.run) or found.exploration.fault_of(found.run)
        return max(status, int(bool(is_bad)))

    def _measured(self, program: Program, plain: Program, board: Mapping[str, object]) -> Measured:
        """Measure the world of a program, a debug build and a plain one, in its recording; raise Refused."""
        from motionlang_explore.init.recorded.drafting import measure

        return self._in_recording(
            lambda recording: measure(
                plain, recording, board, self.until, lambda given: self._drafted(program, dict(given))
            )
        )

    def _in_recording(self, question: Callable[[MeasuredRecording], Answer]) -> Answer:
        """Return the answer to a question about the recording; raise Refused if it is none."""
        need("--recording", "numpy")
        from motionlang_explore.init.recorded.recording import measured_recording

        path = self.recording or ""
        table = recorded(path)
        try:
            recording = measured_recording(table, self.map)
            sys.stderr.write(f"{recording.sentence}\n")
            complain(recording.remarks, table.source, path)
            return question(recording)
        except ProgramError as error:
            raise Refused(error.diagnostics, source=table.source, file=path) from None

    def _update(self, program: Program, path: str) -> int:
        """Print what changes in a machine file, write it on request, and return the exit status.

        Without a recording a line without `guess = true` is true, and the rest is searched again.
        """
        from motionlang_explore.init.recorded.update import (
            FileUpdate,
            changed_in_words,
            searched,
            true_settings,
            update,
        )

        if program.errors:
            raise Refused(program.errors, source=program.source, file=self.file)
        if not os.path.lexists(path):
            missing = unreadable(path, FileNotFoundError(ENOENT, os.strerror(ENOENT)))
            missing.hint = f"motionlang init {self.file} writes it"
            raise Refused([missing], file=path)
        machine = read(path)
        try:
            settings = read_machine(machine)
        except ProgramError as error:
            raise Refused(error.diagnostics, source=machine, file=path) from None
        status = 0
        if self.recording is not None:
            found = self._in_recording(
                lambda recording: update(program, recording, machine.text, settings, self.until)
            )
        else:
            drafted = self._drafted(program, true_settings(settings))
            interrupted = drafted.exploration.interrupted
            if interrupted is not None:
                sys.stderr.write(f"note: cut off after {count_of(drafted.exploration.trials, 'trial')}\n")
                SIGNALS.end_with(interrupted)
            fault = drafted.exploration.fault_of(drafted.run)
            status = int(bool(fault))
            said = [f"no good piece was found: the best cycle {fault}"] if fault else []
            found = FileUpdate(searched(machine.text, settings, drafted.world.settings), said)
        sys.stdout.writelines(
            unified_diff(
                machine.text.splitlines(keepends=True), found.text.splitlines(keepends=True), path, path
            )
        )
        changed = changed_in_words(settings, read_machine(Source(path, found.text)))
        sentences = [*found.sentences, *([f"entries that differ: {changed}"] if changed else [])]
        sys.stderr.writelines(f"note: {each}\n" for each in sentences)
        if self.write and found.text != machine.text:
            try:
                with replacing(path) as file:
                    file.write(found.text.encode())
            except OSError as error:
                raise Refused([unwritten(path, error)], file=self.file) from None
            sys.stdout.write(f"{path}: written\n")
        return status

    def _drafted(self, program: Program, given: dict[str, object]) -> Draft:
        """Play a program in a world with the settings that a person gave, and return the draft of its machine file."""
        with playing(program.source.name) as progress:
            exploration = explore(
                program, given, progress=progress, keeps=True, **play_time(self.seconds, PIECE)
            )
        if exploration.interrupted is not None:
            return Draft(exploration, exploration.world, exploration.interrupted, given)
        found = exploration.cycles
        number = _asked_cycle(exploration) if self.cycle is None else self.cycle
        if number is not None and number > len(found):
            raise WrongOption(f"--cycle {number}: {count_of(len(found), 'cycle')} found")
        with playing(program.source.name) as progress:
            exploration.show(partial(progress, 1.0))
            return draft(exploration, None if number is None else found[number - 1], self.until, given)


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


def _write_scenarios(file: str, below: Draft, until: float) -> None:
    """Write a scenario for each way through the menus that moves an axis; existing files stay."""
    folder = scenario_folder(file)
    exploration, count = below.exploration, 0
    for choice in choices(exploration):
        world = exploration.world_of([choice.cycle], times=1)
        found = Draft(exploration, world, exploration.run(world.settings, until), below.given)
        os.makedirs(folder, exist_ok=True)
        path = os.path.join(folder, f"{choice.name}.toml")
        if not os.path.lexists(path):
            create(path, path_text(choice, found, below, until).encode())
            count += 1
    if count:
        sys.stdout.write(f"{folder}: {count_of(count, 'scenario')} written\n")


def _asked_cycle(exploration: Exploration) -> int | None:
    """Ask which cycle is to run, and return its number; None without a terminal, a choice or an answer."""
    found = [each for each in exploration.cycles if each.work][:MAX_ASKED]
    if len(found) < 2 or sys.stdin is None or not sys.stdin.isatty() or not sys.stdout.isatty():
        return None
    for number, each in enumerate(found, start=1):
        print(f"{number}  {cycle_text(exploration, each)}")
    numbers = [str(number) for number in range(1, len(found) + 1)]
    while True:
        try:
            line = input("Which is the cycle? Enter for the likeliest that repeats: ").strip()
        except EOFError:
            print()
            return None
        if not line or line in numbers:
            return int(line) if line else None
        print(f"  type a number from 1 to {len(found)}")


def _ask(source: Source, found: Draft) -> dict[str, object]:
    """Ask the user about each guess and return the settings that they gave.

    The result is empty if they pressed Enter each time.
    """
    if not found.count:
        return {}
    fixed: dict[str, list[Entry]] = {}
    print(
        f"{count_of(found.count, 'guess', 'guesses')}. Enter keeps a guess, Ctrl-D keeps all that are left."
    )
    leads = leading(found.exploration)
    inputs: dict[int, list[Entry]] = {}
    for entry in found.entries("input"):
        inputs.setdefault(int(str(entry["channel"])), []).append(entry)
    answers: dict[str, str] = {}
    for entry in found.entries("answer"):
        answers.setdefault(str(entry.get("prompt", "")), str(entry["text"]))
    try:
        for channel, mine in sorted(inputs.items()):
            for line in leads.get(channel, ()):
                print(f"  line {line}: {source.line(line).strip()}")
            given = _ask_input(channel, mine)
            if given:
                fixed.setdefault("input", []).extend(given)
        for question, text in answers.items():
            name = f'answer to "{question}"' if question else "answer"
            answer = input(f"{name}: {text}, or type a line: ").strip()
            if answer:
                entry = {"prompt": question, "text": answer} if question else {"text": answer}
                fixed.setdefault("answer", []).append(entry)
    except EOFError:
        print()
    return dict(fixed)


def _ask_input(channel: int, guess: list[Entry]) -> list[Entry]:
    """Ask about one input until the answer is empty or valid."""
    shown = inline(guess[0]) + (f" and {len(guess) - 1} more" if len(guess) > 1 else "")
    while True:
        line = input(f"input {channel}: {shown}, or type 1@0.5 or out4+0.3: ").strip()
        if not line:
            return []
        try:
            found: list[Entry] = entries({}, inputs=f"{channel}={line}")["input"]  # type: ignore[assignment]
            return found
        except WrongEntry as error:
            print(f"  {error.message}")  # the question has the forms
