"""Messages name only options that exist."""

from __future__ import annotations

from pathlib import Path

import motionlang_explore
from tests.test_option_names import unknown_options


def test_messages_name_only_options_that_exist() -> None:
    assert unknown_options(Path(motionlang_explore.__file__).parent) == set()
