"""Compile simulated keywords: reads in expressions, writes with `=`, commands.

The keyword's row in the table gives its access, index, unit and range. At run time
`motionlang.mint.runtime.binding` finds the operation by the row's verb.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.errors import as_hint, count_of
from motionlang.lang.keyword import Keyword
from motionlang.lang.syntax.word import Word
from motionlang.mint.compile import intervals
from motionlang.mint.compile.body import Body, Reading, Value
from motionlang.mint.compile.conversions import NOTHING, article, as_float, as_integer, literal
from motionlang.mint.compile.expressions import condition, number, value
from motionlang.mint.compile.lines import LOOP
from motionlang.mint.compile.terminal_use import line
from motionlang.mint.resolve.folding import constant
from motionlang.mint.resolve.symbols import FLOAT, INTEGER, STRING, Symbol
from motionlang.mint.runtime.task import PARENT
from motionlang.mint.syntax import nodes

# The text of an omitted value. No other value has this text.
OMITTED = "None"


def type_of(row: Keyword) -> str:
    """Return the Mint type of a keyword's value."""
    return INTEGER if row.is_whole else STRING if row.unit == "text" else FLOAT


# ---------------------------------------------------------------------------------------------------- reads


def read(b: Body, node: nodes.Name, row: Keyword) -> Value:
    """Return the value of a keyword, a function or a constant."""
    if row.kind == "constant":
        if node.args is not None:
            b.problem("values", f"{row.name} is a constant and takes no brackets", node)
        return literal(constant(row.verb, row.unit))
    if row.kind == "function":
        return _function(b, node, row)
    if row.kind == "statement":
        b.problem("type", f"{row.name} is a statement and has no value", node)
        return NOTHING
    if not can_be_read(b, node, row):
        return NOTHING
    if row.every and node.args and len(node.args) > 1:
        return value(b, _each_of(node, node.args))
    b.observes = True
    if row.every and by_default(b, node, row):
        read, _ = b.whole.called("read", row, ["axis"])
        axes = b.whole.use("env", "default_axes")
        return Value(f"int(all([{read}() for axis in {axes}()]))", INTEGER, intervals.BOOL)
    operation, arguments = b.whole.called("read", row, read_at(b, node, row))
    if id(node) in b.levels:
        arguments = [*arguments, b.levels[id(node)]]
    found = answer(row, f"{operation}({', '.join(arguments)})")
    if row.solved and id(node) not in b.levels:
        found.solved = lambda level: f"{operation}({', '.join([*arguments, level])})"
        if row.index == "axis":
            found.unsigned = lambda level, centre: (
                f"{operation}({', '.join([*arguments, f'({level}, {centre})'])})"
            )
    return found


def can_be_read(b: Body, node: nodes.Name, row: Keyword) -> bool:
    """True if a program may read a keyword; report an error if not."""
    if "R" in row.access:
        return True
    what = "is a command and has no value" if row.access == "C" else "can be written but not read"
    b.problem("write-only", f"{row.name} {what}", node)
    return False


def read_at(b: Body, node: nodes.Name, row: Keyword) -> list[str]:
    """Return the indices of a read, by default the first axis of AXES."""
    if by_default(b, node, row):
        return [f"{b.whole.use('env', 'default_axes')}()[0]"]
    return indices(b, node, row, single=True)


def answer(row: Keyword, text: str) -> Reading:
    """Return a keyword's value as a Reading, given the text that reads it."""
    if row.unit == "text":
        return Reading(text, STRING, intervals.ANY)
    kind = type_of(row)
    known = (
        intervals.BOOL if row.unit == "bool" else intervals.INTEGER if kind == INTEGER else intervals.FLOAT
    )
    return Reading(text, kind, known)


def _each_of(node: nodes.Name, args: list[nodes.Expr]) -> nodes.Expr:
    """Expand `IDLE[0, 1]`, as written after a path, to `IDLE[0] And IDLE[1]`."""
    conditions: list[nodes.Expr] = [
        nodes.Name(node.start, node.end, node.name, [arg], node.axes).resolve(None, node.row) for arg in args
    ]
    whole = conditions[0]
    for term in conditions[1:]:
        whole = nodes.Binary(node.start, node.end, "And", whole, term)
    return whole


