"""The tests; `python -m tests` runs the complete check."""
