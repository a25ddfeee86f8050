"""No input ends in a traceback: generated and mutated programs.

`python -m tests.fuzz mint 1000000` runs a million and prints those that crash the interpreter; the tests run a
sample.
"""
