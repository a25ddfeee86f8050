"""`tests.sizes` counts the kinds of lines and the fields of classes."""

from __future__ import annotations

import ast

from tests.sizes import Classes, kinds

TEXT = '''"""A module.

With a sentence."""
from __future__ import annotations
# A comment.
TABLE = (
    1,
    2,
)
ONE = 1  # beside

if TYPE_CHECKING:
    from os import PathLike


class A:
    """A class."""

    def f(self) -> int:
        """A function."""
        # A reason.
        return (
            1
        )
'''
CLASSES = """
class Base:
    __slots__ = ("a", "b")
class Small:
    def __init__(self):
        self.x = self.y = 0
class Shared:
    def __init__(self):
        self.z = 0
class Whole(Base):
    kind: int
    def __init__(self):
        self.a, self.c = 0, 1
        self.small = Small()
        self.shared: Shared = Shared()
        self.width = 3
    @property
    def width(self): ...
"""


def test_each_line_has_one_kind() -> None:
    assert kinds(TEXT) == {"docstring": 5, "import": 2, "comment": 2, "data": 4, "blank": 4, "logic": 7}
    assert kinds('"""Written by a script, not by hand."""\nA = 1\n') == {"generated": 2}


def test_fields_with_base_classes_and_what_only_the_class_makes() -> None:
    """a, b of the base; own c, kind, small, shared; x and y of the owned object."""
    trees = {"whole.py": ast.parse(CLASSES), "other.py": ast.parse("made = Shared()")}
    classes = Classes(trees)
    assert set(classes.fields("Whole", "whole.py")) == {"a", "b", "c", "kind", "small", "shared"}
    assert classes.with_owned("Whole", "whole.py") == 6 + 2
