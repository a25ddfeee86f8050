"""Name resolution and control flow of the functions of a Mint program."""
