"""The log of a run: what the controller writes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.log.cycle import cycle_so_far as cycle_so_far
    from motionlang.kernel.log.log import Log as Log
    from motionlang.kernel.log.move import CONTINUED as CONTINUED
    from motionlang.kernel.log.move import MAX_PIECES as MAX_PIECES
    from motionlang.kernel.log.move import LoggedMove as LoggedMove
    from motionlang.kernel.log.records import GRAVE as GRAVE
    from motionlang.kernel.log.records import Changed as Changed
    from motionlang.kernel.log.records import Event as Event
    from motionlang.kernel.log.records import Printed as Printed
    from motionlang.kernel.log.records import Switched as Switched
    from motionlang.kernel.log.records import Waited as Waited
    from motionlang.kernel.log.stream import Stream as Stream

PUBLIC = {
    "cycle": "cycle_so_far",
    "log": "Log",
    "move": "LoggedMove CONTINUED MAX_PIECES",
    "records": "Event Waited Switched Changed Printed GRAVE",
    "stream": "Stream",
}

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)
