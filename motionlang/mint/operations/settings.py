"""Settings of axes that are kept by keyword and axis, until DEFAULT takes them back."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeVar

    Value = TypeVar("Value")


def forget(settings: dict[tuple[str, int], Value], axis: int) -> None:
    """What was set for an axis is as it was before any program."""
    for key in [key for key in settings if key[1] == axis]:
        del settings[key]
