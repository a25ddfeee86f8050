"""The language server: what `editor` shows of a text, over the Language Server Protocol."""
