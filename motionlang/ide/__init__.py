"""The answers that editors ask for: the debugger, its adapter, and what an editor shows.

`debug` runs a program forward and back without a protocol, and `dap` speaks the Debug Adapter Protocol for it. `editor`
has what an editor shows of a text, as pure functions: diagnostics, hover, completion, names, layout, simulated times;
the distribution motionlang-lsp speaks the Language Server Protocol for them.
"""
