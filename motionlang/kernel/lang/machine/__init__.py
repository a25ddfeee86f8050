"""The machine file and the machine built from it."""
