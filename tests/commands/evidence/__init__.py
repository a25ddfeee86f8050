"""The evidence of facts and the assumptions: entries, page, use."""
