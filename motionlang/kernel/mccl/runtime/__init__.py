"""The run time of MCCL: the board, its tasks, and loops that poll."""
