"""Forged planners: single changes of motion arithmetic that the proof must reject.

Changes without a visible effect are allowed. `python -m tests.forged [COUNT]` forges COUNT planners, one after
the other, and runs the programs of `programs.py` with each. It prints a line for each planner, and lists those
that change the motion and still pass.
"""
