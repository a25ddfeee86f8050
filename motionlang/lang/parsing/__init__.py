"""From a `.lark` grammar to tables, and from a text to what the tables make of it."""
