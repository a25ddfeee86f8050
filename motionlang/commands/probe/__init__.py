"""Assumptions: the questions that the sources leave open, our choices, and tests.

They are data, in the folders `evidence/` of the dialects and of this package. Code that explains, documents
or probes loads them; a run never does. The owner of a controller can confirm them.
"""
