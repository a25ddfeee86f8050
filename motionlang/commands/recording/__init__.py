"""A recording of a real machine, read as machines write it: a file becomes signals over seconds, and a sentence.

table.py    the file: text or Parquet as columns of text, with names and units
values.py   a cell of text as a number or a level
clock.py    the column of times as seconds: units, dates, times of day
order.py    the rows in order of time: newest first, swapped, doubled, time that starts again, coarse clocks
columns.py  the meaning of a column, by its name or by `--map`
reading.py  all of it: the signals, the gaps, the rows left out with their reasons, the sentence

A caller gets the signals of `read_recording`, whose `sentence` is the first line of its answer.
"""

from motionlang.commands.recording.columns import CHANNELS, QUANTITIES, Mapped, mapped
from motionlang.commands.recording.reading import GAP, RecordedSignal, Recording, read_recording
from motionlang.commands.recording.table import RecordedTable, read_file, table_of

__all__ = [
    "CHANNELS",
    "GAP",
    "QUANTITIES",
    "Mapped",
    "RecordedSignal",
    "RecordedTable",
    "Recording",
    "mapped",
    "read_file",
    "read_recording",
    "table_of",
]
