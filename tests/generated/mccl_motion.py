"""MCCL programs: moves, velocity mode, contours, slaves, macros and tasks."""

from __future__ import annotations

from tests.generated.draw import Draw

AXES = (1, 2, 3)
# The actions of a program, by frequency; each is a method of `McclProgram`.
ACTIONS = {
    "move": 16, "velocity": 8, "reversal": 4, "contour": 6, "slave": 5, "stop": 10, "speed": 16, "shape": 8, "wait": 20,
    "rest": 10, "limit": 5, "zero": 4, "jog": 2, "switch": 2, "points": 2, "backlash": 3, "units": 1, "override": 4,
    "search": 2, "macro": 2, "task": 2, "repeat": 2, "stepper": 1, "one_line": 6,
}  # fmt: skip


class McclProgram:
    """A random program, drawn action by action; one line is a list of commands."""

    actions = ACTIONS

    def __init__(self, draw: Draw) -> None:
        self.draw = draw
        self.macros: list[str] = []
        lines = ["1MN,2MN,3MN"]
        for axis in AXES:
            lines.append(",".join(f"{axis}{self._setting(name)}" for name in ("SV", "SA", "DS")))
            if draw.chance(0.6):
                lines.append(f"{axis}{self._shape_of()}")
        lines += [",".join(self._action()) for _ in range(draw.randrange(4, 24))]
        ending = draw.random()
        if ending < 0.5:
            lines.append("1WS0,2WS0,3WS0")
        elif ending < 0.75:
            lines.append("1ST,1WS0.1,2ST,3ST,WA0.5")
        self.lines = [*self.macros, *lines]

    @property
    def text(self) -> str:
        """Return the complete program."""
        return "\n".join(self.lines) + "\n"

    def _action(self) -> list[str]:
        commands: list[str] = getattr(self, f"_{self.draw.pick(self.actions)}")()
        return commands

    def _of(self, *names: str) -> list[str]:
        commands: list[str] = getattr(self, f"_{self.draw.choice(names)}")()
        return commands

    def _axis(self) -> int:
        return self.draw.choice((1, 1, 1, 2, 2, 3))

    def _setting(self, name: str) -> str:
        draw = self.draw
        if name == "SV":
            return f"SV{draw.choice((100, 500, 1000, 2000, draw.randrange(50, 3000)))}"
        return f"{name}{draw.choice((500, 1000, 5000, 10000, draw.randrange(300, 30000)))}"

    def _wait_of(self) -> str:
        draw = self.draw
        return f"WA{draw.choice((0.001, round(draw.uniform(0.002, 0.1), 4), round(draw.uniform(0.02, 0.6), 3), 1))}"

    # ------------------------------------------------------------------------------------------------ moves

    def _target(self) -> str:
        draw = self.draw
        size = draw.choice((5, 200, 2000))
        return f"{draw.choice(('MR', 'MR', 'MA'))}{draw.randrange(-size, size)}"

    def _move(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        mode = [f"{axis}PM"] if draw.chance(0.25) else []
        return [*mode, f"{axis}{self._target()}"]

    def _velocity(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        run = [f"{axis}GO"]
        if draw.chance(0.5):
            run.insert(0, f"{axis}DI{draw.randrange(2)}")
        return [f"{axis}VM", *run] if draw.chance(0.85) else run

    def _reversal(self) -> list[str]:
        """Return a motion that turns round, and rates written while it does."""
        axis, draw = self._axis(), self.draw
        if draw.chance(0.5):
            commands = [f"{axis}VM", f"{axis}DI0", f"{axis}GO", self._wait_of(), f"{axis}DI1", f"{axis}GO"]
        else:
            commands = [f"{axis}PM", f"{axis}MR{draw.randrange(1, 2000)}", self._wait_of()]
            commands.append(f"{axis}MR-{draw.randrange(1, 4000)}")
        for _ in range(draw.randrange(1, 4)):
            commands += [self._wait_of(), f"{axis}{self._setting(draw.choice(('SV', 'SA', 'DS')))}"]
        return commands

    def _contour(self) -> list[str]:
        draw = self.draw
        speeds = [
            f"1VV{draw.randrange(100, 2000)}",
            f"1VA{draw.randrange(500, 9000)}",
            f"1VD{draw.randrange(500, 9000)}",
        ]
        commands = ["1WS", "2WS", "1CM1", "2CM1", *speeds] if draw.chance(0.85) else []
        for _ in range(draw.randrange(1, 5)):
            commands += self._path()
            if draw.chance(0.15):
                commands.append(f"1V{draw.choice('VAD')}{draw.randrange(200, 3000)}")
        if draw.chance(0.5):
            commands += (
                ["1WS", "1PM", "2PM"]
                if draw.chance(0.6)
                else [self._wait_of(), *self._of("stop", "override")]
            )
        return commands

    def _path(self) -> list[str]:
        draw = self.draw
        kind = draw.random()
        if kind < 0.6:
            return ["1CP1", f"1{self._target()}", f"2{self._target()}"]
        if kind < 0.7:
            return ["1CP0", f"1CD{draw.randrange(50, 500)}", f"1{self._target()}", f"2{self._target()}"]
        centre = [f"1CR{draw.randrange(-300, 300)}", f"2CR{draw.randrange(10, 300)}"]
        return [f"1CP{draw.choice((2, 3))}", *centre, f"1ER{draw.choice((-270, -90, 30, 90, 180, 360))}"]

    def _slave(self) -> list[str]:
        axis, draw = draw_slave(self.draw), self.draw
        if draw.chance(0.3):
            return [f"{axis}SS{draw.choice((-2, -0.5, 0, 0.5, 1, 2))}"]
        if draw.chance(0.2):
            return [f"{axis}SM0"]
        return [f"{axis}SS{draw.choice((-1, 0.5, 1, 3))}", f"{axis}SM{draw.randrange(1, axis)}"]

    def _points(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        return [f"{axis}{draw.choice(('LP', 'LT'))}1", f"{axis}{self._target()}", f"{axis}MP1"]

    def _search(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        return [
            f"{axis}VM",
            f"{axis}GO",
            f"{axis}{draw.choice(('FI', 'IA', 'EL'))}{draw.randrange(-50, 50)}",
            f"{axis}ST",
        ]

    # ----------------------------------------------------------------------------------------------- changes

    def _stop(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        stop = [f"{axis}{draw.choice(('ST', 'ST', 'ST', 'AB'))}"]
        return [*stop, f"{axis}WS{draw.choice(('', '0.05'))}"] if draw.chance(0.4) else stop

    def _speed(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        return [
            f"{axis}{self._setting(draw.choice(('SV', 'SA', 'DS')))}" for _ in range(draw.choice((1, 1, 2)))
        ]

    def _shape_of(self) -> str:
        return self.draw.choice(("PT", "PP", "PS0", "PS0.2", "PS0.45"))

    def _shape(self) -> list[str]:
        return [f"{self._axis()}{self._shape_of()}"]

    def _one_line(self) -> list[str]:
        """Return several changes and starts of motion in one line."""
        groups = [self._of("speed", "shape", "move", "velocity", "stop", "override") for _ in range(3)]
        return [command for group in groups for command in group]

    def _override(self) -> list[str]:
        return [f"{self._axis()}VO{self.draw.choice((0.2, 0.5, 1, 1, 2))}"]

    def _limit(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        where = [f"{axis}HL{draw.randrange(100, 3000)}", f"{axis}LL{draw.randrange(-3000, -100)}"]
        return [*where, f"{axis}LM{draw.choice((0, 4, 8))}", f"{axis}{draw.choice(('LN12', 'LN4', 'LF0'))}"]

    def _zero(self) -> list[str]:
        return [f"{self._axis()}DH{self.draw.choice((0, self.draw.randrange(-1000, 1000)))}"]

    def _jog(self) -> list[str]:
        axis = self._axis()
        if self.draw.chance(0.4):
            return [f"{axis}JF"]
        return [
            f"{axis}JA{self.draw.randrange(500, 9000)}",
            f"{axis}JG{self.draw.randrange(-300, 300)}",
            f"{axis}JN",
        ]

    def _switch(self) -> list[str]:
        axis = self._axis()
        return [f"{axis}MF", self._wait_of(), f"{axis}MN"]

    def _backlash(self) -> list[str]:
        axis = self._axis()
        return [f"{axis}BF"] if self.draw.chance(0.3) else [f"{axis}BD{self.draw.randrange(30)}", f"{axis}BN"]

    def _units(self) -> list[str]:
        axis = self._axis()
        return [f"{axis}US{self.draw.choice((1, 2.5, 10))}", f"{axis}MN"]

    def _stepper(self) -> list[str]:
        return [f"{self._axis()}MV{self.draw.choice((0, 20, 100))}"]

    def _wait(self) -> list[str]:
        return [self._wait_of()]

    def _rest(self) -> list[str]:
        axis = self._axis()
        wait = f"{axis}{self.draw.choice(('WS', 'WS', 'WS0.05', 'WT'))}"
        return [f"{axis}ST", wait] if self.draw.chance(0.3) else [wait]

    # ------------------------------------------------------------------------------------------------- flow

    def _define(self) -> int:
        groups = [self._of("move", "speed", "shape", "wait", "rest", "stop", "override") for _ in range(3)]
        self.macros.append(",".join([f"MD{len(self.macros) + 1}", *(c for group in groups for c in group)]))
        return len(self.macros)

    def _macro(self) -> list[str]:
        return [f"MC{self._define()}"]

    def _task(self) -> list[str]:
        return [f"GT{self._define()}"]

    def _repeat(self) -> list[str]:
        return [
            *self._of("move", "wait"),
            *self._of("speed", "wait", "rest"),
            f"RP{self.draw.randrange(1, 4)}",
        ]


def draw_slave(draw: Draw) -> int:
    """Return a random axis that has a lower axis, so that it can be a slave."""
    return draw.choice((2, 2, 3))
