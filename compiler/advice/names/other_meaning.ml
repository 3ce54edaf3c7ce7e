open Basis
open Resolve
open Interface

let as_a_field (t : Unknown.t) owners =
  let owners = List.map (fun (r : tycon) -> Printf.sprintf "`%s`" r.global.name) owners in
  let owners = List.filteri (fun i _ -> i < 3) (List.sort_uniq String.compare owners) in
  let name = t.name.text in
  Diagnostic.note
    "`%s` is a field of %s: write `r.%s`, or `\\r -> r.%s` if you need a function, or `proc r -> \
     r.%s` if you need a signal function"
    name (Enumeration.all owners) name name name

let explained (t : Unknown.t) =
  let visible = t.module_.visible and name = t.name.text in
  match t.namespace with
  | Constructors -> (
      match Visible.size_named visible name with
      | Some n ->
          fun d ->
            Diagnostic.note "`%s` is a size: use it in types and expressions, not in patterns" name
              d
            |> Diagnostic.hint "write the number: `%d`" n
      | None when Visible.is_known visible tycons name ->
          Diagnostic.note "`%s` is a type, not a constructor" name
      | None -> Fun.id)
  | Types when Visible.is_known visible constructors name ->
      Diagnostic.note "`%s` is a constructor, not a type" name
  | Values -> (
      match String_map.find_opt name (Lazy.force visible.records) with
      | Some owners -> as_a_field t owners
      | None when Visible.is_known visible units name ->
          Diagnostic.note
            "`%s` is a unit: write it in brackets directly after a number, as in `3[%s]`" name name
      | None -> Fun.id)
  | Types | Units | Classes -> Fun.id

let diagnostic t =
  Unknown.diagnostic t |> if Unknown.c_declaration t = None then explained t else Fun.id

let spelling (t : Unknown.t) =
  let known space other =
    if Visible.is_known t.module_.visible space other then Some other else None
  in
  match t.namespace with
  | Units -> Unit_word.symbol t.name.text
  | Values -> known constructors (String.capitalize_ascii t.name.text)
  | Constructors -> known values (String.uncapitalize_ascii t.name.text)
  | Types | Classes -> None
