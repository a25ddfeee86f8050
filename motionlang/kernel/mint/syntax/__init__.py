"""Parse Mint text to a syntax tree, and report all syntax errors."""
