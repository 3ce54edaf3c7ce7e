open Basis

let all ~encoding : Json.t =
  Object
    [
      ("positionEncoding", String encoding);
      ( "textDocumentSync",
        Object [ ("openClose", Bool true); ("change", Int 2); ("save", Bool true) ] );
      ("documentFormattingProvider", Bool true);
      ("hoverProvider", Bool true);
      ("definitionProvider", Bool true);
      ("documentSymbolProvider", Bool true);
      ("workspaceSymbolProvider", Bool true);
      ("referencesProvider", Bool true);
      ("documentHighlightProvider", Bool true);
      ("renameProvider", Object [ ("prepareProvider", Bool true) ]);
      ( "codeActionProvider",
        Object
          [
            ( "codeActionKinds",
              List [ String "quickfix"; String "refactor.rewrite"; String "refactor.extract" ] );
          ] );
      ( "completionProvider",
        Object
          [ ("triggerCharacters", List [ String "."; String "[" ]); ("resolveProvider", Bool true) ]
      );
      ("signatureHelpProvider", Object [ ("triggerCharacters", List [ String " "; String "(" ]) ]);
      ("codeLensProvider", Object [ ("resolveProvider", Bool false) ]);
      ("inlayHintProvider", Bool true);
      ("semanticTokensProvider", Object [ ("legend", Semantic_tokens.legend); ("full", Bool true) ]);
      ("foldingRangeProvider", Bool true);
      ("selectionRangeProvider", Bool true);
      ( "workspace",
        Object
          [
            ( "workspaceFolders",
              Object [ ("supported", Bool true); ("changeNotifications", Bool true) ] );
          ] );
    ]
