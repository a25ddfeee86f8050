"""Check messages against `debugProtocol.json`, which comes with debugpy."""

from __future__ import annotations

import importlib.util
import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

NAME = "debugProtocol.json"
_TYPES: dict[str, Any] = {
    "string": str, "integer": int, "number": (int, float), "boolean": bool, "object": dict, "array": list,
    "null": type(None),
}  # fmt: skip


def is_installed() -> bool:
    """True if debugpy, which contains the description of the protocol, is installed."""
    return _path() is not None


@cache
def _path() -> Path | None:
    found = importlib.util.find_spec("debugpy")
    if found is None or found.origin is None:
        return None
    return next(Path(found.origin).parent.rglob(NAME), None)


@cache
def _definitions() -> dict[str, Any]:
    path = _path()
    assert path is not None
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))["definitions"]
    return found


def problems(message: dict[str, Any]) -> list[str]:
    """Return how a message of the adapter violates the protocol; empty if it does not."""
    kind = message["type"]
    if kind == "event":
        name = f"{message['event'][:1].upper()}{message['event'][1:]}Event"
    elif message["success"]:
        name = f"{message['command'][:1].upper()}{message['command'][1:]}Response"
    else:
        name = "ErrorResponse"
    if name not in _definitions():
        return [f"the protocol has no {name}"]
    return list(_check({"$ref": f"#/definitions/{name}"}, message, name))


def _check(schema: dict[str, Any], value: Any, where: str) -> Iterator[str]:
    if "$ref" in schema:
        yield from _check(_definitions()[schema["$ref"].rpartition("/")[2]], value, where)
        return
    for subschema in schema.get("allOf", ()):
        yield from _check(subschema, value, where)
    wanted = schema.get("type")
    if wanted is not None:
        kinds = [wanted] if isinstance(wanted, str) else wanted
        fits = any(
            isinstance(value, _TYPES[kind]) and (kind == "boolean" or not isinstance(value, bool))
            for kind in kinds
        )
        if not fits:
            yield f"{where} is {value!r}, not {wanted}"
            return
    if "enum" in schema and value not in schema["enum"]:
        yield f"{where} is {value!r}, not one of {schema['enum']}"
    if isinstance(value, dict):
        for name in schema.get("required", ()):
            if name not in value:
                yield f"{where} has no {name}"
        for name, subschema in schema.get("properties", {}).items():
            if name in value:
                yield from _check(subschema, value[name], f"{where}.{name}")
    if isinstance(value, list) and "items" in schema:
        for number, each in enumerate(value):
            yield from _check(schema["items"], each, f"{where}[{number}]")
