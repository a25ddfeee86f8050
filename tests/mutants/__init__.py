"""Mutation: a small change to the program that no test notices is a place that no test holds.

`python -m tests.mutants [COUNT] [SEED]` changes one place at a time in profile, controller, operations and actions,
runs the tests of that place, and lists the changes that lived.
"""
