"""The coverage of programs: a table of files, a listing, a page, and lcov for other tools."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from html import escape
from urllib.parse import quote

from motionlang.kernel.tools import ranges
from motionlang.kernel.tools import total as total_of
from motionlang.views import documents
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import printable, styled
from motionlang_explore.cover import Coverage

# The style of a line in the listing, by whether it was reached, and in a page.
MISSED, PARTLY = "error", "warning"
MAX_LISTED = 40


def coverage_document(found: Sequence[Coverage]) -> Document:
    """Return the coverage of programs as data: of files, lines, conditions and parts."""
    lines = [
        {"file": each.file, "line": line, "count": count, "missed": missed.get(line)}
        for each in found
        for missed in [each.missed]
        for line, count in each.lines.items()
    ]
    outcomes = [
        {"file": each.file, "line": one.line, "text": one.text, "true": one.true, "false": one.false}
        for each in found
        for one in each.conditions
    ]
    parts = [
        {"file": each.file, "kind": one.kind, "name": one.name, "line": one.line, "count": one.count}
        for each in found
        for one in each.parts
    ]
    tables = (
        files_table(found),
        Table("lines", tuple(map(Column, ("file", "line", "count", "missed"))), lines),
        Table("conditions", tuple(map(Column, ("file", "line", "text", "true", "false"))), outcomes),
        Table("parts", tuple(map(Column, ("file", "kind", "name", "line", "count"))), parts),
    )
    return Document(tables, {"covered": percentage(found)})


def files_table(found: Sequence[Coverage]) -> Table:
    """Return the table of programs: the share of statements, outcomes of conditions and parts that runs reached."""
    rows = [
        {
            "file": each.file,
            "worlds": len(each.worlds) or 1,
            "statements": len(each.statements),
            "statements_reached": each.statements_reached,
            "outcomes": 2 * len(each.conditions),
            "outcomes_reached": each.outcomes_reached,
            "parts": len(each.parts),
            "parts_reached": len([one for one in each.parts if one.count]),
            "covered": percentage([each]),
            "missing": ranges(each.missed),
        }
        for each in found
    ]
    columns = (
        Column("file", left=True, style="word"),
        Column("worlds", drop=3),
        *_share("statements", 2),
        *_share("outcomes", 2),
        *_share("parts", 4),
        Column("covered", text=lambda share: f"{share:.0f} %"),
        Column("missing", "lines to look at", text=_shortened, left=True, drop=1),
    )
    return Table("files", columns, rows)


def percentage(found: Sequence[Coverage]) -> float:
    """Return the share of statements and outcomes that were reached, percent; 100 if there are none."""
    total = total_of(each.total for each in found)
    return 100.0 * total_of(each.reached for each in found) / total if total else 100.0


def listing(found: Coverage, colour: bool) -> list[str]:
    """Return the program with the count of each line before it, and what is missing of the line below."""
    lines, missed = found.lines, found.missed
    out = [styled(found.file, "bold", colour)]
    for number, text in enumerate(found.source.text.rstrip("\n").split("\n"), 1):
        count = (
            "" if number not in lines else f"{lines[number]:,}".replace(",", " ") if lines[number] else "-"
        )
        style = "" if number not in missed else PARTLY if lines.get(number) else MISSED
        out.append(
            f"{styled(f'{count:>9}', style or 'dim', colour)}  {number:>4}  {printable(text)}".rstrip()
        )
        if number in missed and lines.get(number):
            out.append(f"{'':>9}        {styled(printable(missed[number]), PARTLY, colour)}")
    return out


def lcov(found: Iterable[Coverage]) -> Iterator[str]:
    """Yield the lines of a tracefile, as `geninfo` of lcov describes it."""
    for each in found:
        yield from ("TN:", f"SF:{each.file}")
        parts = {f"{part.kind} {part.name}": part for part in each.parts}
        yield from (f"FN:{part.line},{name}" for name, part in parts.items())
        yield from (f"FNDA:{part.count},{name}" for name, part in parts.items())
        yield from (f"FNF:{len(parts)}", f"FNH:{len([each for each in parts.values() if each.count])}")
        for number, one in enumerate(each.conditions):
            was_tested = one.true or one.false
            for branch, count in enumerate((one.true, one.false)):
                yield f"BRDA:{one.line},{number},{branch},{count if was_tested else '-'}"
        yield from (f"BRF:{2 * len(each.conditions)}", f"BRH:{each.outcomes_reached}")
        lines = each.lines
        yield from (f"DA:{line},{lines[line]}" for line in sorted(lines))
        yield from (f"LF:{len(lines)}", f"LH:{len(list(filter(None, lines.values())))}", "end_of_record")


def page(found: Sequence[Coverage]) -> str:
    """Return a self-contained page: the table, and each program with the counts of its lines."""
    table = documents.html_table(files_table(found), _cell)
    programs = "".join(map(_program, found))
    title = f"Coverage: {percentage(found):.0f} %"
    return documents.page(title, f"<h1>{title}</h1>{table}{programs}", _STYLE)


_STYLE = (
    "body{font:15px/1.5 system-ui,sans-serif;margin:2rem;color:#1c2733}"
    "table{border-collapse:collapse}th,td{text-align:left;padding:.2rem .8rem;border-bottom:1px solid #dde3e8}"
    "pre{line-height:1.45}pre span{display:block;padding-left:.5rem}"
    "pre b{display:inline-block;width:8rem;text-align:right;font-weight:normal;color:#6b7785;margin-right:1rem}"
    ".missed{background:#fadede}.partly{background:#fdf3d8}.reached{background:#e3f4ea}i{color:#8a5a00}"
)


def _program(found: Coverage) -> str:
    lines, missed, rows = found.lines, found.missed, []
    for line, text in enumerate(found.source.text.rstrip("\n").split("\n"), 1):
        count = lines.get(line)
        kind = "" if count is None else "missed" if not count else "partly" if line in missed else "reached"
        remark = f"  <i>{escape(missed[line])}</i>" if count and line in missed else ""
        rows.append(
            f"<span class='{kind}'><b>{'' if count is None else count}  {line:>4}</b>{escape(text)}{remark}</span>"
        )
    return f"<h2 id='{escape(found.file)}'>{escape(found.file)}</h2><pre>{''.join(rows)}</pre>"


def _cell(heading: str, text: str) -> str:
    """Return a cell; that of a file is a link to its listing."""
    return (
        f"<td><a href='#{quote(text)}'>{escape(text)}</a></td>"
        if heading == "file"
        else documents.data_cell(heading, text)
    )


def _share(name: str, drop: int) -> tuple[Column, Column, Column]:
    """Return the columns of "reached of all" in text, and of both numbers as data."""
    reached = f"{name}_reached"
    return (
        Column("", name, get=lambda row: f"{row[reached]} of {row[name]}" if row[name] else "", drop=drop),
        Column(name, data=True),
        Column(reached, data=True),
    )


def _shortened(text: str) -> str:
    return text if len(text) <= MAX_LISTED else text[: text.rindex(",", 0, MAX_LISTED)] + " …"
