"""User output: diagnostics, tables, charts, plots, exports and the keyword pages."""
