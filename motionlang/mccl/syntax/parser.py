"""MCCL text to what `grammars/mccl.lark` finds in it: lines, and the commands in them. No mnemonic is known here."""

from __future__ import annotations

from motionlang.mccl.syntax.tables import COMMAND, PIECE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    # The parts of a command: the axis with the mnemonic, and the parameter, of which there is one at most: a whole
    # number, a real one, a register, a text in its quotes. What is not there is None.
    Parts = tuple[str | None, ...]

# The controller's input buffer, in characters.
LONGEST = 255


def pieces(line: str) -> list[str]:
    """The text of each command of a line, and of what stands where one should."""
    found: list[str] = PIECE.findall(line)
    while found and not found[-1]:
        found.pop()
    return found


def spans(line: str) -> Iterator[tuple[int, int]]:
    """Where each of them begins and ends."""
    for match in PIECE.finditer(line):
        if match[1]:
            yield match.span(1)


def parts(piece: str) -> Parts | None:
    """The parts of a command; None where the text is none."""
    match = COMMAND.fullmatch(piece)
    return match and match.groups()


def without_comment(line: str) -> str:
    """The line as a downloader sends it."""
    end = max((end for _, end in spans(line)), default=0)
    rest = line[end:]  # separators, and then a comment
    return line[: len(line) - len(rest.lstrip(", \t"))]
