"""How much a host may ask of the server."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Limits:
    """`hosts` at once; characters read from one host in a turn (`chunk`), kept until the board takes them (`inbox`)
    and until the host reads them (`outbox`); seconds that a host's last lines may take once it has said its last
    (`linger`), and for which one must have been silent to make room for another (`idle`)."""

    hosts: int = 64
    chunk: int = 4096
    inbox: int = 65536
    outbox: int = 65536
    linger: float = 10.0
    idle: float = 60.0
