"""One run of the playground: a program and its machine file, and everything the page shows of it.

The worker of the page calls `start` in the browser's Python; tests call it in any other. Messages to the page
are dictionaries of plain values, in this order: `output` while the program prints, then `asks` or `result`,
and after a result `details`. An INPUT without an answer ends a run with `asks`. The page then starts the
program again with one answer more, which costs little and gives the same output up to there: a run depends on
its text and the switches of its inputs alone.
"""

from __future__ import annotations

import re
import signal
from contextlib import contextmanager
from time import monotonic
from typing import TYPE_CHECKING, Any

from motionlang.kernel.errors import Diagnostic, OutOfTime, ProgramError
from motionlang.kernel.execution import run
from motionlang.kernel.lang import BANK
from motionlang.kernel.source import Source
from motionlang.kernel.tools import missing

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import FrameType

    from motionlang.kernel.lang.machine.machine import Machine
    from motionlang.kernel.result import Run

    Message = dict[str, Any]
    Send = Callable[[Message], object]
    Alarm = Callable[[bool], object]

# The columns of a table in a pipe, so that the page has the table of the command line.
WIDTH = 160
# Characters of output that the page gets, and seconds between two messages with output.
MAX_OUTPUT, SECONDS = 1_000_000, 0.05
# Rows of the page's own tables.
MAX_ROWS = 200
# By the language that was chosen: the page has a list where the command line has an option.
_CHOOSE = {"mint": "choose MCCL above", "mccl": "choose Mint above"}
# Seconds that a program may take.
LIMIT = 20
SOONER = "run.until in the machine file ends it at a machine time"
_OPTION = re.compile(r'--(\w+) (?:(\d+)=1@\S+|"[^"]*"|\S+)')
NO_NUMPY = "install motionlang to run it on your computer: the Python of a browser has no numpy"


class Output:
    """The output of a program, sent in chunks; beyond `MAX_OUTPUT` only counted."""

    def __init__(self, send: Send) -> None:
        self._send = send
        self._chunks: list[str] = []
        self._left, self._last, self.dropped = MAX_OUTPUT, monotonic(), 0

    def write(self, text: str) -> None:
        """Take a text of the program."""
        if len(text) > self._left:
            self.dropped += len(text) - self._left
            text = text[: self._left]
        if text:
            self._left -= len(text)
            self._chunks.append(text)
            if monotonic() - self._last > SECONDS:
                self.flush()

    def flush(self) -> None:
        """Send what was taken since the last time."""
        if self._chunks:
            self._send({"type": "output", "text": "".join(self._chunks)})
        self._chunks, self._last = [], monotonic()


class Answers:
    """The answers of the page to INPUT; `question` is set once one is missing."""

    def __init__(self, answers: list[str]) -> None:
        self._answers = iter(answers)
        self.question: str | None = None

    def next(self, machine: Machine) -> str:
        """Return the next answer; end the run if there is none."""
        for answer in self._answers:
            return answer
        self.question = machine.terminal.begun or "? "
        raise KeyboardInterrupt


def start(request: Message, send: Send, alarm: Alarm = bool) -> None:
    """Run `request`: its `name`, `dialect`, `program`, `machine`, `answers` and `inputs`.

    `machine` is the text of the machine file, blank for none; `inputs` are the channels that are switched on. The
    page raises SIGINT once `LIMIT` is over after `alarm(True)`, until `alarm(False)`.
    """
    source = Source(request["name"], request["program"])
    machine = Source(f"{request['name'].rpartition('.')[0]}.machine.toml", request["machine"])
    try:
        settings = _settings(machine, request["dialect"])
    except ProgramError as error:
        send(
            {
                "type": "result",
                "status": "fault",
                "table": "",
                **_wrong(error.diagnostics, machine, "machine"),
            }
        )
        return
    output, answers = Output(send), Answers(request.get("answers", []))

    def begun(machine: Machine) -> None:
        machine.ask = lambda: answers.next(machine)

    try:
        with _limited(alarm):
            made = run(
                source, dialect=request["dialect"], machine=settings, show=output.write, begun=begun,
                keep_crash=True, inputs=[f"{channel}=1" for channel in request.get("inputs", ())],
            )  # fmt: skip
    except Exception as error:  # before the program began, such as a machine with a motor
        send({"type": "result", "status": "fault", "table": "", **_wrong([_crash(error)], source, "program")})
        return
    output.flush()
    if answers.question is not None:
        send({"type": "asks", "question": answers.question})
        return
    for each in made.diagnostics:
        if each.code == "language":
            each.hint = _CHOOSE[request["dialect"]]
        elif each.code == "interrupted":
            each.hint = SOONER
        each.hint = _without_options(each.hint)
    results = _results(made, source)
    send(
        {
            "type": "result",
            "status": made.status,
            **results,
            "dropped": output.dropped,
            "inputs": inputs(request),
        }
    )
    send({"type": "details", **_details(made)})


