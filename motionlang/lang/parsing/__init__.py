"""Table-driven parsing: from `.lark` grammars to tables, and from texts to trees."""
