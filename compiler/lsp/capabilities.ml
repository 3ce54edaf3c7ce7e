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
      ( "workspace",
        Object
          [
            ( "workspaceFolders",
              Object [ ("supported", Bool true); ("changeNotifications", Bool true) ] );
          ] );
    ]
