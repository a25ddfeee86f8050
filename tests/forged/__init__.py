"""Forged planners: single changes of motion arithmetic that the proof must reject.

A change that has no visible effect is allowed. `python -m tests.forged [COUNT]` forges that many planners,
one after the other, and runs the programs of `programs.py` with each. It prints a line for each planner and
lists those that change the motion and pass.
"""
