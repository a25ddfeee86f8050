"""Writers of files that are derived from others: `python -m tools.derived` writes all of them."""
