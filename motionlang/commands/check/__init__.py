"""The mistakes of a program, found without a run: the command check."""
