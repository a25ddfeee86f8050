"""Check a program: resolve its names, report its errors, and annotate its expressions.

    x = 3 + POS(0)      x: Float    3: Integer, 3    POS: Float    0: Integer, 0    3 + POS(0): Float

Problem. A program may be wrong in ways that its grammar does not exclude: a text where a number is needed, an axis that
the controller does not have, an Exit outside a loop. All errors are reported at once. What a later stage would have
to find again, such as the type of an expression, is recorded in the tree.

Idea. After name resolution (`resolve/names.py`) each function is walked once, in the order of the text, by the writer
of its steps. A class of node has one function, which checks it and makes its value or its steps: statements are in
`steps/statements.py` and `blocks.py`, expressions in `expressions.py` and `calls.py`, keywords in `keywords.py` and
`words.py`. A wrong expression is reported where it is found, and has a harmless value from then on. The sentences that
take more than a line are in `check/`.

Data. A `ProgramWriter` with the settings of a machine file checks: `UnitWriter.checks` is True. Then `error` reports,
`add` writes no step, and a function returns before it binds operations that nothing would call. A `Value` has the type
of an expression, and its value if that is known. They are annotated in the nodes, as `type` and `const`.

Invariants.
- An expression that is evaluated in a run has a type, and a `const` if its value is known; so has the definition of a
  Define at each of its uses, and each `Link` of a chain. What names a variable, an array or a task is no expression: a
  variable has the type of its declaration, a task has none.
- Only a check annotates the tree, which all runs share: the values that they are given differ.
- Nothing here knows how the program will be run. Every diagnostic of a program that can be parsed comes from here or
  from name resolution; warnings about programs without errors come from `commands/check/rules/`.

Cost. One visit of each node, without recursion over statements in a row.
"""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.check.unknown_words import warn_of_misspellings
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.resolve.aliases import rename_old_words
from motionlang.kernel.mint.resolve.diagnostics import Diagnostics
from motionlang.kernel.mint.resolve.names import Symbols
from motionlang.kernel.mint.resolve.symbols import PromptSymbols
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.steps.places import Places
from motionlang.kernel.mint.steps.program import ProgramWriter
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.traversal import walk
from motionlang.kernel.tools import StackSpace


def declared(module: Module, settings: Mapping[str, object]) -> Symbols:
    """Declare the names of a module, the first half of a check; its errors are in their `diagnostics`."""
    rename_old_words(module, settings)
    diagnostics = Diagnostics(module)
    mark(module, settings, diagnostics)
    names = Symbols(table(), diagnostics)
    names.declare_module(module)
    return names


def examined(names: Symbols, settings: Mapping[str, object]) -> Symbols:
    """Check the functions of a module whose names are declared, and return these."""
    _check(names, settings)
    warn_of_misspellings(names)
    return names


def check_line(
    module: Module, settings: Mapping[str, object] | None, session: PromptSymbols, of_program: bool = False
) -> Symbols:
    """Check a line typed at a prompt with what earlier ones have declared, and declare its names for later ones.

    With `of_program` it is a whole program, whose lines may trigger faults of the machine file. Raises ProgramError
    with all errors of a line, which then declares nothing.
    """
    settings = settings or {}
    diagnostics = Diagnostics(module)
    if of_program:
        mark(module, settings, diagnostics)
    with StackSpace():
        names = Symbols(table(), diagnostics, session)
        names.declare_module(module)
        _check(names, settings)
    diagnostics.raise_errors()
    session.scope.names |= names.module.names
    session.types = names.types
    return names


def _check(names: Symbols, settings: Mapping[str, object]) -> None:
    ProgramWriter(names, Environment(Machine(), Places()), names.diagnostics.line, {}, checked=settings)


WORD = "(line)"


def mark(module: nodes.Module, settings: Mapping[str, object], diagnostics: Diagnostics) -> None:
    """Insert a call of a hidden keyword before the first statement of each line with a fault of the machine file.

    To later stages it is a command like any other, so it is executed between statements, at its own time. A line
    without a statement is reported as an error of the machine file.
    """
    faults: list[Mapping[str, int]] = settings.get("fault", [])  # type: ignore[assignment]
    wanted = {entry["line"] for entry in faults if "line" in entry}
    if not wanted:
        return
    missing = set(wanted)
    for body in _bodies(module):
        _mark_body(module, body, wanted, missing)
    for line in sorted(missing):
        message = f"the machine file has a fault at line {line}, where no statement begins"
        found = Diagnostic("machine-file", message, line, hint="give a line on which a statement begins")
        diagnostics.add_to_line(line, found)


def _bodies(module: nodes.Module) -> list[list[nodes.Stmt]]:
    """Return every list of statements, including the nested ones."""
    roots = [value for name in type(module).__slots__ if isinstance(value := getattr(module, name), list)]
    found = [root for root in roots if root and isinstance(root[0], nodes.Stmt)]
    for node in walk([each for root in roots for each in root]):
        for slot in type(node).__slots__:
            value = getattr(node, slot)
            if isinstance(value, list) and value and isinstance(value[0], nodes.Stmt):
                found.append(value)
    return found


def _mark_body(module: nodes.Module, body: list[nodes.Stmt], wanted: set[int], missing: set[int]) -> None:
    position = 0
    while position < len(body):
        node = body[position]
        line = module.line(node.start)
        if line in wanted and line in missing:
            missing.discard(line)
            name = nodes.Name(node.start, node.end, Word(WORD), [nodes.Number(node.start, node.end, line)])
            body.insert(position, nodes.Call(node.start, node.end, name))
            position += 1
        position += 1
