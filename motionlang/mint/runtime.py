"""A compiled Mint program: started on a machine, or kept as bytes for the next run."""

from __future__ import annotations

from motionlang.lang.program import Program
from motionlang.mint.environment import Environment, MintTask

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from types import CodeType
    from typing import Any

    from motionlang.lang.machine import Machine
    from motionlang.lang.task import Task

# The file name of generated code, by which tracebacks are told from our own.
FILE = "<mint>"


class MintProgram(Program):
    """`code` defines `make`; `specs` says what its `kN` are; `places[n]` is the place of line n of the code.

    The source stays with the program: `--set` changes constants, which are written into the code.
    """

    __slots__ = ("code", "name", "places", "settings", "specs", "text")

    def __init__(
        self,
        code: CodeType,
        places: Sequence[int],
        specs: Sequence[tuple[object, ...]],
        name: str,
        text: str,
        settings: Mapping[str, object] | None,
    ) -> None:
        self.code, self.places, self.specs = code, places, specs
        self.name, self.text, self.settings = name, text, dict(settings or {})

    def payload(self) -> bytes:
        """The program as bytes, for `load`."""
        from array import array
        from marshal import dumps

        places = array("q", self.places).tobytes()
        everything: Any = (self.code, places, list(self.specs), self.name, self.text, self.settings)
        return dumps(everything)

    def start(self, machine: Machine) -> Task:
        """The parent task, bound to `machine`; ProgramError when an override names nothing."""
        if machine.overrides:
            from motionlang.mint.overriding import overridden

            return overridden(self, machine.overrides).run(machine)
        return self.run(machine)

    def run(self, machine: Machine) -> Task:
        """The parent task of the program as it stands."""
        environment = Environment(machine)
        environment.prepare()
        environment.files[FILE] = self.places
        namespace: dict[str, object] = {}
        exec(self.code, namespace)
        make = namespace["make"]
        operations = environment.make_operations(self.specs)
        environment.blocks = make(  # type: ignore[operator]
            environment, environment.clock, machine.terminal.write, machine.instruction_time, operations
        )
        if len(environment.blocks) > 1:
            environment.listen()
        task = MintTask("main", environment.blocks["main"], environment)
        task.timer = environment.timer
        return task


def load(payload: bytes) -> MintProgram:
    """The program that `MintProgram.payload` was made of."""
    from marshal import loads

    code, places, specs, name, text, settings = loads(payload)
    return MintProgram(code, memoryview(places).cast("q"), specs, name, text, settings)
