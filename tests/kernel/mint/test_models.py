"""Names of controllers, in any spelling."""

from __future__ import annotations

import pytest

from motionlang.kernel import unknown_model
from motionlang.kernel.mint import DIALECT, named


@pytest.mark.parametrize(
    ("name", "product"),
    [
        ("NextMove ESB-2", "NextMove ESB-2"),
        ("nextmove-esb2", "NextMove ESB-2"),
        ("ESB-2", "NextMove ESB-2"),
        ("NextMove PCI-2", "NextMove PCI-2"),
        ("NextMove PC", "NextMove PC"),
        ("MintDrive", "MintDrive"),
        ("MINTDRIVE II", "MintDrive II"),
        ("FlexDrive", "FlexDrive"),
        ("MotiFlex e180", "MotiFlex e180"),
        ("e150", "MicroFlex e150"),
        ("e100", "NextMove e100"),
        ("ServoNode 51", "ServoNode 51"),
        ("mint4", None),
        ("MintMT", None),
        ("NextMove", None),
        ("NextMove ESP", None),
        ("", None),
    ],
)
def test_a_name_means_a_product(name: str, product: str | None) -> None:
    assert named(name) == product


@pytest.mark.parametrize("product", DIALECT.models())
def test_every_product_is_known_by_its_own_name_in_any_case(product: str) -> None:
    assert DIALECT.knows_model(product.upper())
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
