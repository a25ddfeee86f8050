"""A log of calls as readable MCCL.

Each line has the commands of a call, and its time after `;`.
"""

from __future__ import annotations

import re

from motionlang.kernel import Rejected
from motionlang.kernel.lang import MAX_AXES
from motionlang.kernel.mccl import Fault
from motionlang_mcapi import table as mc
from motionlang_mcapi.block import CommandBlock
from motionlang_mcapi.client import VirtualBoard
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.log import LoggedCall
from motionlang_mcapi.protocol import encode, request
from motionlang_mcapi.registry import AT_ONCE, POLLS, QUERIES
from motionlang_mcapi.session import BadCall, CallInputs, commands_for
from motionlang_mcapi.table import FUNCTIONS

# The column at which the remark begins.
COLUMN = 32


class CallListing:
    """Lists calls, on a board of the log's model, on which the commands may depend."""

    def __init__(self, model: str) -> None:
        board = VirtualBoard(
            {"controller.model": model, "controller.axes": MAX_AXES}, complain=lambda text: None
        )
        handle = board.desk.session().open(mc.MC_OPEN_BINARY)
        self._interface = handle.interface
        # A repeat is a command only in a block.
        self._interface.block = CommandBlock(handle, mc.MC_BLOCK_COMPOUND, (), [])

    def line(self, entry: LoggedCall) -> str:
        """Return the line of a call: its commands, start time, and answer.

        A call without commands is shown as a remark.
        """
        values = encode((entry.result, *entry.outputs))
        remark = f"; {entry.begin:.6f} s"
        commands = self._commands(entry)
        if not commands:
            return f"{remark} {request(entry.name, entry.handle, entry.arguments)} = {values}"
        answer = "" if values in ("0", "-") else f" = {values}"
        return f"{commands:<{COLUMN - 1}} {remark} {entry.name}{answer}"

    def _commands(self, entry: LoggedCall) -> str:
        function = FUNCTIONS[entry.name]
        try:
            given = CallInputs(function, entry.arguments)
            if function.unsupported or function.name in AT_ONCE:
                return ""
            if function.name in QUERIES or function.name in POLLS:
                return _read(function.mccl, given.by_name)
            return ",".join(each.text for each in commands_for(self._interface, function, given.by_name))
        except (BadCall, CallRefused, Fault, Rejected):
            return ""


def _read(mccl: str, given: dict[str, object]) -> str:
    """Return the table's commands with axis, channel or register filled in."""
    number = given.get("channel", given.get("reg", ""))
    axis = given.get("axis") or ""
    plain = re.sub(r"\{\w+\}", "", mccl)
    return ",".join(
        f"{axis}{each[1:]}" if each[0] == "a" else f"{each}{number}" for each in plain.split(", ") if each
    )
