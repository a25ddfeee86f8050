"""The log of a run: what the controller writes."""
