"""Grammatical programs from a seed, and the checks that each must pass.

`python -m tests.generated 100000 --seed 1 --jobs 2` runs a long series; the normal suite runs a sample.
`docs/proof.md` lists the checks.
"""
