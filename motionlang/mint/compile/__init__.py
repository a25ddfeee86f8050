"""Compile a resolved tree to Python."""
