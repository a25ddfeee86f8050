"""The requests that the server answers, each with a function of `editor/`."""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from motionlang.kernel import MACHINE_SUFFIX
from motionlang_lsp.convert import ITEMS, diagnostic, edits, markdown, symbol, workspace_edit
from motionlang_lsp.documents import units
from motionlang_lsp.editor import navigation
from motionlang_lsp.editor.completion import Item, complete
from motionlang_lsp.editor.fixes import fixes
from motionlang_lsp.editor.formatting import format
from motionlang_lsp.editor.hover import hover
from motionlang_lsp.editor.machine_file import complete_machine_file, hover_machine_file
from motionlang_lsp.editor.page import Page
from motionlang_lsp.editor.signature import signature
from motionlang_lsp.editor.tokens import MODIFIERS, TYPES, tokens
from motionlang_lsp.protocol import REQUEST_FAILED
from motionlang_lsp.session import MAX_TEXT, Known

if TYPE_CHECKING:
    from motionlang_lsp.server import EditorServer

T = TypeVar("T")

# A handler that waits: it begins at once, before the next message, and yields calls for pygls to wait for.
Waiting: TypeAlias = Generator[tuple[Callable[..., Any], tuple[object, ...], dict[str, object]], Any, T]

LEGEND = types.SemanticTokensLegend(list(TYPES), list(MODIFIERS))
# The commands of a lens, which an editor has to have; it names those that it has in `initializationOptions`.
LENSES = {
    "motionlang.run": "run",
    "motionlang.profile": "profile",
    "motionlang.scope": "scope",
    "motionlang.debug": "debug",
    "motionlang.map": "map",
}


# The command whose lens each sub has, too.
MAP = "motionlang.map"


def register(server: EditorServer) -> None:
    """Register all requests with a server."""
    _Names(server).register()
    _Typing(server).register()
    _Display(server).register()


class _Feature:
    """A group of requests about the open texts of a server."""

    def __init__(self, server: EditorServer) -> None:
        self.server, self.session = server, server.session

    def known(self, params: Any) -> tuple[Known, Page] | None:
        """Return the text of a request and its page, with its latest names.

        None if the text is not open or is not a program.
        """
        known = self.session.known(params.text_document.uri)
        page = None if known is None else self.session.page(known)
        return None if known is None or page is None else (known, page)

    def named(self, params: Any) -> Waiting[tuple[Known, Page] | None]:
        """Return the same as `known`, with the names of the present text."""
        known = self.session.known(params.text_document.uri)
        if known is None:
            return None
        page = yield self.session.named, (known, known.document.source), {}
        return None if page is None else (known, page)

    def on(self, method: str, handler: Callable[..., Any], options: Any = None) -> None:
        """Register a method of this object as the handler of a method of the protocol."""
        # pygls sets attributes of a handler, which a bound method cannot have.
        self.server.feature(method, options)(partial(handler))


class _Names(_Feature):
    """Hover, definition, references and renaming."""

    def register(self) -> None:
        self.on(types.TEXT_DOCUMENT_HOVER, self.hover)
        self.on(types.TEXT_DOCUMENT_DEFINITION, self.definition)
        self.on(types.TEXT_DOCUMENT_REFERENCES, self.references)
        self.on(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT, self.highlight)
        self.on(types.TEXT_DOCUMENT_PREPARE_RENAME, self.prepare_rename)
        self.on(types.TEXT_DOCUMENT_RENAME, self.rename, types.RenameOptions(prepare_provider=True))
        self.on(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL, self.symbols)

    def hover(self, params: types.HoverParams) -> types.Hover | None:
        known = self.session.known(params.text_document.uri)
        if known is None:
            return None
        document, offset = known.document, known.document.offset(params.position)
        page = self.session.page(known)
        if page is not None:
            shown = hover(page, offset)
        elif known.language is None and len(document.text) <= MAX_TEXT:
            shown = hover_machine_file(document.source, offset)
        else:
            shown = None
        return None if shown is None else types.Hover(markdown(shown.markdown), document.range(shown.span))

    def definition(self, params: types.DefinitionParams) -> Waiting[types.Location | None]:
        found = yield from self.named(params)
        if found is None:
            return None
        known, page = found
        span = navigation.definition(page, known.document.offset(params.position))
        return None if span is None else types.Location(known.document.uri, known.document.range(span))

    def references(self, params: types.ReferenceParams) -> Waiting[list[types.Location]]:
        found = yield from self.named(params)
        if found is None:
            return []
        known, page = found
        offset = known.document.offset(params.position)
        spans = navigation.references(page, offset, params.context.include_declaration)
        return [types.Location(known.document.uri, known.document.range(span)) for span in spans]

    def highlight(self, params: types.DocumentHighlightParams) -> Waiting[list[types.DocumentHighlight]]:
        found = yield from self.named(params)
        if found is None:
            return []
        known, page = found
        spans = navigation.references(page, known.document.offset(params.position))
        return [types.DocumentHighlight(known.document.range(span)) for span in spans]

    def prepare_rename(
        self, params: types.PrepareRenameParams
    ) -> Waiting[types.PrepareRenamePlaceholder | None]:
        found = yield from self.named(params)
        if found is None:
            return None
        known, page = found
        try:
            span, text = navigation.renamed_span(page, known.document.offset(params.position))
        except navigation.RenameRefused as refused:
            raise JsonRpcException(str(refused), REQUEST_FAILED) from None
        return types.PrepareRenamePlaceholder(range=known.document.range(span), placeholder=text)

    def rename(self, params: types.RenameParams) -> Waiting[types.WorkspaceEdit | None]:
        found = yield from self.named(params)
        if found is None:
            return None
        known, page = found
        try:
            changes = navigation.rename(page, known.document.offset(params.position), params.new_name)
        except navigation.RenameRefused as refused:
            raise JsonRpcException(str(refused), REQUEST_FAILED) from None
        return workspace_edit(known.document, changes, self.server.capabilities)

    def symbols(self, params: types.DocumentSymbolParams) -> Waiting[list[types.DocumentSymbol]]:
        found = yield from self.named(params)
        if found is None:
            return []
        return [symbol(found[0].document, each) for each in navigation.symbols(found[1])]


