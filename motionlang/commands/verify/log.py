"""A log of MCAPI calls as a golden file: its replay must show no difference."""

from __future__ import annotations

import os

from motionlang.cli.complaints import unreadable
from motionlang.commands.verify.verdict import Verdict
from motionlang.kernel.errors import ProgramError, Rejected
from motionlang.kernel.execution import machine_of, settings_next_to
from motionlang.kernel.source import Source


def verify_log(path: str) -> Verdict:
    """Replay a log on the machine of the file next to it, or of the log's model."""
    from motionlang.hosts.mcapi.log import BadLog
    from motionlang.hosts.mcapi.replay import call_of, replay_file

    verdict = Verdict(path, "log")
    try:
        replay = replay_file(path, settings_next_to(path))
    except BadLog as problem:
        verdict.fail(f"line {problem.line}: {problem}")
    except Rejected as rejected:
        verdict.fail(rejected.message)
    except OSError as error:
        verdict.refuse([unreadable(str(error.filename or path), error)])
    except ProgramError as error:
        machine = machine_of(path)
        verdict.refuse(error.diagnostics, Source.read(machine) if machine else None, machine or "")
    else:
        if replay.first is not None:
            first = replay.first
            where = f"{os.path.basename(path)}:{first.entry.line}"
            verdict.report([f"{where}: {call_of(first.entry)}: {first.text}", replay.summary])
    return verdict
