"""Drives and servo loops on the bench, apart from any program of the two languages.

`servo` is the servo laboratory: step responses, tuning, what a loop does with a move. `pvt` has moves by position,
velocity and time, as a drive takes them: points, serial words, frames. No run of a program imports this package.
"""
