"""The forms of a map: Mermaid and DOT by their grammars, JSON, Markdown, and the page."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from html.parser import HTMLParser

import pytest
from lark import Lark

from tests.cli.programs import Cell
from tests.commands.map.test_proof import GALLERY

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


PROGRAMS = {path.name: path.read_text(encoding="utf-8") for path in GALLERY[::4]} | {"signs.mnt": SIGNS}


def written(cell: Cell, name: str, text: str, form: str, *options: str) -> str:
    """Return the map of a program in the form of an extension."""
    cell.write(name, text)
    assert cell("map", name, "-o", f"m.{form}", *options).err == ""
    return (cell.folder / f"m.{form}").read_text(encoding="utf-8")


@pytest.mark.parametrize(("form", "grammar"), [("mmd", MERMAID), ("dot", DOT)])
def test_graphs_are_in_the_grammar_of_their_tool(form: str, grammar: str, cell: Cell) -> None:
    parser = Lark(grammar, parser="lalr" if form == "dot" else "earley")
    names = list(PROGRAMS) if form == "dot" else [*list(PROGRAMS)[::6], "signs.mnt"]
    for name in names:
        parser.parse(written(cell, name, PROGRAMS[name], form))


@pytest.mark.skipif(shutil.which("dot") is None, reason="Graphviz is not installed")
def test_graphviz_draws_the_graphs(cell: Cell) -> None:
    for name in [*list(PROGRAMS)[::5], "signs.mnt"]:
        done = subprocess.run(
            ["dot", "-Tsvg"],
            input=written(cell, name, PROGRAMS[name], "dot"),
            text=True,
            capture_output=True,
            check=True,
            timeout=60,
        )
        assert (done.stderr, "<svg" in done.stdout) == ("", True)


def test_a_graph_has_every_state_and_transition(cell: Cell) -> None:
    for name in [*list(PROGRAMS)[::3], "signs.mnt"]:
        text = PROGRAMS[name]
        made = json.loads(written(cell, name, text, "json"))
        for form, arrow in (("mmd", " -->"), ("dot", " -> ")):
            drawn = written(cell, name, text, form)
            assert len(re.findall(rf"^ +\w+{arrow}", drawn, re.M)) == len(made["transitions"])


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


@pytest.mark.parametrize("name", [*list(PROGRAMS)[::6], "signs.mnt"])
def test_the_page_is_complete_in_itself(name: str, cell: Cell) -> None:
    text, found = written(cell, name, PROGRAMS[name], "html"), Links()
    found.feed(text)
    assert found.resources == []
    assert {each for each in found.links if not each.startswith("#")} == set()
    assert {each[1:] for each in found.links} <= found.targets
    assert "url(http" not in text
    assert all(f'id="L{number}"' in text for number in range(1, PROGRAMS[name].count("\n") + 1))


def test_json_has_every_table(cell: Cell) -> None:
    found = json.loads(written(cell, "a.mnt", "PAUSE INX(3)\n", "json"))
    assert found["schema"] == "motionlang/1"
    assert found["channels"][0]["number"] == "3"
    assert [each["kind"] for each in found["states"]] == ["start", "wait", "end"]
    assert [(each["from"], each["to"]) for each in found["transitions"]] == [
        ("begin", "1 PAUSE INX(3)"),
        ("1 PAUSE INX(3)", "end"),
    ]


def test_markdown_has_a_diagram_of_each_unit(cell: Cell) -> None:
    found = written(cell, "a.mnt", "Fill\nSub Fill\n  WAIT = 5\nEnd Sub\n", "md")
    assert found.count("```mermaid\nflowchart TD\n") == 2
    assert "### sub Fill (line 2)" in found


def test_transitions_that_a_run_took_are_drawn_so_and_a_run_that_repeats_has_its_cycle(cell: Cell) -> None:
    drawn = written(cell, "a.mnt", "If INX(1) Then PAUSE INX(2)\nWAIT = 10\n", "html", "--run")
    assert (drawn.count('class="path taken"'), drawn.count('class="path untaken"')) == (2, 2)
    assert 'id="cycle"' not in drawn
    text = "Loop\n  MOVER(0) = 20 : GO(0)\n  PAUSE IDLE(0)\n  WAIT = 200\nEnd Loop\n"
    drawn = written(cell, "a.mnt", text, "html", "--run", "--until", "8")
    assert 'id="cycle"' in drawn
    assert "one cycle of a.mnt" in drawn


@pytest.mark.parametrize("form", ["json", "csv", "md", "mmd", "dot", "html", "txt"])
def test_an_empty_program_has_a_map(form: str, cell: Cell) -> None:
    assert written(cell, "a.mnt", "' nothing\n", form).endswith("\n")
