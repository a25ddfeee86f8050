"""The extension in a real VS Code, which a browser drives."""
