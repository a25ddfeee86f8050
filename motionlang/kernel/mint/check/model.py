"""The check for notation and keywords that the configured controller model lacks.

There are two generations of Mint, v4 and MintMT. A program written for one of them does not compile on a controller
of the other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

from motionlang.kernel.controller.io.host_memory import named_product
from motionlang.kernel.lang.program import Target
from motionlang.kernel.mint.keywords.comms import EVENTS
from motionlang.kernel.mint.keywords.event_kinds import kind_and_number
from motionlang.kernel.mint.models import ABSENT, LARGEST, MINTMT, NAMES, V4, V4_SUFFIX, age, named
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.tokens import Tokens, token_at
from motionlang.kernel.mint.syntax.traversal import names_of, walk
from motionlang.kernel.source import Source
from motionlang.kernel.tools import as_hint


class Foreign(NamedTuple):
    """Notation of the other generation: its offset, what is there, a hint, and its replacement, "" if none is certain.

    The replacement is for the token, or for the text up to `end`.
    """

    at: int
    what: str
    hint: str
    replacement: str = ""
    end: int = 0


Found = Iterator[Foreign]

# Kinds of tokens that only Mint v4 has: what they are, and the MintMT equivalent.
_V4_TOKENS = {
    "DO": ("IF … DO", "If … Then", "Then"),
    "ENDIF": ("ENDIF", "End If", "End If"),
    "ENDW": ("ENDW", "End While", "End While"),
    "ENDL": ("ENDL", "End Loop", "End Loop"),
    "PERCENT": ("%", "Mod", "Mod"),
}
# Kinds of tokens that only MintMT has: what they are, and the Mint v4 equivalent.
_MT_TOKENS = {
    "ELSEIF": ("ElseIf", "write ELSE and a further IF"),
    "SELECT": ("Select Case", "write IF … DO"),
    "CONST": ("Const", "write the value, or a variable"),
    "DEFINE": ("Define", "write the expression"),
    "SUB": ("Sub", "write a label and GOSUB"),
    "FUNCTION": ("Function", "write a label and GOSUB"),
    "TASK": ("Task", "v4 has one task"),
    "EVENT": ("Event", "write a label such as #ONERROR"),
    "STARTUP": ("Startup", "write the settings first"),
    "TYPE": ("Type", "write arrays"),
    "RUN": ("Run", "v4 has one task"),
    "AS": ("As", "v4 has numbers only, without declaration"),
}
# Groups of keywords that v4 has with round brackets, too.
_OF_BOTH = frozenset(("terminal", "without an effect"))
_END_OF = {"IF": "ENDIF", "WHILE": "ENDW", "LOOP": "ENDL"}


def check_model(module: Module, source: Source, model: str, add: Callable[..., None]) -> None:
    """Report everything that the controller model does not accept."""
    wanted = age(model)
    if wanted is None:
        return
    find = _not_v4 if wanted == V4 else _not_mintmt
    other = MINTMT if wanted == V4 else V4
    for at, what, hint, replacement, end in find(module, source, Tokens(source.text, module.tokens)):
        message = f"{what} is {other}: it does not compile on {wanted}"
        add("model", message, at, hint, fix=replacement, end=end)
    product = named(model)
    if product is not None:
        for at, what, hint in _lacking(module, product):
            add("model", what, at, hint)
        for at, what, hint in _never_raised(module, product):
            add("model", what, at, hint, "warning")


def written_for(module: Module) -> Target:
    """Return the generation that a program with declared names is written for.

    There is none if the program uses the notation of both. If it uses that of neither, then labels, AUTO and the
    extension speak for v4, although MintMT accepts them.
    """
    source = module.source
    tokens = Tokens(source.text, module.tokens)
    found = [list(find(module, source, tokens)) for find in (_not_mintmt, _not_v4)]
    if found[0] and found[1]:
        return Target("", [], [])
    reasons: dict[str, str] = {}
    notation = [(at, what) for at, what, *_ in found[0] or found[1]]
    for at, what in sorted(notation or _habits_of_v4(module)):
        reasons.setdefault(what, f"line {module.line(at)}: {what}")
    if not notation and source.name.lower().endswith(V4_SUFFIX):
        reasons[V4_SUFFIX] = f"the extension {V4_SUFFIX}"
    model = NAMES[1 if found[1] else 0] if reasons else ""
    return Target(model, list(reasons.values()), [])


def _habits_of_v4(module: Module) -> Iterator[tuple[int, str]]:
    """Find what programs of v4 have and MintMT accepts as well."""
    for node in walk(module.everything):
        if type(node) is nodes.Label:
            yield node.start, f"#{node.name}"
        elif type(node) is nodes.Auto:
            yield node.start, "AUTO"


def _not_mintmt(module: Module, source: Source, tokens: Tokens) -> Found:
    yield from _v4_tokens(source, tokens)
    for name in names_of(module):
        if name.row is None or not name.axes:
            continue
        text = token_at(source.text, name.start)
        word, *channels = text.split(".")
        if channels:
            meant = f"{word}({', '.join(channels)})"
            yield Foreign(name.start, text, f"write {meant}", meant)
        else:
            yield from _square_brackets(source, name)


def _square_brackets(source: Source, name: nodes.Name) -> Found:
    """Find `MOVER[0, 1]`; one that is continued on another line has a replacement for each bracket."""
    shown = ", ".join(_shown(each) for each in name.args or ())
    what, hint = f"{name.name}[{shown}]", f"write {name.name}({shown})"
    written = source.text[name.start : name.end]
    opening = written.index("[") + 1
    if "\n" not in written:
        meant = f"{written[: opening - 1]}({written[opening:-1]})"
        yield Foreign(name.start, what, hint, meant, name.end)
    else:
        meant = f"{written[: opening - 1]}("
        yield Foreign(name.start, what, hint, meant, name.start + opening)
        yield Foreign(name.end - 1, "]", "write )", ")")


def _not_v4(module: Module, source: Source, tokens: Tokens) -> Found:
    yield from _mt_tokens(tokens)
    yield from _ends(tokens)
    for name in names_of(module):
        row = name.row
        brackets = name.args is not None and not name.axes
        if row is None or row.group in _OF_BOTH:
            continue
        if brackets and row.kind not in ("function", "constant", "statement"):
            shown = ", ".join(_shown(each) for each in name.args or ())
            dotted = f"{name.name}.{shown}" if len(name.args or ()) == 1 else f"{name.name}[{shown}]"
            what, meant = f"{name.name}({shown})", dotted if shown else name.name
            yield Foreign(name.start, what, f"write {meant}")
        elif row.function == "choice":
            yield Foreign(name.start, "IIf", "write IF … DO")
    for node in walk(module.body):
        if type(node) is nodes.Exit and node.kind:
            yield Foreign(node.start, f"Exit {node.kind.capitalize()}", "EXIT leaves the innermost loop")


def _lacking(module: Module, product: str) -> Iterator[tuple[int, str, str]]:
    """Find keywords and values that the manuals give only for other products."""
    for name in names_of(module):
        row = name.row
        if row is not None and product in ABSENT.get(row.family, ()):
            yield name.start, f"the {product} has no {row.name}", as_hint(row.help)
    for node in walk(module.everything):
        target = node.target if type(node) is nodes.Assign else None
        row = target.row if type(target) is nodes.Name else None
        if (
            row is None
            or type(node) is not nodes.Assign
            or product not in LARGEST.get(row.family, (0.0, ()))[1]
        ):
            continue
        largest = LARGEST[row.family][0]
        for value in node.values:
            if type(value) is nodes.Number and value.value > largest:
                bounds = f"it takes {-largest:.10g} to {largest:.10g} there"
                yield value.start, f"{row.name} cannot be {value.value:.10g} on the {product}", bounds


def _never_raised(module: Module, product: str) -> Iterator[tuple[int, str, str]]:
    """Find handlers of host writes that this product never reports."""
    spans = EVENTS.get(named_product(product) or "")
    for event in module.events if spans is not None else ():
        named_event = kind_and_number(event.name)
        if named_event is None or named_event[0] not in ("comms", "netdata") or named_event[1] < 0:
            continue
        kind, number = named_event
        span = spans.get(kind)  # type: ignore[union-attr]
        if span is None:
            known = f"it has no {kind.upper()} events"
        elif span[0] <= number <= span[1]:
            continue
        else:
            known = f"those of {span[0]} to {span[1]} do"
        yield event.start, f"{event.name} never comes on the {product}", known


def _v4_tokens(source: Source, tokens: Tokens) -> Found:
    """Find tokens of Mint v4, each with its replacement.

    All tokens of a block get a replacement, so that the block stays consistent.
    """
    kinds = tokens.kinds
    in_else_if = False
    for at, kind in enumerate(kinds):
        if kind in ("IF", "ELSEIF"):
            in_else_if = kind == "ELSEIF" or (at > 0 and kinds[at - 1] == "ELSE")
        if kind not in _V4_TOKENS:
            continue
        what, hint, replacement = _V4_TOKENS[kind]
        start = tokens.starts[at]
        if kind == "DO" and not in_else_if and kinds[at + 1] != "_NL":
            replacement = (
                f"Then\n{_indentation(source, start)} "  # Then opens a block only at the end of a line
            )
        meant = _apart(source.text, start, tokens.ends[at], replacement)
        yield Foreign(start, what, f"write {hint}", meant)


def _indentation(source: Source, at: int) -> str:
    """Return the whitespace at the beginning of the line of an offset."""
    line = source.line(source.location(at)[0])
    return line[: len(line) - len(line.lstrip(" \t"))]


def _apart(text: str, start: int, end: int, word: str) -> str:
    """Return a replacement with spaces where a letter or digit is next to the token."""
    before = " " if start and _in_word(text[start - 1]) else ""
    return f"{before}{word}{' ' if _in_word(text[end : end + 1]) else ''}"


def _in_word(letter: str) -> bool:
    return letter.isalnum() or letter in ("_", ".")


def _mt_tokens(tokens: Tokens) -> Found:
    """Find tokens of MintMT.

    The `End` before such a token belongs to the same block and is not reported.
    """
    before = ""
    is_reported = False  # `Const x As …` is reported once
    for at, kind in enumerate(tokens.kinds):
        is_reported = is_reported and kind not in ("_NL", "COLON")
        if kind in _MT_TOKENS and before not in ("END", "EXIT") and not (is_reported and kind == "AS"):
            is_reported = True
            yield Foreign(tokens.starts[at], *_MT_TOKENS[kind])
        before = kind


def _ends(tokens: Tokens) -> Found:
    """Find `End If` and similar closers, and an If with Then at the end of its line."""
    before = ""
    for at, kind in enumerate(tokens.kinds):
        if before == "END" and kind in _END_OF:
            what = f"End {tokens.texts[at].capitalize()}"
            yield Foreign(tokens.starts[at - 1], what, f"write {_END_OF[kind]}")
        elif before == "THEN" and kind == "_NL":
            yield Foreign(tokens.starts[at - 1], "Then at the end of a line", "write DO")
        before = kind


def _shown(node: nodes.Expr) -> str:
    if type(node) is nodes.Number or type(node) is nodes.String:
        return f"{node.value:.10g}" if type(node) is nodes.Number else f'"{node.value}"'
    return node.name if type(node) is nodes.Name and node.args is None else "…"
