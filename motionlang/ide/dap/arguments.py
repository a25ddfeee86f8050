"""The arguments of a request, with checks: a wrong argument is an error response."""

from __future__ import annotations

from collections.abc import Mapping

# Numbers outside this range cannot be represented exactly in JavaScript.
_MOST = 2**53


class RequestRefused(Exception):
    """A request that cannot be carried out.

    `code` is the protocol's code for the reason, such as "notStopped", or "".
    """

    def __init__(self, text: str, code: str = "") -> None:
        super().__init__(text)
        self.code = code


class Arguments:
    """The arguments of one request."""

    def __init__(self, values: object) -> None:
        if values is not None and not isinstance(values, dict):
            raise RequestRefused("arguments must be an object")
        self._values: Mapping[str, object] = values or {}

    def text(self, name: str, default: str | None = None) -> str:
        """Return a text; it is required if there is no default."""
        value = self._values.get(name)
        if value is None and default is not None:
            return default
        if not isinstance(value, str):
            raise RequestRefused(f"{name} must be a text")
        return value

    def number(self, name: str, default: int | None = None) -> int:
        """Return an integer; it is required if there is no default."""
        value = self._values.get(name)
        if value is None and default is not None:
            return default
        if isinstance(value, bool) or not isinstance(value, int) or not -_MOST < value < _MOST:
            raise RequestRefused(f"{name} must be a whole number")
        return value

    def seconds(self, name: str) -> float | None:
        """Return a time, s, or None."""
        value = self._values.get(name)
        if value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0.0 <= value < 1e9:
            raise RequestRefused(f"{name} must be a time in seconds")
        return float(value)

    def flag(self, name: str, default: bool = False) -> bool:
        """Return a truth value."""
        value = self._values.get(name)
        if value is None:
            return default
        if not isinstance(value, bool):
            raise RequestRefused(f"{name} must be true or false")
        return value

    def objects(self, name: str) -> list[Arguments]:
        """Return a list of objects; empty if the argument is missing."""
        value = self._values.get(name)
        if value is None:
            return []
        if not isinstance(value, list) or not all(isinstance(each, dict) for each in value):
            raise RequestRefused(f"{name} must be a list of objects")
        return [Arguments(each) for each in value]

    def texts(self, name: str) -> list[str]:
        """Return a list of texts; a single text becomes a list of one."""
        value = self._values.get(name)
        if value is None:
            return []
        if isinstance(value, str):
            return [value]
        if not isinstance(value, list) or not all(isinstance(each, str) for each in value):
            raise RequestRefused(f"{name} must be a list of texts")
        return list(value)

    def object(self, name: str) -> Arguments:
        """Return an object; empty if the argument is missing."""
        return Arguments(self._values.get(name))

    def items(self, name: str) -> dict[str, float | str]:
        """Return an object of numbers and texts; empty if the argument is missing."""
        value = self._values.get(name)
        if value is None:
            return {}
        if not isinstance(value, dict):
            raise RequestRefused(f"{name} must be an object")
        for each in value.values():
            if isinstance(each, bool) or not isinstance(each, (int, float, str)):
                raise RequestRefused(f"the values of {name} must be numbers or texts")
        return dict(value)
