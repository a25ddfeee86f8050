"""Mint programs with moves, paths, slaves, tables, references, and their changes."""

from __future__ import annotations

from tests.generated.draw import Draw, axis_settings, table

AXES = (0, 1, 2)
_TABLES = """Dim rise(5) As Float = 4, 10, 25, 20, 0
Dim ways(5) As Float = 4, 10, 20, 10, 20
Dim small(4) As Float = 3, 5, -5, 8
Dim speeds(5) As Float = 4, 100, 60, 0, 0
Dim spans(5) As Float = 4, 200, 100, 200, 100
Dim k As Integer, faults As Integer"""
# The actions of a program, by frequency; each is a method of `MintProgram`.
ACTIONS = {
    "move": 12, "moves": 6, "line": 9, "arc": 5, "contour": 5, "retarget": 4, "reversal": 5, "jog": 5,
    "follow": 6, "cam": 5, "fly": 3, "spline": 5, "offset": 3, "home": 2, "hold": 1, "stop": 8, "suspend": 5,
    "speed": 10, "setting": 8, "limit": 5, "zero": 4, "scale": 1, "drive": 2, "wait": 14, "rest": 8, "loop": 2,
    "dwell": 2, "triggered": 1,
}  # fmt: skip
_SPEEDS = (
    "SPEED", "ACCEL", "DECEL", "FEEDRATEOVERRIDE", "FEEDRATE", "MAXSPEED", "MAXACCEL", "MAXDECEL", "ACCELJERK",
    "DECELJERK", "PROFILEMODE", "FEEDRATEMODE", "ACCELTIME", "DECELTIME", "SRAMP", "ERRORDECEL", "ACCELJERKTIME",
    "DECELJERKTIME",
)  # fmt: skip
# Those that act on a motion in progress, some with the next of them.
_RATES = (
    "SPEED", "ACCEL", "DECEL", "ACCELTIME", "DECELTIME", "MAXACCEL", "MAXDECEL", "ACCELJERK", "DECELJERK",
    "FEEDRATEOVERRIDE",
)  # fmt: skip
_LIMITS = ("SOFTLIMITFORWARD", "SOFTLIMITREVERSE", "SOFTLIMITMODE", "LIMITMODE", "STOPMODE", "ABORTMODE")


