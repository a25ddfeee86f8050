"""`--set NAME=VALUE`: replace a constant, the first value of a variable, or a literal."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.resolve.literals import literals
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import replace, walk
from motionlang.kernel.tools import nearest


def override(
    module: nodes.Module, overrides: Mapping[str, float | str], given: Mapping[str, bool] | None = None
) -> None:
    """Put the values into the tree; raise ProgramError for unknown names.

    The names of `given` get their values when the program starts. It maps each to True if the value is a
    string.
    """
    wanted: dict[str, float | str | bool] = {name.lower(): value for name, value in overrides.items()}
    wanted |= {name.lower(): is_text for name, is_text in (given or {}).items()}
    names: list[str] = []
    done: set[str] = set()
    for body in (*(block.body for block in module.startup), module.body):
        _replace(body, wanted, done, names)
    missing = [name for name in (*overrides, *(given or ())) if name.lower() not in done]
    if missing:
        bases = dict.fromkeys(each.base.partition("[")[0] for each in literals(module))
        words = [base for base in bases if table().get(base) is not None]
        raise ProgramError([_unknown(name, names, words) for name in missing])


def override_literals(module: nodes.Module, values: Mapping[int, float | str]) -> None:
    """Put numbers into the tree in place of the literals at some offsets.

    A text is the name of a number that the program receives when it starts.
    """

    def change(node: object) -> object:
        is_number = type(node) is nodes.Number or (
            type(node) is nodes.Unary and type(node.operand) is nodes.Number
        )
        if not is_number or node.start not in values:  # type: ignore[attr-defined]
            return node
        at, value = (node.start, node.end), values[node.start]  # type: ignore[attr-defined]
        return nodes.Given(*at, value, False) if isinstance(value, str) else nodes.Number(*at, value)

    replace(module.everything, change)


def override_if_there(module: nodes.Module, overrides: Mapping[str, float | str]) -> None:
    """Override values in a typed line; missing names are not errors.

    They may be declared in a later line.
    """
    wanted: dict[str, float | str | bool] = {name.lower(): value for name, value in overrides.items()}
    if wanted:
        _replace(module.body, wanted, set(), [])


def _unknown(name: str, names: list[str], words: list[str]) -> Diagnostic:
    """Return the error for a name that is none of `names`; the program writes literals to the keywords `words`."""
    row = table().get(name)
    if row is not None:
        hint = f"{row.name} is a keyword; vary a constant or variable of the program instead"
        return Diagnostic("unknown-word", f"the program has no constant or variable {name}", hint=hint)
    near = nearest(name, [*names, *words])
    has = f"the names of the program are {', '.join(names)}" if names else "the program declares no names"
    hint = f"did you mean {near}?" if near else has
    return Diagnostic("unknown-word", f"the program has no constant or variable {name}", hint=hint)


def _replace(
    body: Iterable[nodes.Stmt], wanted: dict[str, float | str | bool], done: set[str], names: list[str]
) -> None:
    """Replace the initial value of each name, in the order of the text.

    If that value is computed from the name itself (`n = n + 1`), or is not assigned in the parent task, the value
    is put into the Dim.
    """
    bare: dict[str, nodes.Variable] = {}
    own: set[str] = set()  # names that the program declares, also those of keywords
    for node in sorted(walk(body), key=lambda each: each.start):
        if type(node) is nodes.Const:
            own.add(node.name.lower())
            if _take(node.name, wanted, done, names):
                node.value = _literal(node, node.name, wanted)
        elif type(node) is nodes.Dim:
            own |= {variable.name.lower() for variable in node.variables}
            for variable in node.variables:
                if not variable.values and not variable.dimensions:
                    bare.setdefault(variable.name.lower(), variable)
                if variable.values and not variable.dimensions and _take(variable.name, wanted, done, names):
                    variable.values = [_literal(variable, variable.name, wanted)]
        elif type(node) is nodes.Assign and type(node.target) is nodes.Name:
            key = node.target.name.lower()
            plain = node.target.args is None and (key in bare or key in own or table().get(key) is None)
            if plain and not _reads_itself(node, key) and _take(node.target.name, wanted, done, names):
                node.values = [_literal(node, key, wanted)]
            elif plain and key in bare and _take(node.target.name, wanted, done, names):
                bare[key].values = [_literal(bare[key], key, wanted)]
    for key, variable in bare.items():
        if _take(variable.name, wanted, done, names):
            variable.values = [_literal(variable, key, wanted)]


def _reads_itself(node: nodes.Assign, key: str) -> bool:
    return any(type(each) is nodes.Name and each.name.lower() == key for each in walk(node.values))


def _take(name: str, wanted: Collection[str], done: set[str], names: list[str]) -> bool:
    """True if `name` is still to be overridden, which marks it as done.

    Each name is also recorded for the message on unknown names.
    """
    if name not in names:
        names.append(name)
    key = name.lower()
    if key not in wanted or key in done:
        return False
    done.add(key)
    return True


def _literal(node: nodes.Node, name: str, wanted: Mapping[str, float | str | bool]) -> nodes.Expr:
    value, at = wanted[name.lower()], (node.start, node.end)
    if value is True or value is False:
        return nodes.Given(*at, name, value)
    return nodes.String(*at, value) if isinstance(value, str) else nodes.Number(*at, value)
