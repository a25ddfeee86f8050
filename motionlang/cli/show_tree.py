"""`run --show-tree`: the syntax tree of a program."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain
from motionlang.errors import ProgramError
from motionlang.execution import dialect_for
from motionlang.lang.foreign import one_sentence
from motionlang.views.tree import render_tree

if TYPE_CHECKING:
    from motionlang.cli.options import Options
    from motionlang.source import Source


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
