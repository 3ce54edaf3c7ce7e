open Basis

(* Values of [CompletionItemKind] in the protocol. *)
let function_ = 3
let field = 5
let variable = 6
let class_ = 7
let module_kind = 9
let unit_kind = 11
let keyword = 14
let snippet = 15
let constructor = 20
let type_kind = 22

(* {1 The context of the cursor} *)

type context =
  | Fields of { base : string list; offset : int }  (** after [a.b.] *)
  | Qualified of string
  | Units
  | Modules
  | Names_of of string  (** the import list of this module *)
  | Types
  | Expression

(* The start of the word that ends at this offset. *)
let rec word_start text i =
  if i > 0 && Basis.Character.is_name text.[i - 1] then word_start text (i - 1) else i

let line_before text offset =
  let start =
    match String.rindex_from_opt text (max 0 (offset - 1)) '\n' with
    | Some i when offset > 0 -> i + 1
    | _ -> 0
  in
  String.sub text start (offset - start)

(* The names before a dot, in source order; empty if anything else precedes the dot. *)
let rec path_before text dot names =
  let start = word_start text dot in
  if start = dot then []
  else
    let names = String.sub text start (dot - start) :: names in
    if start > 0 && text.[start - 1] = '.' then path_before text (start - 1) names else names

(* Does the line end inside brackets after a number or a type, where only a unit can occur? *)
let in_unit line =
  let n = String.length line in
  let is_unit_char c =
    Basis.Character.is_name c || c = ' ' || c = '/' || c = '^' || c = '*' || c = '.'
  in
  let rec back i =
    if i < 0 then None
    else if line.[i] = '[' then Some i
    else if is_unit_char line.[i] then back (i - 1)
    else None
  in
  match back (n - 1) with
  | Some i when i > 0 && Basis.Character.is_name line.[i - 1] -> (
      let word = String.sub line (word_start line i) (i - word_start line i) in
      match word.[0] with '0' .. '9' | 'A' .. 'Z' -> true | _ -> String.length word = 1)
  | Some _ | None -> false

(* Whether the cursor is in a type: after `::`, or after the `=` of a `data` or `type`
   declaration. *)
