"""Mutation: a small change of the program that no test detects shows a gap.

`python -m tests.mutants [COUNT] [SEED]` makes one change at a time in planners, controller, operations and
actions, runs the tests that reach it, and lists the survivors.
"""
