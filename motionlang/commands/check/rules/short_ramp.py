"""A ramp is shorter than one update of the trajectory."""

from __future__ import annotations

from motionlang.commands.check.rule import Case, Rule

RULE = Rule(
    code="short-ramp",
    group="Motion",
    text="""\
An ACCELTIME or DECELTIME below one millisecond, or an ACCEL or DECEL that reaches SPEED in less, is a ramp of no
trajectory update: the axis would jump to its speed. The times are in milliseconds, so 0.2 for 0.2 s is such a ramp. A
rate is compared with the greatest literal SPEED of its axis. `run` also shows this warning.
""",
    fix="write the time in milliseconds, or the rate in user units/s²",
    mint=Case(
        None,
        wrong="SPEED(0) = 50\nACCELTIME(0) = 0.2\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="SPEED(0) = 50\nACCELTIME(0) = 200\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
)
