"""Conversion of the results of `editor/` to types of the protocol."""

from __future__ import annotations

from collections.abc import Sequence

from lsprotocol import types

from motionlang.kernel import Diagnostic
from motionlang_lsp.documents import OpenDocument
from motionlang_lsp.editor.fixes import SpanEdit
from motionlang_lsp.editor.navigation import OutlineEntry

_SEVERITIES = {
    "error": types.DiagnosticSeverity.Error,
    "warning": types.DiagnosticSeverity.Warning,
}
_UNUSED = frozenset(
    ("unused-variable", "unused-label", "unused-sub", "unused-task", "unused-setting", "unreachable")
)
_SYMBOLS = {
    "sub": types.SymbolKind.Function,
    "function": types.SymbolKind.Function,
    "task": types.SymbolKind.Class,
    "event": types.SymbolKind.Event,
    "startup": types.SymbolKind.Constructor,
    "type": types.SymbolKind.Struct,
    "macro": types.SymbolKind.Function,
    "constant": types.SymbolKind.Constant,
    "define": types.SymbolKind.Constant,
    "variable": types.SymbolKind.Variable,
    "label": types.SymbolKind.Key,
    "member": types.SymbolKind.Field,
}
ITEMS = {
    "variable": types.CompletionItemKind.Variable,
    "parameter": types.CompletionItemKind.Variable,
    "register": types.CompletionItemKind.Variable,
    "constant": types.CompletionItemKind.Constant,
    "define": types.CompletionItemKind.Constant,
    "sub": types.CompletionItemKind.Function,
    "function": types.CompletionItemKind.Function,
    "macro": types.CompletionItemKind.Function,
    "move": types.CompletionItemKind.Method,
    "command": types.CompletionItemKind.Method,
    "task": types.CompletionItemKind.Class,
    "event": types.CompletionItemKind.Event,
    "label": types.CompletionItemKind.Reference,
    "type": types.CompletionItemKind.Struct,
    "member": types.CompletionItemKind.Field,
    "block": types.CompletionItemKind.Snippet,
    "setting": types.CompletionItemKind.Property,
    "reading": types.CompletionItemKind.Property,
    "statement": types.CompletionItemKind.Keyword,
}


def diagnostic(document: OpenDocument, each: Diagnostic) -> types.Diagnostic:
    """Convert a diagnostic.

    Without a column it marks its line, without a line the first line.
    """
    line = max(each.line, 1)
    text = document.source.line(line)
    if each.column and each.line:
        begin = min(each.column - 1, len(text))
        end = min(begin + max(each.length, 1), len(text))
    else:
        begin, end = len(text) - len(text.lstrip()), len(text.rstrip())
    start = document.source_offset(line)
    message = f"{each.message}\nhint: {each.hint}" if each.hint else each.message
    return types.Diagnostic(
        document.range((start + begin, start + max(end, begin))),
        message,
        severity=_SEVERITIES.get(each.severity, types.DiagnosticSeverity.Information),
        code=each.code,
        source="motionlang",
        tags=[types.DiagnosticTag.Unnecessary] if each.code in _UNUSED else None,
    )


def edits(document: OpenDocument, found: Sequence[SpanEdit]) -> list[types.TextEdit]:
    """Convert the changes of a text."""
    return [types.TextEdit(document.range(each.span), each.text) for each in found]


def workspace_edit(
    document: OpenDocument, found: Sequence[SpanEdit], capabilities: types.ClientCapabilities
) -> types.WorkspaceEdit:
    """Convert the changes of a text to an edit of the workspace.

    They refer to its present version if the editor supports versions.
    """
    changes = edits(document, found)
    workspace = capabilities.workspace
    edit = workspace.workspace_edit if workspace is not None else None
    if edit is None or not edit.document_changes:
        return types.WorkspaceEdit(changes={document.uri: changes})
    identifier = types.OptionalVersionedTextDocumentIdentifier(document.uri, document.version)
    return types.WorkspaceEdit(document_changes=[types.TextDocumentEdit(identifier, list(changes))])


def symbol(document: OpenDocument, each: OutlineEntry) -> types.DocumentSymbol:
    """Convert an entry of the outline, with all entries inside it."""
    return types.DocumentSymbol(
        each.name,
        _SYMBOLS.get(each.kind, types.SymbolKind.Variable),
        document.range(each.span),
        document.range(each.at),
        detail=each.detail or None,
        children=[symbol(document, inner) for inner in each.inner],
    )


def markdown(text: str) -> types.MarkupContent:
    return types.MarkupContent(types.MarkupKind.Markdown, text)
