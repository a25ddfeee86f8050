"""What the names of a Mint program stand for, and the ways through its functions."""
