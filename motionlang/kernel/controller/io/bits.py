"""Words of 32 bits, as banks of inputs, registers and host memory hold them."""


def signed(word: int) -> int:
    """Return the lowest 32 bits of an integer in two's complement."""
    return (word + 0x80000000 & 0xFFFFFFFF) - 0x80000000
