"""The facts about Mint programs, and what several rules ask of them."""
