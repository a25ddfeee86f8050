"""Limits on the resources of the server that a host may use."""

from __future__ import annotations

from dataclasses import dataclass


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
