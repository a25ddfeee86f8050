"""Everything a person sees: diagnostics, tables, charts, plots, exports and the keyword pages."""
