"""Answers of the server, in this process."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest

from test_lsp.wire import INITIALIZE, PROGRAM, URI, Wire

MACHINE = "file:///nowhere/a.machine.toml"


def ask(
    text: str,
    method: str = "",
    uri: str = URI,
    capabilities: object = None,
    initialization: object = None,
    **parameters: object,
) -> Any:
    """Return the answer to a request about a text, or the text's diagnostics."""

    async def whole() -> Any:
        wire = Wire()
        wire.request(
            "first",
            "initialize",
            {**INITIALIZE, "capabilities": capabilities or {}, "initializationOptions": initialization},
        )
        item = {"uri": uri, "languageId": "mint" if uri == URI else "toml", "version": 4, "text": text}
        wire.notify("textDocument/didOpen", {"textDocument": item})
        await wire.settled()
        if not method:
            return wire.sent[-1]["params"]["diagnostics"]
        wire.request(1, f"textDocument/{method}", {"textDocument": {"uri": uri}, **parameters})
        await wire.settled()
        (answer,) = wire.answers()[1]
        return answer.get("result", answer.get("error"))

    return asyncio.run(whole())


def at(line: int, character: int) -> dict[str, int]:
    return {"line": line, "character": character}


def span(line: int, begin: int, end: int, last: int | None = None) -> dict[str, Any]:
    return {"start": at(line, begin), "end": at(line if last is None else last, end)}


COUNT = [span(0, 4, 9), span(6, 2, 7), span(6, 10, 15), span(9, 6, 11)]


# A text, and the ranges of its diagnostics with their severity (1 error, 2 warning).
MARKED = [
    ("Print 1 1\n", [(span(0, 8, 9), 1)]),
    ("Dim\n", [(span(0, 3, 3), 1)]),
    ("\n  Loop\n", [(span(1, 2, 6), 1)]),
    ("Dim spare\n", [(span(0, 4, 9), 2)]),
    ('Print "\U0001f527" 1\n', [(span(0, 11, 12), 1)]),
    (PROGRAM, [(span(1, 0, 5), 2)]),
]


@pytest.mark.parametrize(("text", "wanted"), MARKED)
def test_the_range_of_a_diagnostic(text: str, wanted: list[tuple[object, int]]) -> None:
    assert [(each["range"], each["severity"]) for each in ask(text)] == wanted


@pytest.mark.parametrize(("text", "tags"), [("Dim spare\n", [1]), ("Print 1 1\n", None)])
def test_what_is_unused_has_the_tag_unnecessary(text: str, tags: list[int] | None) -> None:
    (found,) = ask(text)
    assert found.get("tags") == tags
    assert found["source"] == "motionlang"


def test_uses_of_a_name() -> None:
    """All of them, or without the declaration; between names there is none."""
    place = at(0, 5)
    assert [each["range"] for each in ask(PROGRAM, "documentHighlight", position=place)] == COUNT
    for declaration, wanted in ((True, COUNT), (False, COUNT[1:])):
        found = ask(PROGRAM, "references", position=place, context={"includeDeclaration": declaration})
        assert [each["range"] for each in found] == wanted
        assert {each["uri"] for each in found} == {URI}
    assert ask(PROGRAM, "definition", position=at(8, 1)) == {"uri": URI, "range": span(3, 4, 10)}
    assert ask(PROGRAM, "definition", position=at(1, 6)) is None


def test_a_hover() -> None:
    found = ask(PROGRAM, "hover", position=at(8, 1))
    assert found["range"] == span(8, 0, 6)
    assert found["contents"]["kind"] == "markdown"
    assert ask(PROGRAM, "hover", position=at(8, 7)) is None
    found = ask("[axis.1]\nmotor = ", "hover", MACHINE, position=at(1, 2))
    assert found["range"] == span(1, 0, 5)


