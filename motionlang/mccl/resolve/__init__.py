"""From the text of a command to what it does: words looked up, parameters decoded."""
