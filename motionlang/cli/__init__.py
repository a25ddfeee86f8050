"""The command line: selection of the command, closed pipes and Ctrl-C.

A command is a class of typed fields, from which its options and its help follow (`command`); it is in the folder of its
question, and `commands` lists all of them. Groups of options that several commands share are in `option_groups`,
`run_command` is the base of those that run one program, `run_to_file` of those that write a file about a run. No
command of a single feature is here.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from shlex import quote

from motionlang.cli.commands import parse
from motionlang.cli.complaints import complain
from motionlang.cli.crash import CRASHED, UNAVAILABLE, crash
from motionlang.cli.signals import SIGNALS, status_of
from motionlang.cli.standard_streams import prepare, silence
from motionlang.kernel import MACHINE_SUFFIX, Diagnostic, ProgramError, Terminated, dialect_of
from motionlang.kernel.tools import missing
from motionlang.views.terminal import printable

# The exit status if the reader of standard output has gone: 128 and SIGPIPE's number, like in shells.
PIPE_CLOSED = 141
# The most programs that the welcome names, and the most files that it reads.
MAX_NAMED, MAX_FILES = 3, 10_000


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status.

    0 is success, 1 means that the program is wrong or faulted, and 2 that the command line is wrong;
    docs/commands/README.md lists the others. No error ends in a traceback.
    """
    given = sys.argv[1:] if arguments is None else list(arguments)
    try:
        with SIGNALS:
            return _guarded(given)
    except (KeyboardInterrupt, Terminated) as error:
        return status_of(error)


def _guarded(given: list[str]) -> int:
    prepare()
    try:
        status = _command(given)
        sys.stdout.flush()
    except BrokenPipeError:
        silence()
        return PIPE_CLOSED
    except OSError as error:
        # Every other file has reported its errors by now: this is standard output, for example on a full
        # disk.
        sys.stderr.write(f"motionlang: cannot write the output: {(error.strerror or str(error)).lower()}\n")
        silence()
        return 1
    except Exception as error:
        # A signal in the middle of a wait of the standard library leaves a lock that is not held.
        if type(error) is RuntimeError and isinstance(error.__context__, (KeyboardInterrupt, Terminated)):
            raise error.__context__ from None
        lacking = missing(error, " ".join(["motionlang", *given[:1]]))
        if lacking is not None:
            complain([Diagnostic("extra", lacking.message, hint=lacking.hint)], None, "")
            return UNAVAILABLE if lacking.is_required else 1
        complain([crash(error, given)], None, "")
        return CRASHED
    return status


def _command(given: Sequence[str]) -> int:
    if not given:
        sys.stderr.write(_welcome())
        return 2
    SIGNALS.defer()  # until the command can report how it ended
    command = parse(given)
    try:
        return command.start()
    except ProgramError as error:  # for a machine that cannot be built from the command line
        complain(error.diagnostics, None, "")
        return 1


def _welcome() -> str:
    """Return the text without a command, next steps; in a folder with programs it has commands for the first one."""
    found = _programs()
    lines = ["motionlang runs Mint and MCCL motion programs without the controller.", ""]
    if found:
        first = quote(printable(found[0]))
        more = f" and {len(found) - MAX_NAMED} more" if len(found) > MAX_NAMED else ""
        lines += [f"this folder has {', '.join(map(printable, found[:MAX_NAMED]))}{more}", ""]
        steps = [(f"run {first}", "run it and report what it did"), (f"check {first}", "find its errors")]
        if not os.path.exists(os.path.splitext(found[0])[0] + MACHINE_SUFFIX):
            steps.append((f"init {first}", "write a machine file for it"))
    else:
        steps = [
            ("init --new feed", "write a small program with its machine file"),
            ("init OLD.PRG", "write a machine file for a program that you have"),
            ("run PICK.MNT", "run a program"),
        ]
    steps += [("repl", "type a program line by line"), ("--help", "list all commands")]
    width = max(len(step) for step, _ in steps)
    lines += [f"  motionlang {step:<{width}}  {what}" for step, what in steps]
    return "\n".join(lines) + "\n"


def _programs() -> list[str]:
    """Return the programs of this folder by name; none if it cannot be read."""
    try:
        with os.scandir() as entries:
            names = sorted(entry.name for entry, _ in zip(entries, range(MAX_FILES), strict=False))
    except OSError:
        return []
    return [name for name in names if dialect_of(name) is not None and os.path.isfile(name)]