def _function(b: Body, node: nodes.Name, row: Keyword) -> Value:
    wanted = row.index.split(", ") if row.index else []
    args = node.args or []
    if len(wanted) - row.optional <= len(args) < len(wanted):
        wanted = wanted[: len(args)]
    if len(args) != len(wanted):
        b.problem("values", f"{row.name} takes {_many(len(wanted), 'value')}, {len(args)} given", node,
                  f"{row.name}({row.index})")  # fmt: skip
        return NOTHING
    if row.verb == "choice":
        return _immediate_if(b, node, args)
    found = [_argument(b, arg, kind, row) for arg, kind in zip(args, wanted, strict=True)]
    texts = ", ".join(each.text for each in found)
    if row.verb == "random":
        return Value(f"{b.whole.use('env', 'random')}()", FLOAT, intervals.FLOAT)
    if row.unit != "same":
        kind = type_of(row)
        return Value(f"{b.whole.use('fn', row.verb)}({texts})", kind,
                     intervals.INTEGER if kind == INTEGER else intervals.FLOAT)  # fmt: skip
    kind = FLOAT if any(each.type == FLOAT for each in found) else INTEGER
    known_range = _same_range(row.verb, [each.range for each in found])
    if kind == INTEGER:
        known_range = intervals.to_integer(known_range)
    function = b.whole.use("fn", row.verb)
    made = Reading(f"{function}({texts})", kind, known_range)
    unsigned = found[0].unsigned if row.verb == "absolute" else None
    if unsigned is not None:
        made.solved = lambda level: f"{function}({unsigned(level, '0.0')})"
    return made


def _argument(b: Body, node: nodes.Expr, kind: str, row: Keyword) -> Value:
    if kind != "text":
        return number(b, node)
    found = value(b, node)
    if found.type != STRING and found is not NOTHING:
        b.problem("type", f"{row.name} needs a text, not a number", node, "convert the number with Str")
    return found


def _same_range(verb: str, found: list[intervals.Range]) -> intervals.Range:
    kinds = {each[2] for each in found}
    if kinds != {"i"}:
        return intervals.FLOAT if kinds == {"f"} else intervals.ANY
    if verb == "least":
        return (min(each[0] for each in found), min(each[1] for each in found), "i")
    if verb == "greatest":
        return (max(each[0] for each in found), max(each[1] for each in found), "i")
    return (0, max(abs(found[0][0]), abs(found[0][1])), "i")


def _immediate_if(b: Body, node: nodes.Name, args: list[nodes.Expr]) -> Value:
    test = condition(b, args[0])
    yes, no = value(b, args[1]), value(b, args[2])
    if yes is NOTHING or no is NOTHING:
        return NOTHING
    if (yes.type == STRING) is not (no.type == STRING):
        b.problem("type", "the two values of IIf must both be numbers or both be texts", node)
        return NOTHING
    kind = yes.type if yes.type == no.type else FLOAT
    return Value(f"({yes.text} if {test} else {no.text})", kind, intervals.join(yes.range, no.range))


# -------------------------------------------------------------------------------------------------- indices