def inputs(request: Message) -> list[int]:
    """Return the digital inputs that a program reads, all those of a bank; none if it has a syntax error."""
    from motionlang.kernel.lang.dialect import dialect

    try:
        program = dialect(request["dialect"]).program(Source(request["name"], request["program"]))
        uses = [use for _, use in program.structure.inputs() if use.number.isdecimal()]
    except ProgramError:
        return []
    banks = {int(use.number) for use in uses if use.channel == "input bank"}
    single = {int(use.number) for use in uses if use.channel == "input"}
    return sorted(single.union(*(range(bank * BANK, (bank + 1) * BANK) for bank in banks)))


@contextmanager
def _limited(alarm: Alarm) -> Iterator[None]:
    """Let the alarm of the page end the block as the limit of processor time of `motionlang run` does."""

    def end(number: int, frame: FrameType | None) -> None:
        raise OutOfTime(LIMIT)

    before = signal.signal(signal.SIGINT, end)
    alarm(True)
    try:
        yield
    finally:
        alarm(False)
        signal.signal(signal.SIGINT, before)


def _without_options(hint: str) -> str:
    """Return a hint on what ends a wait, with the switches and the machine file in place of options."""
    options = list(_OPTION.finditer(hint))
    if not options:
        return hint
    channels = [each[2] for each in options if each[1] == "input" and each[2]]
    if len(channels) == len(options):
        switched = f"input{'s' if len(channels) > 1 else ''} {', '.join(channels)}"
        return f"switch {switched} on, or add [[input]] to the machine file"
    entries = re.search(r"as does (.*) of the machine file", hint)
    return f"add {entries[1]} to the machine file" if entries else ""


def _settings(machine: Source, dialect: str) -> dict[str, object]:
    from motionlang.kernel.lang.dialect import dialect as language
    from motionlang.kernel.lang.machine.machine import DEFAULT_AXES, missing_axes

    if not machine.text.strip():
        return {}
    from motionlang.kernel.lang.machine.file import read_machine

    settings = read_machine(machine)
    axes: int = settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
    wrong = missing_axes(settings, axes, language(dialect).first_axis)
    if wrong:
        raise ProgramError(wrong)
    return settings


def _results(made: Run, source: Source) -> Message:
    from motionlang.kernel.failures import failed_events, located
    from motionlang.kernel.report import events
    from motionlang.views.report import render

    diagnostics = list(made.diagnostics)
    if made.crash is not None:
        diagnostics.append(_crash(made.crash))
    began = made.status != "fault" or made.time or made.controller.log.moves
    return {
        "table": render(made, width=WIDTH) if began and made.crash is None else "",
        "events": [_event(row) for row, _ in zip(events(made), range(MAX_ROWS), strict=False)],
        "event_count": len(made.machine.log.events),
        # Without their hint, an option of the command line.
        "complaints": [located(each, made) for each in failed_events(made)],
        **_wrong(diagnostics, source, "program"),
    }


def _crash(error: Exception) -> Diagnostic:
    lacking = missing(error, "this run")
    if lacking is not None:
        return Diagnostic("extra", lacking.message, hint=NO_NUMPY)
    return Diagnostic("crash", f"internal error: {error.__class__.__name__}: {error}")


def _wrong(diagnostics: list[Diagnostic], source: Source, tab: str) -> Message:
    """Return diagnostics as text and as marks in the editor of a tab."""
    from motionlang.views.diagnostics import render_all

    return {
        "diagnostics": render_all(diagnostics, source, name=source.name) if diagnostics else "",
        "marks": [{"tab": tab, "length": each.length, **each.as_dict()} for each in diagnostics],
    }


def _event(row: Message) -> Message:
    limits = {name: row[name] for name in ("axis", "value", "limit") if name in row}
    about = ", ".join(f"{name} {value:g}" for name, value in limits.items())
    return {
        "time": row["time"],
        "line": row["line"],
        "kind": row["kind"],
        "text": "; ".join(filter(None, (about, row.get("text", "")))),
    }


def _details(made: Run) -> Message:
    """Return the scope page and the lines by their time; a sentence in place of a page that is too long."""
    from motionlang.commands.profile.profile import TimeProfile
    from motionlang.commands.scope import page

    if made.crash is not None or not made.time:
        return {"scope": "", "no_scope": "", "lines": []}
    try:
        scope, no_scope = page(made), ""
    except ValueError as error:
        scope, no_scope = "", str(error)
    profile = TimeProfile(made)
    lines = [
        {
            "line": share.line,
            "seconds": share.seconds,
            "share": share.seconds / profile.seconds if profile.seconds else 0.0,
            "text": made.source.line(share.line).strip(),
        }
        for share in profile.lines()[:MAX_ROWS]
        if share.line and share.seconds
    ]
    return {"scope": scope, "no_scope": no_scope, "lines": lines}
