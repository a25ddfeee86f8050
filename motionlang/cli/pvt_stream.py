"""`motionlang pvt stream`: a master on a CAN bus with a simulated or real drive."""

from __future__ import annotations

import json
import logging
import sys
from typing import TYPE_CHECKING

from motionlang.copley.buffer import SIZE
from motionlang.copley.bus import BusError, LockstepBus, RealBus
from motionlang.copley.drive import Drive
from motionlang.copley.master import TRANSFERS, Master, StreamError
from motionlang.copley.point import from_wire, to_wire
from motionlang.errors import Diagnostic
from motionlang.planners.pvt.fit import track_error
from motionlang.planners.pvt.points import Point, absolute, plan_points, relative
from motionlang.views.diagnostics import render
from motionlang.views.pvt import figure, pairs_lines

if TYPE_CHECKING:
    import argparse
    from collections.abc import Sequence

    from motionlang.cli.pvt_input import Move
    from motionlang.copley.master import Streamed
    from motionlang.copley.point import WirePoint

SCHEMA = "motionlang.pvt/2"
FIXED = ("0", "-1")
LINEAR = (*FIXED, "-2")


def run_stream(args: argparse.Namespace, move: Move) -> int:
    """Stream, print the result, and return the exit status."""
    logging.getLogger("canopen").setLevel(logging.CRITICAL)  # the relevant errors are reported as diagnostics
    try:
        return _stream_to_real(args, move) if args.real else _stream_to_simulated(args, move)
    except BusError as problem:
        hint = "choose an interface of python-can that this computer has; virtual works everywhere"
        sys.stderr.write(render(Diagnostic("file", str(problem), hint=hint)))
        return 1


def _stream_to_simulated(args: argparse.Namespace, move: Move) -> int:
    start = _start_position(args, move)
    points = relative(move.points, start) if args.relative else move.points
    wire = to_wire(points)
    drive = Drive(start)
    with LockstepBus(drive, args.node, _poll_period(args, wire), args.interface, args.channel) as bus:
        problem, done = "", None
        try:
            done = Master(bus, args.node).stream(wire, args.transfer)
        except StreamError as error:
            problem = str(error)
        while drive.next_boundary is not None:
            bus.wait()
        frames = bus.frames
    _report(args, move, drive, wire, done, frames)
    if problem:
        sys.stderr.write(render(Diagnostic("never", f"the stream failed: {problem}", hint=_hint(drive))))
    return 1 if problem else 0


def _poll_period(args: argparse.Namespace, wire: Sequence[WirePoint]) -> int:
    """Return the polling period of the master, microseconds.

    In sub-mode 0 the master sends one point per period, so the period is the time between points.
    """
    usual = float(wire[0].time or 1) if args.transfer == "0" else 1.0
    return max(1, round((usual if args.poll_interval is None else args.poll_interval) * 1000))


def _stream_to_real(args: argparse.Namespace, move: Move) -> int:
    points = relative(move.points, _start_position(args, move)) if args.relative else move.points
    wire = to_wire(points)
    try:
        with RealBus(args.node, args.interface, args.channel) as bus:
            done = Master(bus, args.node).stream(wire, args.transfer)
    except StreamError as error:
        sys.stderr.write(render(Diagnostic("never", f"the stream failed: {error}")))
        return 1
    if args.format != "none":
        print(f"{done.sent} points sent, {done.resent} of them resent")
    return 0


def _start_position(args: argparse.Namespace, move: Move) -> float:
    """Return the start position of the simulated motor: as given, or that of the move."""
    if args.start is not None:
        return float(args.start)
    first = move.points[0]
    return 0.0 if first.relative else float(round(first.position))


def _report(
    args: argparse.Namespace,
    move: Move,
    drive: Drive,
    wire: Sequence[WirePoint],
    done: Streamed | None,
    frames: int,
) -> None:
    error = None if args.transfer == "0" else _departure(args, drive, wire)
    if args.format == "json":
        content = {
            "schema": SCHEMA,
            "move": move.name,
            "transfer": args.transfer,
            "points": len(wire),
            "sent": done.sent if done else None,
            "resent": done.resent if done else None,
            "lowest_level": done.lowest if done else None,
            "frames": frames,
            "time": drive.now,
            "position": drive.position,
            "error": error,
            "log": [{"time": time, "event": event} for time, event in drive.log],
        }
        print(json.dumps(content, indent=2))
    elif args.format == "table":
        sys.stdout.write("\n".join(_lines(args, move, drive, len(wire), done, frames, error)) + "\n")


def _lines(
    args: argparse.Namespace,
    move: Move,
    drive: Drive,
    count: int,
    done: Streamed | None,
    frames: int,
    error: float | None,
) -> list[str]:
    pairs = [
        ("move", f"{move.name}, {count} points"),
        ("sent by", TRANSFERS[args.transfer]),
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
    lines = pairs_lines(pairs)
    return lines + [""] * bool(drive.log) + [f"{time:10.6f} s  {what}" for time, what in drive.log]


def _departure(args: argparse.Namespace, drive: Drive, wire: Sequence[WirePoint]) -> float | None:
    """Return the largest deviation of the drive's motion from the points, counts.

    None if the motion never started.
    """
    begin = next((time for time, what in drive.log if what.startswith("move started")), None)
    if begin is None:
        return None
    points = absolute(from_wire(wire), drive.profiles[0].start)
    if args.transfer in LINEAR:
        points = [Point(p.position, None, p.time) for p in points]
    return track_error([begin], [plan_points(points)], drive.starts, drive.profiles, begin, drive.now)


def _hint(drive: Drive) -> str:
    return drive.log[-1][1] if drive.log else ""