def indices(b: Body, node: nodes.Name, row: Keyword, single: bool) -> list[str]:
    """Return the texts of a keyword's indices: axes, channels, or none."""
    args = node.args
    kind = row.index
    if args and len(args) == 1 and kind in _ONE:
        arg = args[0]
        text = b.whole.axis_texts.get(arg.value) if arg.__class__ is nodes.Number else None
        return [text or _index(b, arg, kind)]
    if kind == "none":
        if args:
            b.problem("values", f"{row.name} takes no brackets", node)
        return []
    names = kind.split(", ")
    if names[-1] == "array":
        from motionlang.mint.compile.path_use import with_arrays

        return with_arrays(b, node, row, names)
    if args is None or not args:
        if len(names) > 1 or kind == "task":
            needed = row.index if len(names) > 1 else article(kind)
            b.problem("values", f"{row.name} needs {needed} in brackets", node)
        bank = b.whole.names.default_bank
        if kind == "bank" and row.group == "io" and bank is not None:
            return [
                as_integer(b, value(b, nodes.Name(node.start, node.end, Word(bank.name)).resolve(None, bank)))
            ]
        return ["0"] * len(names)
    many = names[-1] in ("axis", "axes") and not single
    if len(args) != len(names) and not (many and len(args) >= len(names)):
        wanted = _many(1, names[0]) if len(names) == 1 else f"{_many(len(names), 'value')} ({kind})"
        b.problem("values", f"{row.name} takes {wanted} in brackets, {len(args)} given", node)
        return ["0"] * len(names)
    what = [*names, *[names[-1]] * (len(args) - len(names))]
    return [_index(b, arg, kind) for arg, kind in zip(args, what, strict=True)]


# Kinds of index that may be the only one in brackets.
_ONE = frozenset(("axis", "axes", "channel"))


def _index(b: Body, node: nodes.Expr, kind: str) -> str:
    if kind == "task":
        return _name_of_task(b, node)
    if node.__class__ is nodes.Number and node.value in b.whole.axis_texts:
        return b.whole.axis_texts[node.value]
    if kind == "distance":
        return as_float(number(b, node, "a distance"))
    what = f"the number of {article('axis' if kind == 'axes' else kind)}"
    found = number(b, node, what)
    if found.const is not None:
        if found.const != int(found.const):
            b.problem("range", f"{found.const} is not {what}", node)
        elif kind in ("axis", "axes") and found.const not in b.whole.axes:
            last = b.whole.axes[-1]
            hint = f"this controller has axes 0 to {last}; controller.axes sets their number"
            b.problem("axis", f"there is no axis {found.const}", node, hint)
            return "0"
    return as_integer(b, found)


def _name_of_task(b: Body, node: nodes.Expr) -> str:
    """Return the name of the task that an index gives; it is not an expression."""
    named = node if type(node) is nodes.Name and node.args is None else None
    word = node.name if type(node) is nodes.Name else Word("")
    if named is not None and named.symbol is None and word.lower() == PARENT.lower():
        return repr(PARENT)
    symbol = task(b, named or nodes.Name(node.start, node.end, word).resolve(None), word)
    return repr("" if symbol is None else symbol.name.lower())


def task(b: Body, node: nodes.Name | nodes.Run | nodes.End, name: str) -> Symbol | None:
    """Return the task that a node names; report an error if there is none."""
    if node.symbol is not None and node.symbol.kind == "task":
        return node.symbol

    def tasks() -> list[str]:
        return [each.name for each in b.whole.names.module.names.values() if each.kind == "task"]

    b.whole.problems.unknown(f"there is no task {name}".rstrip(), name, tasks, node.start)
    return None


def _many(count: int, what: str) -> str:
    return count_of(count, what, {"axis": "axes", "index": "indices"}.get(what, ""))


# --------------------------------------------------------------------------------------------------- writes


