"""Acts of two runs, ways or reports: moves, outputs and prints, aligned in order and then compared in time."""
