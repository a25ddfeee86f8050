"""The processor time of one call."""

from __future__ import annotations

import gc
from time import process_time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable


def seconds(work: Callable[[], object], collect: bool = False) -> float:
    """Return the processor time of one call, s, with the cyclic collector on or off."""
    gc.collect()
    if not collect:
        gc.disable()
    began = process_time()
    result = work()
    taken = process_time() - began
    gc.enable()
    del result
    return taken
