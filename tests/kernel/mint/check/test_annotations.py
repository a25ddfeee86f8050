"""The types and the known values that the check records in the tree."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source
from motionlang.kernel.mint.check.check import Checked, check_line, check_module
from motionlang.kernel.mint.resolve.overrides import override
from motionlang.kernel.mint.resolve.symbols import Session
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.node import Expression
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.mint.syntax.traversal import walk

DECLARED = """\
Type point
 x As Float
 hits(3) As Integer
End Type
Const three = 3, half As Float = 0.5, title = "lid"
Define twice = 2 * n
Dim n As Integer, f As Float, s As String, t As Time, taken As Semaphore, p As point, list(4) As Integer
Function count() As Integer
 count = 1
End Function
Function where() As point
 where = p
End Function
"""
# An expression, its type, and its value if it is known.
EXPRESSIONS = [
    ("7", "Integer", 7),
    ("7.0", "Float", 7.0),
    ("3000000000", "Float", 3000000000),
    ("0xFFFFFFFF", "Integer", -1),
    ("9007199254740993", "Float", 9007199254740992.0),
    ('"a"', "String", "a"),
    ('"a" + title', "String", "alid"),
    ('"a" < s', "Integer", None),
    ("three", "Integer", 3),
    ("half", "Float", 0.5),
    ("three + 1", "Integer", 4),
    ("three * half", "Float", 1.5),
    ("7 / 2", "Float", 3.5),
    ("7 \\ 2", "Integer", 3),
    ("2147483647 + 1", "Integer", None),  # fails in the run, with its line
    ("1 < 2", "Integer", 1),
    ("1 And 2", "Integer", None),
    ("Not 1", "Integer", None),
    ("-three", "Integer", -3),
    ("-f", "Float", None),
    ("~n", "Integer", None),
    ("n + 1", "Integer", None),
    ("n + f", "Float", None),
    ("n / 2", "Float", None),
    ("n ^ 2", "Float", None),
    ("n Mod 2", "Integer", None),
    ("f Mod 2", "Float", None),
    ("f \\ 2", "Integer", None),
    ("n & 3", "Integer", None),
    ("n << 3", "Integer", None),
    ("t", "Integer", None),
    ("taken", "Integer", None),
    ("p", "point", None),
    ("p.x", "Float", None),
    ("p.hits(2)", "Integer", None),
    ("list(n)", "Integer", None),
    ("count", "Integer", None),
    ("where", "point", None),
    ("twice", "Integer", None),
    ("_TRUE", "Integer", 1),
    ("POS(0)", "Float", None),
    ("IDLE[0, 1]", "Integer", None),
    ("Abs(n)", "Integer", None),
    ("Abs(f)", "Float", None),
    ("Str(n)", "String", None),
    ("IIf(n, 1, 2)", "Integer", None),
    ("IIf(n, 1, f)", "Float", None),
]  # fmt: skip


def checked(text: str) -> tuple[nodes.Module, Checked]:
    module = parse(Source("a.mnt", text))
    return module, check_module(module)


def condition_of(module: nodes.Module) -> nodes.Expr:
    """Return the subject of the last Select of the program."""
    node = module.body[-1]
    assert isinstance(node, nodes.Select)
    return node.subject


@pytest.mark.parametrize(("text", "kind", "known"), EXPRESSIONS, ids=[each[0] for each in EXPRESSIONS])
def test_type_and_value_of_an_expression(text: str, kind: str, known: object) -> None:
    module, _ = checked(f"{DECLARED}Select Case {text}\nEnd Select\n")
    node = condition_of(module)
    assert (node.type, node.const, type(node.const)) == (kind, known, type(known))
    inner = [each for each in walk([node]) if isinstance(each, Expression)]
    assert [each for each in inner if each.type is None] == []


def test_the_definition_of_a_define_is_annotated_at_each_use() -> None:
    module, _ = checked(f"{DECLARED}Select Case twice\nEnd Select\n")
    node = condition_of(module)
    assert isinstance(node, nodes.Name)
    assert isinstance(node.definition, nodes.Binary)
    assert (node.definition.type, node.definition.left.const) == ("Integer", 2)


def test_each_link_of_a_chain_has_the_result_so_far() -> None:
    module, _ = checked(f"{DECLARED}Select Case 1{' + 1' * 60} + f + 1\nEnd Select\n")
    node = condition_of(module)
    assert isinstance(node, nodes.Chain)
    assert [each.const for each in node.links[:60]] == list(range(2, 62))
    assert [(each.type, each.const) for each in node.links[60:]] == [("Float", None)] * 2


def test_targets_have_the_type_of_their_declaration() -> None:
    module, _ = checked(f"{DECLARED}t = 0\ntaken = 1\np.hits(1) = 2\nlist(2) = 3\nf = 1\n")
    targets = [node.target for node in module.body if isinstance(node, nodes.Assign)]
    assert [each.type for each in targets] == ["Time", "Semaphore", "Integer", "Integer", "Float"]


def test_a_task_as_an_index_has_its_symbol_and_no_type() -> None:
    module, _ = checked("Pause TASKSTATUS(blink) = 0\nTask blink\nEnd Task\n")
    (index,) = (n for n in walk(module.body) if isinstance(n, nodes.Name) and n.name == "blink")
    assert index.symbol is not None
    assert (index.symbol.kind, index.type) == ("task", None)


def test_given_values_have_a_type_and_no_value() -> None:
    module = parse(Source("a.mnt", 'Const n As Integer = 3, s = "a"\nPrint n, s\n'))
    override(module, {}, {"n": False, "s": True})
    check_module(module)
    items = [item.value for node in module.body if isinstance(node, nodes.Print) for item in node.items]
    assert [(each.type, each.const) for each in items] == [("Integer", None), ("String", None)]


def test_a_typed_line_knows_the_names_of_earlier_lines() -> None:
    session = Session()
    check_line(parse(Source("a.mnt", "Dim n As Integer")), {}, session)
    module = parse(Source("a.mnt", "Select Case n + 1\nEnd Select"))
    check_line(module, {}, session)
    assert condition_of(module).type == "Integer"


def test_annotations_are_no_content() -> None:
    module, _ = checked("n = 1 + 2\n")
    same = parse(Source("a.mnt", "n = 1 + 2\n"))
    assert module.body == same.body
    assert repr(module.body) == repr(same.body)


def test_thousands_of_elseifs_are_no_recursion() -> None:
    branches = "".join(f"ElseIf n = {number} Then\n n = {number}\n" for number in range(3000))
    module, _ = checked(f"Dim n As Integer\nIf n Then\n{branches}End If\n")
    conditions = [node.condition.type for node in walk(module.body) if isinstance(node, nodes.If)]
    assert conditions == ["Integer"] * 3001
