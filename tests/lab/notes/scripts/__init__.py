"""Scripts that print and draw the figures of the notes."""
