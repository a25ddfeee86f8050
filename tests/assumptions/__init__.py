"""Assumptions: their entries, page and use, and the probes that settle them."""
