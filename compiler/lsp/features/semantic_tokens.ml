open Basis

let types =
  [
    "variable";
    "parameter";
    "function";
    "property";
    "enumMember";
    "type";
    "class";
    "namespace";
    "unit";
  ]

let modifiers = [ "declaration"; "signal"; "static"; "readonly"; "defaultLibrary" ]

let legend : Json.t =
  let strings names = Json.List (List.map (fun name -> Json.String name) names) in
  Object [ ("tokenTypes", strings types); ("tokenModifiers", strings modifiers) ]

let number name names =
  let rec go n = function
    | [] -> 0
    | other :: _ when String.equal other name -> n
    | _ :: rest -> go (n + 1) rest
  in
  go 0 names

let bits names = List.fold_left (fun bits m -> bits lor (1 lsl number m modifiers)) 0 names

let is_function (ty : Typing.Ir.ty) =
  match ty with Function _ | Signal_function _ -> true | _ -> false

let kind (view : View.t) (o : Index.occurrence) =
  let facts = View.facts view in
  let main = (View.program view).main_module in
  let of_library (g : Resolve.Ir.Global.t) =
    let is_it (m : Resolve.Ir.module_) = String.equal m.name g.module_ && m.library in
    if (not (String.equal g.module_ main)) && List.exists is_it (View.program view).modules then
      [ "defaultLibrary" ]
    else []
  in
  match o.symbol.what with
  | Local -> (
      match Option.bind facts (fun facts -> Place_types.local facts o.symbol.at) with
      | None -> ("variable", [])
      | Some { scheme; level } -> (
          let word = if is_function scheme.ty then "function" else "variable" in
          match level with
          | Parameter -> ((if word = "function" then word else "parameter"), [])
          | Level Signal -> (word, [ "signal" ])
          | Level Static -> (word, [ "static" ])
          | Level Constant -> (word, [ "readonly" ])))
  | Value g -> (
      match Option.bind facts (fun facts -> Place_types.global facts g) with
      | Some { ty; _ } when not (is_function ty) -> ("variable", "readonly" :: of_library g)
      | Some _ | None -> ("function", of_library g))
  | Field _ -> ("property", [])
  | Constructor g -> ("enumMember", of_library g)
  | Type g -> ("type", of_library g)
  | Class g -> ("class", of_library g)
  | Unit g -> ("unit", of_library g)
  | Module -> ("namespace", [])

let answer ws (doc : Document.t) : Json.t =
  match Document.names doc with
  | None -> Object [ ("data", List []) ]
  | Some seen ->
      let token (o : Index.occurrence) =
        match View.place seen o.place with
        | None -> None
        | Some (start, stop) ->
            let p = Text.position ws.Workspace.encoding doc.text start in
            let q = Text.position ws.encoding doc.text stop in
            let type_, words = kind seen.view o in
            let words = if o.declares then "declaration" :: words else words in
            if p.line <> q.line || q.character <= p.character then None
            else Some (p, q.character - p.character, number type_ types, bits words)
      in
      (* Positions are relative to the previous token. If there are several tokens at one position,
         only the first is kept. *)
      let add ((line, character), data) ((p : Text.position), length, type_, bits) =
        if p.line = line && p.character <= character && data <> [] then ((line, character), data)
        else
          let first = if p.line = line then p.character - character else p.character in
          ((p.line, p.character), List.rev_append [ p.line - line; first; length; type_; bits ] data)
      in
      let tokens = List.filter_map token (Index.all (View.index seen.view)) in
      let _, data = List.fold_left add ((0, 0), []) tokens in
      Object [ ("data", List (List.rev_map (fun n -> Json.Int n) data)) ]
