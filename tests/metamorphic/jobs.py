"""Random jobs as Mint programs, each from a seed: single moves, contours, masters and slaves.

Contours have limits, and events while they move.
"""

from __future__ import annotations

import random

PAUSES = ("PAUSE IDLE(0)", "PAUSE IDLE(1)", "PAUSE IDLE(2)")


class Moves:
    """Moves of one axis with waits between them, and sometimes a stop at the end."""

    def __init__(self, seed: int) -> None:
        choose = random.Random(seed)
        speed, accel, decel = (round(choose.uniform(5, 200), 3) for _ in range(3))
        self.lines = [f"SPEED(0) = {speed}", f"ACCEL(0) = {accel}", f"DECEL(0) = {decel}"]
        if choose.random() < 0.5:
            jerks = (round(choose.uniform(100, 5000), 3) for _ in range(2))
            self.lines.append("PROFILEMODE(0) = 1 : ACCELJERK(0) = {} : DECELJERK(0) = {}".format(*jerks))
        for _ in range(choose.randrange(1, 5)):
            self.lines.append(f"MOVER(0) = {round(choose.uniform(-300, 300), 3)} : GO(0)")
            self.lines += [PAUSES[0], f"WAIT {choose.randrange(20, 2000)}"]
        if choose.random() < 0.4:
            self.lines += ["MOVER(0) = 500 : GO(0)", "WAIT 700", "STOP(0)", PAUSES[0]]

    @property
    def text(self) -> str:
        return "\n".join(self.lines) + "\n"


class Contour:
    """Contoured paths of two or three axes, `count` of them, with limits.

    They are lines, arcs and helices. With `events`, speeds, overrides, limits, suspends and further paths come while
    they run.
    """

    def __init__(self, seed: int, events: bool) -> None:
        self.choose = choose = random.Random(seed)
        self.count = choose.randrange(3, 13)
        self.late = choose.randrange(0, 3) if events else 0
        self.three = choose.random() < 0.3
        self.lines = [f"MOVEBUFFERSIZE({axis}) = 20" for axis in (0, 1, 2)]
        self._settings()
        paths = [self._path() for _ in range(self.count)]
        now = self.count - self.late
        self.lines += paths[:now]
        self.lines.append("GO(0)")
        if events:
            self._events(paths[now:])
        self.lines += PAUSES

    @property
    def text(self) -> str:
        return "\n".join(self.lines) + "\n"

    def _real(self, low: float, high: float) -> float:
        return round(self.choose.uniform(low, high), 3)

    def _settings(self) -> None:
        choose, real = self.choose, self._real
        for axis in (0, 1, 2):
            if choose.random() < 0.3:
                self.lines.append(f"SCALEFACTOR({axis}) = {choose.choice((10, 100, 2.5))}")
        self.lines.append(
            f"SPEED(0) = {real(5, 80)} : ACCEL(0) = {real(20, 500)} : DECEL(0) = {real(20, 500)}"
        )
        self.lines.append(f"FEEDRATEMODE(0) = {choose.randrange(4)}")
        if choose.random() < 0.4:
            jerks = real(200, 8000), real(200, 8000)
            self.lines.append(f"PROFILEMODE(0) = 1 : ACCELJERK(0) = {jerks[0]} : DECELJERK(0) = {jerks[1]}")
        for axis in (0, 1, 2):
            for word, low, high in (("MAXSPEED", 5, 60), ("MAXACCEL", 20, 300), ("MAXDECEL", 20, 300)):
                if choose.random() < 0.25:
                    self.lines.append(f"{word}({axis}) = {real(low, high)}")
        how = choose.random()
        if how < 0.6:
            self.lines.append(f"CONTOURMODE(0) = 1 : CONTOURANGLE(0) = {choose.choice((0, 5, 30, 60, 180))}")
        elif how < 0.8:
            self.lines.append(f"CONTOURMODE(0) = 1 : CONTOURANGLE(0) = {real(10, 90)}")

    def _path(self) -> str:
        choose, real = self.choose, self._real
        speed = f"SPEED(0) = {real(5, 80)} : " if choose.random() < 0.3 else ""
        kind = choose.random()
        if kind < 0.3:
            angle = choose.choice((-1, 1)) * real(10, 400)
            if self.three and choose.random() < 0.5:
                return f"{speed}HELIXR(0, 1, 2) = {real(-20, 20)}, {real(1, 20)}, {angle}, {real(-20, 20)}"
            return f"{speed}CIRCLER(0, 1) = {real(-20, 20)}, {real(1, 20)}, {angle}"
        axes, values = ("0, 1, 2", 3) if self.three else ("0, 1", 2)
        size = choose.choice((0.5, 5, 60))
        components = ", ".join(str(real(-size, size)) for _ in range(values))
        return f"{speed}VECTOR{choose.choice('RRA')}({axes}) = {components}"

    def _events(self, late: list[str]) -> None:
        choose, real = self.choose, self._real
        for _ in range(choose.randrange(1, 6)):
            self.lines.append(f"WAIT {choose.randrange(20, 900)}")
            event = choose.randrange(7)
            if event == 0:
                self.lines.append(f"FEEDRATEOVERRIDE(0) = {choose.choice((10, 50, 80, 100, 150))}")
            elif event == 1:
                self.lines.append(f"SPEED(0) = {real(5, 80)}")
            elif event == 2:
                self.lines += ["SUSPEND(0) = 1", f"WAIT {choose.randrange(5, 700)}", "SUSPEND(0) = 0"]
            elif event == 3:
                self.lines.append(f"MAXSPEED({choose.randrange(3)}) = {real(3, 60)}")
            elif event == 4:
                self.lines.append(f"MAXACCEL({choose.randrange(3)}) = {real(20, 300)}")
            elif event == 5 and late:
                self.lines += [late.pop(0), "GO(0)"]
            elif event == 6 and choose.random() < 0.3:
                self.lines.append(f"STOP({choose.randrange(2)})")
                late.clear()
        for path in late:
            self.lines += [path, "GO(0)"]


