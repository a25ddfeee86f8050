"""Lines and the commands in them: structure only, nothing here knows a mnemonic.

Commas and blanks separate commands, quotes protect both; `;` begins a comment, as does `#` at the start of a line.
Held equal to `grammars/mccl.lark` by a test.
"""

from __future__ import annotations

# The controller's input buffer, in characters.
LONGEST = 255


def without_comment(line: str) -> str:
    """The line as a downloader sends it."""
    if ";" in line:
        line = line[: _outside_quotes(line, ";")]
    if "#" in line and line.lstrip(" \t").startswith("#"):
        return ""
    return line


def pieces(line: str) -> list[tuple[str, int]]:
    """The text of each command of a line and the offset at which it stands."""
    found: list[tuple[str, int]] = []
    if '"' in line:
        return _quoted_pieces(line)
    at = 0
    plain = " " not in line and "\t" not in line
    for part in line.split(","):
        if plain:
            if part:
                found.append((part, at))
        else:
            _words(part, at, found)
        at += len(part) + 1
    return found


def _words(part: str, at: int, found: list[tuple[str, int]]) -> None:
    end = 0
    for word in part.replace("\t", " ").split(" "):
        if word:
            found.append((word, at + end))
        end += len(word) + 1


def _quoted_pieces(line: str) -> list[tuple[str, int]]:
    found: list[tuple[str, int]] = []
    quoted, start = False, 0
    for k, character in enumerate(line):
        if character == '"':
            quoted = not quoted
        elif not quoted and character in ", \t":
            if k > start:
                found.append((line[start:k], start))
            start = k + 1
    if len(line) > start:
        found.append((line[start:], start))
    return found


def _outside_quotes(line: str, mark: str) -> int:
    """Where `mark` first stands outside quotes; the length of the line if nowhere."""
    quoted = False
    for k, character in enumerate(line):
        if character == '"':
            quoted = not quoted
        elif character == mark and not quoted:
            return k
    return len(line)
