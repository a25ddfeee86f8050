"""Check Mint programs after name resolution: all diagnostics, and types and constants of expressions."""
