"""What a word, a code or a command means: the command help."""
