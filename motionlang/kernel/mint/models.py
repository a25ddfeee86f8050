"""The controllers that run Mint, by name, and the two generations of Mint.

v4 has dots and labels, MintMT has brackets and tasks. The names are those of the host library. The generation
of each controller is from memory (docs/contributing/assumptions.md). Further facts about products come from MN1270,
which covers v4, and AN00198, which covers the shared memory.
"""

from __future__ import annotations

from collections.abc import Iterator

V4, MINTMT = "Mint v4", "MintMT"

# Their names on the command line.
NAMES = ("mint4", "mintmt")
# The extension of a program of Mint v4.
V4_SUFFIX = ".prg"
# The family of the string functions that Mint v4 lacks. A program may give their names to what it declares.
STRINGS = "strings"
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
# Words that name a generation, or a family whose controllers are mostly of one.
_AGES = {
    "mint4": V4, "mintv4": V4, "mintmt": MINTMT, "servonode": V4, "nextmove": MINTMT, "motiflex": MINTMT,
}  # fmt: skip
# Prefixes that may be left out of a product's name if the rest is unambiguous: ESB-2, e150.
_FAMILIES = ("nextmove", "microflex", "motiflex")

# Families of keywords that MN1270 gives only to some v4 products, and the largest value that it gives for
# some (p. 85, 111, 120).
_PROGRAMMED = ("MintDrive", "ServoNode 51")
_NOT_NEXTMOVE = tuple(name for name in _V4 if not name.startswith("NextMove"))
ABSENT: dict[str, tuple[str, ...]] = {
    "offset modes": tuple(name for name in _V4 if name not in _PROGRAMMED),
    "splines": _NOT_NEXTMOVE,
}
LARGEST: dict[str, tuple[float, tuple[str, ...]]] = {"gearing": (20000.0, _PROGRAMMED)}

# The name that WorkBench's library gives its own simulated controller.
VIRTUAL = "Virtual Controller"


def named(model: str) -> str | None:
    """Return the product that a name refers to, None if there is none.

    Case, blanks and punctuation are ignored.
    """
    return _PRODUCT_OF.get(_plain(model))


def age(model: str) -> str | None:
    """Return `V4` or `MINTMT` for the name of a controller, None for an unknown one."""
    product = named(model)
    return _AGES.get(_plain(model)) if product is None else PRODUCTS[product]


def _spellings(plain: str) -> Iterator[str]:
    """Yield a product's name, and the name without its family if that is unambiguous."""
    yield plain
    for family in _FAMILIES:
        rest = plain.removeprefix(family)
        if rest and rest != plain and (rest != "e100" or family == "nextmove"):
            yield rest


def _plain(name: str) -> str:
    return "".join(letter for letter in name.lower() if letter.isalnum())


# The first product of each spelling.
_PRODUCT_OF = {
    spelling: product for product in reversed(PRODUCTS) for spelling in _spellings(_plain(product))
}
