"""Forged planners: single changes to the arithmetic of motion, each of which the proof has to reject where it shows.

`python -m tests.forged [COUNT]` forges so many planners, one after the other, and runs the programs of `programs.py`
with each. It prints a line for each planner and lists those that change the motion and pass.
"""
