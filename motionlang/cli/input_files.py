"""The inputs of a run: program (a file or standard input) and machine file."""

from __future__ import annotations

import sys

from motionlang.execution import language_of
from motionlang.source import STDIN, STDIN_NAME, Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.cli.options import Options


def read_source(file: str) -> Source:
    """Return the program of a file, or of standard input for `-`; may raise OSError."""
    if file == STDIN:
        return Source.from_file(STDIN_NAME, sys.stdin.buffer)
    return Source.read(file)


def read_machine_file(options: Options, settings: dict[str, object]) -> int:
    """Merge the machine file's settings with those of `--set`, which take precedence."""
    from motionlang.errors import ProgramError
    from motionlang.lang.machine.file import read_machine

    assert options.machine is not None
    try:
        source = Source.read(options.machine)
    except OSError as error:
        from motionlang.cli.complaints import refuse, unreadable

        return refuse(options, [unreadable(options.machine, error)], None, 1)
    try:
        for key, value in read_machine(source, language=language_of(options.dialect, options.file)).items():
            settings.setdefault(key, value)
    except ProgramError as error:
        from motionlang.cli.complaints import refuse

        return refuse(options, error.diagnostics, source, 1)
    return 0
