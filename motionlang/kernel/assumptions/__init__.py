"""The open assumptions of keywords, which a report names."""