class _Typing(_Feature):
    """Completion, signatures, fixes and formatting."""

    def register(self) -> None:
        characters = types.CompletionOptions(trigger_characters=[".", "@", "#", "[", '"'])
        self.on(types.TEXT_DOCUMENT_COMPLETION, self.completion, characters)
        brackets = types.SignatureHelpOptions(trigger_characters=["(", "[", ","])
        self.on(types.TEXT_DOCUMENT_SIGNATURE_HELP, self.signature, brackets)
        kinds = types.CodeActionOptions([types.CodeActionKind.QuickFix])
        self.on(types.TEXT_DOCUMENT_CODE_ACTION, self.actions, kinds)
        self.on(types.TEXT_DOCUMENT_FORMATTING, self.format)

    def completion(self, params: types.CompletionParams) -> types.CompletionList:
        known = self.session.known(params.text_document.uri)
        if known is None:
            return types.CompletionList(False, [])
        offset = known.document.offset(params.position)
        page = self.session.page(known)
        items: list[Item] = []
        if page is not None:
            items = complete(page, offset)
        elif known.language is None and len(known.document.text) <= MAX_TEXT:
            items = complete_machine_file(known.document.source, offset)
        has_snippets = self._has_snippets()
        listed = []
        for each in items:
            text = each.snippet if each.snippet and has_snippets else each.text
            start = types.Position(
                params.position.line, params.position.character - (offset - each.start)
            )  # words are in ASCII
            listed.append(
                types.CompletionItem(
                    each.label,
                    kind=ITEMS.get(each.kind, types.CompletionItemKind.Text),
                    detail=each.detail or None,
                    documentation=each.help or None,
                    sort_text=f"{each.rank}{each.label}",
                    filter_text=each.text,
                    text_edit=types.TextEdit(types.Range(start, params.position), text),
                    insert_text_format=types.InsertTextFormat.Snippet if text is each.snippet else None,
                )
            )
        return types.CompletionList(False, listed)

    def _has_snippets(self) -> bool:
        document = self.server.capabilities.text_document
        completion = document.completion if document is not None else None
        item = completion.completion_item if completion is not None else None
        return bool(item is not None and item.snippet_support)

    def signature(self, params: types.SignatureHelpParams) -> types.SignatureHelp | None:
        found = self.known(params)
        if found is None:
            return None
        known, page = found
        shown = signature(page, known.document.offset(params.position))
        if shown is None:
            return None
        parameters = [types.ParameterInformation(each) for each in shown.parameters]
        active = shown.active if shown.active >= 0 else None
        documentation = markdown(shown.help) if shown.help else None
        return types.SignatureHelp(
            [types.SignatureInformation(shown.text, documentation, parameters)], 0, active
        )

    def actions(self, params: types.CodeActionParams) -> list[types.CodeAction]:
        found = self.known(params)
        only = params.context.only
        if found is None or (only and not any("quickfix".startswith(_value(each)) for each in only)):
            return []
        known, page = found
        if known.checked != known.document.version:
            return []
        wanted = params.range
        offered = []
        for each in known.found:
            shown = diagnostic(known.document, each)
            if _before(shown.range.end, wanted.start) or _before(wanted.end, shown.range.start):
                continue
            for fix in fixes(page, each):
                offered.append(
                    types.CodeAction(
                        fix.title,
                        kind=types.CodeActionKind.QuickFix,
                        diagnostics=[shown],
                        is_preferred=fix.preferred or None,
                        edit=workspace_edit(known.document, fix.edits, self.server.capabilities),
                    )
                )
        return offered

    def format(self, params: types.DocumentFormattingParams) -> list[types.TextEdit]:
        found = self.known(params)
        if found is None:
            return []
        options = params.options
        indent = " " * min(max(options.tab_size, 1), 16) if options.insert_spaces else "\t"
        return edits(found[0].document, format(found[1], indent))


