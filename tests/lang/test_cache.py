"""The cache of compiled programs: used when it can be trusted, ignored when it cannot, never in the way."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from motionlang import execution, user_cache
from motionlang.lang import cache
from motionlang.source import Source

PACKAGE = Path(execution.__file__).parent
HELLO = Source("hello.mnt", 'PRINT "hello"\n')


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    place = tmp_path / "cache"
    monkeypatch.setenv("MOTIONLANG_CACHE", str(place))
    monkeypatch.delenv(user_cache.OFF, raising=False)
    return place


def test_what_was_put_comes_back() -> None:
    cache.put(cache.key("a"), b"program")
    assert cache.get(cache.key("a")) == b"program"
    assert cache.get(cache.key("b")) is None


def test_every_part_of_the_key_counts() -> None:
    assert len({cache.key("a", "b"), cache.key("ab", ""), cache.key("a"), cache.key("b", "a")}) == 4


def test_a_damaged_entry_is_ignored(folder: Path) -> None:
    name = cache.key("a")
    cache.put(name, b"program")
    data = (folder / name).read_bytes()
    for damaged in (data[:-1], data + b"x", data[:33], b"", b"\0" * len(data)):
        (folder / name).write_bytes(damaged)
        assert cache.get(name) is None


def test_an_entry_under_another_name_is_ignored(folder: Path) -> None:
    cache.put(cache.key("a"), b"program")
    os.rename(folder / cache.key("a"), folder / cache.key("b"))
    assert cache.get(cache.key("b")) is None


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_what_others_may_write_is_ignored(folder: Path) -> None:
    name = cache.key("a")
    cache.put(name, b"program")
    assert (folder / name).stat().st_mode & 0o077 == 0
    assert folder.stat().st_mode & 0o077 == 0
    (folder / name).chmod(0o666)
    assert cache.get(name) is None
    (folder / name).chmod(0o600)
    folder.chmod(0o777)
    assert cache.get(name) is None


def test_a_folder_that_cannot_be_made_is_no_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "file"))
    cache.put(cache.key("a"), b"program")
    assert cache.get(cache.key("a")) is None
    assert execution.run(HELLO).output == ["hello"]


def test_the_environment_turns_it_off(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(user_cache.OFF, "1")
    cache.put(cache.key("a"), b"program")
    assert not folder.exists()


def test_old_entries_make_room(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(user_cache, "ENTRIES", 4)
    for k in range(5):
        cache.put(cache.key(str(k)), b"program")
    assert len(list(folder.iterdir())) == 2


def compiler_modules() -> list[str]:
    """The files, from the package's root, of every module that compiling the gallery imports."""
    script = (
        "import sys\n"
        "from pathlib import Path\n"
        "from motionlang.mint import DIALECT\n"
        "from motionlang.source import Source\n"
        "for path in sorted(Path(sys.argv[1]).rglob('*.mnt')):\n"
        "    DIALECT.compile(Source.read(path), {})\n"
        "print(*(m.__file__ for n, m in sys.modules.items() if n.startswith('motionlang')), sep='\\n')\n"
    )
    command = [sys.executable, "-c", script, str(PACKAGE.parent / "scripts" / "mint")]
    ran = subprocess.run(command, capture_output=True, text=True, check=True, cwd=PACKAGE.parent)
    found = [Path(line).relative_to(PACKAGE) for line in ran.stdout.splitlines()]
    # The first line of a package that holds nothing else decides nothing.
    return sorted(str(path) for path in found if len((PACKAGE / path).read_text().splitlines()) > 4)


def installed(place: Path) -> str:
    """A copy of the package, as an installation makes one; the folder of Mint in it."""
    shutil.copytree(PACKAGE, place / "motionlang", ignore=shutil.ignore_patterns("__pycache__"))
    return str(place / "motionlang" / "mint")


def test_a_change_in_any_module_of_the_compiler_is_another_key(tmp_path: Path) -> None:
    mint = installed(tmp_path)
    modules = compiler_modules()
    assert {
        "mint/compile/compiler.py",
        "mint/keywords/axis.py",
        "lang/parsing/parser.py",
        "errors.py",
    } <= set(modules)
    seen = {cache.fingerprint(mint)}
    for name in modules:
        with open(tmp_path / "motionlang" / name, "a", encoding="utf-8") as file:
            file.write("# changed\n")
        seen.add(cache.fingerprint(mint))
    # What __init__.py of the package says of versions is not compiled in, and what is kept is what is compiled anew.
    apart = {"__init__.py", "bytecode.py", "kept_file.py", "user_cache.py"}
    assert len(seen) == len([name for name in modules if name not in apart]) + 1


