"""Mint, the motion language of Baldor and ABB controllers.

`DIALECT` is its interface for programs. `PUBLIC` are the names for hosts and questions, each imported on first use.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.lang.dialect import Dialect, Interactive
from motionlang.kernel.lazy import lazy_names
from motionlang.kernel.source import Source

if TYPE_CHECKING:
    from motionlang.kernel.errors import Diagnostic
    from motionlang.kernel.lang.machine.machine import Machine
    from motionlang.kernel.lang.machine.switch import Switch
    from motionlang.kernel.lang.program import Program
    from motionlang.kernel.lang.task import Task
    from motionlang.kernel.lang.vocabulary import Vocabulary
    from motionlang.kernel.lang.wait_causes import Read
    from motionlang.kernel.mint.interactive import MintInteractive as MintInteractive
    from motionlang.kernel.mint.keywords import table as table
    from motionlang.kernel.mint.keywords.switchable import name_of as name_of
    from motionlang.kernel.mint.keywords.switchable import row_with_default as row_with_default
    from motionlang.kernel.mint.keywords.switchable import with_default as with_default
    from motionlang.kernel.mint.models import VIRTUAL as VIRTUAL
    from motionlang.kernel.mint.models import named as named
    from motionlang.kernel.mint.program import MintProgram as MintProgram
    from motionlang.kernel.mint.runtime.errors import NUMBERS as NUMBERS
    from motionlang.kernel.mint.runtime.printing import shows_float as shows_float


PUBLIC = {
    "models": "VIRTUAL named",
    "keywords": "table",
    "interactive": "MintInteractive",
    "program": "MintProgram",
    "runtime.errors": "NUMBERS",
    "runtime.printing": "shows_float",
    "keywords.switchable": "name_of row_with_default with_default",
}


class Mint(Dialect):
    """The Mint dialect.

    Axes count from 0. Every method imports what it needs.
    """

    name, title = "mint", "Mint"
    suffixes = (".mnt", ".mntx", ".prg")
    first_axis = 0
    others = "another task or an Event"
    ends_loops = "Exit Loop leaves it"
    comment = "'"

    def program(
        self, source: Source, settings: Mapping[str, object] | None = None, *, is_debug: bool = False
    ) -> MintProgram:
        from motionlang.kernel.mint.program import MintProgram

        return MintProgram(source, settings, is_debug=is_debug)

    def port_differences(self, before: Program, program: Program) -> list[Diagnostic]:
        from motionlang.kernel.mint.program import port_differences

        return port_differences(before, program)

    def compiled_in(self, key: str) -> bool:
        return key in ("controller.axes", "fault") or key.startswith("mint.")

    def opener(self, word: str) -> str:
        from motionlang.kernel.mint.syntax.blocks import CLOSERS, OPENERS

        kind = "".join(word.upper().split())
        return OPENERS.get(CLOSERS.get(kind, kind.removeprefix("END") if kind.startswith("END") else ""), "")

    def models(self) -> tuple[str, ...]:
        from motionlang.kernel.mint.models import NAMES, PRODUCTS

        return (*NAMES, *PRODUCTS)

    def knows_model(self, name: str) -> bool:
        from motionlang.kernel.mint.models import age

        return age(name) is not None

    def setting_problem(self, key: str, value: object) -> tuple[str, str] | None:
        from motionlang.kernel.mint.keywords import machine_readings
        from motionlang.kernel.mint.resolve import aliases

        checks = aliases.problem if key.startswith(aliases.SECTION) else machine_readings.problem
        return checks(key, value)

    def switches(self) -> Mapping[str, Switch]:
        from motionlang.kernel.mint.keywords.switchable import switches

        return switches()

    def driven_by(self, why: str) -> list[str]:
        import re

        from motionlang.kernel.mint.keywords import table

        found: dict[str, None] = {}
        for word, bracket in re.findall(r"([A-Za-z_]\w*)(\s*[(.[])?", why):
            row = table().get(word)
            # Without brackets a keyword that needs them is an ordinary word of the text.
            if row is not None and row.driven and (row.index == "none" or bracket or word == row.name):
                found[row.driven] = None
        return list(found)

    def triggers(self, task: Task, latches: Sequence[int]) -> tuple[frozenset[Read], str]:
        from motionlang.kernel.mint.keywords.latches import triggers
        from motionlang.kernel.mint.runtime.task import MintTask

        assert isinstance(task, MintTask)
        return triggers(task.environment, latches)

    def table(self) -> Vocabulary:
        from motionlang.kernel.mint.keywords import table

        return table()

    def locate(self, source: Source, at: int) -> tuple[int, int, int]:
        from motionlang.kernel.mint.syntax.tokens import value_length

        return (*source.location(at), value_length(source.text, at))

    def interactive(self, machine: Machine) -> Interactive:
        from motionlang.kernel.mint.interactive import MintInteractive

        return MintInteractive(machine)

    def has_code(self, line: str) -> bool:
        """True if a line has code.

        `REM x`, `rem` and `REMConfigure` are comments, like `' x`. `remaining` and `REMOTEOUT` are names.
        """
        code = line.strip()
        if code[:3].lower() != "rem":
            return bool(code) and code[0] != "'"
        joined = code[:3] == "REM" and code[3:4].isupper() and code[4:5].islower()
        return (code[3:4].isalnum() or code[3:4] == "_") and not joined

    def tokens(self, text: str) -> Iterator[tuple[str, str, int]]:
        from motionlang.kernel.mint.syntax.tokens import tokens

        return tokens(text)


DIALECT = Mint()

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)
