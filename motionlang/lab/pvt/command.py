"""`motionlang pvt`: points to motion, velocities, exports and streams for a drive."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from motionlang.cli.command import Command, Refused, option
from motionlang.cli.option_groups import OutputOptions
from motionlang.cli.output_files import written
from motionlang.cli.readers import whole
from motionlang.kernel import Diagnostic
from motionlang.kernel.files import replacing
from motionlang.kernel.planners import compare_velocities, knot_accelerations
from motionlang.kernel.tools import count_of, total
from motionlang.lab.pvt.drive.point import from_wire, to_wire
from motionlang.lab.pvt.export import Unwritable, export
from motionlang.lab.pvt.input import Points, PointSource, Sent, spans_of
from motionlang.lab.pvt.points import Point, absolute, plan_points, until_end
from motionlang.lab.pvt.table import write_points
from motionlang.lab.pvt.view import WIDTH, methods_table, motion_document, segment_lines
from motionlang.views.table import Document

# Counts below which a difference is rounding.
NOISE = 1e-6
DRIVE_FORMATS = ("csv", "serial", "pdo", "sdo", "record")
_COUNT = whole("a whole number from 1 to 1000", 1, 1000)


def _counts(text: str) -> list[int]:
    return [_COUNT(item) for item in text.split(",")]


@dataclass
class PvtPlot(Points, OutputOptions):
    """Show the motion that a drive makes of points, segment by segment, or as a picture."""

    def run(self) -> int:
        """Print the segments, and draw them if wished."""
        move = self.move(strict=False)
        profile = self.planned(move.points)
        self.show(motion_document(move.name, profile), _text(segment_lines(profile)))
        return self.draw([profile], [move.name])


@dataclass
class PvtRefine(Points, OutputOptions):
    """Choose velocities for positions, and show the remaining acceleration jumps."""

    title: ClassVar[str] = "refinement"
    compare: Sequence[int] = option(
        "N,N…", "show the result after these numbers of passes (1,2)", read=_counts, default=(1, 2)
    )
    to: str | None = option(
        "FILE", "also write the points with their velocities into a file", suffixes=(".csv", ".txt")
    )

    def run(self) -> int:
        """Compare methods for velocities; write the points with the chosen ones."""
        move = self.move(strict=False)
        moving = until_end(absolute(move.points, self.start_ or 0.0))
        positions, spans = [p.position for p in moving], spans_of(moving)
        try:
            rows = compare_velocities(positions, spans, self.compare)
        except (ValueError, OverflowError) as problem:
            raise Refused([Diagnostic("range", str(problem))]) from None
        sides = knot_accelerations(positions, rows[0][1], spans)
        methods = methods_table(rows, [a for pair in sides for a in pair])
        self.show(Document([methods], {"move": move.name}), _text(methods.lines(WIDTH)))
        status = written(self.to, lambda: self._write(moving)) if self.to is not None else 0
        profiles = [plan_points(_replaced(moving, v)) for _, v, _ in rows] if self.plot is not None else []
        return self.draw(profiles, [name for name, _, _ in rows]) or status

    def _write(self, points: Sequence[Point]) -> None:
        assert self.to is not None
        with replacing(self.to) as file:
            file.write("".join(f"{line}\n" for line in write_points(points)).encode("utf-8"))


@dataclass
class PvtExport(Sent, OutputOptions):
    """Write a move, or the motion of a program, as CSV, serial words or CAN frames."""

    format: str = option("", "the form of the output (csv)", choices=DRIVE_FORMATS, default="csv")

    def run(self) -> int:
        """Write the move in the format of a drive, after a line with the rounding error."""
        move = self.move(strict=True)
        start = self.start_ or 0.0
        points = self.sent(move.points, start)
        try:
            made = export(to_wire(points), self.format, self.node)
        except Unwritable as problem:
            raise Refused([Diagnostic("range", str(problem))]) from None
        received = from_wire(made.read_back)
        error, when = self._error(move, received, start)
        span = total(p.time for p in points)
        worst = f"largest error {error:.3g} counts at {when:.3f} s" if error > NOISE else "no error"
        head = f"# {move.name}: {count_of(len(points) - 1, 'segment')}, {span:.3f} s, {worst}"
        sys.stdout.write(_text([head, *made.lines]))
        return self.draw([self.planned(received)], [move.name])

    def _error(self, move: PointSource, sent: Sequence[Point], start: float) -> tuple[float, float]:
        """Return the largest position error of the sent motion, counts, and its time, s."""
        from motionlang.lab.pvt.fit import motion_error

        if move.track is not None:
            track = move.track
            return motion_error(track.starts, track.profiles, sent, track.begin, start)
        return motion_error([0.0], [self.planned(move.points)], sent, 0.0, start)


class Pvt(Command):
    """Work with position-velocity-time moves for Copley drives."""

    removed: ClassVar = {"stream": "motionlang copley stream sends a move to a drive over CANopen"}
    commands: ClassVar = {
        "plot": (
            PvtPlot,
            "show the motion that a drive makes of points, segment by segment, or as a picture",
        ),
        "refine": (PvtRefine, "choose velocities for positions, and show the remaining acceleration jumps"),
        "export": (
            PvtExport,
            "write a move, or the motion of a program, as CSV, serial words or CAN frames",
        ),
    }


def _replaced(points: Sequence[Point], velocities: Sequence[float]) -> list[Point]:
    return [replace(p, velocity=v) for p, v in zip(points, velocities, strict=True)]


def _text(lines: Sequence[str]) -> str:
    return "".join(f"{line}\n" for line in lines)
