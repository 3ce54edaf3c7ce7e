open Basis
open Syntax.Ir

type t = { name : name; kind : int; detail : string; whole : Span.t; inside : t list }

(* Values of [SymbolKind] in the protocol. *)
let class_ = 5
let method_ = 6
let field = 8
let interface = 11
let function_ = 12
let variable = 13
let constant = 14
let enum_member = 22
let struct_ = 23

let symbol ?(inside = []) ?(detail = "") (name : name) kind whole =
  { name; kind; detail; whole; inside }

let rec of_bindings (ds : declaration list) =
  List.concat_map
    (fun (d : declaration) ->
      match d.desc with
      | Binding { left = Name n; right; _ } ->
          [ symbol n variable d.span ~inside:(of_bindings right.where) ]
      | Binding { left = Function_name { name; _ }; right; _ } ->
          [ symbol name function_ d.span ~inside:(of_bindings right.where) ]
      | Binding { left = Pattern p; _ } ->
          List.map (fun n -> symbol n variable d.span) (Mentions.patterns p)
      | _ -> [])
    ds

(* The equations of a proc that is the right-hand side of a definition. *)
let rec equations (e : expr) =
  match e.desc with
  | Proc { body = Output { equations; _ }; _ } -> of_bindings equations
  | Parenthesized e | Apply (_, e) -> equations e
  | _ -> []

let inside (r : right) =
  of_bindings r.where @ match r.body with Plain e -> equations e | Guarded _ -> []

let constructor (c : constructor) =
  let fields =
    match c.fields with
    | Positional _ -> []
    | Named fields -> List.map (fun ((n : name), _) -> symbol n field n.span) fields
  in
  symbol c.name enum_member c.span ~inside:fields

let members (ds : declaration list) =
  List.concat_map
    (fun (d : declaration) ->
      match d.desc with
      | Signature s -> List.map (fun n -> symbol n method_ d.span) s.names
      | _ -> [])
    ds

let declaration (d : declaration) =
  match d.desc with
  | Signature _ -> []
  | Binding { left = Name n; right; _ } ->
      let kind = match inside right with [] -> constant | _ -> function_ in
      [ symbol n kind d.span ~inside:(inside right) ]
  | Binding { left = Function_name { name; _ }; right; _ } ->
      [ symbol name function_ d.span ~inside:(inside right) ]
  | Binding { left = Pattern _; _ } -> []
  | Type_alias { name; _ } -> [ symbol name interface d.span ~detail:"type" ]
  | Data { name; constructors; _ } ->
      [ symbol name struct_ d.span ~detail:"data" ~inside:(List.map constructor constructors) ]
  | Base_unit name | Scaled_unit { name; _ } -> [ symbol name constant d.span ~detail:"unit" ]
  | Class { name; members = ms; _ } ->
      [ symbol name class_ d.span ~detail:"class" ~inside:(members ms) ]
  | Instance { class_ = c; head; members = ms; _ } ->
      let detail = match head.desc with Type { name; _ } -> name.name.text | _ -> "" in
      [
        symbol
          { text = "instance " ^ c.name.text; span = c.span }
          class_ d.span ~detail ~inside:(of_bindings ms);
      ]
  | Primitive s -> List.map (fun n -> symbol n function_ d.span) s.names
  | Foreign (Foreign_value { name; _ }) -> [ symbol name function_ d.span ~detail:"foreign" ]
  | Foreign (Foreign_type { name; _ }) -> [ symbol name struct_ d.span ~detail:"foreign" ]
  | Claim _ | Foreign (Foreign_include _) -> []
  | Parameter { name; _ } -> [ symbol name constant d.span ~detail:"param" ]
  | Check { kind = Test; label; _ } -> [ symbol label constant d.span ~detail:"test" ]
  | Check { kind = Trial; label; _ } -> [ symbol label constant d.span ~detail:"trial" ]

let of_tree (tree : program) = List.concat_map declaration tree.declarations

let of_document ws (doc : Document.t) : Json.t =
  match Document.names doc with
  | None -> List []
  | Some seen ->
      let rec json s =
        match (View.place seen s.name.span, View.range seen s.whole) with
        | Some name, Some ((start, stop) as whole) ->
            let whole = if start <= fst name && snd name <= stop then whole else name in
            Some
              (Json.Object
                 [
                   ("name", String s.name.text);
                   ("kind", Int s.kind);
                   ("detail", String s.detail);
                   ("range", Workspace.range ws doc.text whole);
                   ("selectionRange", Workspace.range ws doc.text name);
                   ("children", List (List.filter_map json s.inside));
                 ])
        | _ -> None
      in
      List (List.filter_map json (of_tree (View.tree seen.view)))

(* {1 Symbols of all programs} *)

let matches query name =
  let query = String.lowercase_ascii query and name = String.lowercase_ascii name in
  let rec go q n =
    q >= String.length query
    || (n < String.length name && if query.[q] = name.[n] then go (q + 1) (n + 1) else go q (n + 1))
  in
  go 0 0

let tree_of (ws : Workspace.t) path text =
  Text_cache.find ws.trees ~path text (fun _ ->
      Syntax.Parse.program (Facts.ignored ()) ~file:path text)

let most_found = 500

let of_workspace ws query : Json.t =
  let of_file path =
    match Workspace.read ws path with
    | Error _ -> []
    | Ok text ->
        let sources = Source.create () in
        Source.add sources ~file:path text;
        let rec all container s =
          (if matches query s.name.text then [ (container, s) ] else [])
          @ List.concat_map (all s.name.text) s.inside
        in
        let json (container, s) : Json.t =
          Object
            [
              ("name", String s.name.text);
              ("kind", Int s.kind);
              ("containerName", String container);
              ("location", Workspace.location ws sources s.name.span);
            ]
        in
        let tops = Option.fold (tree_of ws path text) ~none:[] ~some:of_tree in
        let module_ = Filename.remove_extension (Filename.basename path) in
        List.map json (List.concat_map (all module_) tops)
  in
  let rec take n = function x :: rest when n > 0 -> x :: take (n - 1) rest | _ -> [] in
  List (take most_found (List.concat_map of_file (Workspace.files ws)))
