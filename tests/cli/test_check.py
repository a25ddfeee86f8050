"""`motionlang check`: every mistake of every file."""

from __future__ import annotations

import json

from tests.cli.programs import Cell


def test_every_file_has_its_line_and_its_mistakes(cell: Cell) -> None:
    ran = cell("check", "ballscrew.mcl", "wrong.mcl", "none.mcl", "pick.txt")
    assert ran.status == 1
    assert ran.out == (
        "ballscrew.mcl: no mistakes\nwrong.mcl: 1 error\nnone.mcl: 1 error\npick.txt: 1 error\n"
    )
    assert " --> wrong.mcl:2:1\n" in ran.err
    assert "error[file]: none.mcl cannot be read: no such file or directory\n" in ran.err
    assert "error[file]: the language of pick.txt is unknown" in ran.err


def test_nothing_is_wrong(cell: Cell) -> None:
    ran = cell("check", "ballscrew.mcl")
    assert (ran.status, ran.out, ran.err) == (0, "ballscrew.mcl: no mistakes\n", "")


def test_json(cell: Cell) -> None:
    document = json.loads(cell("check", "wrong.mcl", "--json").out)
    assert document["schema"] == "motionlang.check/1"
    (file,) = document["files"]
    assert (file["program"], file["dialect"]) == ("wrong.mcl", "mccl")
    assert file["diagnostics"][0]["code"] == "unknown-word"
