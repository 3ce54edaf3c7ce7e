open Basis

type t = {
  mutable text : string;  (** the text of the file that is being parsed *)
  mutable told : Diagnostic.t list;
  mutable colons : Lexical_mistake.colons;
}

let create () = { text = ""; told = []; colons = Lexical_mistake.no_colons }

let start t text =
  t.text <- text;
  t.told <- [];
  t.colons <- Lexical_mistake.no_colons

let tabs ~at count =
  let more = if count = 1 then "" else Printf.sprintf " (%d tabs in this file)" count in
  Diagnostic.error ~code:"E0102" ~at "tabs are not allowed, because indentation is significant%s"
    more
  |> Diagnostic.hint "set up your editor to insert spaces instead of tabs"

let lexical t fact =
  let diagnostic, colons = Lexical_mistake.diagnostic ~text:t.text t.colons fact in
  t.colons <- colons;
  diagnostic

let diagnostic t (problem : Syntax.Fact.problem) =
  let text = t.text in
  match problem with
  | Not_utf8 { at; byte } ->
      Some
        (Diagnostic.error ~code:"E0101" ~at
           "this file is not valid UTF-8: byte %d is not allowed here" (Char.code byte)
        |> Diagnostic.hint "save the file as UTF-8 text")
  | Tabs { at; count } -> Some (tabs ~at count)
  | Too_deep at ->
      Some
        (Diagnostic.error ~code:"E0106" ~at "this is nested more than %d levels deep"
           Syntax.Layout.deepest
        |> Diagnostic.hint "move inner parts into definitions of their own")
  | Lexical fact -> lexical t fact
  | Unexpected { state; before; token } ->
      Syntax_error.unexpected ~told:t.told ~text ~state ~before token
  | Rejected reason -> Some (Rejection_mistake.diagnostic ~text reason)
  | Command_in_task { command; block; token } ->
      Some (Syntax_error.command ~text ~command ~block token)
  | Misplaced_header at ->
      Some
        (Diagnostic.error ~code:"E0118" ~at "`module` must be at the beginning of a file"
        |> Diagnostic.hint "move it to the first line, or remove it")
  | Misplaced_import at ->
      Some
        (Diagnostic.error ~code:"E0118" ~at "an `import` must come before all definitions"
        |> Diagnostic.hint "move it to the top of the file")

let diagnostics t ({ text; problem } : Syntax.Fact.t) =
  if t.text != text then start t text;
  match diagnostic t problem with
  | Some diagnostic ->
      t.told <- diagnostic :: t.told;
      [ diagnostic ]
  | None -> []

let into sink = Facts.into_several sink (diagnostics (create ()))
