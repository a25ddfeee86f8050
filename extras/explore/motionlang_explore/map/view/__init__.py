"""The map of a program as text, Markdown, Mermaid, JSON and an HTML page."""
