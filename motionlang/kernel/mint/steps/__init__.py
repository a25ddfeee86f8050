"""From the annotated tree to steps; `program.py` is the entry."""
