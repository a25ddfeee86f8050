"""From Mint text to its tree, and every mistake on the way."""
