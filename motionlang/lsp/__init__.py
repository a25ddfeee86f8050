"""The language server: `motionlang.editor` over the Language Server Protocol."""
