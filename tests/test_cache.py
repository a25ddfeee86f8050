"""The compile cache is used if trustworthy, ignored if not, and never an error."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from marshal import loads
from pathlib import Path
from types import SimpleNamespace

import pytest

from motionlang import cache, execution
from motionlang.cache import Entry, machine_entry, program_entry
from motionlang.source import Source
from tests.built import copy_with_bytecode

PACKAGE = Path(execution.__file__).parent
HELLO = Source("hello.mnt", 'PRINT "hello"\n')


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    path = tmp_path / "cache"
    monkeypatch.setenv("MOTIONLANG_CACHE", str(path))
    monkeypatch.delenv(cache.OFF, raising=False)
    return path


def entry(*components: str) -> Entry:
    """Return the cache entry of a program, computed as in a new process."""
    return program_entry(str(PACKAGE / "mint"), *(components or ("a",)))


def the_file(folder: Path) -> Path:
    (found,) = folder.iterdir()
    return found


def test_the_settings_of_a_machine_file_are_cached_by_its_text() -> None:
    machine_entry("[axis.0]\nstart = 3.0\n", "mint").put(b"settings")
    assert machine_entry("[axis.0]\nstart = 3.0\n", "mint").get() == b"settings"
    assert machine_entry("[axis.0]\nstart = 4.0\n", "mint").get() is None


def test_what_was_put_comes_back() -> None:
    entry("a").put(b"program")
    assert entry("a").get() == b"program"
    assert entry("b").get() is None


def test_every_component_counts() -> None:
    entry("a", "b").put(b"program")
    assert [entry(*components).get() for components in (("ab", ""), ("a",), ("b", "a"))] == [None] * 3
    assert entry("a", "b").get() == b"program"
    assert program_entry(str(PACKAGE / "mccl"), "a", "b").get() is None


def test_a_damaged_entry_is_ignored(folder: Path) -> None:
    entry().put(b"program")
    file = the_file(folder)
    data = file.read_bytes()
    flipped = [data[:k] + bytes((data[k] ^ 0x55,)) + data[k + 1 :] for k in range(0, len(data), 53)]
    for damaged in (data[:-1], data + b"x", data[:33], b"", b"\0" * len(data), *flipped):
        file.write_bytes(damaged)
        assert entry().get() is None


def test_an_entry_under_another_name_is_ignored(folder: Path) -> None:
    entry("b").put(b"program")
    name = the_file(folder).name
    the_file(folder).unlink()
    entry("a").put(b"program")
    the_file(folder).rename(folder / name)
    assert entry("b").get() is None


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_what_others_may_write_is_ignored(folder: Path) -> None:
    entry().put(b"program")
    assert the_file(folder).stat().st_mode & 0o077 == 0
    assert folder.stat().st_mode & 0o077 == 0
    the_file(folder).chmod(0o666)
    assert entry().get() is None
    the_file(folder).chmod(0o600)
    folder.chmod(0o777)
    assert entry().get() is None


def test_a_folder_that_cannot_be_made_is_no_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "file"))
    entry().put(b"program")
    assert entry().get() is None
    assert execution.run(HELLO).output == ["hello"]


def test_the_environment_turns_it_off(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(cache.OFF, "1")
    entry().put(b"program")
    assert not folder.exists()


def test_old_entries_make_room(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "ENTRIES", 4)
    for k in range(5):
        entry(str(k)).put(b"program")
    assert len(list(folder.iterdir())) == 2


def test_the_cache_has_512_entries() -> None:
    """docs/limits.md states the number."""
    assert cache.ENTRIES == 512


@pytest.mark.parametrize(
    ("platform", "variables", "found"),
    [
        ("linux", {}, "/home/ann/.cache/motionlang"),
        ("linux", {"XDG_CACHE_HOME": "/var/caches"}, "/var/caches/motionlang"),
        ("linux", {"XDG_CACHE_HOME": "caches"}, "/home/ann/.cache/motionlang"),
        ("darwin", {"XDG_CACHE_HOME": "/var/caches"}, "/home/ann/Library/Caches/motionlang"),
        ("win32", {"LOCALAPPDATA": "/local"}, "/local/motionlang"),
        ("win32", {}, "/home/ann/AppData/Local/motionlang"),
        ("linux", {"MOTIONLANG_CACHE": "/mine"}, "/mine"),
    ],
)
def test_each_system_has_its_folder_for_caches(
    platform: str, variables: dict[str, str], found: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("MOTIONLANG_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setenv("HOME", "/home/ann")
    monkeypatch.setattr("sys.platform", platform)
    assert cache.folder() == found


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
@pytest.mark.parametrize("permissions", [0o620, 0o602])
def test_what_a_group_or_the_world_may_write_is_ignored(folder: Path, permissions: int) -> None:
    entry().put(b"program")
    the_file(folder).chmod(permissions)
    assert entry().get() is None
    the_file(folder).chmod(0o644)
    folder.chmod(0o755)
    assert entry().get() == b"program"


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
@pytest.mark.parametrize(("permissions", "writable"), [(0o777, True), (0o700, False)])
def test_nothing_is_written_to_a_folder_of_others(
    folder: Path, permissions: int, writable: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The user may be root, who may write to any folder."""
    folder.mkdir()
    folder.chmod(permissions)
    monkeypatch.setattr(os, "access", lambda path, mode: writable)
    entry().put(b"program")
    assert list(folder.iterdir()) == []


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_what_belongs_to_another_user_is_ignored(monkeypatch: pytest.MonkeyPatch) -> None:
    entry().put(b"program")
    monkeypatch.setattr(os, "getuid", lambda: 1)
    assert entry().get() is None
    monkeypatch.delattr(os, "getuid")  # as on Windows
    assert entry().get() == b"program"


