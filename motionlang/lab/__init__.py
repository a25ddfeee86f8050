"""Drives and servo loops on the bench, apart from any program of the two languages.

`servo` is the servo laboratory: step responses, tuning, what a loop does with a move. `pvt` has moves by position,
velocity and time, `copley` the drive that takes them: its buffer, serial words, and the objects of CANopen. `notes` has
the figures that the vendors' documents print. No run of a program imports this package.
"""
