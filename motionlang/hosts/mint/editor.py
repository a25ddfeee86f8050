"""The line editor of a Mint controller, with which hosts download a program.

    PROG, CON     choose the program or the configuration; the prompt is P> or C>
    NEW           clear the chosen one
    EDIT [n]      enter lines, from line n or after the last one; the prompt is the number of the line
    (empty line)  end EDIT
    LIST          list the chosen one
    RUN           run the configuration, then the program

A line of one blank represents an empty line of the text. Hosts send empty lines in this form, because an empty line
ends EDIT.
"""

from __future__ import annotations

PROGRAM, CONFIGURATION = "program", "configuration"
# Characters of a program; no controller has more memory for one.
MAX_TEXT = 1_000_000


class ControllerTexts:
    """The program and the configuration of a controller, as lists of lines."""

    def __init__(self) -> None:
        self._lines: dict[str, list[str]] = {CONFIGURATION: [], PROGRAM: []}
        self._sizes = {CONFIGURATION: 0, PROGRAM: 0}

    def lines(self, which: str) -> list[str]:
        """Return the lines of a text."""
        return self._lines[which]

    def set(self, which: str, text: str) -> None:
        """Replace a text."""
        self._lines[which] = text.split("\n")
        self._sizes[which] = len(text)

    def clear(self, which: str) -> None:
        """Delete a text."""
        self._lines[which], self._sizes[which] = [], 0

    def put(self, which: str, number: int, line: str) -> bool:
        """Write line `number`, from 1; return False if the text would be too long."""
        lines = self._lines[which]
        size = self._sizes[which] + len(line) + 1
        if number <= len(lines):
            size -= len(lines[number - 1]) + 1
        if size > MAX_TEXT:
            return False
        lines[number - 1 : number] = [line]
        self._sizes[which] = size
        return True

    def sources(self) -> list[tuple[str, str]]:
        """Return name and text of the texts that RUN runs, in order."""
        found = [(which, "\n".join(lines)) for which, lines in self._lines.items()]
        return [(which, text) for which, text in found if text.strip()]


class Editor:
    """The editor of one host's line; `number` is the next line in EDIT, otherwise 0."""

    def __init__(self, texts: ControllerTexts) -> None:
        self._texts = texts
        self._which = PROGRAM
        self.number = 0

    @property
    def prompt(self) -> str:
        """The prompt for the next line."""
        if self.number:
            return f"{self.number}>"
        return "P>" if self._which == PROGRAM else "C>"

    def leave(self) -> None:
        """End EDIT."""
        self.number = 0

    def take(self, line: str) -> str | None:
        """Execute an editor command; return its output, None for any other line."""
        if self.number:
            return self._enter(line)
        command, _, argument = line.strip().upper().partition(" ")
        if argument and command != "EDIT":
            return None
        if command in ("PROG", "CON"):
            self._which = PROGRAM if command == "PROG" else CONFIGURATION
        elif command == "NEW":
            self._texts.clear(self._which)
        elif command == "LIST":
            return "".join(f"{line}\n" for line in self._texts.lines(self._which))
        elif command == "EDIT":
            return self._edit(argument.strip())
        else:
            return None
        return ""

    def _edit(self, argument: str) -> str:
        end = len(self._texts.lines(self._which)) + 1
        if argument and not (argument.isdecimal() and len(argument) < 9 and 1 <= int(argument) <= end):
            return f"Error: EDIT takes a line from 1 to {end}, not {argument}\n"
        self.number = int(argument) if argument else end
        return ""

    def _enter(self, line: str) -> str:
        if not line:
            self.leave()
            return ""
        if not self._texts.put(self._which, self.number, line.rstrip()):
            self.leave()
            return f"Error: the {self._which} is longer than {MAX_TEXT} characters\n"
        self.number += 1
        return ""