def test_the_newest_entries_stay(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of 6, one more than 5, the newest 2 stay; of 5, all stay."""
    monkeypatch.setattr(cache, "ENTRIES", 5)
    folder.mkdir(0o700)
    for name, age in (("a", 3), ("b", 1), ("c", 4), ("d", 2)):
        (folder / name).touch()
        os.utime(folder / name, (1000 - age, 1000 - age))
    (folder / "sub").mkdir()
    entry("first").put(b"program")
    assert len(list(folder.iterdir())) == 6
    entry("second").put(b"program")
    assert (entry("first").get(), entry("second").get()) == (b"program", b"program")
    assert len(list(folder.iterdir())) == 3


COMPILES = """
import sys
from pathlib import Path
from motionlang.cache import program_entry
from motionlang.fast.ranges import ranges
from motionlang.mint import DIALECT
from motionlang.source import Source
for path in sorted(Path(sys.argv[1]).rglob('*.mnt')):
    DIALECT.compile(Source.read(path), {}, ranges)
import motionlang
program_entry(str(Path(motionlang.__file__).parent / "mint"), "a").put(b"program")
print(*(m.__file__ for n, m in sys.modules.items() if n.startswith('motionlang')), sep='\\n')
"""


def installed(root: Path) -> Path:
    """Return a copy of the package in the form of an installation."""
    copy_with_bytecode(PACKAGE, root / "motionlang")
    copy_with_bytecode(PACKAGE.parent / "grammars", root / "motionlang" / "grammars")
    return root / "motionlang"


def compiled(root: Path) -> list[str]:
    """Compile the gallery with a copy of the package, and fill the cache.

    Return the imported files.
    """
    command = [sys.executable, "-c", COMPILES, str(PACKAGE.parent / "scripts" / "mint")]
    ran = subprocess.run(command, capture_output=True, text=True, check=True, cwd=root.parent)
    found = [Path(line).relative_to(root) for line in ran.stdout.splitlines()]
    # The one-line docstring of an otherwise empty package has no effect.
    return sorted(path.as_posix() for path in found if len((root / path).read_text().splitlines()) > 4)


def test_an_entry_lists_every_module_of_the_compiler(tmp_path: Path, folder: Path) -> None:
    root = installed(tmp_path)
    modules = set(compiled(root))
    assert {
        "mint/compile/compiler.py",
        "mint/keywords/axis.py",
        "lang/syntax/grammar.py",
        "errors.py",
    } <= modules
    _, compiler, _ = loads(the_file(folder).read_bytes()[cache.CHECKSUM :])
    hashed = {Path(path).relative_to(root).as_posix() for path, _ in compiler}
    # Versions in __init__.py of the package are not compiled in, and the file store does not depend on
    # contents. The controller does not affect the meaning of a program: the files of keywords import it for
    # the run.
    left = {
        path
        for path in modules - hashed
        if not path.startswith(("controller/", "log/", "planners/", "servo/"))
    }
    assert left == {
        "__init__.py",
        "cache.py",
        "files.py",
    }


def append_comment(file: Path) -> None:
    with file.open("a", encoding="utf-8") as opened:
        opened.write("# changed\n")


def change_within_size_and_time(file: Path) -> None:
    """Change a text, but neither the size nor the time of its file."""
    status, text = file.stat(), file.read_text(encoding="utf-8")
    while file.stat().st_ctime_ns == status.st_ctime_ns:  # the clock of a file system is coarse
        file.write_text(text.replace("e", "a", 1), encoding="utf-8")
        os.utime(file, ns=(status.st_atime_ns, status.st_mtime_ns))
    changed = file.stat()
    assert (changed.st_size, changed.st_mtime_ns) == (status.st_size, status.st_mtime_ns)


@pytest.mark.parametrize(
    ("name", "change", "is_void"),
    [
        ("lint/names.py", append_comment, False),  # no compilation takes this
        ("compile/loops.py", append_comment, True),
        ("compile/loops.py", Path.unlink, True),
        pytest.param(
            "compile/loops.py",
            change_within_size_and_time,
            True,
            marks=pytest.mark.skipif(
                sys.platform == "win32", reason="Windows keeps no time of the last change of a file"
            ),
        ),
        ("keywords/type_library/values.txt", append_comment, True),
    ],
)
def test_a_change_in_the_compiler_makes_an_entry_void(
    name: str,
    change: Callable[[Path], object],
    is_void: bool,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    mint = tmp_path / "motionlang" / "mint"
    files = [
        mint / each for each in ("lint/names.py", "compile/loops.py", "keywords/type_library/values.txt")
    ]
    for file in files:
        file.parent.mkdir(parents=True)
        file.write_text('"""Text."""\n', encoding="utf-8")
    modules = {file.stem: SimpleNamespace(__file__=str(file)) for file in files if file.suffix == ".py"}
    monkeypatch.setattr(cache, "sys", SimpleNamespace(modules=modules, version=sys.version))
    program_entry(str(mint), "a").put(b"program")
    assert program_entry(str(mint), "a").get() == b"program"
    change(mint / name)
    assert program_entry(str(mint), "a").get() == (None if is_void else b"program")


def test_what_compiles_more_of_a_program_later_is_listed_too(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = (str(PACKAGE / "mint" / "compile" / name) for name in ("compiler.py", "loops.py"))
    modules = {"a": SimpleNamespace(__file__=first)}
    monkeypatch.setattr(cache, "sys", SimpleNamespace(modules=modules, version=sys.version))
    entry().put(b"program")
    modules["a"] = SimpleNamespace(__file__=second)
    later = entry()
    assert later.get() == b"program"
    later.put(b"more of it")
    _, compiler, payload = loads(the_file(folder).read_bytes()[cache.CHECKSUM :])
    assert ({first, second} <= dict(compiler).keys(), payload) == (True, b"more of it")


def test_an_entry_of_a_compiler_that_has_changed_meanwhile_does_not_grow(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    entry().put(b"program")
    later = entry()
    assert later.get() == b"program"
    as_it_was = cache.state
    monkeypatch.setattr(cache, "state", lambda path: (0, 0, 0))
    later.put(b"more of it")
    monkeypatch.setattr(cache, "state", as_it_was)
    assert entry().get() == b"program"


def test_a_program_compiled_by_another_compiler_is_compiled_again(tmp_path: Path) -> None:
    installed(tmp_path)
    (tmp_path / "hello.mnt").write_text(HELLO.text)
    command = [sys.executable, "-m", "motionlang", "run", "hello.mnt", "--format", "none"]

    def ran() -> str:
        return subprocess.run(command, capture_output=True, text=True, check=True, cwd=tmp_path).stdout

    assert [ran(), ran()] == ["hello\n", "hello\n"]
    printing = tmp_path / "motionlang" / "mint" / "compile" / "terminal_use.py"
    printing.write_text(printing.read_text().replace("return found.text\n", "return repr('bye')\n"))
    assert ran() == "bye\n"


@pytest.mark.slow
def test_without_files_to_check_nothing_is_cached(tmp_path: Path, folder: Path) -> None:
    installed(tmp_path / "loose")
    archive = shutil.make_archive(str(tmp_path / "motionlang"), "zip", tmp_path / "loose")
    program = tmp_path / "hello.mnt"
    program.write_text(HELLO.text)
    ran = subprocess.run(
        [sys.executable, "-c", "from motionlang.cli import main; main()", "run", program, "--format", "none"],
        capture_output=True,
        text=True,
        check=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": archive},
    )
    assert (ran.stdout, ran.stderr) == ("hello\n", "")
    assert not folder.exists()


def test_what_is_not_cached_is_not_looked_up(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lookups: list[Entry] = []

    def look_up(entry: Entry) -> None:
        lookups.append(entry)

    monkeypatch.setattr(Entry, "get", look_up)
    execution.run(Source("hello.mcl", "0"))
    execution.run(HELLO, cache=False)
    monkeypatch.setenv(cache.OFF, "1")
    execution.run(HELLO)
    assert lookups == []
    monkeypatch.delenv(cache.OFF)
    execution.run(HELLO)
    assert len(lookups) == 1


def test_a_cached_run_is_the_same_run(folder: Path) -> None:
    first, second = execution.run(HELLO), execution.run(HELLO)
    assert len(list(folder.iterdir())) == 1
    assert (first.output, first.time) == (second.output, second.time)
    assert len(list(folder.iterdir())) == 1
    execution.run(HELLO, cache=False)


def test_a_cached_run_that_fails_names_its_location_too() -> None:
    source = Source("wrong.mnt", "x = 0\nPRINT 1 / x\n")
    locations = [[(d.line, d.column, d.code) for d in execution.run(source).diagnostics] for _ in range(2)]
    assert locations == [[(2, 1, "division-by-zero")]] * 2
