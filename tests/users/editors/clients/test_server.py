"""Tests `frobc lsp` with pytest-lsp, a third-party client that checks each message against the
protocol. `make test-clients` runs this."""

import pathlib

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

PROGRAM = """import Robot

vMax = 0.5[m/s]

-- | Slower, the nearer it is.
approach :: Distance -> SF Distance Velocity
approach d = proc x -> v where
    way = x - d
    v   = max 0 (min vMax (0.5[1/s] * way))

main = reactimateRobot (proc i -> roMake (setVelTR (approach 0.5[m] (frontSonar i)) 0))
"""


@pytest_lsp.fixture(
    params=["visual-studio-code", "neovim", "emacs"],
    config=ClientServerConfig(server_command=["frobc", "lsp"]),
)
async def client(request, lsp_client: LanguageClient, tmp_path):
    lsp_client.folder = tmp_path
    await lsp_client.initialize_session(
        types.InitializeParams(
            capabilities=client_capabilities(request.param),
            workspace_folders=[types.WorkspaceFolder(uri=tmp_path.as_uri(), name="here")],
        )
    )
    yield
    await lsp_client.shutdown_session()


async def opened(client, text, name="drive.frob"):
    path = pathlib.Path(client.folder) / name
    path.write_text(text)
    client.text_document_did_open(
        types.DidOpenTextDocumentParams(
            types.TextDocumentItem(uri=path.as_uri(), language_id="frob", version=1, text=text)
        )
    )
    await client.wait_for_notification("textDocument/publishDiagnostics")
    return types.TextDocumentIdentifier(uri=path.as_uri())


def at(text, mark):
    before = text[: text.index(mark)]
    return types.Position(line=before.count("\n"), character=len(before) - before.rfind("\n") - 1)


@pytest.mark.asyncio
async def test_messages(client: LanguageClient):
    broken = PROGRAM.replace("* way", "* wya")
    document = await opened(client, broken)
    (message,) = client.diagnostics[document.uri]
    assert message.code == "E0205" and message.range.start == at(broken, "wya")
    actions = await client.text_document_code_action_async(
        types.CodeActionParams(
            text_document=document,
            range=message.range,
            context=types.CodeActionContext(diagnostics=[message]),
        )
    )
    assert "write `way`" in [a.title for a in actions]


@pytest.mark.asyncio
async def test_questions(client: LanguageClient):
    document = await opened(client, PROGRAM)
    assert not client.diagnostics[document.uri]
    place = dict(text_document=document, position=at(PROGRAM, "vMax ("))
    hover = await client.text_document_hover_async(types.HoverParams(**place))
    assert "vMax :: Float[m/s]" in hover.contents.value
    found = await client.text_document_definition_async(types.DefinitionParams(**place))
    assert found.range.start == at(PROGRAM, "vMax =")
    found = await client.text_document_references_async(
        types.ReferenceParams(**place, context=types.ReferenceContext(include_declaration=True))
    )
    assert len(found) == 2
    found = await client.text_document_completion_async(types.CompletionParams(**place))
    assert "vMax" in [i.label for i in found.items]
    found = await client.text_document_rename_async(types.RenameParams(**place, new_name="top"))
    assert len(found.changes[document.uri]) == 2


@pytest.mark.asyncio
async def test_whole_texts(client: LanguageClient):
    document = await opened(client, PROGRAM)
    symbols = await client.text_document_document_symbol_async(
        types.DocumentSymbolParams(text_document=document)
    )
    assert [s.name for s in symbols] == ["vMax", "approach", "main"]
    edits = await client.text_document_formatting_async(
        types.DocumentFormattingParams(
            text_document=document, options=types.FormattingOptions(tab_size=4, insert_spaces=True)
        )
    )
    assert not edits
    tokens = await client.text_document_semantic_tokens_full_async(
        types.SemanticTokensParams(text_document=document)
    )
    assert tokens.data and len(tokens.data) % 5 == 0
    lenses = await client.text_document_code_lens_async(
        types.CodeLensParams(text_document=document)
    )
    assert {l.command.command for l in lenses} == {"frob.run", "frob.report"}
    folds = await client.text_document_folding_range_async(
        types.FoldingRangeParams(text_document=document)
    )
    assert (6, 8) in [(f.start_line, f.end_line) for f in folds]


@pytest.mark.asyncio
async def test_edits(client: LanguageClient):
    document = await opened(client, PROGRAM)
    start = at(PROGRAM, "0.5[m/s]")
    end = types.Position(start.line, start.character + len("0.5[m/s]"))
    client.text_document_did_change(
        types.DidChangeTextDocumentParams(
            text_document=types.VersionedTextDocumentIdentifier(uri=document.uri, version=2),
            content_changes=[
                types.TextDocumentContentChangePartial(range=types.Range(start, end), text="0.5[s]")
            ],
        )
    )
    await client.wait_for_notification("textDocument/publishDiagnostics")
    assert [d.code for d in client.diagnostics[document.uri]] == ["E0320"]
