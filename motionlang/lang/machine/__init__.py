"""The machine file, and the machine that is made of it."""