def test_a_renamed_name() -> None:
    """The edits belong to the version of the text if the editor knows versions."""
    assert ask(PROGRAM, "prepareRename", position=at(0, 5)) == {
        "range": COUNT[0], "placeholder": "count",
    }  # fmt: skip
    assert ask(PROGRAM, "prepareRename", position=at(4, 3)) == {
        "code": -32803, "message": "MOVER is a keyword",
    }  # fmt: skip
    edits = [{"range": each, "newText": "done"} for each in COUNT]
    rename: dict[str, Any] = {"position": at(0, 5), "newName": "done"}
    assert ask(PROGRAM, "rename", **rename) == {"changes": {URI: edits}}
    for has_versions in (False, True):
        capabilities = {"workspace": {"workspaceEdit": {"documentChanges": has_versions}}}
        assert ask(PROGRAM, "rename", capabilities=capabilities, **rename) == (
            {"documentChanges": [{"textDocument": {"uri": URI, "version": 4}, "edits": edits}]}
            if has_versions
            else {"changes": {URI: edits}}
        )
    found = ask(PROGRAM, "rename", position=at(0, 5), newName="go")
    assert (found["code"], found["message"]) == (-32803, "GO is a keyword of Mint")


def test_an_outline() -> None:
    """The kinds are 13 variable and 12 function; a sub has the range of its block."""
    found = ask(PROGRAM, "documentSymbol")
    assert [(each["name"], each["kind"], each["range"], each["selectionRange"]) for each in found] == [
        ("count", 13, span(0, 4, 9), span(0, 4, 9)),
        ("SPEDE", 13, span(1, 0, 5), span(1, 0, 5)),
        ("Travel", 12, span(3, 0, 7, 7), span(3, 4, 10)),
    ]
    assert ask("[axis.1]\n", "documentSymbol", MACHINE) == []


@pytest.mark.parametrize(("snippets", "text", "form"), [(True, "For ${1:i} = ", 2), (False, "For", None)])
def test_a_block_is_completed_as_a_snippet(snippets: bool, text: str, form: int | None) -> None:
    """Only for editors that have snippets; the typed beginning is replaced."""
    capabilities = {"textDocument": {"completion": {"completionItem": {"snippetSupport": snippets}}}}
    found = ask("Print 1 : Fo", "completion", capabilities=capabilities, position=at(0, 12))
    assert found["isIncomplete"] is False
    (block,) = [each for each in found["items"] if (each["label"], each["kind"]) == ("For", 15)]
    assert block["textEdit"]["newText"].startswith(text)
    assert block["textEdit"]["range"] == span(0, 10, 12)
    assert block.get("insertTextFormat") == form


def test_a_completed_keyword() -> None:
    found = ask(PROGRAM, "completion", position=at(4, 4))
    (item,) = [each for each in found["items"] if each["label"] == "MOVER"]
    assert (item["kind"], item["detail"], item["sortText"]) == (2, "move, uu", "2MOVER")
    assert item["textEdit"] == {"range": span(4, 2, 4), "newText": "MOVER"}
    found = ask("[axis.1]\nmotor = ", "completion", MACHINE, position=at(1, 8))
    assert [each["textEdit"]["newText"] for each in found["items"]] == ['"servo"', '"stepper"']


@pytest.mark.parametrize(("character", "active"), [(2, 0), (6, 1)])
def test_the_signature_of_a_call(character: int, active: int) -> None:
    text = "Sub s(a As Float, b As Float)\nEnd Sub\ns(10, 20)\n"
    found = ask(text, "signatureHelp", position=at(2, character))
    (signature,) = found["signatures"]
    assert signature["label"] == "Sub s(a As Float, b As Float)"
    assert [each["label"] for each in signature["parameters"]] == ["a As Float", "b As Float"]
    assert (found["activeSignature"], found["activeParameter"]) == (0, active)
    assert ask(text, "signatureHelp", position=at(1, 2)) is None
    assert ask("[axis.1]\n", "signatureHelp", MACHINE, position=at(0, 6)) is None


@pytest.mark.parametrize(
    ("wanted", "count"),
    [
        (span(1, 0, 5), 1),
        (span(1, 5, 5), 1),
        (span(1, 6, 6), 0),
        (span(0, 0, 0, 1), 1),
        (span(0, 0, 9), 0),
        (span(2, 0, 0), 0),
    ],
)
def test_fixes_of_what_a_range_touches(wanted: dict[str, Any], count: int) -> None:
    """The mistake is in line 1, from 0 to 5; a range may touch its ends."""
    found = ask(PROGRAM, "codeAction", range=wanted, context={"diagnostics": []})
    assert [each["title"] for each in found[:1]] == ["Change to SPEED"] * count
    assert [each["title"] for each in found[1:]] == ["Suppress unused-variable on this line"] * count
    for each in found[:1]:
        assert each["kind"] == "quickfix"
        assert each["edit"] == {"changes": {URI: [{"range": span(1, 0, 5), "newText": "SPEED"}]}}
        assert [shown["code"] for shown in each["diagnostics"]] == ["unused-variable"]


