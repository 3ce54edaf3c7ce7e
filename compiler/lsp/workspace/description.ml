open Basis

type t = { code : string; notes : string list; doc : string option }

(* {1 Source text} *)

let squeezed text =
  String.split_on_char ' ' (String.map (function '\n' | '\r' | '\t' -> ' ' | c -> c) text)
  |> List.filter (( <> ) "")
  |> String.concat " "

let quote (view : View.t) (span : Span.t) =
  let sources = (View.analysis view).sources in
  match Source.text sources span.file with
  | None -> None
  | Some text ->
      let start = Source.offset sources span.file span.start in
      let stop = Source.offset sources span.file span.stop in
      if start < stop then Some (String.sub text start (stop - start)) else None

let most_lines = 14

(* The lines of a top-level declaration, and the doc comment above them. *)
let declaration view (at : Span.t) =
  let line n = Source.line (View.analysis view).sources at.file n in
  let first = Span.line at.start in
  let is_inside text = text <> "" && (text.[0] = ' ' || text.[0] = '\t') in
  let rec back n =
    match line n with Some text when is_inside text && n > 1 -> back (n - 1) | _ -> n
  in
  let first = back first in
  let rec below n =
    match line n with
    | Some text when is_inside text && n - first < most_lines -> text :: below (n + 1)
    | _ -> []
  in
  let is_comment text = String.starts_with ~prefix:"--" text in
  let rec above n lines =
    match line n with
    | Some text when n > 0 && is_comment text -> above (n - 1) (text :: lines)
    | _ -> lines
  in
  let doc =
    match above (first - 1) [] with
    | first :: rest when String.starts_with ~prefix:"-- |" first ->
        let text prefix l = String.trim (String.sub l prefix (String.length l - prefix)) in
        Some (String.concat "\n" (text 4 first :: List.map (text 2) rest))
    | _ -> None
  in
  (String.concat "\n" (Option.value (line first) ~default:"" :: below (first + 1)), doc)

(* {1 Definitions} *)

type definition = { scheme : Resolve.Ir.scheme option; doc : string option }

let find (program : Resolve.Ir.program) (g : Resolve.Ir.Global.t) =
  let primitive (p : Resolve.Ir.primitive) =
    if p.name = g then Some { scheme = Some p.scheme; doc = p.doc } else None
  in
  let method_ (c : Resolve.Ir.class_) =
    List.find_map
      (fun (m : Resolve.Ir.method_) ->
        if m.name = g then Some { scheme = Some m.scheme; doc = m.doc } else None)
      c.methods
  in
  let binding (b : Resolve.Ir.binding) =
    match b.name with
    | Top (name, _) when name = g -> Some { scheme = b.signature; doc = b.doc }
    | Top _ | Inner _ | Destructure _ -> None
  in
  let group (group : Resolve.Ir.binding_group) = List.find_map binding group.bindings in
  match List.find_map primitive program.primitives with
  | Some d -> Some d
  | None -> (
      match List.find_map group program.groups with
      | Some d -> Some d
      | None -> List.find_map method_ program.classes)

let written view (scheme : Resolve.Ir.scheme) = Option.map squeezed (quote view scheme.span)

let inferred view g =
  Option.map Typing.Show.scheme (Option.bind (View.facts view) (fun f -> Place_types.global f g))

let signature view g =
  match Option.bind (find (View.program view) g) (fun d -> d.scheme) with
  | Some scheme -> written view scheme
  | None -> inferred view g

let doc view g = Option.bind (find (View.program view) g) (fun d -> d.doc)

(* {1 Symbols} *)

let level : Place_types.level -> string = function
  | Level Constant -> "constant"
  | Level Static -> "static: known when the enclosing signal function starts"
  | Level Signal -> "signal"
  | Parameter -> "parameter, or part of a matched value"

let is_operator name = match name.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> false | _ -> true
let shown name = if is_operator name then "(" ^ name ^ ")" else name

let from view (g : Resolve.Ir.Global.t) =
  if Resolve.Test_file.is_module_of g.module_ ~main:(View.program view).main_module then []
  else [ Printf.sprintf "from `%s`" g.module_ ]

let field_type view ~record name =
  let of_constructor (c : Resolve.Ir.constructor) =
    if String.equal c.constructor.name record then
      List.find_map
        (fun (f : Resolve.Ir.field) ->
          if String.equal f.field_name name then quote view f.ty.span else None)
        c.fields
    else None
  in
  List.find_map
    (fun (t : Resolve.Ir.type_declaration) ->
      match t.definition with
      | Data constructors -> List.find_map of_constructor constructors
      | Alias _ | Builtin | Foreign _ -> None)
    (View.program view).types

let of_symbol view (s : Index.symbol) =
  let declared g =
    if s.at.file = "" then Some { code = s.name; notes = [ "built in" ]; doc = None }
    else
      let code, doc = declaration view s.at in
      Some { code; notes = from view g; doc }
  in
  match s.what with
  | Local ->
      let of_local (l : Place_types.local) =
        {
          code = Printf.sprintf "%s :: %s" s.name (Typing.Show.scheme l.scheme);
          notes = [ level l.level ];
          doc = None;
        }
      in
      Option.map of_local
        (Option.bind (View.facts view) (fun facts -> Place_types.local facts s.at))
  | Value g ->
      let code =
        match signature view g with
        | Some type_ -> Printf.sprintf "%s :: %s" (shown s.name) type_
        | None -> shown s.name
      in
      Some { code; notes = from view g; doc = doc view g }
  | Field { record } ->
      let type_ = Option.value (field_type view ~record s.name) ~default:"…" in
      Some
        {
          code = Printf.sprintf "%s :: %s" s.name (squeezed type_);
          notes = [ Printf.sprintf "field of `%s`" record ];
          doc = None;
        }
  | Constructor g | Type g | Class g | Unit g -> declared g
  | Module -> Some { code = "module " ^ s.name; notes = []; doc = None }

let parameters type_ =
  let n = String.length type_ in
  let rec go depth start i parts =
    if i >= n then List.rev (String.sub type_ start (n - start) :: parts)
    else
      match type_.[i] with
      | '(' | '[' -> go (depth + 1) start (i + 1) parts
      | ')' | ']' -> go (depth - 1) start (i + 1) parts
      | '=' when depth = 0 && i + 1 < n && type_.[i + 1] = '>' -> go 0 (i + 2) (i + 2) []
      | '-' when depth = 0 && i + 1 < n && type_.[i + 1] = '>' ->
          go 0 (i + 2) (i + 2) (String.sub type_ start (i - start) :: parts)
      | _ -> go depth start (i + 1) parts
  in
  List.map String.trim (go 0 0 0 [])
