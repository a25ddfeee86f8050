"""The meaning of a word, a code or a command: the command help."""
