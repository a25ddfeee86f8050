"""What the five documents say, and what reproduces it."""
