"""An MCCL program or line as it runs: the board, its tasks, and loops that poll."""
