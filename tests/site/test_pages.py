"""The pages of the site, before they are built."""

from __future__ import annotations

import base64
import json
import zlib
from pathlib import Path

from tests.built import ROOT
from tests.cases import cases
from tests.site.check import problems
from tests.site.fragments import fragment
from tests.site.pages import rewritten, runnable, site_path


def unpacked(text: str) -> object:
    packed = text.removeprefix("v1.")
    data = base64.urlsafe_b64decode(packed + "=" * (-len(packed) % 4))
    return json.loads(zlib.decompress(data, wbits=-zlib.MAX_WBITS))


def never(kind: str, text: str) -> str:
    return ""


@cases(
    ("page", "text", "shown"),
    [
        ("README.md", "[cli](docs/commands/run.md)", "[cli](commands/run.md)"),
        ("README.md", "![a](docs/images/scope.png)", "![a](images/scope.png)"),
        ("README.md", "[all](docs/keywords)", "[all](keywords/mint.md)"),
        ("README.md", "[try](playground/README.md)", '<a href="playground/index.html?docs">try</a>'),
        ("docs/README.md", "[c](../CONTRIBUTING.md)", "[c](CONTRIBUTING.md)"),
        ("docs/contributing/kernel.md", "[events.md](../events.md)", "[events.md](../events.md)"),
        ("extras/explore/docs/old-machine.md", "[old](../../../examples/old)", "old"),
        ("CONTRIBUTING.md", "[a](docs/contributing/decisions.md)", "[a](contributing/decisions.md)"),
        ("README.md", "[there](https://example.org/a)", "[there](https://example.org/a)"),
        (
            "README.md",
            "```text\n[a](docs/commands/README.md)\n```",
            "```text\n[a](docs/commands/README.md)\n```",
        ),
    ],
)
def test_links_lead_to_where_a_page_is_on_the_site(page: str, text: str, shown: str) -> None:
    assert rewritten(text, page, never) == shown


def test_a_program_gets_a_link_that_has_it() -> None:
    text = rewritten("```mint\nPRINT 1\n```\n", "docs/keywords/mint.md", runnable({}))
    head, _, packed = text.partition("../playground/index.html?docs#")
    assert head.endswith('<p class="run"><a href="')
    program = {"name": "example.mnt", "dialect": "mint", "program": "PRINT 1\n", "machine": ""}
    assert unpacked(packed.partition('"')[0]) == program


def test_a_program_of_the_gallery_comes_with_its_machine_file() -> None:
    program = {"name": "a.mcl", "dialect": "mccl", "program": "1TP\n", "machine": "x = 1\n"}
    run = runnable(
        {"scripts/mccl/a.mcl": {**program, "needs": ""}, "scripts/mccl/b.mcl": {**program, "needs": "numpy"}}
    )
    assert unpacked(run("console", "$ motionlang run scripts/mccl/a.mcl\n01 0\n")) == program
    assert run("console", "$ motionlang run scripts/mccl/b.mcl\n") == ""
    assert run("console", "$ motionlang check feed.mnt\n") == ""


def test_each_page_of_the_menu_exists() -> None:
    menu = (ROOT / "mkdocs.yml").read_text(encoding="utf-8").partition("nav:\n")[2]
    named = {line.rpartition(": ")[2] for line in menu.splitlines() if line.endswith(".md")}
    globs = ("README.md", "CONTRIBUTING.md", "docs/**/*.md", "extras/*/docs/**/*.md")
    pages = [page.relative_to(ROOT).as_posix() for each in globs for page in ROOT.glob(each)]
    assert named == {site_path(page) for page in pages}


def test_the_checker_finds_what_is_wrong(tmp_path: Path) -> None:
    (tmp_path / "b.html").write_text('<h1 id="here"></h1>')
    (tmp_path / "a.html").write_text(
        '<a href="b.html#here">1</a><a href="b.html#there">2</a><a href="c.html">3</a>'
        '<a href="https://example.org">4</a><script src="https://example.org/x.js"></script>'
    )
    assert list(problems(tmp_path)) == [
        "a.html loads https://example.org/x.js",
        "a.html links to b.html#there, which has no such place",
        "a.html links to c.html, which does not exist",
    ]


def test_a_fragment_is_safe_in_an_address() -> None:
    assert set(fragment("mint", "' ÿ\n" * 50)) <= set(
        "v1._-abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
    )
