"""Mutants that change nothing that can be seen, by their names, each with the reason.

To rounding, as two ways to the same figure may differ in their last bits.
"""

from __future__ import annotations

EQUIVALENT: dict[str, str] = {
    "motionlang/profile/approach.py: _travel: v >= speed -> v > speed": (
        "a peak that is just the speed leaves nothing to slew but rounding"
    ),
    "motionlang/profile/bent.py: Bent: curve: self.duration > knots[-2] -> self.duration >= knots[-2]": (
        "where both are the same the last piece has no time in which anyone is on it"
    ),
    "motionlang/profile/between.py: _farthest: 0.5 -> 1.5 #3": (
        "how soon the secants come near; the halves that follow find the last bit from anywhere"
    ),
    "motionlang/profile/composed.py: _on: place < 0.0 -> place <= 0.0": (
        "at 0 the straight continuation and the curve have the same position and slope"
    ),
    "motionlang/profile/fade.py: fade: bounds.decel * bounds.decel -> bounds.decel / bounds.decel": (
        "v0 beside it is at least as large as what can be lost by rounding there"
    ),
    "motionlang/profile/formula.py: Formula: _turn: last > 0.0 -> last >= 0.0": (
        "a last of 0 has returned in the line before"
    ),
    "motionlang/profile/jerk.py: _directly: 0.5 -> 1.5": (
        "only whether the closed form is asked: the search that is asked otherwise comes to the same plan"
    ),
    "motionlang/profile/jerk.py: _stops_within: 1e-09 -> 1.000000001": (
        "only whether the plan is written out: the general one comes to the same"
    ),
    "motionlang/profile/jerk.py: peak_speed: v - u >= accel * rise -> v - u > accel * rise": (
        "where both are the same the closed form and Newton's steps come to the same speed"
    ),
    "motionlang/profile/lookahead.py: _ramps_of: way * (1.0 + _SLACK) -> way / (1.0 + _SLACK)": (
        "`reaches` allows the slack once more, and the speed asked for has been found to fit without any"
    ),
    "motionlang/profile/ramps.py: _add_trapezoidal: 0.0 -> 1.0 #12": "the frequency of a wave of no height",
    "motionlang/profile/sample.py: _sample_chunk: 4 -> 5 #2": "the fifth column is read by none",
    "motionlang/profile/sample.py: _sample_short: 0 -> 1": "how many points are worked on at once",
    "motionlang/profile/sample.py: _sample_short: 1 -> 2": "how many points are worked on at once",
}
