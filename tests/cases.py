"""`@cases`: many small cases in one test, without pytest's overhead for each.

    @cases("word", WORDS)
    def test_a_word_has_a_sentence(word): ...

Every case runs, even after a failure, and the message lists the cases that failed. Fixtures and other
parameters of the test are created once for all cases. For cases that need a fixture of their own, or take a
second or more, use pytest's `parametrize`.
"""

from __future__ import annotations

import inspect
import os
import re
from collections.abc import Callable, Collection, Container, Iterable
from pathlib import Path
from typing import Any

import pytest

from tests.mutants.recorder import ACTIVE, SEEN

# `pytest.raises` without an exception raises something that is no Exception.
FAILURES = (Exception, pytest.fail.Exception)


# A property draws one in this many of its examples, but at least `FEW`.
draws_one_in = 4
FEW = 10


def examples(count: int) -> int:
    """Return how many of `count` examples or generated programs a test draws.

    The normal run draws a quarter of them, and one with `--all-examples` all.
    """
    return max(count // draws_one_in, min(count, FEW))


def is_complete() -> bool:
    """True if a test compares all its recorded cases.

    It does with `--all-examples`, when the code that it reaches is recorded for mutants, and against a mutant.
    """
    return draws_one_in == 1 or not {ACTIVE, SEEN}.isdisjoint(os.environ)


def covering(kinds: Collection[str], count: int, kinds_of: Callable[[int], Container[str]]) -> list[int]:
    """Return the seeds below `count` whose program has a kind not seen earlier.

    With `--all-examples` it returns all seeds below `count`. The chosen programs together have all of `kinds`.
    """
    missing, chosen = list(kinds), []
    for seed in range(count):
        found = kinds_of(seed)
        left = [kind for kind in missing if kind not in found]
        if len(left) < len(missing) or draws_one_in == 1:
            chosen.append(seed)
        missing = left
    assert missing == []
    return chosen


def one_in(number: int, values: Iterable[Any]) -> list[Any]:
    """Return `values` for `parametrize`, all marked `long` except one in `number`."""
    return [
        pytest.param(value, marks=() if index % number == 0 else pytest.mark.long)
        for index, value in enumerate(values)
    ]


def cases(
    names: str | tuple[str, ...], table: Iterable[Any], ids: Callable[[Any], object] | None = None
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Return a decorator that runs a test for each row of `table`, like `parametrize`.

    `ids` formats a field of a row for the failure message.
    """
    wanted = [each.strip() for each in names.split(",")] if isinstance(names, str) else list(names)
    rows = [row if len(wanted) > 1 else (row,) for row in table]
    spell = ids or repr

    def decorate(test: Callable[..., None]) -> Callable[..., None]:
        def run(**given: Any) -> None:
            failures: list[BaseException] = []
            for row in rows:
                try:
                    test(**dict(zip(wanted, row, strict=True)), **given)
                except FAILURES as error:
                    error.add_note(f"case {', '.join(str(spell(argument)) for argument in row)}")
                    failures.append(error)
            if len(failures) == 1:
                raise failures[0]
            if failures:
                raise BaseExceptionGroup(f"{len(failures)} of {len(rows)} cases failed", failures)

        run.__name__, run.__doc__, run.__module__ = test.__name__, test.__doc__, test.__module__
        left = [p for name, p in inspect.signature(test).parameters.items() if name not in wanted]
        run.__signature__ = inspect.Signature(left)  # type: ignore[attr-defined]
        return run

    return decorate


def blocks(path: Path) -> dict[str, str]:
    """Return the texts of a file by their titles: `== title` begins one."""
    parts = re.split("^== (.+)\n", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def sessions(*paths: Path) -> pytest.MarkDecorator:
    """Run a test for each part of some files that `== title` begins: parameters `path` and `session`."""
    parts = [(path, part) for path in paths for part in _parts(path)]
    titles = [part.partition("\n")[0].removeprefix("== ") for _, part in parts]
    return pytest.mark.parametrize(("path", "session"), parts, ids=titles)


def repeat(path: Path, session: str, replayed: Callable[[str], str], update: bool) -> None:
    """Assert that a session is repeated as it is written; with `update`, its file is written anew, once."""
    if not update:
        assert replayed(session) == session
    elif session == _parts(path)[0]:
        path.write_text("".join(map(replayed, _parts(path))), encoding="utf-8", newline="\n")


def _parts(path: Path) -> list[str]:
    return [
        part for part in re.split("^(?===)", path.read_text(encoding="utf-8"), flags=re.MULTILINE) if part
    ]
