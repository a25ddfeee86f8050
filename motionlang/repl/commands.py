"""Commands of the prompt itself.

They begin with a dot, with which no statement of either language begins.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from os.path import expanduser
from textwrap import wrap
from typing import TYPE_CHECKING

from motionlang.commands.help.view import listing, page
from motionlang.kernel import (
    ONE_SHIFT,
    Diagnostic,
    Rejected,
    Run,
    Source,
    WrongEntry,
    dialect,
    dialect_of,
    entries,
)
from motionlang.kernel.files import reason
from motionlang.kernel.tools import as_hint, missing, nearest
from motionlang.repl import debugging, status
from motionlang.views.chart import velocity_chart
from motionlang.views.figure_files import write_figure
from motionlang.views.report import render

if TYPE_CHECKING:
    from motionlang.repl.session import Session

Obey = Callable[["Session", str], None]

# A space at which no line is wrapped.
_FIXED = "\u00a0"
_MORE = ".help input explains a group, .help .run a command, .help WORD a keyword."


@dataclass(frozen=True, slots=True)
class PromptCommand:
    """A command of the prompt, with its argument as shown in the help.

    `X` is a required argument, `[X]` an optional one, and an empty text means none.
    """

    name: str
    argument: str
    help: str
    obey: Obey

    @property
    def usage(self) -> str:
        return f".{self.name} {self.argument}".rstrip()


def is_command(line: str) -> bool:
    """True if a line is a command of the prompt rather than a statement."""
    text = line.lstrip()
    return text[:1] == "." and text[1:2].isalpha()


def without_dot(line: str) -> str:
    """Return the dot command that a rejected line most likely means, or ""."""
    word, _, argument = line.strip().partition(" ")
    command = COMMANDS.get({"exit": "quit", "bye": "quit", "?": "help"}.get(word.lower(), word.lower()))
    if command is None or (argument and (word == "?" or not command.argument)):
        return ""
    return f".{command.name} {argument}".rstrip()


def obey(session: Session, line: str) -> None:
    """Carry out a dot command."""
    word, _, argument = line[1:].partition(" ")
    argument = argument.replace("\0", "").strip()  # no system has a file with a NUL in its name
    command = COMMANDS.get(word.lower())
    if command is None:
        near = nearest(word, COMMANDS)
        hint = f"did you mean .{near}?" if near else ".help lists the commands"
        _wrong(session, "unknown-word", f"there is no command .{word}", hint)
    elif (argument and not command.argument) or (not argument and command.argument[:1].isalpha()):
        _wrong(session, "values", f"usage: {command.usage}", as_hint(command.help))
    else:
        try:
            command.obey(session, argument)
        except ImportError as error:
            lacking = missing(error, f".{command.name}")
            if lacking is None:
                raise
            _wrong(session, "extra", lacking.message, lacking.hint)


def _wrong(session: Session, code: str, message: str, hint: str = "") -> None:
    session.trouble([Diagnostic(code, message, hint=hint)])


def _help(session: Session, word: str) -> None:
    if word:
        _help_on(session, word)
        return
    usages = {group: "  ".join(each.usage.replace(" ", _FIXED) for each in GROUPS[group]) for group in GROUPS}
    session.write(columns(usages.items(), session.width))
    session.write("\n".join(["", *wrap(_MORE, min(session.width, 80))]) + "\n")


def _help_on(session: Session, word: str) -> None:
    """Explain a command, a group of commands, a keyword and a group of keywords, whichever has this name."""
    command = COMMANDS.get(word.lstrip(".").lower()) if word.startswith(".") else None
    if command is not None:
        session.write(columns([(command.usage, command.help)], session.width))
        return
    table = session.dialect.table()
    group, row, rows = GROUPS.get(word.lower(), ()), table.get(word), table.group(word)
    if group:
        session.write(columns([(each.usage, each.help) for each in group], session.width))
    if row is not None:
        session.write(page([row], session.dialect.name, width=session.width, colour=session.colour))
    elif rows:
        session.write(listing(rows, session.dialect.name, width=session.width, colour=session.colour))
    elif not group:
        near = nearest(word, (*GROUPS, *table.names()))
        _wrong(session, "unknown-word", f"{word} is not a keyword", f"did you mean {near}?" if near else "")


def columns(rows: Iterable[tuple[str, str]], width: int) -> str:
    """Return names and texts in two columns, wrapped at words to `width`, at most 80."""
    rows = list(rows)
    indent = max(len(name) for name, _ in rows) + 2
    lines: list[str] = []
    for name, text in rows:
        room = max(min(width, 80) - indent, 20)
        first, *more = wrap(text, room, break_on_hyphens=False)
        lines += [f"{name.ljust(indent)}{first}", *(" " * indent + each for each in more)]
    return "\n".join(lines).replace(_FIXED, " ") + "\n"


def _axes(session: Session, _: str) -> None:
    session.write(status.table(*session.shown))


def _time(session: Session, _: str) -> None:
    session.write(status.one_line(*session.shown) + "\n")


def _own_time(session: Session) -> None:
    """Show the session's machine, whose time has passed, and not that in the debugger."""
    session.write(status.one_line(session.machine, session.machine.clock.now) + "\n")


