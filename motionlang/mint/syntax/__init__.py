"""From Mint text to its syntax tree, and all syntax errors on the way."""
