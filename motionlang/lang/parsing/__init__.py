"""Table-driven parsing: from a `.lark` grammar to tables, from a text to its tree."""
