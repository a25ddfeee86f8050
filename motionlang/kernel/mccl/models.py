"""The boards: differences between models, as switches for the rest of the dialect.

The facts are from docs/contributing/assumptions.md. Unless a source says otherwise, an older board behaves
like the MultiFlex.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault

# The command families that boards lack, a column of the rows. MCAPI has a flag for each. Which board lacks
# which is remembered, or inferred from the LM628 chip of the basic modules, which has one profile, one rate
# and no feed-forward.
_CONTOURS, _TASKS, _SCALES, _OUTPUT_CONTROL = "contours", "tasks", "scales", "output control"
_BASIC = ("profiles", "deceleration", "rates", "feed-forward", _OUTPUT_CONTROL)


@dataclass(eq=False, slots=True)
class Model:
    """One board.

    `prompt`, `echo` and `line_end` define its dialogue. `rounds` is true if parameters are rounded to counts
    before a scale is set. `lacks` has the families of commands that are missing. `macros` is the highest
    macro number, and `registers` the number of registers. `words` is true if TS has its four status words,
    and `at_target` if status bit 2 means "at target". `outputs` has the channels that are outputs at
    power-up, and `channels` is the highest number of a digital channel. `whole_gains` is true if gains are
    integers. `update` is the servo period, s. `stepper` has velocity, acceleration and minimum velocity of a
    stepper at power-up. `axes` is the number of axes.
    """

    name: str
    title: str
    prompt: str = ">"
    echo: bool = True
    line_end: str = "\n"
    rounds: bool = True
    lacks: tuple[str, ...] = ()
    macros: int = 1000
    registers: int = 256
    words: bool = True
    at_target: bool = True
    outputs: range = range(9, 17)
    channels: int = 80
    whole_gains: bool = False
    update: float = 0.00025
    stepper: tuple[float, float, float] = (40_000.0, 100_000.0, 0.0)
    axes: int = 8

    @property
    def separate_decel(self) -> bool:
        """True if deceleration has its own setting; if not, the acceleration sets both."""
        return "deceleration" not in self.lacks


_MODELS = (
    Model("multiflex", "MultiFlex PCI 1000 series", outputs=range(33, 49), channels=64,
          stepper=(10_000.0, 10_000.0, 1000.0)),
    Model("dcx-pci300", "DCX-PCI300, DSP based modular controller", words=False, lacks=(_OUTPUT_CONTROL,)),
    Model("dcx-pci100", "DCX-PCI100 modular controller", words=False, at_target=False, whole_gains=True,
          lacks=_BASIC, update=0.000341),
    Model("dcx-at200", "DCX-AT200 advanced modular controller", line_end="\r", words=False,
          at_target=False, lacks=(_OUTPUT_CONTROL,), channels=64, update=0.001, axes=6),
    Model("dcx-pc100", "DCX-PC100 modular controller", prompt="", echo=False, line_end="\r", macros=255, words=False,
          at_target=False, whole_gains=True, lacks=(*_BASIC, _TASKS, _SCALES, _CONTOURS), update=0.001),
)  # fmt: skip

# The boards by name.
MODELS: dict[str, Model] = {model.name: model for model in _MODELS}
DEFAULT = "multiflex"
# The board of a file by PMC's suffixes; suffixes of boards that are not simulated are missing.
_SUFFIXES = {
    "pc1": "dcx-pc100",
    "at2": "dcx-at200",
    "pci1": "dcx-pci100",
    "pci3": "dcx-pci300",
    "mfx1": "multiflex",
}


def written_for(name: str) -> str:
    """Return the model that a file name implies, or the default."""
    return _SUFFIXES.get(name.rpartition(".")[2].lower(), DEFAULT)


def named(name: str) -> Model | None:
    """Return the model of a name in any case, None if there is none."""
    return MODELS.get(name.lower())


def missing(model: Model, row: Keyword) -> Fault:
    """Return the fault with which a board answers a command that it does not have."""
    hint = elsewhere(lambda each: row.family not in each.lacks)
    return Fault(codes.INVALID, f"the {model.title} has no {row.name}", hint, "model")


def no_macro_number(model: Model, number: int) -> Fault:
    """Return the fault of a macro number that a board does not have."""
    message = f"macros are numbered 0 to {model.macros}, not {number}"
    return Fault(codes.MACRO_RANGE, message, elsewhere(lambda each: 0 <= number <= each.macros), "range")


def elsewhere(has: Callable[[Model], bool]) -> str:
    """Return a hint with the models that have what a program needs; "" if there are none."""
    names = models_with(has)
    return (
        f"{names} {'have' if ',' in names else 'has'} it: controller.model in the machine file"
        if names
        else ""
    )


def models_with(has: Callable[[Model], bool]) -> str:
    """Return the names of the models that have what a program needs."""
    return ", ".join(each.name for each in _MODELS if has(each))
