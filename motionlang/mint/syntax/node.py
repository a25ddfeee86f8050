"""What every node of the syntax tree has: its place, and equality by what it says."""

from __future__ import annotations


class Node:
    """A piece of a program that starts at token number `at`."""

    __slots__ = ("at",)

    at: int

    def __repr__(self) -> str:
        fields = ", ".join(repr(getattr(self, name)) for name in self.__slots__)
        return f"{type(self).__name__}({fields})"

    def __eq__(self, other: object) -> bool:
        """Nodes are equal when what they say is equal; where they stand takes no part."""
        return type(self) is type(other) and all(
            getattr(self, name) == getattr(other, name) for name in self.__slots__
        )

    __hash__ = None  # type: ignore[assignment]
