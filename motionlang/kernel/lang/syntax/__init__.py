"""Syntax that both languages share: grammars, stacks of a parser, names with positions."""
