"""The assumptions: entries, page, use, and the probes that settle them."""
