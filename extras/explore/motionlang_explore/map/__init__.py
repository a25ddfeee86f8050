"""The map of a program: what it reads and writes, its axes, its structure and its states."""
