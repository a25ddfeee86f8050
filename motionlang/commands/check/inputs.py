"""The digital inputs that may change during a run."""

from __future__ import annotations

from collections.abc import Mapping


def driven_inputs(settings: Mapping[str, object]) -> set[int] | None:
    """Return the digital inputs driven by a machine file; None without a file.

    Without a file every input may change.
    """
    if all(key.startswith(("controller.", "run.")) for key in settings):
        return None
    found: set[int] = {entry["channel"] for entry in settings.get("input", ())}  # type: ignore[attr-defined]
    return found | {value for key, value in settings.items() if key.endswith("_input")}  # type: ignore[misc]
