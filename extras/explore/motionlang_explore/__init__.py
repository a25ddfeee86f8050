"""The exploration of a program, and the commands that ask it."""

# What each command does; the name of each comes from an entry point.
SUMMARIES = {
    "cover": "show which statements and conditions of programs their runs reach",
    "improve": "find a shorter cycle within the limits of the machine",
    "init": "write a first machine file for a program, and run it",
    "map": "show what a program does: channels, axes, structure, states",
    "panel": "operate the machine of a program in a browser",
}
