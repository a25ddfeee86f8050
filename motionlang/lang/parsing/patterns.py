"""The patterns that a start needs, without the module that compiles patterns.

To import `re` and to compile what cuts up a text takes as long as half of an empty Python. A command keeps what they
were compiled to beside its bytecode, for this very Python; everybody else gets them from `re`.
"""

from __future__ import annotations

from marshal import dumps, loads

from motionlang.bytecode import Finder

TYPE_CHECKING = False
if TYPE_CHECKING:
    import re


def compiled(text: str) -> re.Pattern[str]:
    """What `re.compile(text, re.ASCII)` is."""
    keeper, name = Finder.of_the_command, f"pattern {text}"
    kept = None if keeper is None else keeper.kept(name)
    if kept is not None:
        import _sre  # type: ignore[import-not-found]

        pattern: re.Pattern[str] = _sre.compile(text, *loads(kept))
        return pattern
    import re

    if keeper is not None:
        program = _program(text)
        if program is not None:
            keeper.remember(name, program)
    return re.compile(text, re.ASCII)


def _program(text: str) -> bytes | None:
    """What Python's own matcher is given for a pattern; None where `re` is made otherwise than it is known to be."""
    import re

    try:
        compiler = re._compiler  # type: ignore[attr-defined]
        tree = compiler._parser.parse(text, int(re.ASCII))
        code = compiler._code(tree, int(re.ASCII))
        state = tree.state
        names: list[str | None] = [None] * state.groups
        for name, group in state.groupdict.items():
            names[group] = name
        flags = int(re.ASCII) | int(state.flags)
        return dumps((flags, [int(each) for each in code], state.groups - 1, state.groupdict, tuple(names)))
    except AttributeError:
        return None
