"""Names that are no longer commands, options, keys or parameters, and what does their work."""

from __future__ import annotations

REMOVED = {"prove": "certify verifies the motion of a run"}


def refuse_prove(value: object) -> None:
    """Refuse the parameter `prove` of `run` and `sweep`, which the file of a user may still give."""
    if value is not None:
        raise ValueError(f"there is no parameter prove: {REMOVED['prove']}")
