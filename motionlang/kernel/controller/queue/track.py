"""The track of an axis and the log entries of its moves, which every motion extends."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.controller import watch
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.events import BY_DESIGN, check_velocity
from motionlang.kernel.log.log import PROFILE, Log
from motionlang.kernel.log.move import MAX_PIECES, LoggedMove
from motionlang.kernel.log.records import Zeroed
from motionlang.kernel.planners import Profile, hold


def extend_track(a: Axis, profile: Profile, cause: str = "", ended: LoggedMove | None = None) -> None:
    """Put `profile` on the track now: solve watches, notify followers, check limits.

    A jump of velocity is reported with its `cause`, unless the profile is `BY_DESIGN`. `ended` is the move that a
    standstill ends.
    """
    if cause != BY_DESIGN and (profile.start_velocity or a.profiles[-1].shape != "hold"):
        check_velocity(a, profile, cause, ended or a.move)
    controller = a.controller
    if a.feedback is None and len(a.starts) > 1 and _is_rest(a):
        del a.starts[-1], a.profiles[-1]
        controller.log.budget.take(-PROFILE)
    controller.motion_listener.add(a)
    if controller.asking is not None:
        controller.asking.starts(a, profile)
    a.starts.append(a.clock.now)
    a.profiles.append(profile)
    a.present = profile
    controller.log.count_profile(a.profiles[-2])
    if a.feedback is not None:
        a.feedback.changed()
    else:
        if a.watches:
            watch.solve(a)
        if a.present is not profile:  # a crossed watch has given it another profile and notified of that
            return
    for follower in tuple(a.followers):
        follower(profile)
    for limit in a.barriers:
        limit.check()


def _is_rest(a: Axis) -> bool:
    """True if the last profile of the track only says that the axis rests where the one before it ended."""
    before, last = a.profiles[-2:]
    return (
        last.shape == "hold"
        and before.has_ramps
        and before.end == last.start
        and not before.end_velocity
        and a.starts[-2] + before.duration <= a.starts[-1]
    )


def log_move(a: Axis, move: LoggedMove, profile: Profile, is_stop: bool = False) -> None:
    """Log the start of a move and make it the move in progress of its axis.

    `is_stop` is true if it only completes the stop of the move before it.
    """
    move.profile, move.start_time = profile, a.clock.now
    move.scale, move.zero = a.scale.counts, a.scale.zero
    if move.chain < 0:
        move.chain = a.controller.log.chain()
    a.move = move  # first: an interrupt in between then leaves no log entry without an owner
    a.controller.log.moves.add(move)
    a.target = move.target
    if not is_stop:
        for limit in a.barriers:
            limit.forget()


def amend_log(
    log: Log, now: float, entries: Sequence[LoggedMove], profiles: Sequence[Profile], ended: str
) -> None:
    """Replace the rest of a move, or of a path's moves, in the log only.

    Entries with many pieces continue as others, those of a path all at once.
    """
    parts = [move.until(now) for move in entries]
    is_full = not ended and max(len(done.knots) for done in parts) > MAX_PIECES
    for move, done, profile in zip(entries, parts, profiles, strict=True):
        if is_full:
            log.moves.split(move, done, now)
            move.profile = profile
            continue
        # If a new zero was set in between, the two differ by it, and by its rounding.
        move.profile = done.then(profile.scaled(done.end, 1.0) if move.offset else profile)
        move.ended = ended or move.ended


def end_move(a: Axis, ended: str) -> None:
    """Close the log entry of a move that is being replaced; the motion continues."""
    move = a.move
    if move is not None and move.profile is not None:
        if move.action is not None:
            move.action.leave(a, ended)
        done = move.until(a.clock.now)
        exact = a.here(a.clock.now) - move.offset
        # An axis that has not moved is where it was.
        if done.distance and abs(exact - done.end) < watch.margin(exact):
            done = done.ending_at(exact)
        move.profile = done
        move.ended = ended
        a.move = None
        if a.homing is not None:
            a.homing.replaced(move)


def log_dropped(a: Axis, move: LoggedMove) -> None:
    """Log a move of an axis, or of another one on its path, that will not be executed."""
    a.controller.log.dropped.add(move)
    a.controller.log.note(a.clock.now, "dropped", move.axis, ordered=move.line, text=move.command)


def define_position(a: Axis, position: float) -> None:
    """Give the present position a new value; the rest of a move shifts with it."""
    now = a.clock.now
    here = a.here(now)
    shift = position - a.actual_position
    if not shift:
        return
    rest = a.profiles[-1].after(now - a.starts[-1]) if a.move is not None else hold(here)
    if a.move is not None and a.move.action is not None:
        a.move.action.shift(a, shift)
    a.controller.log.zeros.add(Zeroed(now, a.index, a.datum))
    a.datum += shift
    a.target += shift
    if a.move is not None:
        a.move.offset += shift
        a.move.target += shift
    extend_track(a, rest.shifted(shift))
    a.cross(now, here + shift if a.feedback is not None else position)