let in_type (tokens : Tokens.token array) ~from ~upto =
  let step inside (t : Tokens.token) =
    if t.start < from || t.stop > upto then inside
    else
      match (t.token, inside) with
      | DOUBLE_COLON, _ -> `Type
      | (DATA | TYPE | INSTANCE | CLASS | FOREIGN), _ when t.first -> `Declaration
      | EQUAL, `Declaration -> `Type
      | (EQUAL | LEFT_ARROW | WHERE | RBRACE), _ -> `No
      | COMMA, `Type -> `Type
      | (LOWER _ | UNDERSCORE), `Type when t.first -> `No
      | _, inside -> inside
  in
  Array.fold_left step `No tokens <> `No

let context text tokens offset =
  let start = word_start text offset in
  let line = line_before text offset in
  let words = String.split_on_char ' ' line in
  let from, _ = Tokens.item text offset in
  match words with
  | "import" :: rest when not (String.contains line '(') ->
      if List.mem "as" rest then Expression else Modules
  | "import" :: rest -> (
      let is_module w = w <> "" && 'A' <= w.[0] && w.[0] <= 'Z' in
      match List.find_opt is_module rest with
      | Some name -> Names_of (List.hd (String.split_on_char '(' name))
      | None -> Modules)
  | _ ->
      if start > 0 && text.[start - 1] = '.' then
        match path_before text (start - 1) [] with
        | [ name ] when 'A' <= name.[0] && name.[0] <= 'Z' -> Qualified name
        | base -> Fields { base; offset = start - 1 }
      else if in_unit line then Units
      else if in_type tokens ~from ~upto:start then Types
      else Expression

(* {1 Items} *)

let item ?(more = []) ?(detail = "") label kind ~rank : Json.t =
  Object
    ([
       ("label", Json.String label);
       ("kind", Int kind);
       ("sortText", String (Printf.sprintf "%d%s" rank label));
     ]
    @ (if detail = "" then [] else [ ("detail", Json.String detail) ])
    @ more)

let kind_of : Mentions.space -> int = function
  | Value -> function_
  | Constructor -> constructor
  | Type -> type_kind
  | Class -> class_
  | Unit -> unit_kind
  | Field -> field

(* The data that identifies an entry, so that [resolve] can look up its doc comment. *)
let data (doc : Document.t) (e : Catalogue.entry) : (string * Json.t) list =
  [
    ( "data",
      Object
        [
          ("uri", String doc.uri);
          ("module", String e.module_);
          ("name", String e.name);
          ("value", Bool (e.space = Value));
        ] );
  ]

let of_entry doc ?(more = []) ?(rank = 2) (e : Catalogue.entry) =
  let detail = if e.module_ = "" then "" else e.module_ in
  let details : Json.t = Object [ ("description", String detail) ] in
  item e.name (kind_of e.space) ~rank ~more:((("labelDetails", details) :: data doc e) @ more)

let entry_item doc e = of_entry doc e
let is_word (e : Catalogue.entry) = Basis.Character.is_name e.name.[0]

let snippets =
  [
    ( "proc",
      "proc ${1:x} -> ${2:y} where\n    ${2:y} = $0",
      "a signal function defined by equations" );
    ("if", "if ${1:condition} then ${2:a} else ${3:b}", "a choice");
    ("case", "case ${1:x} of\n    ${2:pattern} -> $0", "a choice by pattern matching");
    ( "switch",
      "switch (${1:sf} &&& ${2:event}) (\\\\${3:_} -> $0)",
      "a switch from one behaviour to another" );
    ( "main",
      "main = reactimateRobot (proc i -> roMake (setVelTR v omega) where\n\
      \    v     = ${1:0.3[m/s]}\n\
      \    omega = ${2:0[rad/s]})$0",
      "a robot program" );
    ("do", "do\n    $0", "tasks in sequence");
    ("let", "let ${1:x} = ${2:e}\nin $0", "a local definition");
  ]

let of_snippet (label, text, detail) =
  item label snippet ~rank:4 ~detail
    ~more:[ ("insertText", String text); ("insertTextFormat", Int 2) ]

(* {1 Names in scope} *)

(* Names that occur in the definition around the cursor, except the word that the cursor touches. *)
let locals (doc : Document.t) tokens text offset known =
  let from, upto = Tokens.item text offset in
  let start = word_start text offset in
  let in_unit = ref false in
  let add found (t : Tokens.token) =
    (match t.token with UNIT_BRACKET -> in_unit := true | RBRACKET -> in_unit := false | _ -> ());
    match t.token with
    | LOWER name
      when (not !in_unit) && t.start >= from && t.stop <= upto && t.start <> start
           && (not (List.mem name found))
           && not (Hashtbl.mem known name) ->
        name :: found
    | _ -> found
  in
  Array.fold_left add [] tokens
  |> List.map (fun name ->
         let detail =
           Option.fold (Expression_type.of_name doc ~offset name) ~none:"" ~some:Typing.Show.ty
         in
         item name variable ~rank:1 ~detail)

(* An edit that adds an import after the last import, or at the top of the file. *)
let import_edit ws (doc : Document.t) text module_ : Json.t =
  let tokens = Tokens.of_text text in
  let last =
    Array.fold_left
      (fun found (t : Tokens.token) -> if t.token = IMPORT && t.first then Some t.start else found)
      None tokens
  in
  let at, line =
    match last with
    | Some start ->
        let stop =
          Option.value (String.index_from_opt text start '\n') ~default:(String.length text)
        in
        (stop, "\nimport " ^ module_)
    | None -> (0, "import " ^ module_ ^ "\n\n")
  in
  Object [ ("range", Workspace.range ws doc.text (at, at)); ("newText", String line) ]

(* Library entries that are not imported yet. *)
let importable ws doc text prefix in_scope =
  if String.length prefix < 2 then []
  else
    let known = Hashtbl.create 256 in
    List.iter (fun (e : Catalogue.entry) -> Hashtbl.replace known (e.name, e.module_) ()) in_scope;
    let of_module (module_, entries) =
      List.filter_map
        (fun (e : Catalogue.entry) ->
          if
            String.starts_with ~prefix e.name && is_word e && e.space <> Unit && e.space <> Field
            && not (Hashtbl.mem known (e.name, e.module_))
          then (
            Hashtbl.replace known (e.name, e.module_) ();
            let edit = import_edit ws doc text module_ in
            Some
              (of_entry doc e ~rank:5
                 ~more:
                   [
                     ("additionalTextEdits", Json.List [ edit ]);
                     ("detail", String ("import " ^ module_));
                   ]))
          else None)
        entries
    in
    (* Modules that re-export others come first, because users normally import these. *)
    let modules = Catalogue.library ws in
    let gathers (module_, entries) =
      List.exists (fun (e : Catalogue.entry) -> e.module_ <> module_) entries
    in
    let first, rest = List.partition gathers modules in
    List.concat_map of_module (first @ rest)

(* Only the library may declare primitives. *)
let keywords =
  let has_snippet word = List.exists (fun (label, _, _) -> String.equal label word) snippets in
  List.filter (fun w -> w <> "primitive" && not (has_snippet w)) Syntax.Lexer.keywords

let answer ws (doc : Document.t) params : Json.t =
  let text = Text.contents doc.text in
  let offset = Workspace.offset ws doc.text (Json.member "position" params) in
  let tokens = Tokens.of_text text in
  let imports = Catalogue.imports tokens in
  let directory = Filename.dirname doc.path in
  let in_scope = lazy (Catalogue.in_scope ws doc imports) in
  let start = word_start text offset in
  let prefix = String.sub text start (offset - start) in
  let of_spaces spaces =
    List.filter
      (fun (e : Catalogue.entry) -> List.mem e.space spaces && is_word e)
      (Lazy.force in_scope)
  in
  let items =
    match context text tokens offset with
    | Fields { base; offset } -> (
        let rec follow ty = function
          | [] -> Expression_type.fields doc ty
          | name :: rest -> (
              match List.assoc_opt name (Expression_type.fields doc ty) with
              | Some ty -> follow ty rest
              | None -> [])
        in
        let known =
          match base with
          | [] -> []
          | name :: rest ->
              Option.fold (Expression_type.of_name doc ~offset name) ~none:[] ~some:(fun ty ->
                  follow ty rest)
        in
        match known with
        | [] -> List.map (entry_item doc) (of_spaces [ Field ])
        | fields ->
            List.map (fun (name, ty) -> item name field ~rank:1 ~detail:(Typing.Show.ty ty)) fields)
    | Qualified name ->
        let is_it (i : Catalogue.import) = i.of_module = name || i.alias = Some name in
        List.concat_map
          (fun (i : Catalogue.import) -> Catalogue.exports ws ~directory i.of_module)
          (List.filter is_it imports)
        |> List.filter is_word
        |> List.map (entry_item doc)
    | Units -> List.map (entry_item doc) (of_spaces [ Unit ])
    | Modules ->
        List.map (fun name -> item name module_kind ~rank:1) (Catalogue.modules ws ~directory)
    | Names_of module_ ->
        let listed (e : Catalogue.entry) =
          is_word e && not (List.mem e.space [ Mentions.Field; Constructor ])
        in
        List.map (entry_item doc) (List.filter listed (Catalogue.exports ws ~directory module_))
    | Types -> List.map (entry_item doc) (of_spaces [ Type; Class ])
    | Expression ->
        let entries = of_spaces [ Value; Constructor ] in
        let known = Hashtbl.create 256 in
        List.iter (fun (e : Catalogue.entry) -> Hashtbl.replace known e.name ()) entries;
        locals doc tokens text offset known
        @ List.map (entry_item doc) entries
        @ List.map (fun word -> item word keyword ~rank:3) keywords
        @ (if ws.snippets then List.map of_snippet snippets
           else List.map (fun (label, _, _) -> item label keyword ~rank:3) snippets)
        @ importable ws doc text prefix (Lazy.force in_scope)
  in
  Object [ ("isIncomplete", Bool (String.length prefix < 2)); ("items", List items) ]

(* {1 Details of an item} *)

let resolve ws (json : Json.t) : Json.t =
  let text path = Json.(string (at [ "data"; path ] json)) in
  match (text "uri", text "module", text "name", json) with
  | Some uri, Some module_, Some name, Object members
    when Json.(at [ "data"; "value" ] json) = Bool true -> (
      let seen = Option.bind (Workspace.document ws uri) Document.names in
      let g : Resolve.Ir.Global.t = { module_; name } in
      match seen with
      | None -> json
      | Some { view; _ } ->
          let doc =
            Option.fold (Description.doc view g) ~none:[] ~some:(fun text ->
                [
                  ( "documentation",
                    Json.Object [ ("kind", String "markdown"); ("value", String text) ] );
                ])
          in
          let detail =
            match Description.signature view g with
            | Some s when not (List.mem_assoc "detail" members) -> [ ("detail", Json.String s) ]
            | Some _ | None -> []
          in
          Object (members @ detail @ doc))
  | _ -> json
