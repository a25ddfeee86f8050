"""Build the artefacts of a release and try them; see `__main__.py`."""
