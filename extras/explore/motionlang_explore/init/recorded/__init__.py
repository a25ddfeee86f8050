"""The world of a machine from its recording: the rule that explains each input, with its figures, and a comparison.

recording.py   the columns of the file: changes of channels, positions of axes
rules.py       the rules that may explain the changes of an input
judging.py     the run judges which of them are right
levels.py      the level of an analogue input
unrecorded.py  the entries that no column has: keys, answers, numbers of a host
outcome.py     a run against the recording: power-up, the clock, the cycle
axes.py        switches, scale, speed and lag of the axes, and the clock by their strokes
drafting.py    the draft of the machine file: measured, the rest explored, and run
"""
