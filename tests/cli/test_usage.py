"""Command lines without a command, and incomplete command lines."""

from __future__ import annotations

import pytest

from motionlang.cli import main


def test_a_line_of_options_alone_names_no_command(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["--"])
    assert end.value.code == 2
    assert "the following arguments are required: COMMAND" in capsys.readouterr().err


def test_a_command_of_a_command_that_there_is_not(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["servo", "nonsense"])
    assert end.value.code == 2
    assert "there is no command nonsense" in capsys.readouterr().err