class _Display(_Feature):
    """Folding, semantic tokens, hints and lenses."""

    def __init__(self, server: EditorServer) -> None:
        super().__init__(server)
        self._lenses: list[str] = []

    def register(self) -> None:
        self.on(types.INITIALIZE, self.initialize)
        self.on(types.INITIALIZED, self.watch)
        self.on(types.TEXT_DOCUMENT_FOLDING_RANGE, self.folding)
        self.on(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, self.tokens, LEGEND)
        self.on(types.TEXT_DOCUMENT_INLAY_HINT, self.hints)
        self.on(types.TEXT_DOCUMENT_CODE_LENS, self.lenses)
        self.on(types.WORKSPACE_DID_CHANGE_WATCHED_FILES, self.files_changed)

    def initialize(self, params: types.InitializeParams) -> None:
        """Record which code-lens commands the editor supports."""
        options = params.initialization_options
        commands = options.get("commands") if isinstance(options, dict) else None
        self._lenses = [name for name in LENSES if isinstance(commands, list) and name in commands]

    def watch(self, params: types.InitializedParams) -> None:
        """Ask the editor, if it can, to report changes of machine files on disk."""
        workspace = self.server.capabilities.workspace
        watched = workspace.did_change_watched_files if workspace is not None else None
        if watched is None or not watched.dynamic_registration:
            return
        watchers = [
            types.FileSystemWatcher(f"**/{name}") for name in (f"*{MACHINE_SUFFIX}", MACHINE_SUFFIX[1:])
        ]
        wanted = types.Registration(
            "machine files",
            types.WORKSPACE_DID_CHANGE_WATCHED_FILES,
            types.DidChangeWatchedFilesRegistrationOptions(watchers),
        )
        # An editor that refuses reports nothing; programs are still checked again with each change of theirs.
        self.server.client_register_capability(types.RegistrationParams([wanted]), lambda answer: None)

    def folding(self, params: types.FoldingRangeParams) -> Waiting[list[types.FoldingRange]]:
        found = yield from self.named(params)
        if found is None:
            return []
        return [
            types.FoldingRange(
                first - 1, last - 1, kind=types.FoldingRangeKind.Comment if is_comment else None
            )
            for first, last, is_comment in navigation.folds(found[1])
        ]

    def tokens(self, params: types.SemanticTokensParams) -> Waiting[types.SemanticTokens]:
        found = yield from self.named(params)
        return types.SemanticTokens([] if found is None else self._data(*found))

    def _data(self, known: Known, page: Page) -> list[int]:
        """Return tokens as numbers, each position relative to the previous token."""
        data: list[int] = []
        line = column = 0
        for at, start, length, kind, modifiers in tokens(page):
            text = known.document.source.line(at + 1)
            if not text.isascii():
                length = units(text[start : start + length])
                start = units(text[:start])
            data += (at - line, start - column if at == line else start, length, kind, modifiers)
            line, column = at, start
        return data

    async def hints(self, params: types.InlayHintParams) -> list[types.InlayHint]:
        known = self.session.known(params.text_document.uri)
        found = await self.session.times(known) if known is not None else None
        if known is None or found is None:
            return []
        tip = (
            f"simulated time of the first {found.until:g} s" if found.until else "simulated time of this line"
        )
        first, last = params.range.start.line + 1, params.range.end.line + 1
        return [
            types.InlayHint(
                types.Position(line - 1, units(known.document.source.line(line))),
                text,
                tooltip=tip,
                padding_left=True,
            )
            for line, text in sorted(found.texts().items())
            if first <= line <= last
        ]

    def lenses(self, params: types.CodeLensParams) -> list[types.CodeLens]:
        found = self.known(params)
        if found is None:
            return []
        known, page = found
        start = types.Position(0, 0)
        lenses = [
            types.CodeLens(
                types.Range(start, start), types.Command(LENSES[name], name, arguments=[known.document.uri])
            )
            for name in self._lenses
        ]
        if MAP in self._lenses:
            lenses += [
                types.CodeLens(
                    known.document.range(block.at),
                    types.Command(LENSES[MAP], MAP, arguments=[known.document.uri, block.name]),
                )
                for block in page.names.blocks
                if block.name
            ]
        return lenses

    def files_changed(self, params: types.DidChangeWatchedFilesParams) -> None:
        """Check the programs again with the machine files on disk."""
        self.session.machine_changed()


def _before(one: types.Position, other: types.Position) -> bool:
    return (one.line, one.character) < (other.line, other.character)


def _value(kind: types.CodeActionKind | str) -> str:
    return kind.value if isinstance(kind, types.CodeActionKind) else kind
