"""README leads to a first program, and shows a program of the gallery."""

from __future__ import annotations

import re
import tomllib

from tools.scope_picture import PICTURE, PROGRAM, ROOT, digest, recorded, with_digest

README = (ROOT / "README.md").read_text(encoding="utf-8")
ORDER = ["Install", "One minute of use", "Accuracy", "Documentation", "Built with"]


def test_a_sentence_the_playground_and_the_picture_come_first() -> None:
    title, lead, picture = README.split("\n\n")[:3]
    assert title == "# motionlang"
    sentence, _, link = lead.partition("\n[")
    assert link.startswith("The playground](docs/playground.md)")
    assert len(sentence) <= 240
    assert sentence.count(". ") == 0
    assert re.fullmatch(r"!\[[^\]]+\]\((.+)\)", picture), picture
    assert PICTURE.relative_to(ROOT).as_posix() in picture
    assert PROGRAM.name in picture


def test_a_difference_and_the_installation_are_on_the_first_screen() -> None:
    screen = README[: README.index("\n## Install")]
    assert screen.count("\n") <= 40
    assert "--explore --write-scenarios" in screen


def test_a_run_and_a_diagnostic_are_shown_in_the_minute_of_use() -> None:
    use = README[README.index("\n## One minute of use") : README.index("\n## Accuracy")]
    assert use.index("$ motionlang run") < use.index("\nerror[")


def test_the_sections_are_in_the_order_of_use() -> None:
    assert re.findall(r"^## (.+)$", README, re.MULTILINE) == ORDER


def test_every_extra_of_users_is_named() -> None:
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    built = README[README.index("\n## Built with") :]
    assert set(re.findall(r"\(`(\w+)`\)", built)) == set(extras) - {"dev", "release", "site"}


def test_the_picture_is_of_the_program_as_it_is() -> None:
    png = PICTURE.read_bytes()
    assert recorded(png) == digest(), "python -m tools.scope_picture draws it again"
    assert len(png) < 200_000


def test_a_picture_without_a_digest_is_noticed() -> None:
    png = PICTURE.read_bytes()
    plain = png[:33] + png[33 + 12 + len(b"Program digest\0") + len(digest()) :]
    assert recorded(plain) is None
    assert with_digest(plain) == png


def test_the_remembered_keywords_are_counted_as_on_the_page() -> None:
    page = (ROOT / "docs" / "fidelity.md").read_text(encoding="utf-8")
    table = page.partition("| source of the meaning |")[2].partition("\n\n")[0]
    counts = {
        name: int(count) for name, count in re.findall(r"^\| ([a-z ,]+) \| (\d+) \|", table, re.MULTILINE)
    }
    sentence = f"Of {sum(counts.values())} simulated Mint keywords, {counts['memory, low confidence']} have"
    assert sentence in README.replace("\n", " ")


def test_the_programs_in_python_are_counted() -> None:
    count = len(list((ROOT / "examples").glob("*.py")))
    assert f"`examples/` has {count} programs" in README.replace("\n", " ")