@pytest.mark.skipif(sys.platform == "win32", reason="Windows keeps no time of the last change of a file")
def test_a_module_of_the_same_size_and_time_is_another_key(tmp_path: Path) -> None:
    mint = installed(tmp_path)
    module = tmp_path / "motionlang" / "mint" / "compile" / "compiler.py"
    before, status, text = cache.fingerprint(mint), module.stat(), module.read_text()
    while module.stat().st_ctime_ns == status.st_ctime_ns:  # the clock of a file system ticks slowly
        module.write_text(text.replace("e", "a", 1))
        os.utime(module, ns=(status.st_atime_ns, status.st_mtime_ns))
    changed = module.stat()
    assert (changed.st_size, changed.st_mtime_ns) == (status.st_size, status.st_mtime_ns)
    assert cache.fingerprint(mint) != before


def test_a_new_module_of_the_compiler_is_another_key(tmp_path: Path) -> None:
    mint = installed(tmp_path)
    before = cache.fingerprint(mint)
    (tmp_path / "motionlang" / "mint" / "keywords" / "lasers.py").write_text("ROWS = ()\n")
    assert cache.fingerprint(mint) != before


def test_a_change_in_the_data_of_the_compiler_is_another_key(tmp_path: Path) -> None:
    mint = installed(tmp_path)
    before = cache.fingerprint(mint)
    words = tmp_path / "motionlang" / "mint" / "keywords" / "type_library" / "values.txt"
    words.write_text(words.read_text(encoding="utf-8").replace("|value|", "|kept|"), encoding="utf-8")
    assert cache.fingerprint(mint) != before


def test_a_program_compiled_by_another_compiler_is_compiled_anew(tmp_path: Path) -> None:
    installed(tmp_path)
    (tmp_path / "hello.mnt").write_text(HELLO.text)
    command = [sys.executable, "-m", "motionlang", "run", "hello.mnt", "--report", "none"]

    def ran() -> str:
        return subprocess.run(command, capture_output=True, text=True, check=True, cwd=tmp_path).stdout

    assert [ran(), ran()] == ["hello\n", "hello\n"]
    printing = tmp_path / "motionlang" / "mint" / "compile" / "terminal_use.py"
    printing.write_text(printing.read_text().replace("return found.text if", "return repr('bye') if"))
    assert ran() == "bye\n"


def test_without_files_to_look_at_nothing_is_cached(tmp_path: Path, folder: Path) -> None:
    installed(tmp_path / "loose")
    archive = shutil.make_archive(str(tmp_path / "motionlang"), "zip", tmp_path / "loose")
    program = tmp_path / "hello.mnt"
    program.write_text(HELLO.text)
    ran = subprocess.run(
        [sys.executable, "-c", "from motionlang.cli import main; main()", "run", program, "--report", "none"],
        capture_output=True,
        text=True,
        check=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": archive},
    )
    assert (ran.stdout, ran.stderr) == ("hello\n", "")
    assert not folder.exists()
    assert cache.fingerprint(os.path.join(archive, "motionlang", "mint")) == ""


def test_what_is_not_kept_is_not_looked_for(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[str] = []

    def look(package: str) -> str:
        looked.append(package)
        return "state"

    monkeypatch.setattr(cache, "fingerprint", look)
    execution.run(Source("hello.mcl", "0"))
    execution.run(HELLO, cache=False)
    monkeypatch.setenv(user_cache.OFF, "1")
    execution.run(HELLO)
    assert looked == []
    monkeypatch.delenv(user_cache.OFF)
    execution.run(HELLO)
    assert len(looked) == 1


def test_a_cached_run_is_the_same_run(folder: Path) -> None:
    first, second = execution.run(HELLO), execution.run(HELLO)
    assert len(list(folder.iterdir())) == 1
    assert (first.output, first.time) == (second.output, second.time)
    assert len(list(folder.iterdir())) == 1
    execution.run(HELLO, cache=False)


def test_a_cached_run_that_fails_names_its_place_too() -> None:
    source = Source("wrong.mnt", "x = 0\nPRINT 1 / x\n")
    places = [[(d.line, d.column, d.code) for d in execution.run(source).diagnostics] for _ in range(2)]
    assert places == [[(2, 1, "division-by-zero")]] * 2
