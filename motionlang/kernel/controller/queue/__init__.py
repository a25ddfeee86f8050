"""The queue of an axis: loading a move, its start, its end, and what cuts it short."""
