"""The language server: `motionlang.ide.editor` over the Language Server Protocol."""
