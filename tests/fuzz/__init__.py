"""No input ends in a traceback: programs made from the tables of words, and from the gallery with pieces changed.

`python -m tests.fuzz mint 1000000` runs so many and prints what brought the interpreter down; the tests run a slice.
"""
