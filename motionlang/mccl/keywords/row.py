"""How the rows of this table are written: what most of them share is said once."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

# Where a fact comes from, in the words of docs/fidelity.md.
TN1069 = "PMC TN1069"
MANUAL = "MultiFlex user's manual"
FIRMWARE = "PMC firmware history"
MX = "MX beam-line driver"
MCAPI = "PMC MCAPI header"
SELF_TEST = "PMC self-test"
RECALL = "recollection of PMC's manuals"


class Group:
    """Makes the rows of one group."""

    def __init__(self, title: str, source: str = RECALL, trust: str = "memory") -> None:
        self.title, self.source, self.trust = title, source, trust

    def row(
        self,
        name: str,
        kind: str,
        access: str,
        index: str,
        unit: str,
        verb: str,
        help: str,
        example: str,
        *,
        default: float | str | None = None,
        low: float | None = None,
        high: float | None = None,
        source: str = "",
        trust: str = "",
        solved: bool = False,
        tunes: str = "",
    ) -> Keyword:
        """One simulated command."""
        return Keyword(
            name,
            "",
            kind,
            access,
            index,
            unit,
            verb,
            help,
            example,
            default=default,
            low=low,
            high=high,
            source=source or self.source,
            trust=trust or self.trust,
            group=self.title,
            solved=solved,
            tunes=tunes,
        )

    def known(
        self, name: str, kind: str, index: str, help: str, source: str = "", trust: str = ""
    ) -> Keyword:
        """A command of the language that is recognised and answered as not simulated."""
        return Keyword(
            name,
            "",
            kind,
            "W",
            index,
            "",
            "",
            help,
            source=source or self.source,
            trust=trust or self.trust,
            group=self.title,
            simulated=False,
        )
