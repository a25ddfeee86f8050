"""What a command leaves in the file of the package's bytecode as it ends.

A module that it missed is put there as Python has it, which takes no time. One that is used again is compiled to what
a command needs of it, once: whoever runs a single command in a new place does not wait for that.
"""

from __future__ import annotations

import _frozen_importlib_external as external
import sys
from marshal import dumps

from motionlang.bytecode import holds
from motionlang.kept_file_writing import add
from motionlang.user_cache import state
from motionlang.user_cache_writing import writable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from importlib.machinery import ModuleSpec
    from types import CodeType

    from motionlang.bytecode import Finder, Note


def keep(finder: Finder) -> None:
    """Put what was missed into the file, and what was whole without the rest, beside what stands there and holds."""
    if sys.dont_write_bytecode or not writable():
        return
    new: dict[str, tuple[Note | None, bytes]] = {name: (None, part) for name, part in finder.made.items()}
    for name in finder.missed:
        _put(new, name, _as_it_is, True)
    for name in finder.whole:
        _put(new, name, _without_the_rest, False)
    if new:
        add(finder.file.name, new, holds)


def _put(
    parts: dict[str, tuple[Note | None, bytes]],
    name: str,
    code: Callable[[ModuleSpec, str], CodeType | None],
    whole: bool,
) -> None:
    """Put the code of a module to the parts, unless Python did not load it from a source, or that is another by now."""
    spec = getattr(sys.modules.get(name), "__spec__", None)
    if spec is None or spec.origin is None or not isinstance(spec.loader, external.SourceFileLoader):
        return
    before = state(spec.origin)
    try:
        made = code(spec, spec.origin)
    except (OSError, SyntaxError):
        return
    if before is not None and state(spec.origin) == before:
        parts[name] = (spec.origin, spec.cached, before, whole), dumps(made)


def _as_it_is(spec: ModuleSpec, place: str) -> CodeType | None:
    return external.SourceFileLoader.get_code(spec.loader, spec.name)  # type: ignore[arg-type]  # what `_put` asks for


def _without_the_rest(spec: ModuleSpec, place: str) -> CodeType:
    from motionlang.bytecode_compiling import compiled

    return compiled(spec.loader.get_data(place), place)  # type: ignore[union-attr]
