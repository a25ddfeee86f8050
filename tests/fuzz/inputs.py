"""The inputs: every keyword in every form and loop, and mutated gallery programs."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from random import Random

from motionlang.kernel import Keyword, Source, dialect

ROOT = Path(__file__).parents[2]
SUFFIX = {"mint": ".mnt", "mccl": ".mcl"}

# ------------------------------------------------------------------------------------------- keywords of Mint

LOOPS = {
    "for": "For i = 1 To 3\n  {}\nNext\n",
    "while": "While i < 3\n  i = i + 1\n  {}\nEnd While\n",
    "repeat": "Repeat\n  i = i + 1\n  {}\nUntil i > 2\n",
    "loop": "Loop\n  {}\n  WAIT = 1\nEnd Loop\n",
}
_BEFORE = "Dim i As Integer, x As Float, a(4) As Float, s As String\nx = 2.5\n"
_INDICES = {"none": ("", "(0)"), "axis": ("(0)", ""), "axes": ("(0, 1)", "(0)")}


def _spelt(row: Keyword) -> tuple[str, str]:
    """Return a keyword in its normal spelling, and in another one."""
    if row.index in _INDICES:
        right, wrong = _INDICES[row.index]
    else:
        right, wrong = f"({', '.join('0' for _ in row.index.split(', '))})", "(1, 2, 3, 4)"
    return row.name + right, row.name + wrong


def mint_forms(row: Keyword) -> tuple[str, str, str, str]:
    """Return four statements with a keyword."""
    right, wrong = _spelt(row)
    if "W" in row.access and "R" in row.access:
        return (
            f"{right} = 1",
            f"PRINT {right}",
            f"{right} = {right} + x",
            f"If {wrong} > 1 Then {wrong} = -1, 5",
        )
    if "R" in row.access:
        return (
            f"PRINT {right}",
            f"If {right} > x Then x = {right}",
            f"PAUSE {right} = 1",
            f"x = {wrong} + Len(s)",
        )
    if "W" in row.access:
        return f"{right} = 1", f"{right} = x * 1000", f"{wrong} = -1, 2", f"{right} = a(1), a(2);"
    return right, f"If x > 1 Then {right}", wrong, f"{right} = 1"


def mint_words() -> Iterator[str]:
    """Yield every keyword in four statements and four loops."""
    for row in dialect("mint").table():
        for form in mint_forms(row):
            for loop in LOOPS.values():
                yield _BEFORE + loop.format(form) + "PRINT x\n"


# ------------------------------------------------------------------------------------------- keywords of MCCL

_PARAMETERS = ("", "1", "-2.5", "@3")
_LINES = (
    "1MN,2MN\n{},RP3\n",
    "MD1,{},WA0.001,RP\nMC1\n",
    "AL3,AR3\nMD2,{}\nGT2\nWA0.01\n",
    "1MN,1MR100\n{},IB5,JR-1\n",
)


def mccl_words() -> Iterator[str]:
    """Yield every command with and without an axis, with four parameters and in lines."""
    for row in dialect("mccl").table():
        for axis in ("1", ""):
            for parameter in _PARAMETERS:
                for line in _LINES:
                    yield line.format(f"{axis}{row.name}{parameter}")


WORDS = {"mint": mint_words, "mccl": mccl_words}

# ---------------------------------------------------------------------------------------------- mutations

_NUMBERS = (
    "0", "-1", "1e308", "-1e308", "1e-308", "9" * 400, "0.5", "2147483647", "2147483648", "-2147483649", "65536",
    "255", "0x7FFFFFFF", "1e12", "1e-12", "nan", "3.", ".", "1.5.2", "$", "@1", "@@", "?",
    '"', "'", "(", ")", ",", ";", ":", "\t",
)  # fmt: skip


@cache
def gallery(name: str) -> tuple[list[str], ...]:
    """Return the tokens of each program of a language in the gallery and the manual."""
    suffix, language = SUFFIX[name], dialect(name)
    paths = sorted([*ROOT.glob(f"scripts/{name}/*{suffix}"), *ROOT.glob(f"tests/spec/{name}/**/*{suffix}")])
    texts = [Source.read(path).text for path in paths]
    return tuple([piece for _, piece, _ in language.tokens(text)] for text in texts if len(text) < 6000)


@cache
def vocabulary(name: str) -> list[str]:
    """Return each token of the gallery once, and every keyword of the language."""
    pieces = {piece for tokens in gallery(name) for piece in tokens if piece.strip()}
    return sorted(pieces | {row.name for row in dialect(name).table()})


def mutated(name: str, random: Random) -> str:
    """Return a program of the gallery with one to six tokens changed."""
    tokens = list(random.choice(gallery(name)))
    if random.random() < 0.2:
        return _bytes_changed("".join(tokens), random)
    words = vocabulary(name)
    for _ in range(random.choice((1, 1, 1, 2, 3, 6))):
        at = random.randrange(len(tokens))
        what = random.random()
        if what < 0.2:
            del tokens[at : at + random.choice((1, 1, 3))]
        elif what < 0.35:
            tokens.insert(at, tokens[random.randrange(len(tokens))])
        elif what < 0.6:
            tokens[at] = random.choice(_NUMBERS)
        elif what < 0.9:
            tokens[at] = random.choice(words)
        else:
            other = random.randrange(len(tokens))
            tokens[at], tokens[other] = tokens[other], tokens[at]
        if not tokens:
            tokens = ["\n"]
    return "".join(tokens)


def _bytes_changed(text: str, random: Random) -> str:
    data = bytearray(text.encode())
    for _ in range(random.choice((1, 2, 8))):
        at = random.randrange(len(data))
        what = random.randrange(3)
        if what == 0:
            data[at] = random.randrange(256)
        elif what == 1:
            del data[at]
        else:
            data.insert(at, random.randrange(256))
        data = data or bytearray(b"\n")
    return Source.from_bytes("fuzz", bytes(data)).text


def inputs(name: str, count: int, seed: int) -> Iterator[str]:
    """Yield `count` programs of a language.

    Nine in ten are mutations; one in ten is a form of a keyword.
    """
    random = Random(f"{name} {seed}")
    words = list(WORDS[name]())
    for _ in range(count):
        yield random.choice(words) if random.random() < 0.1 else mutated(name, random)
