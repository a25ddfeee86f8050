"""Name resolution: find what every name of a Mint program refers to.

Problem. A name is written in any case and may be a variable, constant, parameter, Define, sub, task or keyword. A sub
may be called above its declaration, a Define is replaced by its expression, and an assignment to an unknown name
declares a Float. So no name can be resolved before all declarations and assignments are known.

Idea. Each function is walked once (`Survey`). The passes of `declare_module` use the results of that walk:

1. Declare: the types, then each function with its parameters, labels, and its Const, Define and Dim statements, in
   text order.
2. Implicit: a name that a function assigns to and that is neither declared nor a keyword becomes a variable there. The
   main program comes first, so a sub that assigns to one of its variables gets that variable.
3. Use: every use of a name is bound. A Define is expanded at each use, and the names in its expression are looked up in
   the function that uses it.
4. Subscripts: the number of subscripts of an array parameter follows from its uses, also through calls that pass it on.

    Dim x                      main, the module     x, twice, show
    Define twice = 2 * x         └ sub show         n, y
    x = 3 : show twice
    Sub show(n)                x      shared, since main and show use it
     x = n : y = n             y      implicit in show, since main does not assign to it
    End Sub                    twice  bound to a copy of 2 * x

Data (`symbols.py`). A `Symbol` has a kind and a type. A `Scope` is a dict that links to its enclosing scope: from a sub
to its task, if any, and then to the module. A `Function` is the main program, a task, a sub or an event handler; it has
its labels. A `Record` is a user type with its members. Each node with a name gets its `symbol`. A `Name` gets `row`
instead if it is a keyword, and for a Define also `definition`, the expression. An unknown name gets none of these; the
check reports it with a suggestion.

Invariants.
- A declaration hides a keyword of the same name. It is also reported, unless a program may reuse the keyword: a short
  form, a v4 keyword, one that is not simulated, or a string function. Uses of a name that is reported may mean the
  keyword, so no other error is reported at them.
- A declaration that repeats a name of its scope is reported. Its symbol's `first` is what the name refers to.
- Errors are collected in `diagnostics`. After each of them resolution continues with a usable symbol.
- `shared`: a function other than the one that declares the variable uses it. `uses` counts reads, not assignments.
- At a prompt the names of the module outlive the line, and a later declaration replaces an earlier one.

Cost. One walk over each function, and one lookup for each spelling in it. Each use of a Define copies its expression;
expanded expressions nest to at most `MAX_DEFINED_DEPTH` levels.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import chain
from math import inf

from motionlang.kernel.lang.vocabulary import Vocabulary
from motionlang.kernel.mint.keywords.event_kinds import (
    KINDS,
    NUMBERS,
    SINGLE,
    SOURCELESS,
    kind_and_number,
)
from motionlang.kernel.mint.keywords.unsimulated import WRITTEN, written
from motionlang.kernel.mint.models import STRINGS
from motionlang.kernel.mint.resolve.diagnostics import Diagnostics
from motionlang.kernel.mint.resolve.folding import Meaning, fold, given
from motionlang.kernel.mint.resolve.symbols import (
    FLOAT,
    INTEGER,
    OTHER_TYPES,
    RECORD,
    STRING,
    TYPES,
    Function,
    PromptSymbols,
    Record,
    Scope,
    Symbol,
    Type,
)
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nesting import depth_of
from motionlang.kernel.mint.syntax.node import Resolved
from motionlang.kernel.mint.syntax.traversal import Survey, copied, walk

# The maximum number of array elements. A typing error in a Dim must not exhaust the memory of the computer.
MAX_ELEMENTS = 10_000_000
# The maximum nesting of nodes when Defines stand for expressions that contain further Defines.
MAX_DEFINED_DEPTH = 1000


class Symbols:
    """All symbols of a module.

    If the program is typed line by line, `session` has the names and types from earlier lines.
    """

    def __init__(
        self, table: Vocabulary, diagnostics: Diagnostics, session: PromptSymbols | None = None
    ) -> None:
        self.table, self.diagnostics = table, diagnostics
        self.types: dict[str, Symbol] = {} if session is None else dict(session.types)
        self.functions: list[Function] = []
        self.main = Function("main", "main", [], None if session is None else session.scope)
        self.typed = session is not None
        self.module = self.main.scope
        # True if the program uses AXES, which sets the axes of keywords without brackets.
        self.uses_axes = self.typed
        # The row of BANK, which sets the bank of keywords without brackets, if the program uses it.
        self.default_bank = table.get(table.doing("default_bank")) if self.typed else None
        # True if the program uses TERMINAL, which sets where a PRINT without a number prints.
        self.uses_terminal = self.typed
        self._surveys: dict[Function, Survey] = {}
        # Declared names that are keywords.
        self._taken: set[str] = set()
        # The Defines that are being expanded, innermost last.
        self._replacing: list[Symbol] = []
        # The depth of their expressions, and a flag that is True once it was too deep. No further Defines are
        # expanded then.
        self._defined_depth = 0
        self._defines_too_deep = False

    # ------------------------------------------------------------------------------------- declarations

    def declare_module(self, module: nodes.Module) -> None:
        """Declare all names of the module, then bind every use of a name."""
        self._declare_names(module)
        self.diagnostics.taken = self._taken
        for function in self.functions:
            self._use(function)
        self._count_subscripts()
        self._surveys.clear()

    def _declare_names(self, module: nodes.Module) -> None:
        main = self.main
        main.body = [statement for block in module.startup for statement in block.body] + module.body
        self.functions.append(main)
        for user_type in module.types:
            self._declare_type(user_type)
        self._declare_data(main, module.types)
        for sub in module.subs:
            self._declare_sub(sub, self.module)
        for task in module.tasks:
            self._declare_task(task)
        for event in module.events:
            self._block("event", event)
            self._check_event(event)
        for function in self.functions:
            self._implicit(function)

    def _block(self, kind: str, node: nodes.Task | nodes.Event) -> Function:
        function = Function(kind, node.name, node.body, self.module)
        function.node, function.at = node, node.start
        self.functions.append(function)
        symbol = Symbol(node.name, kind, Type(FLOAT), node.start, function)
        if kind == "event":
            node.resolve(symbol)
        else:
            self._declare(self.module, node, symbol)
        self._declare_data(function)
        return function

    def _check_event(self, event: nodes.Event) -> None:
        found = kind_and_number(event.name)
        if found is None:
            names = [
                kind.upper() + ("" if kind in SINGLE else "0") for kind in KINDS if kind not in SOURCELESS
            ]
            self.diagnostics.unknown(f"there is no event {event.name}", event.name, lambda: names, event.start,
                                     f"the events are {', '.join(names)}")  # fmt: skip
        elif any(f.kind == "event" and kind_and_number(f.name) == found for f in self.functions[:-1]):
            self.diagnostics.add("duplicate", f"there is already a handler for {event.name}", event.start)
        elif found[1] >= 0 and (numbers := NUMBERS.get(found[0])) is not None and found[1] not in numbers:
            word = event.name.rstrip("0123456789")
            self.diagnostics.add("channel", f"there is no event {event.name}", event.start,
                                 f"they are numbered {word}{numbers[0]} to {word}{numbers[-1]}")  # fmt: skip
        elif found[0] in SOURCELESS:
            self.diagnostics.add("not-simulated", f"the event {event.name.upper()} never occurs here", event.start,
                                 "nothing raises it in the simulated machine", "warning")  # fmt: skip

    def _declare_task(self, task: nodes.Task) -> None:
        function = self._block("task", task)
        for sub in task.subs:
            self._declare_sub(sub, function.scope)

    def _declare_sub(self, sub: nodes.Sub, scope: Scope) -> Function:
        function = Function("sub", sub.name, sub.body, scope)
        function.node, function.at = sub, sub.start
        self.functions.append(function)
        result = self.type_of(sub.result, INTEGER) if sub.function else Type(FLOAT)
        self._declare(scope, sub, Symbol(sub.name, "sub", result, sub.start, function))
        for parameter in sub.parameters:
            self._declare_parameter(function, parameter)
        if sub.function:
            symbol = Symbol(sub.name, "variable", result, sub.start, function)
            function.result = symbol
        self._declare_data(function)
        return function

    def _declare_parameter(self, function: Function, node: nodes.Parameter) -> None:
        kind = self.type_of(node.type, FLOAT)
        by_ref = node.by_ref and not node.is_array
        symbol = Symbol(node.name, "parameter", kind, node.start, function)
        symbol.by_ref = by_ref
        symbol.dimensions = (0,) if node.is_array else ()
        function.parameters.append(symbol)
        self._declare(function.scope, node, symbol)

    def _count_subscripts(self) -> None:
        """Find the number of subscripts of array parameters from their use in the subs.

        A parameter that is only passed on has the number of the parameter that receives it.
        """
        handed: list[tuple[Symbol, Symbol]] = []
        for name in chain.from_iterable(chain(*(each.names.values() for each in self._surveys.values()))):
            symbol = name.symbol
            if symbol is None or not name.args:
                continue
            if symbol.kind == "sub":
                handed += _handed(name, symbol)
            elif _is_array_parameter(symbol):
                symbol.dimensions = (0,) * len(name.args)
        found = handed
        while found:
            found = [pair for pair in handed if len(pair[1].dimensions) > len(pair[0].dimensions)]
            for symbol, parameter in found:
                symbol.dimensions = parameter.dimensions

    def _declare_type(self, node: nodes.UserType) -> None:
        record = Record(node.name)
        for member in node.members:
            symbol = Symbol(member.name, "member", self.type_of(member.type, FLOAT), member.start, self.main)
            symbol.owner, symbol.index = record, len(record.members)
            symbol.first = record.members.setdefault(member.name.lower(), symbol)
            if symbol.first is symbol:
                symbol.dimensions = self._dimensions(member, self.module)
            else:
                message = f"{node.name} already has a member {member.name}"
                self.diagnostics.add("duplicate", message, member.start)
            member.resolve(symbol)
        key = node.name.lower()
        if (key in self.types and not self.typed) or key in TYPES:
            self.diagnostics.add("duplicate", f"there is already a type {node.name}", node.start)
        symbol = Symbol(node.name, "type", Type(RECORD, record=record), node.start, self.main)
        symbol.first = self.types[key].first if key in self.types else symbol
        self.types[key] = symbol
        node.resolve(symbol)

    def type_of(self, node: nodes.TypeName | None, default: str) -> Type:
        """Return the type named after `As`, or the default without one."""
        if node is None:
            return Type(default)
        key = node.name.lower()
        symbol = self.types.get(key)
        node.resolve(symbol)
        if symbol is not None:
            return symbol.type
        if key not in TYPES:
            known = [*TYPES.values(), *self.types]
            word = OTHER_TYPES.get(key, node.name)
            otherwise = f"the types are {', '.join(known)}"
            self.diagnostics.unknown(
                f"there is no type {node.name}", word, lambda: known, node.start, otherwise
            )
            return Type(default)
        size = (
            self._whole(node.size, self.module, "the length of a String", 1)
            if node.size is not None
            else None
        )
        return Type(TYPES[key], size)

    def _declare_data(self, function: Function, types: Iterable[nodes.UserType] = ()) -> None:
        """Declare the names in the body of a function; the names in the declarations of types are those of main."""
        survey = self._surveys[function] = Survey([*function.body, *types])
        for node in survey.of(nodes.Const, nodes.Define, nodes.Dim, nodes.Label):
            if type(node) is nodes.Dim:
                for variable in node.variables:
                    symbol = self._declare_variable(function, variable)
                    if node.nv:
                        self._make_lasting(symbol, variable)
            elif type(node) is nodes.Const:
                self._declare_const(function, node)
            elif type(node) is nodes.Define:
                symbol = Symbol(node.name, "define", Type(FLOAT), node.start, function)
                symbol.node = node.value
                self._declare(function.scope, node, symbol)
            elif type(node) is nodes.Label:
                self._declare_label(function, node)

    def _declare_label(self, function: Function, node: nodes.Label) -> None:
        symbol = Symbol(node.name, "label", Type(FLOAT), node.start, function)
        symbol.first = function.labels.setdefault(node.name.lower(), symbol)
        if symbol.first is not symbol:
            self.diagnostics.add("duplicate", f"there is already a label {node.name}", node.start)
        node.resolve(symbol)

    def _make_lasting(self, symbol: Symbol, node: nodes.Variable) -> None:
        """Box an nv variable in a list, which is shared with non-volatile memory."""
        if symbol.type.name not in (INTEGER, FLOAT, STRING, RECORD):
            self.diagnostics.add("type", f"nv data cannot be {symbol.type}", node.start,
                                 hint="Integer, Float, String and user types can outlive the run")  # fmt: skip
        symbol.boxed = not (symbol.is_array or symbol.type.record)

    def _declare_variable(self, function: Function, node: nodes.Variable) -> Symbol:
        if node.type is not None and node.type.name.lower() == "controller":
            hint = "no source documents them"
            self.diagnostics.add(
                "not-simulated", "variables of type Controller are not simulated", node.type.start, hint=hint
            )
        symbol = Symbol(node.name, "variable", self.type_of(node.type, FLOAT), node.start, function)
        symbol.dimensions = self._dimensions(node, function.scope)
        self._declare(function.scope, node, symbol)
        return symbol

    def _declare_const(self, function: Function, node: nodes.Const) -> None:
        means = self._means(function.scope)
        value = fold(node.value, means)
        expression = given(node.value, means) if value is None else None
        if expression is not None:
            symbol = Symbol(node.name, "define", Type(FLOAT), node.start, function)
            if node.type is not None:
                expression = nodes.Cast(node.start, node.end, expression, self.type_of(node.type, FLOAT))
            symbol.node, symbol.given = expression, True
            self._declare(function.scope, node, symbol)
            return
        if value is None:
            names = (each.name for each in walk([node.value]) if isinstance(each, nodes.Name))
            near = next((found[0] for name in names if (found := self.table.meant_by(name))), None)
            hint = f"did you mean {near}?" if near else "a Const can use numbers, texts and other constants"
            message = f"the value of {node.name} is not known before the program runs"
            self.diagnostics.add("type", message, node.start, hint=hint)
            value = 1  # as the size of an array or a divisor, 0 would be a second error
        natural = STRING if isinstance(value, str) else INTEGER if isinstance(value, int) else FLOAT
        kind = self.type_of(node.type, natural)
        if (kind.name == STRING) is not isinstance(value, str):
            self.diagnostics.add("type", f"{node.name} is {kind}, its value is {natural}", node.start)
            value = "" if kind.name == STRING else 1
        symbol = Symbol(node.name, "const", kind, node.start, function)
        symbol.const = int(value) if kind.name == INTEGER else float(value) if kind.name == FLOAT else value
        self._declare(function.scope, node, symbol)

    def _dimensions(self, node: nodes.Variable, scope: Scope) -> tuple[int, ...]:
        sizes = [self._whole(size, scope, f"the size of {node.name}", 1) for size in node.dimensions]
        count = 1
        for size in sizes:
            count *= size
        if count > MAX_ELEMENTS:
            self.diagnostics.add("range", f"{node.name} has more than {MAX_ELEMENTS} elements", node.start,
                                 hint="make the array smaller")  # fmt: skip
            return (1,) * len(sizes)
        return tuple(sizes)

    def _means(self, scope: Scope) -> Callable[[nodes.Name], Meaning]:
        """Return a lookup of names in a scope that is not complete yet."""
        return lambda name: (scope.find(name.name), self.table.get(name.name))

    def _whole(self, node: nodes.Expr, scope: Scope, what: str, least: int) -> int:
        value = fold(node, self._means(scope))
        if isinstance(value, (int, float)) and least <= value < inf and value == int(value):
            return int(value)
        self.diagnostics.add("range", f"{what} must be a whole number of at least {least} that is known beforehand",
                             node.start)  # fmt: skip
        return least

    def _declare(self, scope: Scope, node: Resolved, symbol: Symbol) -> None:
        """Add the name of a declaration to a scope; report a duplicate or the name of a keyword."""
        node.resolve(symbol)
        key = symbol.name.lower()
        if key in scope.names and not (self.typed and scope is self.module):
            first = self.diagnostics.line(scope.names[key].at)
            message, hint = f"{symbol.name} is already declared", f"the first one is in line {first}"
            self.diagnostics.add("duplicate", message, symbol.at, hint)
            symbol.first = scope.names[key]
            return
        row = self.table.get(symbol.name)
        # A keyword of v4 is no keyword in a program that declares its name. Keywords of statements are
        # reported by the grammar.
        if (
            row is not None
            and row.name.lower() == key
            and row.simulated
            and row.group != "v4"
            and row.family != STRINGS
            and (row.kind != "statement" or key in TYPES)
        ):
            self.diagnostics.add("duplicate", f"{row.name} is a {row.kind} of Mint and cannot be declared", symbol.at,
                                 hint="choose another name")  # fmt: skip
            self._taken.add(key)
        scope.names[key] = symbol

    # ---------------------------------------------------------------------------------------------- uses

    def _implicit(self, function: Function) -> None:
        """Declare names that are assigned without a Dim as Float variables."""
        for name, target in self._surveys[function].assigned.items():
            if function.scope.find(name) is not None:
                continue
            row = self.table.get(name)
            if row is not None and row.family != STRINGS:
                continue
            symbol = Symbol(name, "variable", Type(FLOAT), target.start, function)
            symbol.declared = False
            function.scope.names[name.lower()] = symbol

    def _use(self, function: Function) -> None:
        survey = self._surveys[function]
        self._bind(function, survey)
        for target in survey.targets:
            self._written(target)

    def _bind(self, function: Function, survey: Survey) -> None:
        """Bind the names of a body or an expression in the scope of a function."""
        for spelling, names in survey.names.items():
            symbol = function.scope.find(spelling)
            row = self.table.get(spelling) if symbol is None else None
            for name in names:
                name.symbol = symbol
                name.row = row
                name.definition = None
            if symbol is None or symbol.kind in (
                "variable",
                "parameter",
            ):  # the result is the same for all uses of a name
                self._use_name(function, names[0])
                if symbol is not None:
                    symbol.uses += len(names) - 1
            else:
                for name in names:
                    self._use_name(function, name)
        for node in reversed(survey.statements):  # the owner of a member before the member
            kind = node.__class__
            if kind is nodes.Member:
                node.resolve(_member(node))  # type: ignore[attr-defined, arg-type]
            elif kind is nodes.Jump:
                node.resolve(_target(function, node))  # type: ignore[attr-defined, arg-type]
            elif (kind is nodes.Run or kind is nodes.End) and node.name is not None:  # type: ignore[attr-defined]
                node.resolve(function.scope.find(node.name))  # type: ignore[attr-defined]
            elif kind is nodes.Print and node.word:  # type: ignore[attr-defined]
                symbol = function.scope.find(node.word)  # type: ignore[attr-defined]
                node.resolve(symbol, self.table.get(node.word) if symbol is None else None)  # type: ignore[attr-defined]

    def _written(self, target: nodes.Expr) -> None:
        """Undo the count of a use for the target of an assignment, which is no read.

        A keyword that is simulated for reads only gets its row for writing.
        """
        if type(target) is not nodes.Name:
            return
        if target.symbol is not None:
            target.symbol.uses -= target.symbol.kind != "define"
        elif target.row is not None and target.row.name in WRITTEN:
            target.row = written(target.row)

    def _use_name(self, function: Function, node: nodes.Name) -> None:
        symbol, row = node.symbol, node.row
        if symbol is None:
            if row is not None and row.kind not in ("function", "constant"):
                self.uses_axes = self.uses_axes or row.function == "default_axes"
                if row.function == "default_bank":
                    self.default_bank = row
                self.uses_terminal = self.uses_terminal or row.function == "terminal.terminal"
            return
        if symbol.kind in ("variable", "parameter"):
            symbol.uses += 1
            if symbol.home is not function:
                symbol.shared = True
        elif symbol.kind == "define":
            symbol.uses += 1
            self._replace(function, node, symbol)
        elif symbol.kind == "sub" and function.result_named(node) is None:
            function.calls.add(symbol.home)

    def _replace(self, function: Function, node: nodes.Name, define: Symbol) -> None:
        """Bind a name to the expression of a Define, whose names are resolved at this use."""
        if self._defines_too_deep:
            return
        if define in self._replacing:
            message = f"{define.name} is defined by itself"
            self.diagnostics.add(
                "type", message, define.at, "the expression of a Define must not contain its own name"
            )
            return
        depth = depth_of(define.node)  # type: ignore[arg-type]
        if self._defined_depth + depth > MAX_DEFINED_DEPTH:
            message = f"Defines nest expressions more than {MAX_DEFINED_DEPTH} deep, with this one"
            self.diagnostics.add("syntax", message, define.at, "use a variable for a subexpression")
            self._defines_too_deep = True
            return
        self._defined_depth += depth
        self._replacing.append(define)
        definition: nodes.Expr = copied(define.node)  # type: ignore[assignment]
        self._bind(function, Survey([definition]))
        self._replacing.pop()
        self._defined_depth -= depth
        node.definition = definition


def _target(function: Function, node: nodes.Jump) -> Symbol:
    """Return the label that a jump names, a new one without a declaration if there is none."""
    unknown = Symbol(node.name, "label", Type(FLOAT), node.start, function)
    unknown.declared = False
    return function.labels.setdefault(node.name.lower(), unknown)


def _member(node: nodes.Member) -> Symbol | None:
    """Return the symbol of a member whose owner is bound, None if the owner has no such member."""
    owner = node.value.symbol if isinstance(node.value, nodes.Name | nodes.Member) else None
    record = None if owner is None else owner.type.record
    return None if record is None else record.members.get(node.field.lower())


def _handed(call: nodes.Name, callee: Symbol) -> Iterator[tuple[Symbol, Symbol]]:
    """Yield each array parameter that a call passes on, with the receiving parameter."""
    for argument, parameter in zip(call.args or (), callee.home.parameters, strict=False):
        symbol = argument.symbol if isinstance(argument, nodes.Name) and argument.args is None else None
        if symbol is not None and _is_array_parameter(symbol) and parameter.is_array:
            yield symbol, parameter


def _is_array_parameter(symbol: Symbol) -> bool:
    return symbol.kind == "parameter" and symbol.is_array
