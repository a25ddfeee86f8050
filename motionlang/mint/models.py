"""The controllers that speak Mint, by their names, and its two ages: v4 with dots and labels, MintMT with brackets and
tasks.

The names are those of the host library; which of them speak which is remembered (docs/fidelity.md). What else is known
of a product is in MN1270, which is of v4, and AN00198, which is of the shared memory.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

V4, MINTMT = "Mint v4", "MintMT"

# How they are called on the command line.
NAMES = ("mint4", "mintmt")
_V4 = (
    "EuroSystem", "ServoNode 34", "ServoNode 50", "ServoNode 51", "NextMove PC", "NextMove PC2", "NextMove RK",
    "NextMove BX", "MintDrive",
)  # fmt: skip
_MINTMT = (
    "NextMove PCI", "NextMove PCI-2", "NextMove BX II", "NextMove ST", "NextMove ES", "NextMove ESB", "NextMove ESB-2",
    "NextMove ESL", "NextMove e100", "MintDrive II", "Flex+Drive II", "FlexDrive", "FlexDrive II", "MicroFlex",
    "MicroFlex e100", "MicroFlex e150", "MicroFlex e190", "MotiFlex e100", "MotiFlex e180", "EuroFlex", "H2 drive",
    "Virtual Controller",
)  # fmt: skip
PRODUCTS: dict[str, str] = {**dict.fromkeys(_V4, V4), **dict.fromkeys(_MINTMT, MINTMT)}
# Words that name an age, or a family whose controllers are mostly of one.
_AGES = {
    "mint4": V4, "mintv4": V4, "mintmt": MINTMT, "servonode": V4, "nextmove": MINTMT, "motiflex": MINTMT,
}  # fmt: skip
# What a product's name may be said without, where it says enough all the same: ESB-2, e150.
_FAMILIES = ("nextmove", "microflex", "motiflex")

# Families of words that MN1270 gives to some v4 products only, and the largest value that it gives to some (p. 85, 111,
# 120).
_PROGRAMMED = ("MintDrive", "ServoNode 51")
_NOT_NEXTMOVE = tuple(name for name in _V4 if not name.startswith("NextMove"))
ABSENT: dict[str, tuple[str, ...]] = {
    "offset modes": tuple(name for name in _V4 if name not in _PROGRAMMED),
    "splines": _NOT_NEXTMOVE,
}
LARGEST: dict[str, tuple[float, tuple[str, ...]]] = {"gearing": (20000.0, _PROGRAMMED)}


def named(model: str) -> str | None:
    """The product that a name means, in any case, with or without blanks and signs; None where it means none."""
    wanted = _plain(model)
    for product in PRODUCTS:
        if wanted in _spellings(_plain(product)):
            return product
    return None


def age(model: str) -> str | None:
    """`V4` or `MINTMT` for the name of a controller, None where there is no such controller."""
    product = named(model)
    return _AGES.get(_plain(model)) if product is None else PRODUCTS[product]


def _spellings(plain: str) -> Iterator[str]:
    """A product's name, and what remains of it without its family, where no other product is called so."""
    yield plain
    for family in _FAMILIES:
        rest = plain.removeprefix(family)
        if rest and rest != plain and (rest != "e100" or family == "nextmove"):
            yield rest


def _plain(name: str) -> str:
    return "".join(letter for letter in name.lower() if letter.isalnum())
