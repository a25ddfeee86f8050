"""The package's bytecode in one file: used by the command alone, and only where it is that of the sources."""

from __future__ import annotations

import inspect
import os
import re
import subprocess
import sys
import traceback
from collections.abc import Callable
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pytest

from motionlang import bytecode, user_cache
from motionlang.bytecode import Finder
from motionlang.bytecode_writing import keep
from tests.cases import cases

ROOT = Path(__file__).parent.parent
HELLO = str(ROOT / "scripts" / "mint" / "hello.mnt")
# Says which modules a command took from the file, and which from elsewhere.
WITNESS = """
import sys
from motionlang import __main__ as command
sys.argv[0] = "motionlang"
command._leave = lambda status: None
status = command.main()
loaders = [type(m.__loader__).__module__ for n, m in sys.modules.items() if n.startswith("motionlang.")]
print(loaders.count("motionlang.bytecode"), len(loaders))
"""

pytestmark = pytest.mark.skipif(
    sys.implementation.name != "cpython" or not hasattr(os, "pread"), reason="left to Python there"
)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    place = tmp_path / "cache"
    monkeypatch.setenv("MOTIONLANG_CACHE", str(place))
    monkeypatch.delenv(user_cache.OFF, raising=False)
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    return place


def imported(finder: Finder, source: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module of a source, from the file where that has it, as `import` has it otherwise."""
    name = f"motionlang.{source.stem}"
    spec = finder.find_spec(name) or spec_from_file_location(name, source)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    monkeypatch.setitem(sys.modules, name, module)
    spec.loader.exec_module(module)
    return module


def finder() -> Finder:
    """What a new process has."""
    return Finder("/somewhere/motionlang")


def is_of_the_file(module: ModuleType) -> bool:
    return isinstance(module.__loader__, bytecode.Loader)


@pytest.fixture
def source(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A module that is in the file."""
    place = tmp_path / "gauge.py"
    place.write_text('"""A gauge."""\n\ndef read():\n    """What it shows."""\n    return 1\n')
    first = finder()
    assert not is_of_the_file(imported(first, place, monkeypatch))
    keep(first)
    return place


def the_file(folder: Path) -> Path:
    (found,) = folder.glob("bytecode-*")
    return found


def test_a_module_of_the_file_is_what_python_makes_of_its_source(
    source: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = imported(finder(), source, monkeypatch)
    assert is_of_the_file(module)
    spec = spec_from_file_location("motionlang.gauge", source)
    assert spec is not None
    assert (module.__file__, module.__cached__) == (spec.origin, spec.cached)
    assert module.read() == 1
    assert inspect.getsource(module.read).startswith("def read():")
    assert module.read.__code__.co_filename == str(source)


SHOWN = '''\
"""What no command shows."""
from __future__ import annotations
from dataclasses import dataclass

@dataclass
class Gauge:
    """A gauge."""
    unit: str
    value: float = 0.0

    def read(self, places: int = 1, *, sign: bool = False) -> str:
        """What it shows."""
        assert places > 0, "places"
        return f"{self.value:.{places}f} {self.unit}"

def is_plain(text: str, /, *more: object, **others: object) -> bool:
    """Nothing but what is asked for."""

if True:
    async def later() -> None:
        "It comes."
        raise ValueError("later")
'''


def test_of_a_module_that_is_used_again_docstrings_and_annotations_of_functions_are_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "shown.py"
    place.write_text(SHOWN)
    first = finder()
    imported(first, place, monkeypatch)
    keep(first)
    second = finder()
    whole = imported(
        second, place, monkeypatch
    )  # as Python has it: most commands of a new place are the only one
    keep(second)
    module = imported(finder(), place, monkeypatch)
    assert is_of_the_file(whole)
    assert is_of_the_file(module)
    functions = [(each.Gauge.read, each.is_plain, each.later) for each in (whole, module)]
    assert [each.__doc__ for each in functions[0]] == [
        "What it shows.",
        "Nothing but what is asked for.",
        "It comes.",
    ]
    assert [(each.__doc__, each.__annotations__) for each in functions[1]] == [(None, {})] * 3
    assert (whole.__doc__, module.__doc__) == ("What no command shows.", None)
    assert module.is_plain("", 1, more=2) is None
    # Fields of a dataclass are annotations of a class.
    assert module.Gauge("bar", 2.5).read() == "2.5 bar"
    assert module.Gauge.__annotations__ == whole.Gauge.__annotations__ == {"unit": "str", "value": "float"}
    with pytest.raises(AssertionError, match="places"):
        module.Gauge("bar").read(0)
    # What Python says of an error, and what it shows of its place, is as it was.
    for whole_one, one in ((whole.Gauge.read, module.Gauge.read), (whole.later, module.later)):
        places = [list(each.__code__.co_positions()) for each in (whole_one, one)]
        assert places[0] == places[1]
        assert one.__code__.co_firstlineno == whole_one.__code__.co_firstlineno
    shown = [said(each.Gauge("bar").read) for each in (whole, module)]
    assert shown[0] == shown[1]
    assert 'assert places > 0, "places"' in shown[0]


def said(read: Callable[[int], str]) -> str:
    """The traceback of a wrong call."""
    try:
        return read(0)
    except AssertionError as error:
        return "".join(traceback.format_exception(error))


def test_no_module_asks_for_what_is_left_out() -> None:
    package = Path(bytecode.__file__).parent
    asks = re.compile(r"__doc__|__annotations__|getdoc|get_type_hints|singledispatch")
    found = {
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        if asks.search(path.read_text())
    }
    assert not found


def test_a_changed_source_is_read_anew(source: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source.write_text("def read():\n    return 22\n")
    second = finder()
    module = imported(second, source, monkeypatch)
    assert (is_of_the_file(module), module.read()) == (False, 22)
    keep(second)
    module = imported(finder(), source, monkeypatch)
    assert (is_of_the_file(module), module.read()) == (True, 22)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows keeps no time of the last change of a file")
def test_a_source_of_the_same_size_and_time_is_read_anew(source: Path) -> None:
    before = source.stat()
    while source.stat().st_ctime_ns == before.st_ctime_ns:  # the clock of a file system ticks slowly
        source.write_text(source.read_text().replace("return 1", "return 2"))
        os.utime(source, ns=(before.st_atime_ns, before.st_mtime_ns))
    after = source.stat()
    assert (after.st_size, after.st_mtime_ns) == (before.st_size, before.st_mtime_ns)
    assert finder().find_spec("motionlang.gauge") is None


def test_a_source_that_is_gone_is_no_module(source: Path) -> None:
    source.unlink()
    assert finder().find_spec("motionlang.gauge") is None


def test_a_damaged_file_is_ignored_and_replaced(
    source: Path, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = the_file(folder).read_bytes()
    for damaged in (b"", b"\0" * len(whole), whole[:40], b"\xff" * len(whole), whole[1:]):
        the_file(folder).write_bytes(damaged)
        second = finder()
        assert imported(second, source, monkeypatch).read() == 1
        assert second.missed == ["motionlang.gauge"]
        keep(second)
        assert the_file(folder).read_bytes() == whole


def test_no_damaged_byte_is_executed(source: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = the_file(folder).read_bytes()
    for place in range(0, len(whole), 5):
        damaged = bytearray(whole)
        damaged[place] ^= 0x55
        the_file(folder).write_bytes(damaged)
        second = finder()
        assert imported(second, source, monkeypatch).read() == 1
        assert second.missed == ["motionlang.gauge"]
    keep(second)
    assert the_file(folder).read_bytes() == whole


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_a_file_that_others_may_write_is_ignored(source: Path, folder: Path) -> None:
    assert finder().find_spec("motionlang.gauge") is not None
    assert the_file(folder).stat().st_mode & 0o077 == 0
    the_file(folder).chmod(0o666)
    assert finder().find_spec("motionlang.gauge") is None


def test_another_python_has_another_file(source: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in (("version", "4.0"), ("pycache_prefix", "/elsewhere")):
        with monkeypatch.context() as patch:
            patch.setattr(sys, name, value)
            assert finder().find_spec("motionlang.gauge") is None
    assert Finder("/elsewhere/motionlang").find_spec("motionlang.gauge") is None
    assert finder().find_spec("motionlang.gauge") is not None


def test_two_commands_at_once_lose_nothing(
    source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = tmp_path / "ruler.py"
    other.write_text("length = 5\n")
    one, two = finder(), finder()
    third = tmp_path / "clamp.py"
    third.write_text("force = 6\n")
    imported(one, other, monkeypatch)
    imported(two, third, monkeypatch)
    keep(one)
    keep(two)
    assert imported(one, source, monkeypatch).read() == 1  # the file that it began with
    assert all(is_of_the_file(imported(finder(), each, monkeypatch)) for each in (source, other, third))


def test_what_is_no_longer_there_leaves_the_file(
    source: Path, tmp_path: Path, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source.unlink()
    other = tmp_path / "ruler.py"
    other.write_text("length = 5\n")
    second = finder()
    imported(second, other, monkeypatch)
    keep(second)
    assert b"ruler" in the_file(folder).read_bytes()
    assert b"gauge" not in the_file(folder).read_bytes()


def test_nothing_is_written_where_python_may_write_no_bytecode(
    source: Path, tmp_path: Path, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = the_file(folder).read_bytes()
    other = tmp_path / "ruler.py"
    other.write_text("length = 5\n")
    second = finder()
    imported(second, other, monkeypatch)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    keep(second)
    assert the_file(folder).read_bytes() == before


def test_a_start_looks_for_no_file_but_its_own(folder: Path) -> None:
    script = (
        WITNESS
        + """
ours = [n for n in sys.modules if n.startswith("motionlang")]
files = [n for n, m in sys.modules.items() if getattr(m, "__file__", None) and n not in before and n not in ours]
print(*sorted(n for n in files if not sys.modules[n].__file__.endswith((".so", ".pyd"))))
"""
    )
    script = f"import sys\nbefore = set(sys.modules)\n{script}"
    for _ in range(2):
        shown(script, *PLAIN)
    assert shown(script, *PLAIN).splitlines()[-1] == ""


def test_a_name_that_is_no_module_is_left_to_python(source: Path, folder: Path) -> None:
    before = the_file(folder).stat().st_mtime_ns
    second = finder()
    assert [second.find_spec(name) for name in ("motionlang.no_such", "elsewhere")] == [None, None]
    keep(second)
    assert the_file(folder).stat().st_mtime_ns == before


def counted(script: str, *words: str, **environment: str) -> list[int]:
    """How many modules a process took from the file, and how many of the package it has."""
    return [int(word) for word in shown(script, *words, **environment).splitlines()[-1].split()]


def shown(script: str, *words: str, **environment: str) -> str:
    """What a process prints that begins with a script."""
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    ran = subprocess.run(
        [sys.executable, "-c", script, *words],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
        env=clean | environment,
    )
    assert ran.stderr == ""
    return ran.stdout


PLAIN = ("run", HELLO, "--report", "none")


def test_the_command_takes_its_modules_from_the_file() -> None:
    none, everything = counted(WITNESS, *PLAIN)
    assert (none, everything > 20) == (0, True)
    counted(WITNESS, *PLAIN)
    found, everything = counted(WITNESS, *PLAIN)
    # What has to be there before the file can be looked into.
    assert everything - found == len(["__main__", "bytecode", "kept_file", "user_cache"])


@cases(
    "case", ("--no-cache", "MOTIONLANG_NO_CACHE", "sys.settrace", "sys.setprofile", "import motionlang.cli")
)
def test_the_file_is_left_alone(case: str) -> None:
    counted(WITNESS, *PLAIN)
    script, words = WITNESS, list(PLAIN)
    environment: dict[str, str] = {}
    if case.startswith("sys"):
        script = f"import sys\n{case}(lambda *each: None)\n{WITNESS}"
    elif case.startswith("import"):
        script = f"{case}\n{WITNESS.replace('status = command.main()', '')}"
    elif case.startswith("--"):
        words.append(case)
    else:
        environment = {case: "1"}
    assert counted(script, *words, **environment)[0] == 0
