open Basis

let all ~encoding : Json.t =
  Object
    [
      ("positionEncoding", String encoding);
      ( "textDocumentSync",
        Object [ ("openClose", Bool true); ("change", Int 2); ("save", Bool true) ] );
      ("documentFormattingProvider", Bool true);
      ( "workspace",
        Object
          [
            ( "workspaceFolders",
              Object [ ("supported", Bool true); ("changeNotifications", Bool true) ] );
          ] );
    ]
