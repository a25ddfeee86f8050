"""The forms of a map: Mermaid by its grammar, JSON, Markdown, and the page."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest
from lark import Lark

from tests.cli.programs import Cell

# The part of Mermaid's grammar of flowcharts that maps use: a text in quotes has no quote, and signs as codes.
MERMAID = r"""
start: "flowchart TD" _NL line*
line: (node | edge) _NL
node: ID ("([" TEXT "])" | "[" TEXT "]")
edge: ID "-->" ("|" TEXT "|")? ID
ID: /[a-z][a-z0-9_]*/
TEXT: /"(?:[^"#<>&`|\\]|#[a-z0-9]+;|<br>)*"/
_NL: /\n/
%ignore / +/
"""
SIGNS = (
    'Dim t As String * 40\nt = "a|b <c> #d & {e} `f` ^ "\nPRINT t : WAIT = 5\nIf t = "]" Then PAUSE INX(1)\n'
    'PRINT "x\\\\y"\n'
)


SCRIPTS = Path(__file__).parents[5] / "scripts"
NAMES = ("mint/pick-and-place.mnt", "mint/two-tasks.mnt", "mccl/cut-to-length.mcl")
PROGRAMS = {name.partition("/")[2]: (SCRIPTS / name).read_text(encoding="utf-8") for name in NAMES} | {
    "signs.mnt": SIGNS
}


def written(cell: Cell, name: str, text: str, form: str, *options: str) -> str:
    """Return the map of a program in the form of an extension."""
    cell.write(name, text)
    assert cell("map", name, "-o", f"m.{form}", *options).err == ""
    return (cell.folder / f"m.{form}").read_text(encoding="utf-8")


@pytest.mark.slow
def test_graphs_are_in_the_grammar_of_their_tool(cell: Cell) -> None:
    parser = Lark(MERMAID)
    for name in PROGRAMS:
        parser.parse(written(cell, name, PROGRAMS[name], "mmd"))


@pytest.mark.slow
def test_a_graph_has_every_state_and_transition(cell: Cell) -> None:
    for name in PROGRAMS:
        text = PROGRAMS[name]
        made = json.loads(written(cell, name, text, "json"))
        drawn = written(cell, name, text, "mmd")
        assert len(re.findall(r"^ +\w+ -->", drawn, re.M)) == len(made["transitions"])


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


@pytest.mark.parametrize("name", PROGRAMS)
def test_the_page_is_complete_in_itself(name: str, cell: Cell) -> None:
    text, found = written(cell, name, PROGRAMS[name], "html"), Links()
    found.feed(text)
    assert found.resources == []
    assert {each for each in found.links if not each.startswith("#")} == set()
    assert {each[1:] for each in found.links} <= found.targets
    assert "url(http" not in text
    assert all(f'id="L{number}"' in text for number in range(1, PROGRAMS[name].count("\n") + 1))


def test_lines_that_are_never_reached_are_marked(cell: Cell) -> None:
    drawn = written(cell, "a.mnt", "PAUSE INX(1)\nEnd\nSub unused\n  Print 2\nEnd Sub\n", "html")
    assert re.findall(r'"row never" id="(L\d)"', drawn) == ["L4"]


def test_json_has_every_table(cell: Cell) -> None:
    found = json.loads(written(cell, "a.mnt", "PAUSE INX(3)\nMOVER(0) = 5 : GO(0)\n", "json"))
    assert found["schema"] == "motionlang/1"
    assert found["channels"][0]["number"] == "3"
    assert found["states"] == [
        {"name": "power-up", "statement": "", "reads": []},
        {"name": "1", "statement": "PAUSE INX(3)", "reads": ["input 3"]},
    ]
    assert [(each["state"], each["until"], each["to"]) for each in found["transitions"]] == [
        ("power-up", "by itself", "1"),
        ("1", "input 3 on", "the end"),
    ]
    assert found["cycle"][0]["what"] == "input 3 on"
    assert (found["handlers"], found["choices"], found["never_reached"]) == ([], [], [])


def test_a_page_begins_with_the_cycle_and_its_picture(cell: Cell) -> None:
    text = "Loop\n  MOVER(0) = 20 : GO(0)\n  PAUSE IDLE(0)\n  WAIT = 200\nEnd Loop\n"
    drawn = written(cell, "a.mnt", text, "html")
    assert drawn.index('id="cycle"') < drawn.index("one cycle of a.mnt") < drawn.index('id="channels"')
    assert 'id="cycle"' not in written(cell, "a.mnt", text, "html", "--no-run")


@pytest.mark.parametrize("form", ["json", "csv", "md", "mmd", "html", "txt"])
def test_an_empty_program_has_a_map(form: str, cell: Cell) -> None:
    assert written(cell, "a.mnt", "' nothing\n", form).endswith("\n")
