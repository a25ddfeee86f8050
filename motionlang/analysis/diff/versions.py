"""Read reports of `motionlang.report/1` under the field names of version 2.

`FIELDS` and `VALUES` are the only record of the old names; `docs/report.md` shows them and a test compares
both.
"""

from __future__ import annotations

from typing import Any

from motionlang.report import SCHEMA

# The schema that came before `SCHEMA`.
OLD_SCHEMA = "motionlang.report/1"
# By the list of a report whose rows have the field, "" for the report itself: the old and the new name.
FIELDS = {
    "": {"not_counted": "notes", "readings": "assumptions", "written": "device_writes"},
    "moves": {"asked_speed": "commanded_speed"},
    "events": {"ordered_by": "commanded_by"},
    "device_writes": {"what": "kind", "sub": "subindex"},
}
# By list and field: the old and the new value.
VALUES = {("certificate", "verdict"): {"beyond": "exceeded"}}


def current(report: dict[str, Any]) -> dict[str, Any]:
    """Return a report under the names of version 2.

    Raise ValueError for a version that is neither 1 nor 2.
    """
    schema = report.get("schema")
    if schema == SCHEMA:
        return report
    if schema != OLD_SCHEMA:
        raise ValueError(f"its schema is {schema}, and only {OLD_SCHEMA} and {SCHEMA} can be read")
    made: dict[str, Any] = _renamed(report, FIELDS[""]) | {"schema": SCHEMA}
    for name, fields in FIELDS.items():
        if name and isinstance(made.get(name), list):
            made[name] = [_renamed(row, fields) for row in made[name]]
    for (name, field), values in VALUES.items():
        if isinstance(made.get(name), list):
            made[name] = [_revalued(row, field, values) for row in made[name]]
    return made


def _renamed(row: Any, names: dict[str, str]) -> Any:
    return {names.get(name, name): value for name, value in row.items()} if isinstance(row, dict) else row


def _revalued(row: Any, field: str, values: dict[str, str]) -> Any:
    if not isinstance(row, dict) or not isinstance(row.get(field), str):
        return row
    return row | {field: values.get(row[field], row[field])}
