"""Limits on the resources of the server that a host may use."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeVar

Host = TypeVar("Host")


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits on hosts, buffers and times.

    `hosts` is the number of hosts connected at once. Characters are limited per read from one host (`chunk`),
    until the board accepts them (`inbox`) and until the host reads them (`outbox`). Times are in seconds.
    `linger` is the time for a host's last lines after it has closed its sending side. A host must have been
    silent for `idle` seconds before it is dropped in favour of another.
    """

    hosts: int = 64
    chunk: int = 4096
    inbox: int = 65536
    outbox: int = 65536
    linger: float = 10.0
    idle: float = 60.0

    def to_drop(self, silent: Iterable[tuple[float, Host]], now: float) -> Host | None:
        """Return the host to drop in favour of another: the one that was heard of the longest ago, if that is idle.

        `silent` are the hosts that nothing is under way for, each with the time when it was last heard of.
        """
        found = [each for each in silent if now - each[0] >= self.idle]
        return min(found, key=lambda each: each[0])[1] if found else None
