"""Calculations of the notes of PMC and of chapter 12, a module per subject."""
