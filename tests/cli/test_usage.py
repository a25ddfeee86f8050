"""Command lines without a command, and incomplete command lines."""

from __future__ import annotations

import pytest

from motionlang.cli import main
from motionlang.cli.commands import COMMANDS, FOLDERS


def test_a_line_of_options_alone_names_no_command(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["--"])
    assert end.value.code == 2
    assert "the following arguments are required: COMMAND" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("line", "hint"),
    [
        ("servo nonsense", "motionlang servo --help lists the options"),
        ("servo plan", "motionlang plan is a command of its own"),
        ("pvt stream", "motionlang copley stream sends a move to a drive over CANopen"),
    ],
)
def test_a_command_of_a_command_that_there_is_not(
    line: str, hint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as end:
        main(line.split())
    assert end.value.code == 2
    error, said = capsys.readouterr().err.splitlines()
    assert f"there is no command {line.split()[1]}; choose" in error
    assert said == f"  hint: {hint}"


@pytest.mark.parametrize(
    ("line", "command", "hint"),
    [
        ("pvt refine --timee 5", "pvt refine", "did you mean --time?"),
        ("servo step --bandwith 9", "servo step", "did you mean --bandwidth?"),
        ("serve --can x:y", "serve", "motionlang copley serve INTERFACE:CHANNEL puts drives on a bus"),
        (
            "serve --mcapi 5011",
            "serve",
            "motionlang mcapi serve --port HOST:PORT serves hosts that call MCAPI",
        ),
        ("run x.mnt --untl 5", "run", "did you mean --until?"),
    ],
)
def test_an_unknown_option_is_compared_with_those_of_its_command(
    line: str, command: str, hint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(line.split())
    error, said = capsys.readouterr().err.splitlines()
    assert error.startswith(f"motionlang {command}: error: unrecognized arguments: --")
    assert said == f"  hint: {hint}"


@pytest.mark.parametrize(
    ("name", "folder"), sorted(each for each in FOLDERS.items() if each[0] not in COMMANDS)
)
@pytest.mark.parametrize("line", ["{} serve", "{} --help", "help {}"])
def test_a_command_of_a_package_that_is_not_installed(
    name: str, folder: str, line: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: ())
    with pytest.raises(SystemExit) as end:
        main(line.format(name).split())
    assert end.value.code == 2
    install = f"python -m pip install ./extras/{folder}"
    assert capsys.readouterr() == ("", f"motionlang: error: {name} needs motionlang-{folder}: {install}\n")