@pytest.mark.parametrize(
    ("only", "count"), [(["quickfix"], 2), (["refactor"], 0), (["refactor", ""], 2), ([], 2)]
)
def test_only_the_kinds_of_fixes_that_an_editor_requests(only: list[str], count: int) -> None:
    context = {"diagnostics": [], "only": only}
    assert len(ask(PROGRAM, "codeAction", range=span(1, 0, 5), context=context)) == count


@pytest.mark.parametrize(
    ("size", "spaces", "indent"), [(2, True, "  "), (0, True, " "), (99, True, " " * 16), (2, False, "\t")]
)
def test_the_indent_of_an_editor(size: int, spaces: bool, indent: str) -> None:
    """Between 1 and 16 blanks, or a tab."""
    options = {"tabSize": size, "insertSpaces": spaces}
    (edit,) = ask("If 1 Then\nPrint 1\nEnd If\n", "formatting", options=options)
    assert edit == {"range": span(1, 0, 0), "newText": indent}


def test_folds() -> None:
    """The last line of a block stays visible; comments have a kind."""
    assert ask(PROGRAM, "foldingRange") == [{"startLine": 3, "endLine": 6}]
    assert ask("' a\n' b\nPrint 1\n", "foldingRange") == [{"startLine": 0, "endLine": 1, "kind": "comment"}]


def test_semantic_tokens_count_from_the_previous_token() -> None:
    """Line, character, length, kind and modifiers.

    A symbol outside the BMP has 2 UTF-16 units.
    """
    found = ask('Print 1 : Print 2\n\nPrint "\U0001f527", 3\n', "semanticTokens/full")
    places = [tuple(found["data"][k : k + 3]) for k in range(0, len(found["data"]), 5)]
    assert places == [(0, 0, 5), (0, 6, 1), (0, 4, 5), (0, 6, 1), (2, 0, 5), (0, 6, 4), (0, 6, 1)]


@pytest.mark.parametrize(
    ("options", "titles"),
    [
        ({"commands": ["motionlang.scope", "motionlang.run", "other"]}, ["run", "scope"]),
        ({"commands": "motionlang.run"}, []),
        (["motionlang.run"], []),
        (None, []),
    ],
)
def test_lenses_of_the_commands_that_an_editor_has(options: object, titles: list[str]) -> None:
    found = ask(PROGRAM, "codeLens", initialization=options)
    assert [each["command"]["title"] for each in found] == titles
    assert all(each["range"] == span(0, 0, 0) for each in found)
    assert all(each["command"]["arguments"] == [URI] for each in found)


def test_each_sub_has_a_lens_for_its_map() -> None:
    text = "Go1\nSub Go1\n  While 1\n    WAIT(5)\n  End While\nEnd Sub\nTask Lamp\nEnd Task\n"
    found = ask(text, "codeLens", initialization={"commands": ["motionlang.map"]})
    assert [(each["range"]["start"]["line"], each["command"]["arguments"]) for each in found] == [
        (0, [URI]),
        (1, [URI, "Go1"]),
        (6, [URI, "Lamp"]),
    ]
    assert {each["command"]["title"] for each in found} == {"map"}


@pytest.mark.parametrize(
    ("name", "language", "count"),
    [
        ("a.mnt", "toml", 1),
        ("a.txt", "mint", 1),
        ("a.txt", "toml", None),
        ("a.mcl", "mint", 1),
        ("b.machine.toml", "", 1),
    ],
)
def test_the_language_of_a_text(name: str, language: str, count: int | None) -> None:
    """It is that of the suffix, else the one that the editor names.

    Other texts are not checked.
    """

    async def whole() -> list[Any]:
        wire = Wire()
        wire.request("first", "initialize", INITIALIZE)
        item = {"uri": f"file:///nowhere/{name}", "languageId": language, "version": 1, "text": "( = )\n"}
        wire.notify("textDocument/didOpen", {"textDocument": item})
        await wire.settled()
        return [
            each["params"] for each in wire.sent if each.get("method") == "textDocument/publishDiagnostics"
        ]

    published = asyncio.run(whole())
    assert len(published) == (0 if count is None else 1)
    assert all(each["diagnostics"] for each in published)
