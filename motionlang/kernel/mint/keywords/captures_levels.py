"""The exact time at which a captured quantity crosses a level.

The time is solved for, or is that of the event that changes the quantity.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.controller.triggers.position_zones import Cells
from motionlang.kernel.errors import Rejected
from motionlang.kernel.mint.keywords import captures_quantities as quantities
from motionlang.kernel.mint.keywords.camboxes import AUX_ENCODER, AXIS, ENCODER, CamSource, source_of
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, checked
from motionlang.kernel.mint.keywords.io_outputs import Analogue
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.rate import Rate

EdgeListener = Callable[[bool], None]
View = Callable[[Profile], Profile]

_KINDS = {
    quantities.MEASURED: AXIS,
    quantities.DEMAND: AXIS,
    quantities.ENCODER: ENCODER,
    quantities.AUX_ENCODER: AUX_ENCODER,
}


class _Side:
    """The side of its level on which a watched quantity was last."""

    def __init__(self, side: int = 0) -> None:
        self.side = side


def watch(
    environment: Environment, quantity: int, where: int, level: float, absolute: bool, on_edge: EdgeListener
) -> Callable[[], None]:
    """Call `on_edge(rising)` whenever a quantity crosses a level.

    Returns a function that ends the watch. With `absolute` the sign of the quantity is ignored. For digital
    channels `where` is the channel, and the quantity crosses the level when the channel switches.
    """
    if quantity in (quantities.INPUTS, quantities.OUTPUTS):
        return _watch_bit(environment, quantity, where, on_edge)
    quantities.check(environment, quantity, where)
    if quantity in (quantities.ADC, quantities.DAC):
        return _watch_analogue(environment, quantity, where, level, absolute, on_edge)
    has_motor = quantities.is_of(quantity) and environment.controller.has_motor(where)
    if quantity in _KINDS:
        source = source_of(environment, _KINDS[quantity], where)
        view = _as_it_is if has_motor and quantity == quantities.DEMAND else None
        return _watch_motion(environment, source, source.counts, view, (level, absolute), on_edge)
    if quantity == quantities.SPEED or (quantity == quantities.MEASURED_SPEED and not has_motor):
        source = source_of(environment, AXIS, where)
        source.period, scale = 0.0, environment.controller.axes[where].scale
        return _watch_motion(
            environment,
            source,
            lambda value: scale.to_counts(value, "uu/s"),
            Rate,
            (level, absolute),
            on_edge,
        )
    motor = " of a simulated motor" if has_motor else ""
    words = f"a capture cannot be triggered by {quantities.NAMES[quantity].lower()}{motor}"
    raise Rejected("not-simulated", words, "positions, speeds, encoders and channels can trigger it")


def _as_it_is(profile: Profile) -> Profile:
    """Return the profile unchanged: the demand, which may differ from the motor."""
    return profile


def _watch_motion(
    environment: Environment,
    source: CamSource,
    counts: Callable[[float], float],
    view: View | None,
    level: tuple[float, bool],
    on_edge: EdgeListener,
) -> Callable[[], None]:
    value, absolute = level
    both = absolute and not source.period and value > 0.0
    edges = sorted({counts(value), counts(-value)} if both else {counts(value)})
    if source.period:
        edges = [edges[0] % source.period]
    forward = source.per_unit > 0
    last = _Side()

    def changed(index: int) -> None:
        before, last.side = last.side, index
        on_edge(index != 1 if both else (index > before) is forward)

    cells = Cells(source.track, edges, changed, source.period, source.physical, view)
    last.side = cells.index
    return cells.remove


def _watch_analogue(
    environment: Environment, quantity: int, where: int, level: float, absolute: bool, on_edge: EdgeListener
) -> Callable[[], None]:
    controller, analogue = environment.controller, environment.component(Analogue)
    is_input = quantity == quantities.ADC
    channels = controller.analogue_inputs if is_input else controller.analogue_outputs

    def is_above() -> bool:
        value = analogue.read(where) if is_input else float(channels[where])
        return (abs(value) if absolute else value) >= level

    last = _Side(is_above())

    def changed(channel: int, value: float) -> None:
        before, last.side = last.side, is_above()
        if channel == where and last.side != before:
            on_edge(bool(last.side))

    channels.listen(changed)
    return lambda: channels.listeners.remove(changed)


def _watch_bit(
    environment: Environment, quantity: int, where: int, on_edge: EdgeListener
) -> Callable[[], None]:
    controller = environment.controller
    is_input = quantity == quantities.INPUTS
    channels = controller.inputs if is_input else controller.outputs
    checked(where, LAST_CHANNEL, "channel")

    def changed(channel: int, value: float) -> None:
        if channel == where:
            on_edge(channels.inverted(channel) if is_input else bool(value))

    channels.listeners.append(changed)
    return lambda: channels.listeners.remove(changed)
