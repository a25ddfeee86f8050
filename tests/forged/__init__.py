"""Forged planners: single changes of motion arithmetic that the proof or the tests of planners must reject.

The proof has to reject those that break a limit, an end or continuity. Those that are only slow have to fail the tests
of planners (`plugin.py`).

Changes without a visible effect are allowed. `python -m tests.forged [COUNT]` forges COUNT planners, one after
the other, and runs the programs of `programs.py` with each. It prints a line for each planner, and lists those
that change the motion and still pass.
"""
