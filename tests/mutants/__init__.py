"""Mutation testing: a small change that no test detects shows a gap in the tests.

`python -m tests.mutants [COUNT] [SEED]` makes one change at a time in the package, runs the tests that reach it,
and lists the survivors.
"""
