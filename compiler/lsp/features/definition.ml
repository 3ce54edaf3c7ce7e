open Basis

let symbol_at ws (doc : Document.t) params =
  let open Basis.Let_syntax.Option in
  let offset = Workspace.offset ws doc.text (Json.member "position" params) in
  let of_version seen =
    let* seen = seen in
    let* position = View.position seen offset in
    let* occurrence = Index.at (View.index seen.view) position in
    let* _ = View.place_at seen offset occurrence.place in
    Some (seen, occurrence)
  in
  match of_version (Document.names doc) with
  | Some found -> Some found
  | None -> of_version (Document.types doc)

let answer ws (doc : Document.t) params : Json.t =
  match symbol_at ws doc params with
  | None -> Null
  | Some (seen, { symbol; _ }) -> (
      let a = View.analysis seen.view in
      match (symbol.at.file, View.place seen symbol.at) with
      | "", _ -> Null
      | file, Some range when String.equal file a.shown ->
          Object [ ("uri", String doc.uri); ("range", Workspace.range ws doc.text range) ]
      | file, None when String.equal file a.shown -> Null
      | _ -> Workspace.location ws a.sources symbol.at)
