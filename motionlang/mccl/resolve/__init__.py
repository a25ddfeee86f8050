"""From the text of a command to its action: look-up of words and parameters."""
