"""From Mint text to its syntax tree, with all syntax errors."""
