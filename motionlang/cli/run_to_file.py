"""The base of the commands that write a file about a run."""

from __future__ import annotations

import sys
from dataclasses import dataclass

from motionlang.cli.command import argument
from motionlang.cli.option_groups import forms
from motionlang.cli.output_files import written
from motionlang.cli.run_command import Simulated
from motionlang.kernel import Run as Result


@dataclass
class RunToFile(Simulated):
    """A command that writes a file about a run, and reports the run only on request."""

    out: str = argument("OUT", "the file to write")
    format: str = forms("none", "text", "json", "csv", what="the report of the run")

    def after(self, result: Result) -> int:
        sys.stdout.flush()
        return written(self.out, lambda: self.write(result))

    def write(self, result: Result) -> None:
        """Write the file."""
        raise NotImplementedError
