"""INPUT answered from standard input.

A person at a terminal is prompted at once; a pipe provides one line for each INPUT.
"""

from __future__ import annotations

import sys

from motionlang.kernel import Machine
from motionlang.kernel.lang import Terminal


def ask(machine: Machine) -> str | None:
    """Return the next line of standard input for an INPUT, None at end of file."""
    terminal, stdin = machine.terminal, sys.stdin
    if stdin is None:
        return None
    at_terminal = stdin.isatty()
    if at_terminal:
        _show_question(terminal)
    try:
        line = stdin.readline()
    except (OSError, ValueError):  # it is closed, or cannot be read
        return None
    if not line:
        return None
    line = line.rstrip("\r\n")
    if at_terminal and terminal.show is not None and sys.stdout.isatty():
        _show_once(terminal, f"{line}\n")
    return line


def _show_question(terminal: Terminal) -> None:
    """Show the question on the terminal.

    The program's output may go elsewhere.
    """
    if terminal.show is None or not sys.stdout.isatty():
        sys.stderr.write(terminal.begun or "? ")
        sys.stderr.flush()
    else:
        terminal.show("" if terminal.begun else "? ")
        sys.stdout.flush()


def _show_once(terminal: Terminal, typed: str) -> None:
    """Do not repeat `typed` when the program echoes it.

    The terminal has already shown it.
    """
    show = terminal.show

    def shown(text: str) -> None:
        terminal.show = show
        if text != typed and show is not None:
            show(text)

    terminal.show = shown
