"""The conversations on docs/mcapi-protocol.md, repeated with a served board."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from test_mcapi.conftest import Serve

PAGE = Path(__file__).parents[1] / "docs" / "mcapi-protocol.md"
BLOCKS = re.findall(r"^```mcapi\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("block", BLOCKS)
def test_a_conversation_of_the_page(serve: Serve, block: str) -> None:
    line = serve().connect()
    if "MCOpen" not in block:
        line.ask("MCOpen 0 2 -")
    for each in block.splitlines():
        if each.startswith("> "):
            line.send(each[2:])
        else:
            assert line.answer() == each.removeprefix("< ")
