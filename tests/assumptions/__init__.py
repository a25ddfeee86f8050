"""The open readings: their entries, their page, what depends on them, and the probes that settle them."""
