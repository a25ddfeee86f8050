"""Use the moves of a run as columns.

`run.moves.to_polars()` and `.to_pandas()` make data frames.
"""

import motionlang

text = "SPEED(0) = 100\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\nMOVER(0) = -50 : GO(0)\nPAUSE IDLE(0)\n"
moves = motionlang.run(motionlang.Source("feed.mnt", text)).moves
print(moves.columns()["distance"])  # [200.0, -50.0]
print(sum(abs(move.distance) for move in moves))  # 250.0
