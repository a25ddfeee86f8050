"""A ramp is shorter than one update of the trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.resolve.short_ramps import UPDATE, USUAL, short_ramps

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import AxisKey as Key


def check_mint(facts: MintFacts, warn: Warn) -> None:
    for message, at, hint in short_ramps(facts.structure.statements.values()):
        warn(message, at, hint)


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    """Compare each rate with the greatest velocity of its axis; in another unit of time the quotient is no ramp."""
    if any(row.function == "rate" for row in facts.used):
        return
    known = facts.values(lambda row: row.gives == "speed")
    speeds: dict[Key, float] = {key: max(values) for key, values in known.items() if values}
    for act in facts.written_by(lambda row: row.gives in ("accel", "decel")):
        speed, rate = speeds.get(act.axes[0]), act.number(0)
        if speed is None or not rate or None in known:
            continue
        if 0.0 < speed / rate < UPDATE:
            ramp = f"a ramp of {speed / rate * 1e3:.3g} ms to SV{speed:.10g}"
            message = f"{ramp} is shorter than one trajectory update, 1 ms"
            warn(message, act.at, f"for a ramp of {USUAL * 1e3:.0f} ms write {speed / USUAL:.10g}")


RULE = Rule(
    code="short-ramp",
    text="""\
An ACCELTIME or DECELTIME below one millisecond, or an ACCEL or DECEL that reaches SPEED in less, is a ramp of no
trajectory update: the axis would jump to its speed. The times are in milliseconds, so 0.2 for 0.2 s is such a ramp. A
rate is compared with the greatest literal SPEED of its axis. `run` also shows this warning. In MCCL: an SA or DS that
reaches the greatest SV of its axis within a millisecond.
""",
    fix="write the time in milliseconds, or the rate in user units/s²",
    mint=RuleCase(
        check_mint,
        wrong="SPEED(0) = 50\nACCELTIME(0) = 0.2\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="SPEED(0) = 50\nACCELTIME(0) = 200\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(
        check_mccl,
        wrong="1MN,1SV20000,1SA100000000\n1MR100,1WS\n",
        right="1MN,1SV20000,1SA100000\n1MR100,1WS\n",
    ),
)
