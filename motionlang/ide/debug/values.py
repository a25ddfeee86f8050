"""Values of variables as text."""

from __future__ import annotations


def shown(value: object) -> str:
    """Return a value as text: 10 digits, texts in quotes, elements in brackets."""
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "1" if value else "0"
    if isinstance(value, float):
        return f"{value:.10g}" if round(value, 12) or value == 0 else "0"
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, (list, tuple)):
        return f"({', '.join(shown(getattr(each, 'value', each)) for each in value)})"
    return str(value)