class Train:
    """A chain of masters and slaves with random actions.

    The masters move and jog; the slaves have gears, cams, flying shears, offsets and limits.
    """

    def __init__(self, seed: int) -> None:
        self.choose = choose = random.Random(seed)
        real = self._real
        self.lines: list[str] = ["Dim a(5) As Float = 4, 10, 25, 20, 0", "Dim b(4) As Float = 3, 5, -5, 8"]
        for axis in (0, 1, 2):
            self.lines.append(
                f"SPEED({axis}) = {real(20, 80)} : ACCEL({axis}) = {real(50, 500)} : DECEL({axis}) = {real(50, 500)}"
            )
            self.lines.append(f"MOVEBUFFERSIZE({axis}) = 10 : ERRORDECEL({axis}) = {real(100, 900)}")
            if choose.random() < 0.3:
                self.lines.append(f"SCALEFACTOR({axis}) = {choose.choice((10, 4, 2.5))}")
            if axis and choose.random() < 0.25:
                self.lines.append(
                    f"SOFTLIMITFORWARD({axis}) = {real(20, 90)} : SOFTLIMITREVERSE({axis}) = -500"
                )
                self.lines.append(f"SOFTLIMITMODE({axis}) = {choose.choice((1, 3, 5))}")
            if choose.random() < 0.3:
                self.lines.append(
                    f"PROFILEMODE({axis}) = 1 : ACCELJERK({axis}) = {real(500, 9000)} : "
                    f"DECELJERK({axis}) = {real(500, 9000)}"
                )
        for slave in (1, 2):
            self.lines.append(
                f"MASTERSOURCE({slave}) = _msPOS : MASTERCHANNEL({slave}) = {choose.randrange(slave)}"
            )
            self.lines.append(self._tie(slave))
        for _ in range(choose.randrange(2, 7)):
            self.lines += [self._event(), f"WAIT {choose.randrange(5, 800)}"]
        self.lines += [
            "STOP(0) : PAUSE IDLE(0)",
            "WAIT 200",
            "STOP(1) : STOP(2)",
            "PAUSE IDLE(1) And IDLE(2)",
        ]
        self.lines += ["WAIT 50", "Event ONERROR", "  ERRORCLEAR(_egALL, 0)", "End Event"]

    @property
    def text(self) -> str:
        return "\n".join(self.lines) + "\n"

    def _real(self, low: float, high: float) -> float:
        return round(self.choose.uniform(low, high), 3)

    def _tie(self, slave: int) -> str:
        choose, real = self.choose, self._real
        kind = choose.random()
        if kind < 0.5:
            mode = f"FOLLOWMODE({slave}) = {choose.randrange(2)} : " if choose.random() < 0.5 else ""
            return f"{mode}FOLLOW({slave}) = {real(-2, 2)}"
        if kind < 0.75:
            table = choose.choice("ab")
            once = choose.choice(("0", "_spCONTINUOUS"))
            return (
                f"CAMTABLE({slave}, {table}) : MASTERDISTANCE({slave}) = {real(5, 30)} : CAM({slave}) = {once} : "
                f"GO({slave})"
            )
        lines = [
            f"MASTERDISTANCE({slave}) = {real(10, 40)} : FLY({slave}) = {real(2, 30)}"
            for _ in range(choose.randrange(1, 4))
        ]
        return "\n".join([*lines, f"GO({slave})"])

    def _event(self) -> str:
        choose, real = self.choose, self._real
        slave = choose.randrange(1, 3)
        return (
            f"JOG(0) = {real(-40, 60)}",
            f"STOP(0) : PAUSE IDLE(0) : MOVER(0) = {real(-50, 80)} : GO(0)",
            f"IF AXISMODE({slave}) THEN\nOFFSET({slave}) = {real(-15, 15)} : GO({slave})\nEND IF",
            f"SPEED(0) = {real(10, 80)}",
            f"IF IDLE({slave}) THEN\n{self._tie(slave)}\nEND IF",
            f"IF AXISMODE({slave}) = 16 THEN\nFOLLOW({slave}) = {real(-2, 2)}\nEND IF",
        )[choose.randrange(6)]