def write(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Compile `KEYWORD(axes) = values`."""
    if "W" not in row.access:
        refuse(b, node, target, row)
        return
    if row.verb == "wait":
        if target.args or node.repeat:
            b.problem("values", "WAIT = ms takes one time and no axis", target, "WAIT = 100 waits for 100 ms")
        wait(b, node, node.values, row)
        return
    if row.kind == "move" and row.index == "axes":
        from motionlang.mint.compile.path_use import write_path

        write_path(b, node, target, row)
        return
    axes = None if by_default(b, target, row) else indices(b, target, row, single=False)
    give(b, node, row, axes, [str(b.whole.line(node.start))] if row.group == "motion" else [])


def refuse(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Report that a keyword takes no value."""
    b.problem("read-only", f"{row.name} {_why_not(row)}", target, _instead(row, target.name))
    for each in node.values:
        value(b, each)


def give(b: Body, node: nodes.Assign, row: Keyword, where: list[str] | None, last: list[str]) -> None:
    """Write values to the axes or other indices in `where`; None means AXES.

    `last` are arguments that follow the value in each operation.
    """
    if where is None:
        _write_to_defaults(b, node, row, last)
        return
    values = _values(b, node, row, max(1, len(where)) if row.index in ("axis", "axes") else 1)
    if values is None:
        return
    if row.index in ("axis", "axes"):
        pairs = [([axis], text) for axis, text in zip(where, values, strict=True) if text != OMITTED]
    else:
        pairs = [(where, values[0])]
    copy = id(node) in b.copies
    b.operate([_storing(b, row, axes, text, last, copy) for axes, text in pairs])


def by_default(b: Body, target: nodes.Name, row: Keyword) -> bool:
    """True if a keyword without brackets means the axes of AXES."""
    return target.args is None and row.index in ("axis", "axes") and b.whole.names.uses_axes


def _write_to_defaults(b: Body, node: nodes.Assign, row: Keyword, last: list[str]) -> None:
    """Compile `SPEED = 10, 20` after `AXES[0, 1]`.

    The number of axes is known only at run time.
    """
    texts = _given(b, node, row)
    observes, b.observes = b.observes, True
    b.settle(observes)
    axis, text = b.temp(), b.temp()
    pairs = b.whole.use("env", "pairs")
    b.emit(f"for {axis}, {text} in {pairs}(({', '.join(texts)},), {node.repeat}):", LOOP)
    b.indent += 1
    if OMITTED in texts:
        b.emit(f"if {text} is {OMITTED}: continue")
    b.operation(*_storing(b, row, [axis], text, last))
    b.indent -= 1
    b.pending += 1


def _why_not(row: Keyword) -> str:
    if row.kind == "constant":
        return "is a constant and cannot be changed"
    if row.kind in ("function", "statement"):
        return f"is a {row.kind} and cannot be assigned to"
    return "is a command and takes no value" if row.access == "C" else "can be read but not written"


def _instead(row: Keyword, name: str) -> str:
    if name.lower() == row.short.lower():
        return f"{name} is short for {row.name}; Dim {name} makes a variable of it"
    if row.access == "C" and row.kind == "command":
        return f"write {row.name}(0) without ="
    if row.group == "v4":
        return "a variable of this name must be declared with Dim"
    return {"VEL": "SPEED sets the speed of moves", "IDLE": "PAUSE IDLE waits for the end of a move"}.get(
        row.name, ""
    )


def _given(b: Body, node: nodes.Assign, row: Keyword) -> list[str]:
    """Return the texts of the values of an assignment, `OMITTED` for an omitted one."""
    return [OMITTED if type(each) is nodes.Omitted else _value(b, each, row) for each in node.values]


def _values(b: Body, node: nodes.Assign, row: Keyword, count: int) -> list[str] | None:
    texts = _given(b, node, row)
    if node.repeat and 0 < len(texts) < count:
        texts += texts[-1:] * (count - len(texts))
    if len(texts) != count:
        given = _many(len(node.values), "value")
        hint = ""
        if len(texts) < count:
            hint = "end the list with ; to give the last value to all further axes"
        elif row.index in ("axis", "axes"):
            axes = ", ".join(map(str, range(len(texts))))
            hint = f"name an axis for each value: {row.name}({axes}) = …"
        b.problem("values", f"{row.name} needs {_many(count, 'value')} here, {given} given", node, hint)
        return None
    return texts


def _value(b: Body, node: nodes.Expr, row: Keyword) -> str:
    found = value(b, node)
    if found.type == FLOAT and found.const is None and found.range[2] == "f" and type_of(row) == FLOAT:
        return found.bare
    if row.unit == "text":
        if found.type != STRING and found is not NOTHING:
            b.problem("type", f"{row.name} takes a text, not a number", node)
        return found.text
    if not found.is_number:
        b.problem("type", f"{row.name} takes a number, not a text", node)
        return "0"
    if found.const is not None:
        _check_range(b, node, row, float(found.const))
    return as_float(found) if row.takes_fractions else as_integer(b, found)


def _check_range(b: Body, node: nodes.Expr, row: Keyword, given: float) -> None:
    refusal = row.refusal(given)
    if refusal is not None:
        message, hint = refusal
        b.problem("range", message, node, hint)


def _storing(
    b: Body, row: Keyword, where: list[str], text: str, last: list[str], copy: bool = False
) -> tuple[str, list[str]]:
    """Return the operation that writes a value or loads a move, with its arguments."""
    how = "copy" if copy else "load" if row.kind == "move" else "write" if "W" in row.access else "do"
    operation, where = b.whole.called(how, row, where)
    return operation, [*where, text, *last]


# ------------------------------------------------------------------------------------------------- commands


def command(b: Body, node: nodes.Call, row: Keyword) -> None:
    """Compile a keyword as a statement: `GO(0, 1)`, `WAIT(100)`."""
    target = node.target
    if row.verb == "wait":
        wait(b, target, target.args or [], row)
        return
    if row.verb == "line":
        line(b, node)
        return
    if row.access != "C" or row.kind == "statement":
        not_a_command(b, target, row)
        return
    operation, where = done_at(b, target, row, indices)
    if row.index in ("axes", "axis") or row.group == "motion":
        where.append(str(b.whole.line(node.start)))
    b.operate([(operation, where)])


def done_at(
    b: Body, target: nodes.Name, row: Keyword, indices: Callable[..., list[str]]
) -> tuple[str, list[str]]:
    """Return the operation of a command, and the texts of its indices.

    The indices come from the function `indices`.
    """
    if by_default(b, target, row):
        default = f"{b.whole.use('env', 'default_axes')}()"
        return b.whole.called("do", row, [default if row.index == "axes" else f"{default}[0]"])
    where = indices(b, target, row, single=False)
    return (
        b.whole.called_together("do", row, where) if row.index == "axes" else b.whole.called("do", row, where)
    )


def _with_value(target: nodes.Name, row: Keyword, shown: str) -> str:
    """Return the statement that writes a keyword: TIME = 0 for TIME 0 or TIME(0).

    If no value is given, add the statement that shows the keyword.
    """
    given = target.args or []
    if row.index == "none" and given:
        number = given[0] if len(given) == 1 else None
        return (
            f"{row.name} = {number.value:.10g}" if isinstance(number, nodes.Number) else f"{row.name} = value"
        )
    return f"{shown} = value sets it, PRINT {shown} shows it" if "R" in row.access else f"{shown} = value"


def not_a_command(b: Body, target: nodes.Name, row: Keyword) -> None:
    """Report that a keyword is not a statement."""
    shown = row.name if target.args is None else f"{row.name}(…)"
    if row.kind == "statement":
        b.problem("syntax", f"{row.name} cannot be used here", target, as_hint(row.help))
    elif "W" in row.access:
        b.problem("not-a-command", f"{row.name} needs a value", target, _with_value(target, row, shown))
    else:
        b.problem(
            "not-a-command",
            f"{row.name} is a value, not a statement",
            target,
            f"print it with PRINT {shown}",
        )


def wait(b: Body, node: nodes.Node, values: list[nodes.Expr], row: Keyword) -> None:
    """Compile `WAIT = ms` and `WAIT(ms)`."""
    if len(values) != 1:
        b.problem("values", f"WAIT needs 1 value, {len(values)} given", node, "WAIT = 100 waits for 100 ms")
        return
    text = _value(b, values[0], row)
    b.flush()
    b.settle()
    own = b.function.kind != "sub" and not b.function.jumps and not b.whole.typed
    try:
        rest, given = b.whole.use("wait", b.at, float(text), own), ""
    except ValueError:
        rest, given = b.whole.use("wait", b.at, None, own), f", {text}"
    b.wait("E.wait", f"{rest}(t{given}) or ")
    b.pending += 1
