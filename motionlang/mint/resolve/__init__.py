"""Name resolution, and the control flow of the functions, of a Mint program."""
