"""Data that outlives a run: variables declared `nv`, and numbered words.

They are in a JSON file next to the program: variables by name, and words of 32 bits by address. Without a
file, they last only as long as the run.
"""

from __future__ import annotations

from json import dumps, loads
from math import inf
from struct import pack, unpack
from typing import Any

from motionlang.kernel.files import Lock, replacing
from motionlang.kernel.source import contents

SCHEMA = "motionlang.nv/1"
# Seconds for which a run waits for another one that has the file: runs that a script starts at once take
# turns.
PATIENCE = 10.0
LAST_WORD = 1023
_LOW, _HIGH = -2147483648, 2147483647
_LARGEST_FLOAT = 3.4028235677973366e38  # from here on a number rounds to infinity in 32 bits


class NonVolatile:
    """The stored values, and the live variables of the running program."""

    def __init__(self, path: str | None = None) -> None:
        """Lock the file against other runs, and read it if it exists.

        Raises InUse if another run has the lock, OSError or ValueError if the file cannot be locked or read.
        """
        self.path = path
        self._lock: Lock | None = None
        self._values: dict[str, object] = {}
        self._words: dict[int, int] = {}
        self._live: dict[str, list[object]] = {}
        if path is not None:
            self._lock = Lock(path, PATIENCE)
            try:
                self._read(path)
            except BaseException:
                self.close()
                raise

    def _read(self, path: str) -> None:
        try:
            with open(path, "rb") as file:
                tree: Any = loads(contents(file))
        except FileNotFoundError:
            return
        except RecursionError:
            raise ValueError("its values are nested too deeply") from None
        if not isinstance(tree, dict) or tree.get("schema") != SCHEMA:
            raise ValueError(f"it is not an nv file, which begins with the schema {SCHEMA}")
        values, words = tree.get("values", {}), tree.get("words", {})
        if not isinstance(values, dict) or not isinstance(words, dict):
            raise ValueError("its values and its words must be objects")
        self._values = values
        addresses = {str(address): address for address in range(LAST_WORD + 1)}
        for address, word in words.items():
            if isinstance(word, int) and _LOW <= word <= _HIGH and address in addresses:
                self._words[addresses[address]] = word

    def restore(self, key: str, variable: list[object]) -> None:
        """Load a variable with the value stored under its name, and save it after the run.

        A stored value that no longer fits the variable's type or size is dropped.
        """
        before = self._live.get(key)
        stored = self._values.get(key) if before is None else list(before)
        fitting = _fitted(stored, variable)
        if fitting is not None:
            variable[:] = fitting
        self._live[key] = variable

    @property
    def names(self) -> list[str]:
        """The nonvolatile variables of the program, by name."""
        return [*self._live, *(["NVLONG"] if self._words else [])]

    def word(self, address: int) -> int:
        return self._words.get(address, 0)

    def set_word(self, address: int, word: int) -> None:
        self._words[address] = word

    def real(self, address: int) -> float:
        """Return a word as the float with the same bits."""
        found: float = unpack("<f", pack("<i", self.word(address)))[0]
        return found

    def set_real(self, address: int, value: float) -> None:
        if not abs(value) < _LARGEST_FLOAT:
            value = inf if value > 0 else -inf if value < 0 else value
        self.set_word(address, unpack("<i", pack("<f", value))[0])

    def save(self) -> None:
        """Write the file; raise OSError if that fails."""
        if self.path is None:
            return

        values = {**self._values, **self._live}
        words = {str(address): word for address, word in sorted(self._words.items())}
        tree = {"schema": SCHEMA, "values": dict(sorted(values.items())), "words": words}
        with replacing(self.path, only_copy=True) as file:
            file.write((dumps(tree, indent=1, ensure_ascii=False) + "\n").encode())

    def close(self) -> None:
        """Unlock the file for other runs."""
        if self._lock is not None:
            self._lock.release()


def _fitted(stored: object, variable: list[object]) -> list[object] | None:
    """Return the stored value as values of a variable, or None if it does not fit."""
    if not isinstance(stored, list) or len(stored) != len(variable):
        return None
    found: list[object] = []
    for value, present in zip(stored, variable, strict=True):
        fitting = _fitted(value, present) if isinstance(present, list) else _plain(value, present)
        if fitting is None and present is not None:
            return None
        found.append(fitting)
    return found


def _plain(value: object, present: object) -> object:
    """Return a number or a text of the same type, or None for anything else."""
    if isinstance(present, str):
        return value if isinstance(value, str) else None
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    if isinstance(present, float):
        return float(value)
    return value if isinstance(value, int) and _LOW <= value <= _HIGH else None