class MintProgram:
    """A random program, drawn action by action."""

    actions = ACTIONS

    def __init__(self, draw: Draw) -> None:
        self.draw, self.lines = draw, _TABLES.split("\n")
        self._settings()
        for _ in range(draw.randrange(4, 22)):
            self.lines += self._action()
        self._end()

    @property
    def text(self) -> str:
        """Return the complete program."""
        return "\n".join(self.lines) + "\n"

    # ------------------------------------------------------------------------------------------------ frame

    def _settings(self) -> None:
        draw = self.draw
        # The default of 4,000 uu/s turns a cam that follows thousands of times a second: seconds of the processor.
        self.lines.append("HOMESPEED(0, 1, 2) = 50;")
        for axis in AXES:
            if draw.chance(0.25):
                self.lines.append(self._write("SCALEFACTOR", axis))
            self.lines.append(" : ".join(self._write(name, axis) for name in ("SPEED", "ACCEL", "DECEL")))
            self.lines.append(
                f"ERRORDECEL({axis}) = {draw.real(100, 900)} : {self._write('MOVEBUFFERSIZE', axis)}"
            )
            if draw.chance(0.3):
                jerks = ("ACCELJERK", "DECELJERK")
                self.lines.append(
                    f"PROFILEMODE({axis}) = 1 : " + " : ".join(self._write(name, axis) for name in jerks)
                )
            for name in ("MAXSPEED", "MAXACCEL", "MAXDECEL"):
                if draw.chance(0.1):
                    self.lines.append(self._write(name, axis))
            if axis:
                self.lines.append(
                    f"MASTERSOURCE({axis}) = _msPOS : MASTERCHANNEL({axis}) = {draw.randrange(axis)}"
                )
        for _ in range(draw.choice((0, 0, 1, 3))):
            self.lines += self._setting()

    def _end(self) -> None:
        draw = self.draw
        ending = draw.random()
        if ending < 0.4:
            self.lines += ["TIME = 0 : PAUSE IDLE(0) And IDLE(1) And IDLE(2) Or TIME > 5000"]
        elif ending < 0.7:
            self.lines += ["STOP(0) : PAUSE IDLE(0)", "STOP(1) : STOP(2)", "WAIT = 300"]
        tasks = draw.chance(0.2)
        if tasks:
            self.lines.insert(draw.randrange(6, len(self.lines)), "Run Other")
        self.lines.append("End")
        if draw.chance(0.85):
            self.lines += ["Event ONERROR", "  ERRORCLEAR(_egALL, 0)"]
            self.lines += self._handled() if draw.chance(0.2) else []
            self.lines.append("End Event")
        if tasks:
            body = [line for _ in range(draw.randrange(1, 6)) for line in self._action()]
            self.lines += ["Task Other", *self._indented(body), "End Task"]
        if draw.chance(0.12):
            self.lines.insert(6, f"TIMEREVENT = {draw.choice((20, 150, 400))}")
            self.lines += ["Event TIMER", *self._indented(self._speed()), "End Event"]

    def _handled(self) -> list[str]:
        """Return an action for the ONERROR handler.

        The action may raise the next error at once, so the handler acts on the first 20 errors only.
        """
        action = ["faults = faults + 1", *self._action()]
        return ["  If faults < 20 Then", *self._indented(self._indented(action)), "  End If"]

    def _indented(self, lines: list[str]) -> list[str]:
        return [f"  {line}" for line in lines]

    def _action(self) -> list[str]:
        lines: list[str] = getattr(self, f"_{self.draw.pick(self.actions)}")()
        if self.draw.chance(0.15):
            lines = [f"If IDLE({self._axis()}) Then", *self._indented(lines), "End If"]
        return lines

    def _axis(self) -> int:
        return self.draw.choice((0, 0, 0, 1, 1, 2))

    def _slave(self) -> int:
        return self.draw.choice((1, 1, 2))

    def _write(self, name: str, axis: int) -> str:
        value = self.draw.value(table("mint")[name])
        return f"{name}({axis}) = {value}"

    def _go(self, axis: int) -> str:
        return f"GO({axis})" if self.draw.chance(0.95) else "GO(0, 1)"

    # ------------------------------------------------------------------------------------------------ moves

    def _move(self) -> list[str]:
        axis = self._axis()
        return [f"{self._move_of(axis)} : {self._go(axis)}"]

    def _move_of(self, axis: int) -> str:
        return self._write(self.draw.choice(("MOVER", "MOVEA")), axis)

    def _moves(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        lines = []
        for _ in range(draw.randrange(2, 5)):
            before = f"{self._write(draw.choice(_SPEEDS), axis)} : " if draw.chance(0.4) else ""
            lines.append(before + self._move_of(axis))
        return [*lines, self._go(axis)]

    def _values(self, count: int) -> str:
        draw = self.draw
        size = draw.choice((0.5, 5, 40, 80))
        return ", ".join("0" if draw.chance(0.12) else str(draw.real(-size, size)) for _ in range(count))

    def _line_of(self) -> str:
        axes = self.draw.choice(("0, 1", "0, 1", "0, 1", "1, 0", "1, 2", "0, 1, 2"))
        return f"VECTOR{self.draw.choice('RA')}({axes}) = {self._values(axes.count(',') + 1)}"

    def _line(self) -> list[str]:
        line = self._line_of()
        return [f"{line} : GO({line[8]})"]

    def _arc_of(self) -> str:
        draw = self.draw
        angle = draw.choice((-1, 1)) * draw.real(10, 400)
        centre = f"{draw.real(-20, 20)}, {draw.real(1, 20)}, {angle}"
        if draw.chance(0.2):
            return f"HELIX{draw.choice('RRA')}(0, 1, 2) = {centre}, {draw.real(-20, 20)}"
        return f"CIRCLE{draw.choice('RRA')}({draw.choice(('0, 1', '0, 1', '1, 2'))}) = {centre}"

    def _arc(self) -> list[str]:
        arc = self._arc_of()
        return [f"{arc} : GO({arc[arc.index('(') + 1]})"]

    def _paths(self, least: int) -> list[str]:
        draw, lines = self.draw, []
        for _ in range(draw.randrange(least, 7)):
            if draw.chance(0.2):
                lines.append(self._write(draw.choice(_SPEEDS), 0))
            lines.append(self._arc_of() if draw.chance(0.2) else self._line_of())
        return [*lines, "GO(0)"]

    def _contour(self) -> list[str]:
        return [f"CONTOURMODE(0) = 1 : {self._write('CONTOURANGLE', 0)}", *self._paths(2)]

    def _retarget(self) -> list[str]:
        return [self._write(self.draw.choice(("INCR", "INCA")), self._axis())]

    def _reversal(self) -> list[str]:
        """Return a motion that turns round, and rates written while it does."""
        axis, draw = self._axis(), self.draw
        size = draw.real(1, 80)
        there, back = draw.choice(
            (
                (
                    f"MOVER({axis}) = {size} : GO({axis})",
                    f"INCA({axis}) = POS({axis}) - {draw.real(0.1, 80)}",
                ),
                (f"MOVER({axis}) = {size} : GO({axis})", f"INCR({axis}) = -{draw.real(0.1, 80)}"),
                (f"JOG({axis}) = {size}", f"JOG({axis}) = -{draw.real(1, 60)}"),
                (f"JOG({axis}) = {size}", f"INCA({axis}) = POS({axis}) - {draw.real(0.1, 80)}"),
            )
        )
        lines = [there, f"WAIT = {draw.randrange(5, 400)}", back]
        for _ in range(draw.randrange(1, 4)):
            rate = self._write(draw.choice(_RATES), axis)
            lines += [f"WAIT = {draw.choice((1, draw.randrange(2, 40), draw.randrange(20, 400)))}", rate]
        return lines

    def _jog(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        return [f"JOG({axis}) = {draw.choice((0, draw.real(-60, 60), draw.real(-60, 60)))}"]

    def _dwell(self) -> list[str]:
        axis = self._axis()
        dwell = self.draw.choice(
            (f"MOVEDWELL({axis}) = {self.draw.randrange(5, 300)}", f"MOVEOUTX({axis}, 1) = 1")
        )
        return [dwell, f"{self._move_of(axis)} : {self._go(axis)}"]

    def _triggered(self) -> list[str]:
        axis, other = self._axis(), self._axis()
        source = f"TRIGGERMODE({axis}) = 2 : TRIGGERSOURCE({axis}) = 0 : TRIGGERCHANNEL({axis}) = {other}"
        return [
            f"{source} : TRIGGERVALUE({axis}) = {self.draw.real(-20, 20)}",
            self._move_of(axis),
            f"{self._move_of(other)} : {self._go(other)}",
            "WAIT = 400",
            f"TRIGGERMODE({axis}) = 1",
        ]

    # ------------------------------------------------------------------------------------- slaves and tables

    def _follow(self) -> list[str]:
        slave = self._slave()
        mode = f"FOLLOWMODE({slave}) = {self.draw.randrange(2)} : " if self.draw.chance(0.4) else ""
        return [mode + self._write("FOLLOW", slave)]

    def _cam(self) -> list[str]:
        slave, draw = self._slave(), self.draw
        rows = draw.choice(("rise", "small", "rise, ways", "rise, NULL"))
        names = ("MASTERDISTANCE", *(n for n in ("CAMAMPLITUDE", "CAMSTART", "CAMEND") if draw.chance(0.2)))
        return [
            " : ".join([f"CAMTABLE({slave}, {rows})", *(self._write(name, slave) for name in names)]),
            f"CAM({slave}) = {draw.choice((0, 0, 1, 2, 4, 4, 5))} : GO({slave})",
        ]

    def _fly(self) -> list[str]:
        slave, draw = self._slave(), self.draw
        lines = [
            f"MASTERDISTANCE({slave}) = {draw.real(2, 40)} : FLY({slave}) = {draw.real(-20, 30)}"
            for _ in range(draw.randrange(1, 4))
        ]
        return [*lines, f"GO({slave})"]

    def _offset(self) -> list[str]:
        slave = self._slave()
        mode = f"OFFSETMODE({slave}) = {self.draw.randrange(4)} : {self._write('OFFSETDISTANCE', slave)} : "
        return [f"{mode if self.draw.chance(0.4) else ''}{self._write('OFFSET', slave)} : GO({slave})"]

    def _spline(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        rows = draw.choice(
            ("small, NULL, NULL", "rise, NULL, NULL", "rise, speeds, spans", "rise, NULL, spans")
        )
        names = [
            n for n in ("SPLINETIME", "SPLINESUSPENDTIME", "SPLINESTART", "SPLINEEND") if draw.chance(0.3)
        ]
        return [
            " : ".join([f"SPLINETABLE({axis}, {rows})", *(self._write(name, axis) for name in names)]),
            f"SPLINE({axis}) = {draw.choice((0, 0, 1, 4, 5, 8, 12))} : GO({axis})",
        ]

    def _home(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        lines = [self._write(n, axis) for n in ("HOMESPEED", "HOMEBACKOFF", "HOMEACCEL") if draw.chance(0.4)]
        return [*lines, self._write("HOME", axis)]

    def _hold(self) -> list[str]:
        return [f"HTA({self._axis()}) = {self.draw.choice((0, self.draw.real(-60, 60)))}"]

    # ----------------------------------------------------------------------------------------------- changes

    def _stop(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        kind = draw.pick({"STOP": 6, "CANCEL": 4, "RESET": 2, "ABORT": 1, "CANCELALL": 1, "DEFAULT": 1})
        line = kind if kind in ("ABORT", "CANCELALL") else f"{kind}({axis})"
        return [line, f"PAUSE IDLE({axis})"] if draw.chance(0.4) else [line]

    def _suspend(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        if draw.chance(0.2):
            return [f"SUSPEND({axis}) = {draw.randrange(2)}"]
        inside = (
            self._action_of("speed", "setting", "limit", "move", "stop", "zero") if draw.chance(0.3) else []
        )
        wait = f"WAIT = {draw.choice((5, 40, 200, 900))}"
        return [f"SUSPEND({axis}) = 1", *inside, wait, f"SUSPEND({axis}) = 0"]

    def _action_of(self, *names: str) -> list[str]:
        lines: list[str] = getattr(self, f"_{self.draw.choice(names)}")()
        return lines

    def _speed(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        return [" : ".join(self._write(draw.choice(_SPEEDS), axis) for _ in range(draw.choice((1, 1, 2))))]

    def _setting(self) -> list[str]:
        draw = self.draw
        row = draw.choice(axis_settings("mint"))
        return [self._write(row.name, self._axis())]

    def _limit(self) -> list[str]:
        axis = self._axis()
        return [self._write(self.draw.choice(_LIMITS), axis)]

    def _zero(self) -> list[str]:
        axis, draw = self._axis(), self.draw
        return [f"{draw.choice(('POS', 'POS', 'ENCODER'))}({axis}) = {draw.choice((0, draw.real(-50, 50)))}"]

    def _scale(self) -> list[str]:
        return [self._write("SCALEFACTOR", self._axis())]

    def _drive(self) -> list[str]:
        axis = self._axis()
        return [
            f"DRIVEENABLE({axis}) = 0",
            f"WAIT = {self.draw.choice((1, 100))}",
            f"DRIVEENABLE({axis}) = 1",
        ]

    def _wait(self) -> list[str]:
        draw = self.draw
        if draw.chance(0.1):
            return [f"PAUSE POS({self._axis()}) > {draw.real(-20, 20)} Or TIME > {draw.randrange(200, 4000)}"]
        return [
            f"WAIT = {draw.choice((1, draw.randrange(2, 40), draw.randrange(20, 400), draw.randrange(100, 1500)))}"
        ]

    def _rest(self) -> list[str]:
        idle = f"PAUSE IDLE({self._axis()})"
        return [
            f"TIME = 0 : {idle} Or TIME > {self.draw.randrange(100, 3000)}"
            if self.draw.chance(0.75)
            else idle
        ]

    def _loop(self) -> list[str]:
        body = [line for _ in range(self.draw.randrange(1, 4)) for line in self._plain()]
        return [f"For k = 1 To {self.draw.randrange(2, 5)}", *self._indented(body), "Next"]

    def _plain(self) -> list[str]:
        return self._action_of("move", "line", "speed", "wait", "rest", "retarget", "zero")
