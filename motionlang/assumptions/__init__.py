"""Assumptions: what the sources leave open, the choices, and how to confirm them.

They are data, in the folders `evidence/` of the dialects and of this package. Code that explains, documents
or probes loads them; a run never does. An owner of a controller can confirm them.
"""
