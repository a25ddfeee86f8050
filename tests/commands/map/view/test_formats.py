"""The forms of a map: Mermaid and DOT by their grammars, JSON, Markdown, and the page."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from html.parser import HTMLParser
from pathlib import Path

import pytest
from lark import Lark

from motionlang.commands.map.program_map import ProgramMap, map_of_run, program_map
from motionlang.commands.map.view.formats import FORMS, written
from motionlang.commands.map.view.layout import layout
from motionlang.commands.map.view.page import page
from motionlang.commands.map.view.svg import picture
from motionlang.kernel import Checked, Source, dialect, dialect_for, settings_next_to
from tests.commands.map.test_proof import GALLERY

ROOT = Path(__file__).parents[4]
# The part of Mermaid's grammar of flowcharts that maps use: a text in quotes has no quote, and signs as codes.
MERMAID = r"""
start: "flowchart TD" _NL (subgraph | line)*
subgraph: "subgraph" ID "[" TEXT "]" _NL line* "end" _NL
line: (node | edge) _NL
node: ID ("([" TEXT "])" | "[[" TEXT "]]" | "[" TEXT "]" | ">" TEXT "]" | "{{" TEXT "}}" | "(" TEXT ")")
edge: ID "-->" ("|" TEXT "|")? ID
ID: /[a-z][a-z0-9_]*/
TEXT: /"(?:[^"#<>&`|\\]|#[a-z0-9]+;|<br>)*"/
_NL: /\n/
%ignore / +/
"""
# The grammar of DOT (https://graphviz.org/doc/info/lang.html), for directed graphs without ports and HTML.
DOT = r"""
start: "digraph" id "{" statement* "}"
statement: ("graph" | "node" | "edge") attributes | "subgraph" id "{" statement* "}"
         | id "=" id | id "->" id attributes? | id attributes?
attributes: "[" (id "=" id)* "]"
id: /[A-Za-z_][A-Za-z0-9_]*/ | /-?(?:\.\d+|\d+(?:\.\d*)?)/ | /"(?:[^"\\]|\\.)*"/s
%ignore /\s+/
"""
SIGNS = (
    'Dim t As String * 40\nt = "a|b <c> #d & {e} `f` ^ "\nPRINT t : WAIT = 5\nIf t = "]" Then PAUSE INX(1)\n'
    'PRINT "x\\\\y"\n'
)


@pytest.fixture(scope="module")
def maps() -> list[ProgramMap]:
    sources = [Source.read(path) for path in GALLERY[::4]] + [Source("signs.mnt", SIGNS)]
    return [program_map(each, dialect_for(each, None), settings_next_to(each.name)) for each in sources]


@pytest.mark.parametrize(("form", "grammar"), [("mermaid", MERMAID), ("dot", DOT)])
def test_graphs_are_in_the_grammar_of_their_tool(form: str, grammar: str, maps: list[ProgramMap]) -> None:
    parser = Lark(grammar, parser="lalr" if form == "dot" else "earley")
    for made in maps if form == "dot" else maps[::6] + maps[-1:]:
        parser.parse(written(made, form))


@pytest.mark.skipif(shutil.which("dot") is None, reason="Graphviz is not installed")
def test_graphviz_draws_the_graphs(maps: list[ProgramMap]) -> None:
    for made in maps[::5] + maps[-1:]:
        done = subprocess.run(
            ["dot", "-Tsvg"],
            input=written(made, "dot"),
            text=True,
            capture_output=True,
            check=True,
            timeout=60,
        )
        assert (done.stderr, "<svg" in done.stdout) == ("", True)


def test_a_graph_has_every_state_and_transition(maps: list[ProgramMap]) -> None:
    for made in maps:
        for form, arrow in (("mermaid", " -->"), ("dot", " -> ")):
            text = written(made, form)
            for diagram in made.diagrams.diagrams:
                assert all(re.search(rf"^ +{each.id}\W", text, re.M) for each in diagram.states)
            count = sum(len(diagram.transitions) for diagram in made.diagrams.diagrams)
            assert len(re.findall(rf"^ +\w+{arrow}", text, re.M)) == count


class Links(HTMLParser):
    """The links, the targets and the resources of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.links: list[str] = []
        self.targets: set[str] = set()
        self.resources: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        if given.get("id"):
            self.targets.add(str(given["id"]))
        if tag == "a" and "href" in given:
            self.links.append(str(given["href"]))
        if tag in ("script", "img", "link", "iframe") or "src" in given:
            self.resources.append(tag)


