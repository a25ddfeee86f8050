"""What editors ask: the debugger, its adapter, what an editor shows, the language server.

`debug` runs a program forward and back without a protocol, and `dap` speaks the Debug Adapter Protocol for it. `editor`
has what an editor shows of a text, as pure functions: diagnostics, hover, completion, names, layout, simulated times;
`lsp` speaks the Language Server Protocol for them, and keeps the open texts.
"""
