"""How the rows of this table are written: what most of them share is said once."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword


class Group:
    """Makes the rows of one group."""

    def __init__(self, title: str) -> None:
        self.title = title

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
        solved: bool = False,
        tunes: str = "",
        meant: str = "",
        family: str = "",
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
            group=self.title,
            solved=solved,
            tunes=tunes,
            meant=meant,
            family=family,
        )

    def known(self, name: str, kind: str, index: str, help: str) -> Keyword:
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
            group=self.title,
            simulated=False,
        )