def _run(session: Session, argument: str) -> None:
    try:
        seconds = float(argument)
    except ValueError:
        seconds = -1.0
    if not 0.0 <= seconds <= ONE_SHIFT:
        _wrong(session, "range", f".run takes 0 to {ONE_SHIFT:.10g} seconds, not {argument}", ".run 0.5")
        return
    if session.runner.pass_time(seconds):
        _own_time(session)


def _settle(session: Session, _: str) -> None:
    if session.runner.settle():
        _own_time(session)


def _live(session: Session, argument: str) -> None:
    if session.live is None:
        _wrong(session, "not-simulated", ".live needs a terminal", "use .run S to let time pass")
    elif argument.lower() in ("on", "off"):
        session.live = argument.lower() == "on"
    else:
        _wrong(session, "range", f".live is on or off, not {argument}")


def _adds(kind: str) -> Obey:
    """Return the command that adds entries to the world of the machine; times are relative to now."""

    def add(session: Session, text: str) -> None:
        try:
            session.machine.add_entries(entries(session.machine.settings, **{kind: text}))
        except WrongEntry as error:
            _wrong(session, "option", error.message, error.hint)

    return add


def _report(session: Session, _: str) -> None:
    session.write(render(_so_far(session), width=session.width, colour=session.colour))


def _plot(session: Session, path: str) -> None:
    if not path:
        _chart(session)
    elif path.lower().endswith((".png", ".svg")):
        _picture(session, expanduser(path))
    else:
        _wrong(session, "file", f"{path} is neither a .png nor a .svg file")


def _chart(session: Session) -> None:
    controller = session.machine.controller
    for number in sorted({move.axis for move in controller.log.moves}):
        lines = velocity_chart(
            controller.axes[number],
            controller.clock.now,
            width=session.width,
            height=6,
            colour=session.colour,
        )
        session.write("\n".join([f"velocity of axis {number}, uu/s", *lines]) + "\n")
    if not controller.log.moves:
        session.write("no axis has moved\n")


def _picture(session: Session, path: str) -> None:
    from motionlang.commands.plot.view import run_figure

    try:
        write_figure(run_figure(_so_far(session)), path)
    except OSError as error:
        _wrong(session, "file", f"{path} cannot be written: {reason(error)}")


def _so_far(session: Session) -> Run:
    run = Run(Source("session", ""), session.dialect, session.machine)
    run.status, run.time = "open", session.machine.controller.clock.now
    return run


def load_file(session: Session, path: str) -> None:
    """Run the program in a file; existing names and the machine are preserved."""
    try:
        source = Source.read(expanduser(path))
    except OSError as error:
        _wrong(session, "file", f"{path} cannot be read: {reason(error)}")
        return
    other = dialect_of(path)
    if other is not None and other is not session.dialect:
        _wrong(
            session,
            "language",
            f"{path} is {other.title}, not {session.dialect.title}",
            f".{other.name} switches the prompt to {other.title}",
        )
    else:
        session.load(source)


def _reset(session: Session, _: str) -> None:
    session.reset()


