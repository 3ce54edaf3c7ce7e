open Basis

let report sink ~text:_ ~state:_ ~before (token : Layout.token) =
  let at = Build.span (token.start, token.stop) in
  ignore (before : Layout.token option);
  Diagnostic.emit sink (Diagnostic.error ~code:"E0110" ~at "this does not fit here")
