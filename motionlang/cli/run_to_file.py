"""The base of the commands that write a file about a run."""

from __future__ import annotations

import sys
from dataclasses import dataclass

from motionlang.cli.command import Refused, argument
from motionlang.cli.option_groups import forms
from motionlang.cli.output_files import written
from motionlang.cli.run_command import Simulated
from motionlang.kernel import STDIN, Diagnostic
from motionlang.kernel import Run as Result
from motionlang.kernel.files import same_file


@dataclass
class RunToFile(Simulated):
    """A command that writes a file about a run, and reports the run only on request."""

    out: str = argument("OUT", "the file to write")
    format: str = forms("none", "text", "json", "csv", what="the report of the run")

    def prepare(self) -> None:
        refuse_input(self, self.out)

    def after(self, result: Result) -> int:
        sys.stdout.flush()
        return written(self.out, lambda: self.write(result))

    def write(self, result: Result) -> None:
        """Write the file."""
        raise NotImplementedError


def refuse_input(command: Simulated, path: str) -> None:
    """Refuse a file to write that the run reads."""
    inputs = {
        "the program": None if command.file == STDIN else command.file,
        "the machine file": command.machine_path(),
        "the nv data": command.nv,
    }
    for what, used in inputs.items():
        if used is not None and same_file(path, used):
            found = Diagnostic("file", f"{path} is {what} of this run", hint="write to another file")
            raise Refused([found], file=command.file)
