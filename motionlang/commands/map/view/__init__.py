"""The map of a program as text, Markdown, Mermaid, DOT, JSON and an HTML page."""
