"""From the text of a command to its action: lookup of mnemonics and parameters."""
