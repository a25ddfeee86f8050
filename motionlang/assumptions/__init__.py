"""Open readings: what the sources leave open, what was chosen, and how the owner of a controller can settle it.

The readings are data, in the folders `evidence/` of the dialects and of this package. What explains, documents or
probes loads them; a run never does.
"""