def _switches_to(name: str) -> Obey:
    def switch(session: Session, _: str) -> None:
        language = dialect(name)
        if language is session.dialect:
            session.write(f"-- this prompt is {language.title} already\n")
            return
        try:
            session.switch(language)
        except Rejected as rejected:
            _wrong(session, rejected.code, rejected.message, rejected.hint)
        else:
            session.write(f"-- {language.title}, on a new machine at 0 s\n")

    return switch


def _quit(session: Session, _: str) -> None:
    session.over = True


GROUPS: dict[str, tuple[PromptCommand, ...]] = {
    "prompt": (
        PromptCommand("help", "[WORD]", "Show this list, or explain a keyword, a command or a group.", _help),
        PromptCommand("load", "FILE", "Run a program; its names and the machine state stay.", load_file),
        PromptCommand(
            "mint", "", "Switch the prompt to Mint, on a new machine at 0 s.", _switches_to("mint")
        ),
        PromptCommand(
            "mccl", "", "Switch the prompt to MCCL, on a new machine at 0 s.", _switches_to("mccl")
        ),
        PromptCommand("reset", "", "Power up again: machine time zero, no names, no moves.", _reset),
        PromptCommand("quit", "", "Leave, like Ctrl-D.", _quit),
    ),
    "time": (
        PromptCommand("run", "S", "Let S seconds of machine time pass.", _run),
        PromptCommand("settle", "", "Run until the motion ends.", _settle),
        PromptCommand("live", "on|off", "Let machine time follow real time.", _live),
        PromptCommand("time", "", "Show machine time and positions in one line.", _time),
    ),
    "input": (
        PromptCommand(
            "input",
            "N=V@S",
            "A digital input: 2=1 now, 2=1@0.5 in 0.5 s, 2=1@0.5..0.9 a pulse.",
            _adds("inputs"),
        ),
        PromptCommand(
            "analog", "N=V@S", "An analogue input, in percent: 0=25 now, 0=25@1 in 1 s.", _adds("analog")
        ),
        PromptCommand(
            "answer",
            "TEXT",
            "The line for the next INPUT; PROMPT=TEXT for one that asks PROMPT.",
            _adds("answers"),
        ),
        PromptCommand(
            "keys", "TEXT@S", "Keys that the operator presses: R now, R@0.5 in 0.5 s.", _adds("keys")
        ),
    ),
    "result": (
        PromptCommand("axes", "", "Show every axis in use: position, velocity, target, state.", _axes),
        PromptCommand(
            "report", "", "List every move so far: distance, duration, peak speed, phases.", _report
        ),
        PromptCommand(
            "plot",
            "[FILE]",
            "Chart the velocities so far, or draw everything into a .png or .svg file.",
            _plot,
        ),
    ),
    "debug": (
        PromptCommand(
            "debug",
            "[FILE]",
            "Stop a program before its first statement; again: run its new text.",
            debugging.debug,
        ),
        PromptCommand(
            "break",
            "[WHERE]",
            "A breakpoint: 12, 12 if n > 3, position(0) > 120; none lists, off removes.",
            debugging.break_,
        ),
        PromptCommand("go", "", "Run to the next breakpoint, limit, fault or error.", debugging.go),
        PromptCommand("step", "", "Run to the next statement, also into a sub.", debugging.step),
        PromptCommand("over", "", "Run to the next statement, over a sub.", debugging.over),
        PromptCommand("back", "", "Go back to the statement before.", debugging.back),
        PromptCommand("reverse", "", "Go back to the breakpoint before.", debugging.reverse),
        PromptCommand(
            "goto", "S", "Go to a time, forward or back; line 12: to its next start.", debugging.goto
        ),
        PromptCommand(
            "changed", "X", "Go back to the last change of n, output 2, input 5 or axis 0.", debugging.changed
        ),
        PromptCommand(
            "change",
            "N TEXT",
            "Replace line N of the program, and run it to the same time.",
            debugging.change,
        ),
        PromptCommand(
            "vars",
            "[X]",
            "Show the state at the stop, or X; X = 5 sets a variable. Without a program, show what you assigned.",
            debugging.vars_,
        ),
    ),
}
COMMANDS: dict[str, PromptCommand] = {each.name: each for group in GROUPS.values() for each in group}
