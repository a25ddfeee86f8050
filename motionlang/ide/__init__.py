"""Editors: the debugger, its adapter, what an editor shows, the language server."""
