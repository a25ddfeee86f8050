"""`run --show-code` and `--show-tree`: generated code and syntax tree."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain
from motionlang.errors import ProgramError
from motionlang.execution import accelerators, dialect_for
from motionlang.lang.foreign import one_sentence
from motionlang.lang.literals import edited
from motionlang.views.listing import render_listing
from motionlang.views.terminal import wants_colour
from motionlang.views.tree import render_tree

if TYPE_CHECKING:
    from motionlang.cli.options import Options
    from motionlang.source import Source


def show_code(options: Options, source: Source, settings: dict[str, object]) -> int:
    """Print the listing; return the exit status, 1 if the program has an error."""
    language = dialect_for(source, options.dialect)
    try:
        source, overrides, _ = edited(source, language, options.overrides)
        listing = language.listing(source, settings, overrides, accelerators().ranges)
    except ProgramError as error:
        complain(one_sentence(language, source, error.diagnostics), source, options.file)
        return 1
    sys.stdout.writelines(render_listing(language, source, listing, colour=wants_colour(sys.stdout)))
    return 0


def show_tree(options: Options, source: Source) -> int:
    """Print the syntax tree; return the exit status, 1 if the text has a syntax error."""
    language = dialect_for(source, options.dialect)
    try:
        tree = language.parse(source)
    except ProgramError as error:
        complain(one_sentence(language, source, error.diagnostics), source, options.file)
        return 1
    sys.stdout.write(render_tree(tree))
    return 0
