"""`motionlang verify`: run programs and compare them with their golden files."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain, no_dialect, unreadable, unwritten
from motionlang.cli.crash import crash
from motionlang.cli.golden import differences, golden_files, programs, update
from motionlang.cli.verify_besides import Besides, expectations, tell
from motionlang.errors import ProgramError
from motionlang.execution import dialect_of, machine_of, run
from motionlang.source import Source

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.result import Run


def verify_command(paths: Sequence[str], rewrite: bool) -> int:
    """Verify programs, or write their golden files anew; 1 where one differs, cannot be read or has none."""
    found = programs(paths)
    if not found:
        sys.stderr.write(f"no programs in {', '.join(paths)}\n")
        return 1
    failed, besides = 0, Besides()
    for program in found:
        failed += _update(program) if rewrite else _verify(program)
        besides.check(program, rewrite)
    good = f"{len(found) - failed} of {len(found)} programs{besides.summary()}"
    failed += sum(1 for each in besides.failed.values() if each)
    sys.stdout.write(f"{good} {'have their golden files' if rewrite else 'as their golden files say'}\n")
    return 1 if failed else 0


def _verify(program: str) -> bool:
    """Whether a program failed."""
    if not _is_readable(program):
        return True
    report, _ = golden_files(program)
    if not os.path.exists(report):
        sys.stdout.write(f"{program}: no {os.path.basename(report)} beside it; --update writes one\n")
        return True
    result = _ran(program)
    if result is None:
        return True
    try:
        found = differences(program, result)
    except OSError as error:
        complain([unreadable(str(error.filename), error)], None, program)
        return True
    except ValueError as error:
        sys.stdout.write(f"{program}: {os.path.basename(report)} is not JSON: {error}\n")
        return True
    return tell(program, expectations(result) + found)


def _update(program: str) -> bool:
    """Whether a program's golden files could not be written."""
    result = _ran(program) if _is_readable(program) else None
    if result is None:
        return True
    try:
        if update(program, result):
            sys.stdout.write(f"{program}: written\n")
    except OSError as error:
        complain([unwritten(str(error.filename), error)], None, program)
        return True
    return False


def _ran(program: str) -> Run | None:
    """The run of a program; None where it, or the machine file beside it, cannot be read."""
    try:
        return run(program, cache=False)
    except OSError as error:
        complain([unreadable(str(error.filename or program), error)], None, program)
    except ProgramError as error:
        machine = machine_of(program)
        complain(error.diagnostics, Source.read(machine) if machine else None, machine or program)
    except (
        Exception
    ) as error:  # a mistake of motionlang's own is no reason to leave out the programs behind it
        complain([crash(error, (program,))], None, program)
    return None


def _is_readable(program: str) -> bool:
    if not os.path.exists(program):
        complain([unreadable(program, FileNotFoundError(2, "no such file or directory"))], None, program)
        return False
    if dialect_of(program) is None:
        complain([no_dialect(program)], None, program)
        return False
    return True