@pytest.mark.parametrize("graphviz", [False, None])
def test_the_page_is_complete_in_itself(graphviz: bool | None, maps: list[ProgramMap]) -> None:
    for made in maps[::6] + maps[-1:]:
        text, found = page(made, graphviz=graphviz), Links()
        found.feed(text)
        assert found.resources == []
        assert {each for each in found.links if not each.startswith("#")} == set()
        assert {each[1:] for each in found.links} <= found.targets
        assert "url(http" not in text
        assert all(f'id="L{number}"' in text for number, _ in made.source.numbered())


def test_json_has_every_table() -> None:
    found = json.loads(written(program_map(Source("a.mnt", "PAUSE INX(3)\n"), dialect("mint")), "json"))
    assert found["schema"] == "motionlang/1"
    assert found["channels"][0]["number"] == "3"
    assert [each["kind"] for each in found["states"]] == ["start", "wait", "end"]
    assert [(each["from"], each["to"]) for each in found["transitions"]] == [
        ("begin", "1 PAUSE INX(3)"),
        ("1 PAUSE INX(3)", "end"),
    ]


def test_markdown_has_a_diagram_of_each_unit() -> None:
    text = "Fill\nSub Fill\n  WAIT = 5\nEnd Sub\n"
    found = written(program_map(Source("a.mnt", text), dialect("mint")), "markdown")
    assert found.count("```mermaid\nflowchart TD\n") == 2
    assert "### sub Fill (line 2)" in found


def test_transitions_that_a_run_took_are_drawn_so() -> None:
    text = "If INX(1) Then PAUSE INX(2)\nWAIT = 10\n"
    made = map_of_run(Source("a.mnt", text), dialect("mint"), Checked({}))
    drawn = picture(made, made.diagrams.diagrams[0], graphviz=False)
    assert (drawn.count('class="path taken"'), drawn.count('class="path untaken"')) == (2, 2)


def test_every_form_is_written(maps: list[ProgramMap]) -> None:
    assert all(written(maps[0], form).endswith("\n") for form in FORMS)


def test_the_layout_has_no_overlapping_nodes_or_labels() -> None:
    """Boxes of a layer are beside each other, and layers are below each other."""
    sizes = {f"n{k}": (60.0 + 7 * (k % 5), 20.0 + 3 * (k % 4)) for k in range(20)}
    edges = [(f"n{k}", f"n{(k * 7 + 3) % 20}", (30.0, 12.0)) for k in range(20)]
    edges += [(f"n{k}", f"n{k + 1}", (44.0, 24.0)) for k in range(19)]
    placed = layout(sizes, edges)
    boxes = [(*placed.nodes[name], *size) for name, size in sizes.items()]
    boxes += [(*place, *size) for (a, b, size), (_, place) in zip(edges, placed.edges, strict=True) if a != b]
    for k, (x, y, width, height) in enumerate(boxes):
        for other_x, other_y, other_width, other_height in boxes[:k]:
            beside = abs(x - other_x) >= (width + other_width) / 2 - 1e-6
            below = abs(y - other_y) >= (height + other_height) / 2 - 1e-6
            assert beside or below
        assert x - width / 2 + 1e-6 >= 0
        assert x + width / 2 <= placed.width + 1e-6


def test_an_empty_program_has_a_map() -> None:
    made = program_map(Source("a.mnt", "' nothing\n"), dialect("mint"))
    assert all(written(made, form) for form in FORMS)
