"""Checks of superposed offsets: each covers its commanded distance.

The rest of an offset that it replaces is added.
"""

from __future__ import annotations

from motionlang.kernel.log import LoggedMove
from motionlang.kernel.planners import Profile
from tests.proof.checker import ROUNDED, SLACK, Proof, RunRecords

# The fraction of a time by which a sum of times may differ.
LATE = 4.0 * ROUNDED


def _left(run: RunRecords, move: LoggedMove) -> float:
    """Return the remaining distance of the offset that `move` replaces."""
    before, wanted = run.offset_goals.get(move.axis, (None, 0.0))
    if before is None or before.profile is None or before.ended != "retarget":
        return 0.0
    start, end = move.start_time, before.start_time + before.profile.duration
    if abs(start - end) > LATE * (1.0 + start) or start in run.expected_motion.begun[move.axis]:
        return 0.0  # other following begins then, and no offset continues
    return wanted - before.profile.end


def check_missing(proof: Proof, run: RunRecords) -> None:
    """Check that every OFFSET that adds a distance has an entry."""
    if run.expected_motion.was_cut:
        return
    for (axis, time), (line, distance) in run.expected_motion.offsets.items():
        offsets = run.offsets.get(axis)
        if distance and (offsets is None or not offsets.begin_at(time)):
            proof.breaks(
                line, f"axis {axis} at {time:.6f} s: its offset of {distance:g} counts does not begin"
            )


def check_offset(proof: Proof, run: RunRecords, move: LoggedMove, profile: Profile) -> None:
    """Check the entry of an offset.

    An entry that resumes a suspended offset has no order of its own.
    """
    start, end = move.start_time, move.start_time + profile.duration
    where, late = f"axis {move.axis} from {start:.6f} s", LATE * (1.0 + end)
    if abs(profile.start) > SLACK:
        proof.breaks(move.line, f"{where}: it is superposed on other motion but begins at {profile.start:g}")
    expected_motion = run.expected_motion
    scale = {counts for counts, _ in expected_motion.scale(move.axis, start)}
    if (scale and move.scale not in scale) or move.zero:
        proof.breaks(move.line, f"{where}: it has {move.scale:g} counts per unit, unlike its axis")
    ordered = expected_motion.offsets.get((move.axis, start))
    if ordered is None:
        return
    line, distance = ordered
    wanted = distance + _left(run, move)
    run.offset_goals[move.axis] = move, wanted
    if line != move.line:
        proof.breaks(move.line, f"{where}: it is commanded by line {line}")
    if not move.ended:
        if end <= run.until and abs(profile.end - wanted) > SLACK * max(1.0, abs(wanted)):
            proof.breaks(move.line, f"{where}: it moves {profile.end:g} counts, commanded {wanted:g}")
    elif end <= run.until:
        words = {word for _, word in expected_motion.stopped(move.axis, end - late, end + late)}
        followed = any(abs(time - end) <= late for time in run.begins_near(move.axis, end))
        # A suspension and the end of a cam stop it, too.
        short = abs(profile.end - wanted) > SLACK * max(1.0, abs(wanted))
        cut = move.ended == "stop" or (move.ended == "retarget" and followed)
        if move.ended not in words and not (short and cut):
            proof.breaks(
                move.line, f"{where}: it is logged as ended by a {move.ended} that was not commanded"
            )
