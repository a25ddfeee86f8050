"""The editor's tables have the kind of each keyword."""

from __future__ import annotations

import json

from tools import highlight_tables


def test_each_keyword_has_its_kind() -> None:
    kinds = json.loads(highlight_tables.written())
    words = {
        (language, word): kind
        for language, found in kinds.items()
        for kind, text in found.items()
        for word in text.split()
    }
    assert words["mint", "mover"] == words["mccl", "mr"] == "move"
    assert words["mint", "speed"] == words["mint", "sp"] == words["mccl", "sv"] == "keyword"
    assert words["mint", "print"] == words["mint", "endif"] == "control"
