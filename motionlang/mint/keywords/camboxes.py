"""Outputs that are switched by the position of an axis or an encoder."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_BOX = (
    "Dim p(3) As Float = 2, 20, 30\nCAMBOXDATA(0, 5, 0, 0, 0, p)\nCAMBOX(0) = _ON\nPRINT CAMBOX(0), OUTX(5)"
)

ROWS = (
    Keyword("CAMBOX", "", "setting", "RW", "box", "bool", "camboxes.box",
            "Whether a cam box switches its output at the positions of its CAMBOXDATA.",
            _BOX, default=0.0, low=0, high=1, group="latches"),
    Keyword("CAMBOXDATA", "", "command", "C", "box, output, source, channel, time, array", "", "camboxes.data",
            "Define a cam box: its output, its source (0 an axis, 1 an encoder, 2 an auxiliary encoder) and the "
            "source's channel, how many ms ahead it switches, and a table of pairs of positions, on and off, whose "
            "element 1 is the count.",
            _BOX, group="latches"),
)  # fmt: skip
