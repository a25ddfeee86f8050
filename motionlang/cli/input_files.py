"""What a run reads: the program, from a file or standard input, and the machine file."""

from __future__ import annotations

import sys

from motionlang.source import STDIN, STDIN_NAME, Source, contents

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.cli.options import Options


def read_source(file: str) -> Source:
    """The program of a file, or of standard input for `-`; OSError where it cannot be read."""
    if file == STDIN:
        return Source.from_bytes(STDIN_NAME, contents(sys.stdin.buffer))
    return Source.read(file)


def read_machine_file(options: Options, settings: dict[str, object]) -> int:
    """Put the machine file's settings below those of `--set`."""
    from motionlang.cli.complaints import refuse, unreadable
    from motionlang.errors import ProgramError
    from motionlang.lang.machine.file import read_machine

    assert options.machine is not None
    try:
        source = Source.read(options.machine)
    except OSError as error:
        return refuse(options, [unreadable(options.machine, error)], None, 1)
    try:
        for key, value in read_machine(source).items():
            settings.setdefault(key, value)
    except ProgramError as error:
        return refuse(options, error.diagnostics, source, 1)
    return 0
