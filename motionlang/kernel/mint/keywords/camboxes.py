"""Cam boxes: outputs that switch at exact positions of an axis or an encoder.

The positions are pairs, on and off, in an array of the program whose element 1 is the count. A box uses the
array, the scale and the wrap as they are when it is enabled. A later change of the scale does not move
the counts at which it switches.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import pairwise

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.motion.encoder import AUXILIARY
from motionlang.kernel.controller.triggers.position_zones import Cells
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.following_auxiliary import AuxEncoders, checked_channel
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, checked
from motionlang.kernel.mint.keywords.sensing import Encoders, channel_of
from motionlang.kernel.mint.keywords.table_motion_cams import elements
from motionlang.kernel.mint.runtime.binding import ByNumber, axis_of, of, scale_of
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.planners.extrapolation import Extrapolated

LAST_BOX = 31
# The sources, with the numbers of LATCHSOURCE.
AXIS, ENCODER, AUX_ENCODER = 0, 1, 2


class CamSource:
    """The source of a cam box: a track, and the conversion of positions to counts."""

    def __init__(
        self, track: Axis, zero: float, per_unit: float, wrap: float, physical: bool = False
    ) -> None:
        self.track, self.zero, self.per_unit, self.physical = track, zero, per_unit, physical
        self.period = abs(wrap * per_unit)

    def counts(self, position: float) -> float:
        return (position - self.zero) * self.per_unit


def source_of(environment: Environment, kind: int, channel: int) -> CamSource:
    """Return the track that a cam box watches, with its conversion to user units.

    Raises Rejected if there is no such source.
    """
    controller = environment.controller
    if kind == AXIS:
        scale = scale_of(environment, channel)
        return CamSource(controller.axes[channel], 0.0, scale.counts, scale.wrap)
    encoders = environment.component(Encoders if kind == ENCODER else AuxEncoders)
    shown = (
        encoders.setting("zero", channel),
        encoders.per_unit(channel),
        encoders.setting("ENCODERWRAP", channel),
    )
    if kind == AUX_ENCODER:
        return CamSource(controller.encoder(AUXILIARY + channel), *shown)
    if channel in controller.encoders:
        return CamSource(controller.encoders[channel], *shown)
    return CamSource(controller.axes[channel], *shown, physical=True)


class CamBox:
    """One cam box: its source, its output, and its lead time in seconds."""

    def __init__(self, environment: Environment, number: int) -> None:
        self._environment, self.number = environment, number
        self.output, self.kind, self.channel, self.lead = 0, AXIS, 0, 0.0
        self.table: Sequence[float] | None = None
        self._states: list[int] = []
        self._cells: Cells | None = None

    @property
    def enabled(self) -> bool:
        return self._cells is not None

    def enable(self, enabled: bool) -> None:
        """Enable the box, or disable it and leave its output unchanged.

        When it is enabled, the output takes the state that belongs to the present position.
        """
        if self._cells is not None:
            self._cells.remove()
            self._cells = None
        if not enabled:
            return
        source = source_of(self._environment, self.kind, self.channel)
        edges, self._states = self._edges(source)
        view = None
        if self.lead:
            view = partial(Extrapolated, lead=self.lead)
        self._cells = Cells(
            source.track,
            edges,
            self._show,
            source.period,
            source.physical,
            view,
        )
        self._show(self._cells.index)

    def _show(self, index: int) -> None:
        states = self._states
        if self._cells is not None and self._cells.period:
            state = states[(index - 1) % len(states)]
        else:
            state = states[index - 1] if index else 0
        self._environment.controller.set_output(self.output, state)

    def _edges(self, source: CamSource) -> tuple[list[float], list[int]]:
        """Return the positions at which the output changes, and the state after each.

        The positions are in ascending order. The states are those of forward motion.
        """
        positions = self._positions()
        found: list[tuple[float, int]] = []
        for begin, end in zip(positions[::2], positions[1::2], strict=True):
            if not source.period and begin >= end:
                raise self._wrong(f"it is on from {begin:.10g} to {end:.10g}")
            found += [(source.counts(begin), 1), (source.counts(end), 0)]
        if source.period:
            found = sorted((position % source.period, state) for position, state in found)
        for (position, state), (other, following) in pairwise(found):
            if position >= other or state == following:
                raise self._wrong("its stretches touch or overlap")
        return [position for position, _ in found], [state for _, state in found]

    def _positions(self) -> list[float]:
        if self.table is None:
            raise Rejected("range", f"cam box {self.number} has no positions",
                          f"write CAMBOXDATA({self.number}, …) first")  # fmt: skip
        positions = elements(self.table, "CAMBOXDATA")
        if len(positions) % 2:
            raise self._wrong(f"{len(positions)} positions are no pairs")
        return positions

    def _wrong(self, what: str) -> Rejected:
        return Rejected(
            "range", f"cam box {self.number}: {what}", "the table is pairs of positions: on, off, on, off …"
        )


class CamBoxes:
    """The cam boxes, created on first use."""

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        self._boxes = ByNumber(lambda number: CamBox(environment, checked(number, LAST_BOX, "cam box")))

    def box(self, number: int) -> CamBox:
        return self._boxes[number]


# ----------------------------------------------------------------------------------------------- operations


def write_box(boxes: CamBoxes, number: int, enabled: int) -> None:
    """CAMBOX: enable the box with its present data, or disable it."""
    boxes.box(number).enable(bool(enabled))


def do_data(
    boxes: CamBoxes,
    number: int,
    output: int,
    kind: int,
    channel: int,
    time: int,
    table: Sequence[float] | None,
) -> None:
    """CAMBOXDATA: set output, source, lead time in ms and table.

    An enabled box is restarted.
    """
    box = boxes.box(number)
    checked(output, LAST_CHANNEL, "output")
    checked(kind, AUX_ENCODER, "source of a cam box")
    if not 0 <= time <= 32767:
        raise Rejected("range", f"CAMBOXDATA cannot switch {time} ms ahead", "it takes 0 to 32767")
    validate = (axis_of, channel_of, lambda _, channel: checked_channel(channel))[kind]
    validate(boxes.environment, channel)
    enabled = box.enabled
    box.enable(False)
    box.output, box.kind, box.channel, box.lead, box.table = output, kind, channel, time / 1000.0, table
    if enabled:
        box.enable(True)


# ------------------------------------------------------------------------------------------------- keywords

_BOX_ACTIONS = Actions(
    read=of(CamBoxes, lambda boxes, number: int(boxes.box(number).enabled)), write=of(CamBoxes, write_box)
)

_BOX = (
    "Dim p(3) As Float = 2, 20, 30\nCAMBOXDATA(0, 5, 0, 0, 0, p)\nCAMBOX(0) = _ON\nPRINT CAMBOX(0), OUTX(5)"
)


ROWS = (
    Keyword("CAMBOX", "", "setting", "RW", "box", "bool", _BOX_ACTIONS,
            "State of a cam box: 1 switches its output at the positions of its CAMBOXDATA.",
            _BOX, default=0.0, low=0, high=1, group="latches"),
    Keyword("CAMBOXDATA", "", "command", "C", "box, output, source, channel, time, array", "",
            Actions(do=of(CamBoxes, do_data)),
            "Define a cam box: its output, its source (0 an axis, 1 an encoder, 2 an auxiliary encoder) and the "
            "source's channel, how many ms ahead it switches, and a table of pairs of positions, on and off, whose "
            "element 1 is the count.",
            _BOX, group="latches"),
)  # fmt: skip
