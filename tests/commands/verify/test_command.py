"""`motionlang verify`: comparison of programs with their golden files."""

from __future__ import annotations

import io
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from motionlang.kernel import Scheduler
from tests.cli.programs import BALLSCREW, Cell


def test_update_then_verify(cell: Cell) -> None:
    for name in ("wrong.mcl", "jog.mcl"):
        (cell.folder / name).unlink()
    ran = cell("verify", ".", "--update")
    assert (ran.status, ran.out) == (
        0,
        "./ballscrew.mcl: written\n1 of 1 programs have current golden files\n",
    )
    assert (cell.folder / "ballscrew.golden.txt").read_text() == "01 200.000000\n"
    assert cell("verify", ".").out == "1 of 1 programs match their golden files\n"
    assert cell("verify", ".", "--update").out == "1 of 1 programs have current golden files\n"


def test_a_difference_is_named_by_its_position(cell: Cell) -> None:
    cell("verify", "ballscrew.mcl", "--update")
    golden = cell.folder / "ballscrew.golden.json"
    document = json.loads(golden.read_text())
    document["moves"][0]["phases"][0]["duration"] = 0.25
    document["moves"][0]["peak_speed"] += 1e-9  # less than a billionth of 250: an equal figure
    del document["axes"][0]["error"]
    golden.write_text(json.dumps(document))
    (cell.folder / "ballscrew.golden.txt").write_text("01 199.000000\n")
    ran = cell("verify", "ballscrew.mcl")
    assert ran.status == 1
    assert ran.out == (
        "ballscrew.mcl: differs\n"
        "  moves[0].phases[0].duration: 0.25 → 0.2\n"
        "  axes[0].error: none → 0\n"
        "  the printed output differs from ballscrew.golden.txt\n"
        "0 of 1 programs match their golden files\n"
    )


def test_line_ends_of_git_for_windows_match(cell: Cell) -> None:
    cell("verify", "ballscrew.mcl", "--update")
    for name in ("ballscrew.golden.txt", "ballscrew.golden.json"):
        path = cell.folder / name
        path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    ran = cell("verify", "ballscrew.mcl")
    assert (ran.status, ran.out) == (0, "1 of 1 programs match their golden files\n")
    (cell.folder / "ballscrew.golden.txt").write_bytes(b"01 200.000001\r\n")
    assert cell("verify", "ballscrew.mcl").status == 1


PICK = (
    "SPEED(0) = 200 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)\nPRINT TIME\n"
)


def test_a_line_that_is_put_in_is_no_difference_and_a_mistake_is_shown(cell: Cell) -> None:
    cell.write("pick.mnt", PICK)
    cell("verify", "pick.mnt", "--update")
    cell.write("pick.mnt", "' a remark\n\n" + PICK)
    assert cell("verify", "pick.mnt").status == 0
    cell.write("pick.mnt", PICK.replace("ACCEL", "ACEL"))
    ran = cell("verify", "pick.mnt")
    assert ran.status == 1
    assert (
        "  A axis 0 MOVEA to 100 at 200, then '700' after 0.00 s, B does not (line 2 of A)\n  status: ended → fault\n"
        in ran.out
    )
    assert "pick.mnt:1:18" in ran.err


def answers(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO(text))


def golden(cell: Cell, name: str) -> str:
    return "".join((cell.folder / f"{name}.golden.{kind}").read_text() for kind in ("json", "txt"))


@pytest.fixture
def changed(cell: Cell) -> Cell:
    """Return a folder of three programs that are slower and print more than expected."""
    for name in ("wrong.mcl", "jog.mcl", "ballscrew.mcl"):
        (cell.folder / name).unlink()
    for name in ("a.mnt", "b.mnt", "c.mnt"):
        cell.write(name, PICK.replace("PRINT TIME", 'PRINT "there"'))
    cell("verify", ".", "--update")
    for name in ("a.mnt", "b.mnt", "c.mnt"):
        program = PICK.replace("PRINT TIME", 'PRINT "there" : PRINT "at last"')
        cell.write(name, program.replace("= 200", "= 150"))
    return cell


