"""How results look, on a terminal, a page or a picture.

A `Table` is columns with units, written as text, Markdown, HTML, CSV or JSON; a `Figure` is panels of curves, drawn as
SVG or, by matplotlib, as PNG. `diagnostics` shows an error with its excerpt and caret, `report` a run, `formatting` a
number. A view of a single command is in its folder. Views return text; only commands print it.
"""
