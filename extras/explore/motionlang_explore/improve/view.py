"""A shorter cycle as text: the edits with what each gains, what bounds it, and the program's difference."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import unified_diff

from motionlang.commands.certify.view import limits_table
from motionlang.kernel.tools import count_of
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import styled
from motionlang_explore.improve import Improvement

# So many ways in which a program does something else with the edits are shown.
MAX_ELSEWHERE = 3


def improvement_document(found: Improvement, file: str) -> Document:
    """Return an improvement as data; `diff` is that of the program."""
    texts = (
        *found.skipped,
        *found.refused,
        *([found.sets] if found.sets else []),
        *found.waits,
        *_ways(found),
    )
    held = Table("held", tuple(map(Column, ("literal", "line", "value", "reason"))), [*_held_rows(found)])
    remarks = Table("remarks", (Column("text"),), [{"text": each} for each in texts])
    values = {
        "cycle": found.cycle,
        "where": found.where,
        "before": found.before,
        "after": found.after,
        "trials": found.trials,
        "ways": found.ways.summary if found.ways is not None else "",
        "diff": "" if _is_refused(found) else "".join(difference(found, file)),
    }
    return Document([edits_table(found), held, limits_table(found.limits), remarks], values)


def edits_table(found: Improvement) -> Table:
    """Return the edits, each with what bounds it; the column that warns of an output is never left out."""
    rows = [
        {
            "literal": each.literal.address,
            "line": each.literal.line,
            "old": each.literal.value,
            "new": each.value,
            "gain": each.share,
            "bound": each.bound,
            "outputs": each.outputs[0] if each.outputs else None,
        }
        for each in found.edits
    ]
    columns = (
        Column("literal", "edit", left=True, style="word"),
        Column("line", drop=3),
        Column("old", "from", drop=2),
        Column("new", "to"),
        Column("gain", unit="s", text=lambda seconds: f"{round(seconds, 4) + 0.0:.4f}", drop=1),
        Column("bound", "bounded by", left=True),
        Column("outputs", "while this is on", left=True, data=not any(each.outputs for each in found.edits)),
    )
    return Table(
        "edits", columns, rows, empty="no edit gains anything", notes=[count_of(found.trials, "trial")]
    )


def improvement_lines(found: Improvement, file: str, *, width: int, colour: bool) -> list[str]:
    """Return an improvement as lines of text."""
    share = 100.0 * (found.after / found.before - 1.0)
    where = found.where if found.cycle else "no cycle: the whole run"
    seconds = f"{found.before:.5g} s → {found.after:.5g} s"
    head = f"{file}: {found.cycle or 'run'} {seconds}, {share:.1f} % ({where})"
    lines = [styled(head, "bold", colour), "", *edits_table(found).lines(width, colour=colour)]
    lines += _held_lines(found, colour)
    note = styled("note:", "note", colour)
    sets = [found.sets] if found.sets else []
    texts = (*found.skipped, *found.refused, *sets, *found.waits, *_ways(found))
    remarks = [f"{note} {each}" for each in texts]
    lines += ["", *remarks] if remarks else []
    if found.edits:
        lines += ["", *limits_table(found.limits).lines(width, colour=colour)]
    if found.edits and not _is_refused(found):
        lines += ["", *(line.rstrip("\n") for line in difference(found, file))]
    return lines


def _is_refused(found: Improvement) -> bool:
    return found.ways is not None and bool(found.ways.refused)


def _ways(found: Improvement) -> Iterator[str]:
    """Yield what the edits do in all ways that were found, but for what refuses them."""
    if found.ways is not None:
        yield found.ways.summary
        shown = found.ways.elsewhere[:MAX_ELSEWHERE]
        yield from (f"B, with the edits, does something else: {each}" for each in shown)
        if len(found.ways.elsewhere) > len(shown):
            yield f"and so in {count_of(len(found.ways.elsewhere) - len(shown), 'other way')}"


def _held_rows(found: Improvement) -> Iterator[dict[str, object]]:
    for each in found.held:
        literal = each.literal
        yield {
            "literal": literal.address,
            "line": literal.line,
            "value": literal.value,
            "reason": each.reason,
        }


def _held_lines(found: Improvement, colour: bool) -> Iterator[str]:
    """Yield the numbers of the process, which are not changed, each with the reason."""
    if found.held:
        yield ""
        first = found.held[0].literal.address
        yield styled(f"held: --also {first} tries one", "bold", colour)
        width = max(len(f"{each.literal.address} = {each.literal.text}") for each in found.held)
        for each in found.held:
            named = f"{each.literal.address} = {each.literal.text}"
            yield f"  {named:<{width}}  {each.reason}"


def difference(found: Improvement, file: str) -> Iterator[str]:
    """Yield the lines of a unified diff of the program, which `patch` applies."""
    old, new = (each.text.splitlines(keepends=True) for each in (found.source, found.patched))
    return unified_diff(old, new, file, file)
