"""`motionlang copley stream`: a master on a CAN bus with a simulated or real drive."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.cli.command import Refused, flag, option
from motionlang.cli.complaints import complain
from motionlang.cli.option_groups import OutputOptions
from motionlang.kernel import Diagnostic
from motionlang.lab.pvt.drive.packet import SIZE
from motionlang.lab.pvt.drive.point import WirePoint, from_wire, to_wire
from motionlang.lab.pvt.input import POSITIVE, PointSource, Sent
from motionlang.lab.pvt.points import Point, absolute, plan_points
from motionlang.lab.pvt.view import figure
from motionlang.views.table import Column, Document, Table
from motionlang_copley.drive import Drive

if TYPE_CHECKING:
    from motionlang_copley.master import Streamed

LINEAR = ("0", "-1", "-2")

LOG = (Column("time"), Column("event"))


@dataclass
class CopleyStream(Sent, OutputOptions):
    """Send a move to a simulated drive over CANopen and compare the motion."""

    transfer: str = option(
        "",
        "how to send the points: by PDO or SDO to object 0x2010, or in a sub-mode",
        choices=("pdo", "sdo", "0", "-1", "-2", "-3"),
        default="pdo",
    )
    poll_interval: float | None = option(
        "MS",
        "polling interval of the master, ms (1; with --transfer 0, the time between points)",
        read=POSITIVE,
    )
    interface: str = option("NAME", "python-can interface (virtual)", default="virtual")
    channel: str = option("NAME", "channel of the interface, such as vcan0", default="")
    real: bool = flag("stream to a real drive on the bus and move it; simulate none")

    def run(self) -> int:
        """Stream, print the result, and return the exit status."""
        from motionlang_copley.bus import BusError

        logging.getLogger("canopen").setLevel(
            logging.CRITICAL
        )  # the relevant errors are reported as diagnostics
        move = self.move(strict=True)
        wire = to_wire(self.sent(move.points, self._start_position(move)))
        try:
            status = self._stream_to_real(wire) if self.real else self._stream_to_simulated(move, wire)
        except BusError as problem:
            hint = "choose an interface of python-can that this computer has; virtual works everywhere"
            raise Refused([Diagnostic("file", str(problem), hint=hint)]) from None
        return self.draw([self.planned(move.points)], [move.name]) or status

    def _stream_to_simulated(self, move: PointSource, wire: Sequence[WirePoint]) -> int:
        from motionlang_copley.bus import LockstepBus
        from motionlang_copley.master import BusMaster, StreamError

        drive = Drive(self._start_position(move))
        with LockstepBus(drive, self.node, self._poll_period(wire), self.interface, self.channel) as bus:
            problem, done = "", None
            try:
                done = BusMaster(bus, self.node).stream(wire, self.transfer)
            except StreamError as error:
                problem = str(error)
            while drive.next_boundary is not None:
                bus.wait()
            frames = bus.frames
        self._report(move, drive, wire, done, frames)
        if problem:
            _complain_of_stream(problem, drive.log[-1][1] if drive.log else "")
        return 1 if problem else 0

    def _poll_period(self, wire: Sequence[WirePoint]) -> int:
        """Return the polling period of the master, microseconds.

        In sub-mode 0 the master sends one point per period, so the period is the time between points.
        """
        usual = float(wire[0].time or 1) if self.transfer == "0" else 1.0
        return max(1, round((usual if self.poll_interval is None else self.poll_interval) * 1000))

    def _stream_to_real(self, wire: Sequence[WirePoint]) -> int:
        from motionlang_copley.bus import RealBus
        from motionlang_copley.master import BusMaster, StreamError

        try:
            with RealBus(self.node, self.interface, self.channel) as bus:
                done = BusMaster(bus, self.node).stream(wire, self.transfer)
        except StreamError as error:
            _complain_of_stream(str(error))
            return 1
        if self.format != "none":
            print(f"{done.sent} points sent, {done.resent} of them resent")
        return 0

    def _start_position(self, move: PointSource) -> float:
        if self.start_ is not None:
            return self.start_
        first = move.points[0]
        return 0.0 if first.relative else float(round(first.position))

    def _report(
        self,
        move: PointSource,
        drive: Drive,
        wire: Sequence[WirePoint],
        done: Streamed | None,
        frames: int,
    ) -> None:
        error = None if self.transfer == "0" else self._departure(drive, wire)
        values = {
            "move": move.name,
            "transfer": self.transfer,
            "points": len(wire),
            "sent": done.sent if done else None,
            "resent": done.resent if done else None,
            "lowest_level": done.lowest if done else None,
            "frames": frames,
            "time": drive.now,
            "position": drive.position,
            "error": error,
        }
        log = Table("log", LOG, [dict(zip(("time", "event"), each, strict=True)) for each in drive.log])
        lines = self._lines(move, drive, len(wire), done, frames, error)
        self.show(Document([log], values), "\n".join(lines) + "\n")

    def _lines(
        self,
        move: PointSource,
        drive: Drive,
        count: int,
        done: Streamed | None,
        frames: int,
        error: float | None,
    ) -> list[str]:
        from motionlang_copley.master import TRANSFERS

        pairs = [
            ("move", f"{move.name}, {count} points"),
            ("sent by", TRANSFERS[self.transfer]),
            ("frames", f"{frames} on the bus"),
            ("end", f"{figure(drive.position)} counts after {drive.now:.3f} s"),
        ]
        if done:
            again = f", {done.resent} of them resent" if done.resent else ""
            level = (
                f"; never fewer than {done.lowest} in the buffer"
                if done.lowest < SIZE
                else ", all before the start"
            )
            pairs.insert(2, ("points", f"{done.sent} sent{again}{level}"))
        if error is not None:
            shown = f"{error:.3g} counts" if error > 1e-6 else "none"
            pairs.append(("departure", f"{shown} between the motion of the drive and the points"))
        lines = _pairs_lines(pairs)
        return lines + [""] * bool(drive.log) + [f"{time:10.6f} s  {what}" for time, what in drive.log]

    def _departure(self, drive: Drive, wire: Sequence[WirePoint]) -> float | None:
        """Return the largest deviation of the drive's motion from the points, counts.

        None if the motion never started.
        """
        from motionlang.lab.pvt.fit import track_error

        begin = next((time for time, what in drive.log if what.startswith("move started")), None)
        if begin is None:
            return None
        points = absolute(from_wire(wire), drive.profiles[0].start)
        if self.transfer in LINEAR:
            points = [Point(p.position, None, p.time) for p in points]
        return track_error([begin], [plan_points(points)], drive.starts, drive.profiles, begin, drive.now)


def _complain_of_stream(problem: str, hint: str = "") -> None:
    complain([Diagnostic("never", f"the stream failed: {problem}", hint=hint)], None, "")


def _pairs_lines(pairs: Sequence[tuple[str, str]]) -> list[str]:
    """Return aligned names and values."""
    width = max(len(name) for name, _ in pairs)
    return [f"{name:<{width}}  {value}" for name, value in pairs]
