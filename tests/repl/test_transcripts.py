"""Sessions as they appear on the screen: input after the prompt, output below it.

A transcript begins with its subject. A line that begins with `mint> ` or `mccl> ` is typed. A line with dots
instead of the name continues a block. All other lines are output. Paths of files are relative to this folder.
`pytest --update` rewrites the output.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang.kernel import dialect, dialects
from motionlang.repl.session import Session

FOLDER = Path(__file__).parent
PROMPTS = {f"{name}> ": name for name in dialects()}


def replay(transcript: str) -> str:
    """Return the transcript with its output as it is now."""
    shown: list[str] = []
    session: Session | None = None
    for line in transcript.splitlines():
        prompt = line[:6].ljust(6)
        if prompt in PROMPTS and session is None:
            session = Session(dialect(PROMPTS[prompt]))
        if session is None:
            shown.append(line + "\n")
        elif prompt in PROMPTS or prompt == "....> ":
            assert bool(session._block) == (prompt == "....> "), (
                f"the prompt is not the one that {line!r} shows"
            )
            shown.append(line + "\n")
            shown.append(session.feed(line[6:]))
    assert session is not None, "nothing is typed"
    assert not session._block
    return "".join(shown)


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.txt")), ids=lambda path: path.stem)
def test_transcript(path: Path, golden: Callable[[Path, str], None], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FOLDER)
    golden(path, replay(path.read_text(encoding="utf-8")))
