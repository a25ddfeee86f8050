"""Defaults of settings that the machine file can change."""

from __future__ import annotations

import subprocess
import sys

from motionlang.kernel.mint import name_of, row_with_default, table, with_default
from motionlang.kernel.mint.keywords.index import FILES
from motionlang.kernel.mint.keywords.switchable import has_default, switches


def test_a_setting_has_one_name_whose_default_counts() -> None:
    """FEEDRATE is another name of SPEED, so it has no default of its own."""
    settings = [row.verb or row.name for row in with_default()]
    assert len(set(settings)) == len(settings)
    assert "mint.speed-default" in switches()
    assert "mint.feedrate-default" not in switches()


def test_keyword_is_found_under_its_listed_name() -> None:
    words = {word for names in FILES.values() for word in names.split()} | {row.name for row in table()}
    found = {row.name for word in words if (row := row_with_default(word)) is not None}
    assert found == {row.name for row in table() if has_default(row)}
    assert set(switches()) >= {name_of(row) for row in with_default()}
    assert all(name in switches() for name in switches())
    assert len(switches()) == len(list(switches()))


def test_a_lookup_imports_one_file_of_keywords() -> None:
    code = (
        "import sys\n"
        "from motionlang.kernel.mint.keywords.switchable import switches\n"
        "assert switches()['mint.homespeed-default'].low is not None\n"
        "assert 'mint.float-zeros' in switches()\n"
        "assert 'motionlang.kernel.mint.keywords.camboxes' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
