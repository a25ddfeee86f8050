"""Grammatical programs from a seed, and the checks that each of them must pass.

`python -m tests.generated 100000 --seed 1 --jobs 2` runs a long series; the normal suite runs a slice of it.
`docs/proof.md` says what is checked.
"""
