type t = { types : string list; values : (string * string) list }

let bare name =
  let name = String.trim name in
  let n = String.length name in
  if n > 2 && name.[0] = '(' then String.sub name 1 (n - 2) else name

let find text word =
  let n = String.length word in
  let rec go i =
    if i + n > String.length text then None
    else if String.sub text i n = word then Some i
    else go (i + 1)
  in
  go 0

let before text i = String.sub text 0 i
let after text i = String.sub text i (String.length text - i)

let first_word text =
  let stops = [ ' '; '['; '=' ] in
  let rec go i =
    if i < String.length text && not (List.mem text.[i] stops) then go (i + 1) else i
  in
  before text (go 0)

(* The first word of each alternative after the equals sign. *)
let constructors declaration =
  match String.index_opt declaration '=' with
  | None -> []
  | Some i ->
      after declaration (i + 1)
      |> String.split_on_char '|'
      |> List.map (fun alternative -> first_word (String.trim alternative))

let signature line =
  match find line " :: " with
  | Some i when line.[0] <> ' ' ->
      let names = String.split_on_char ',' (before line i) in
      let type_ = String.trim (after line (i + 4)) in
      List.map (fun name -> (bare name, type_)) names
  | Some _ | None -> []

(* Foreign values have a type, followed by a C symbol; keeps only the type. *)
let in_c names =
  List.map
    (fun (name, type_) ->
      match find type_ " = " with Some i -> (name, before type_ i) | None -> (name, type_))
    (signature names)

let declared text =
  let keyword line word =
    let n = String.length word in
    if String.length line > n && before line n = word then Some (after line n) else None
  in
  let line found text =
    let comment = String.length text >= 2 && before text 2 = "--" in
    if text = "" || comment then found
    else
      let types = List.find_map (keyword text) [ "unit "; "type "; "foreign type " ] in
      match (types, keyword text "data ", keyword text "foreign ", keyword text "primitive ") with
      | Some name, _, _, _ -> { found with types = first_word name :: found.types }
      | _, Some name, _, _ ->
          { found with types = (first_word name :: constructors name) @ found.types }
      | _, _, Some names, _ -> { found with values = List.rev_append (in_c names) found.values }
      | _, _, _, Some names ->
          { found with values = List.rev_append (signature names) found.values }
      | None, None, None, None ->
          { found with values = List.rev_append (signature text) found.values }
  in
  List.fold_left line { types = []; values = [] } (String.split_on_char '\n' text)
