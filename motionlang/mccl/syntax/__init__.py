"""The structure of MCCL text: lines, commands, tokens. No mnemonic is known here."""
