"""The listing of an MCCL program: commands with the operations they execute."""

from __future__ import annotations

from motionlang.mccl.resolve.listing import listing
from motionlang.source import Source


def test_each_command_has_its_operation_and_parameters() -> None:
    """Columns are as wide as the longest command of the line."""
    found = listing(Source("a.mcl", 'MD1,1MR@5,NO\n1MR-5 , LU"STATUS",2RL@0 ; comment\n\nWA0.5,tp\n1BF\n'))
    assert not found.is_python
    assert found.lines == [
        (1, " MD1  ", "macros.define_macro(1)"),
        (1, " 1MR@5", "motion.move_by(axis 1, register 5)"),
        (1, " NO   ", "flow.nothing()"),
        (2, " 1MR-5     ", "motion.move_by(axis 1, -5)"),
        (2, ' LU"STATUS"', "registers_variables.look_up('STATUS')"),
        (2, " 2RL@0     ", "registers_variables.read_long(axis 2, register 0)"),
        (4, " WA0.5", "flow_waits.wait(0.5)"),
        (4, " tp   ", "reports.tell_position()"),
        (5, " 1BF", "trajectory_backlash.backlash_off(axis 1)"),
    ]
