"""The structure of MCCL text: lines, commands, tokens.

This package contains no mnemonic.
"""
