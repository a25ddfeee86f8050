"""The figures that vendors' notes print, a note a file; no run imports this package."""
