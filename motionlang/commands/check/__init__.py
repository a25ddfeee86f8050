"""What is wrong with a program, without a run: the command check."""
