"""The facts about files in MCCL, and what several rules ask of them."""