def test_each_program_is_asked_for(changed: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    before = [golden(changed, name) for name in "abc"]
    answers(monkeypatch, "y\nx\nn\nq\n")
    ran = changed("verify", ".", "--review", "--jobs", "1")
    assert ran.status == 1
    assert (
        ran.out.count("./b.mnt: write its golden files? [y,n,q,?] ") == 2
    )  # x is no answer, and asked again
    assert "y  write the golden files" in ran.out
    assert "./a.mnt: written\n" in ran.out
    assert [golden(changed, name) == was for name, was in zip("abc", before, strict=True)] == [
        False,
        True,
        True,
    ]
    ran = changed("verify", ".")
    assert "a.mnt" not in ran.out
    assert ran.out.endswith("1 of 3 programs match their golden files\n")


def test_after_quitting_nothing_is_asked_or_written(changed: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    before = golden(changed, "b")
    answers(monkeypatch, "q\ny\n")
    ran = changed("verify", ".", "--review", "--jobs", "1")
    assert ran.status == 1
    assert ran.out.count("write its golden files?") == 1
    assert "./c.mnt: differs\n" in ran.out
    assert golden(changed, "b") == before


def test_only_golden_files_are_asked_for(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """The golden files of the program match, and those of a scenario and a sweep are missing."""
    cell.write("pick.mnt", PICK)
    cell.write("pick.machine.toml", '[[expect]]\nprints = "gone"\n')
    cell("verify", "pick.mnt", "--update")
    (cell.folder / "pick.scenarios").mkdir()
    cell.write("pick.scenarios/slow.toml", "[axis.0]\nstart = 1\n")
    cell.write("pick.sweep.toml", 'keep = ["time"]\n[vary]\naxis.0.start = [0, 1]\n')
    answers(monkeypatch, "y\ny\n")
    ran = cell("verify", "pick.mnt", "--review")
    assert "pick.mnt: write" not in ran.out
    assert "pick.mnt: differs\n  'gone' " in ran.out
    assert "slow.toml: written\n" in ran.out
    assert "pick.sweep.golden.csv: written\n" in ran.out
    assert ran.out.endswith("0 of 1 programs, 1 of 1 scenarios, 1 of 1 sweeps match their golden files\n")


@pytest.mark.parametrize("given", ["", "x\n"])
def test_without_an_answer_nothing_is_written(
    given: str, changed: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = golden(changed, "a")
    answers(monkeypatch, given)
    ran = changed("verify", ".", "--review", "--jobs", "1")
    assert ran.status == 2
    assert "standard input is at its end" in ran.err
    assert golden(changed, "a") == before
    assert changed("verify", ".", "--review", "--update").status == 2
    assert golden(changed, "a") == before


def test_new_golden_files_are_asked_for(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    answers(monkeypatch, "n\ny\n")
    assert cell("verify", "ballscrew.mcl", "--review").status == 1
    assert cell("verify", "ballscrew.mcl", "--review").status == 0
    assert cell("verify", "ballscrew.mcl").status == 0
    (cell.folder / "ballscrew.golden.txt").write_text("01 199.000000\n")
    answers(monkeypatch, "y\n")
    assert cell("verify", "ballscrew.mcl", "--review").status == 0
    assert cell("verify", "ballscrew.mcl").status == 0
    cell.write("ballscrew.golden.json", '{"schema": "motionlang.report/2", "mo')  # truncated
    answers(monkeypatch, "n\n")
    assert cell("verify", "ballscrew.mcl", "--review").status == 1
    answers(monkeypatch, "y\n")
    assert cell("verify", "ballscrew.mcl", "--review").status == 0
    assert cell("verify", "ballscrew.mcl").status == 0


def test_what_has_no_golden_file_or_no_file_at_all(cell: Cell) -> None:
    cell.write("pick.txt", "1MN")
    ran = cell("verify", "jog.mcl", "none.mcl", "pick.txt")
    assert ran.status == 1
    assert ran.out == (
        "jog.mcl: no jog.golden.json next to it; --update writes one\n"
        "0 of 3 programs match their golden files\n"
    )
    assert "error[file]: none.mcl cannot be read: no such file or directory\n" in ran.err
    assert "unknown language of pick.txt" in ran.err


def test_a_golden_file_that_is_no_json(cell: Cell) -> None:
    cell.write("jog.golden.json", "{")
    ran = cell("verify", "jog.mcl")
    assert ran.status == 1
    assert "jog.mcl: jog.golden.json is not JSON: " in ran.out
    assert cell("verify", "jog.mcl", "--update").status == 0
    assert cell("verify", "jog.mcl").status == 0


def test_a_folder_that_is_not_there(cell: Cell) -> None:
    ran = cell("verify", "scripts")
    assert (ran.status, ran.err) == (1, "error[file]: scripts cannot be read: no such file or directory\n")


# A process whose files are limited to 64 bytes, like a full disk.
SMALL_DISK = """
import resource, signal, sys
from motionlang.cli import main
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (64, 64))
sys.exit(main(["verify", "ballscrew.mcl", "--update"]))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX limits")
@pytest.mark.parametrize("old", ["{}", None])
def test_where_there_is_no_room_the_old_golden_file_stays(old: str | None, tmp_path: Path) -> None:
    (tmp_path / "ballscrew.mcl").write_text(BALLSCREW)
    if old is not None:
        (tmp_path / "ballscrew.golden.json").write_text(old)
    before = {path.name: path.read_text() for path in tmp_path.iterdir()}
    # Without -B the limit would also cut the bytecode that Python writes, and break later imports.
    ran = subprocess.run(
        [sys.executable, "-B", "-c", SMALL_DISK], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    message = "error[file]: ballscrew.golden.json cannot be written: file too large\n"
    assert (ran.returncode, ran.stderr) == (1, message)
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == before


@pytest.mark.parametrize("option", [[], ["--update"]], ids=str)
def test_a_wrong_machine_file_beside_a_program(option: list[str], cell: Cell) -> None:
    cell("verify", "ballscrew.mcl", "--update")
    cell.write("ballscrew.machine.toml", "[controller]\naxs = 3\n")
    ran = cell("verify", "ballscrew.mcl", *option)
    assert ran.status == 1
    assert "error[machine-file]: there is no key controller.axs\n" in ran.err
    assert "ballscrew.machine.toml:2:1" in ran.err


def test_a_program_that_motionlang_stumbles_over_leaves_the_others_their_golden_files(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """The first of the two programs ends with an internal error."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path_factory.mktemp("bundles")))
    whole = Scheduler.run

    def stumbles(scheduler: Scheduler, *given: object) -> object:
        monkeypatch.setattr(Scheduler, "run", whole)
        raise AssertionError("somebody has thought wrong")

    monkeypatch.setattr(Scheduler, "run", stumbles)
    (cell.folder / "wrong.mcl").unlink()
    ran = cell("verify", ".", "--update")
    assert ran.status == 1
    assert ran.out == "./jog.mcl: written\n1 of 2 programs have current golden files\n"
    assert "error[crash]: internal error: AssertionError: somebody has thought wrong" in ran.err
    assert not (cell.folder / "ballscrew.golden.json").exists()
    files = sorted(each.name for each in Path(tempfile.gettempdir()).glob("*/*"))
    assert files == ["ballscrew.mcl", "crash.txt"]
