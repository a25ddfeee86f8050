"""From a resolved tree to Python."""
