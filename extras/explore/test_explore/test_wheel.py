"""The commands of the wheel, next to that of motionlang, in users' environments."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path

import pytest

from tests.built import ROOT, distributions
from tests.installed import PROJECT, STRICT, USES_OF_EXPLORE, Install, check_uses, closure
from tests.test_environments import HOMES, home_of, posix, without_a_home, works
from tests.test_wheel import check_without_numpy

pytestmark = [posix, pytest.mark.slow]
# Uses that need numpy: by the command in the message.
WITHOUT_NUMPY = {USES_OF_EXPLORE[2]: "motionlang improve", "panel move.mnt": "motionlang panel"}


@pytest.fixture(scope="session")
def wheels(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with both wheels, unpacked."""
    folder = tmp_path_factory.mktemp("wheels")
    (built,) = distributions(folder / "explore", "wheel", source=ROOT / "extras" / "explore")
    shutil.copytree(wheel, folder / "site")
    with zipfile.ZipFile(built) as archive:
        archive.extractall(folder / "site")
    return folder / "site"


@pytest.fixture
def install(wheels: Path, tmp_path: Path) -> Install:
    return Install(tmp_path, wheels, closure(PROJECT["dependencies"]))


def test_every_command(install: Install) -> None:
    check_uses(install(USES_OF_EXPLORE), dict.fromkeys(USES_OF_EXPLORE, ""), set())


def test_every_command_without_numpy(wheels: Path, tmp_path: Path) -> None:
    install = Install(tmp_path, wheels, closure(PROJECT["dependencies"]) - {"numpy"})
    check_without_numpy(install([*USES_OF_EXPLORE, *WITHOUT_NUMPY]), WITHOUT_NUMPY)


def test_every_command_with_warnings_as_errors(install: Install) -> None:
    works(install, USES_OF_EXPLORE, *STRICT)


def test_every_command_without_a_home(install: Install, tmp_path: Path) -> None:
    works(install, USES_OF_EXPLORE, **without_a_home(tmp_path))


@pytest.mark.parametrize("kind", HOMES)
def test_every_command_with_a_home_that_takes_no_file(kind: str, install: Install, tmp_path: Path) -> None:
    works(install, USES_OF_EXPLORE, **home_of(kind, tmp_path))
