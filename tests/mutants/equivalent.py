"""Mutants that change nothing that can be seen, by their names, each with the reason."""

from __future__ import annotations

EQUIVALENT: dict[str, str] = {}
