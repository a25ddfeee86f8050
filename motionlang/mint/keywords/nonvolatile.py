"""Memory that outlives a run, addressed by numbers."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

ROWS = (
    Keyword("NVLONG", "", "setting", "RW", "address", "integer", "nonvolatile.word",
            "A whole number in non-volatile memory, addresses 0 to 1023; `run --nv FILE` keeps it from run to run.",
            "NVLONG(5) = NVLONG(5) + 1\nPRINT NVLONG(5)", default=0.0, group="control"),
    Keyword("NVFLOAT", "", "setting", "RW", "address", "number", "nonvolatile.real",
            "The same memory as single-precision numbers: NVLONG and NVFLOAT of one address share their bits.",
            "NVFLOAT(7) = 2.5\nPRINT NVFLOAT(7)", default=0.0, group="control"),
)  # fmt: skip
