"""The servo laboratory: the command servo."""
