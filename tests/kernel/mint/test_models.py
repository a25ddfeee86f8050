"""Names of controllers, in any spelling, and the Mint version of each."""

from __future__ import annotations

import pytest

from motionlang.kernel import unknown_model
from motionlang.kernel.mint import named
from motionlang.kernel.mint.models import MINTMT, PRODUCTS, V4, age


@pytest.mark.parametrize(
    ("name", "product", "spoken"),
    [
        ("NextMove ESB-2", "NextMove ESB-2", MINTMT),
        ("nextmove-esb2", "NextMove ESB-2", MINTMT),
        ("ESB-2", "NextMove ESB-2", MINTMT),
        ("NextMove PCI-2", "NextMove PCI-2", MINTMT),
        ("NextMove PC", "NextMove PC", V4),
        ("MintDrive", "MintDrive", V4),
        ("MINTDRIVE II", "MintDrive II", MINTMT),
        ("FlexDrive", "FlexDrive", MINTMT),
        ("MotiFlex e180", "MotiFlex e180", MINTMT),
        ("e150", "MicroFlex e150", MINTMT),
        ("e100", "NextMove e100", MINTMT),
        ("ServoNode 51", "ServoNode 51", V4),
        ("mint4", None, V4),
        ("MintMT", None, MINTMT),
        ("NextMove", None, MINTMT),
        ("NextMove ESP", None, None),
        ("", None, None),
    ],
)
def test_a_name_means_a_product(name: str, product: str | None, spoken: str | None) -> None:
    assert named(name) == product
    assert age(name) == spoken


@pytest.mark.parametrize("product", PRODUCTS)
def test_every_product_is_known_by_its_own_name_in_any_case(product: str) -> None:
    assert age(product.upper()) == PRODUCTS[product]
    assert unknown_model(product.lower()) is None


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("NextMove ESP", "NextMove ES"),
        ("mint5", "mint4"),
        ("MotiFlex e18", "MotiFlex e180"),
        ("dcx-pci30", "dcx-pci300"),
    ],
)
def test_unknown_model_is_reported_with_a_suggestion(name: str, meant: str) -> None:
    problem = unknown_model(name)
    assert problem == (f"{name!r} is not a known controller", f"did you mean {meant}?")
