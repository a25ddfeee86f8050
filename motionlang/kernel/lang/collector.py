"""A pause of Python's garbage collector, for passes that make many objects."""

from __future__ import annotations

import gc


class CollectorOff:
    """A block in which the collector does not run.

    The objects that such a block creates remain in use, so the collector would only scan them repeatedly.
    """

    def __enter__(self) -> None:
        self._was_on = gc.isenabled()
        gc.disable()

    def __exit__(self, *_: object) -> None:
        if self._was_on:
            gc.enable()
