"""The extension in a real VS Code that is driven through a browser."""
