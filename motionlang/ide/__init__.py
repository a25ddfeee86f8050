"""The debugger and its adapter.

`debug` runs a program forward and back without a protocol, and `dap` speaks the Debug Adapter Protocol for it. What an
editor shows of a text is in the distribution motionlang-lsp.
"""
