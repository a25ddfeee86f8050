"""No input ends in a traceback: generated programs, and mutated ones.

`python -m tests.fuzz mint 1000000` runs that many and prints those that crash the interpreter; the tests run
a sample.
"""
