open Basis

let indentation line =
  let rec go i = if i < String.length line && line.[i] = ' ' then go (i + 1) else i in
  let i = go 0 in
  if String.trim line = "" then None else Some i

(* Blocks: a line and the more deeply indented lines that follow it. *)
let blocks lines =
  let n = Array.length lines in
  let last_of i indent =
    let rec go j last =
      if j >= n then last
      else
        match indentation lines.(j) with
        | None -> go (j + 1) last
        | Some other when other > indent -> go (j + 1) j
        | Some _ -> last
    in
    go (i + 1) i
  in
  List.concat
    (List.init n (fun i ->
         match indentation lines.(i) with
         | Some indent when last_of i indent > i -> [ (i, last_of i indent, None) ]
         | Some _ | None -> []))

(* Sequences of lines that start with [prefix]. *)
let runs lines ~prefix ~kind =
  let n = Array.length lines in
  let rec go i found =
    if i >= n then found
    else if String.starts_with ~prefix (String.trim lines.(i)) then
      let rec stop j =
        if j < n && String.starts_with ~prefix (String.trim lines.(j)) then stop (j + 1) else j
      in
      let behind = stop i in
      go behind (if behind - i > 1 then (i, behind - 1, Some kind) :: found else found)
    else go (i + 1) found
  in
  go 0 []

let lines_of text = Array.of_list (String.split_on_char '\n' text)
let most_lines = 20_000

let ranges (doc : Document.t) : Json.t =
  let lines = lines_of (Text.contents doc.text) in
  if Array.length lines > most_lines then List []
  else
    let json (first, last, kind) : Json.t =
      Object
        ([ ("startLine", Json.Int first); ("endLine", Int last) ]
        @ Option.fold kind ~none:[] ~some:(fun kind -> [ ("kind", Json.String kind) ]))
    in
    List
      (List.map json
         (blocks lines
         @ runs lines ~prefix:"--" ~kind:"comment"
         @ runs lines ~prefix:"import " ~kind:"imports"))

(* {1 Selection ranges} *)

let word text offset =
  let n = String.length text in
  let rec back i = if i > 0 && Basis.Character.is_name text.[i - 1] then back (i - 1) else i in
  let rec forth i = if i < n && Basis.Character.is_name text.[i] then forth (i + 1) else i in
  (back offset, forth offset)

let line text offset =
  let n = String.length text in
  let rec back i = if i > 0 && text.[i - 1] <> '\n' then back (i - 1) else i in
  let rec forth i = if i < n && text.[i] <> '\n' then forth (i + 1) else i in
  let start = back offset and stop = forth offset in
  let rec first i = if i < stop && text.[i] = ' ' then first (i + 1) else i in
  (min (first start) offset, stop)

let without_last_blanks text (start, stop) =
  let is_blank c = c = '\n' || c = '\r' || c = ' ' in
  let rec back i = if i > start && is_blank text.[i - 1] then back (i - 1) else i in
  (start, back stop)

(* The ranges of the expressions around the offset, taken from the typed tree. *)
let expressions (doc : Document.t) offset =
  match Document.types doc with
  | None -> []
  | Some seen -> (
      match (View.facts seen.view, View.position seen offset) with
      | Some facts, Some position ->
          List.filter_map (View.range seen) (Place_types.spans_at facts position)
      | _ -> [])

let selections ws (doc : Document.t) params : Json.t =
  let text = Text.contents doc.text in
  let n = String.length text in
  let of_position json : Json.t =
    let offset = Workspace.offset ws doc.text json in
    let whole =
      [
        word text offset;
        line text offset;
        without_last_blanks text (Tokens.item text offset);
        (0, n);
      ]
      @ expressions doc offset
    in
    let around (start, stop) = start <= offset && offset <= stop in
    let by_length (a, b) (c, d) = compare (b - a, a) (d - c, c) in
    (* Keeps only ranges that contain the previous one. *)
    let rec nest inner = function
      | [] -> []
      | (start, stop) :: rest ->
          if start <= fst inner && snd inner <= stop && (start, stop) <> inner then
            (start, stop) :: nest (start, stop) rest
          else nest inner rest
    in
    let all = List.sort_uniq by_length (List.filter around whole) in
    let chain =
      match all with [] -> [ (offset, offset) ] | first :: rest -> first :: nest first rest
    in
    let json parent range : Json.t =
      Object
        (("range", Workspace.range ws doc.text range)
        :: Option.fold parent ~none:[] ~some:(fun parent -> [ ("parent", parent) ]))
    in
    Option.get (List.fold_left (fun parent range -> Some (json parent range)) None (List.rev chain))
  in
  List (List.map of_position (Json.list (Json.member "positions" params)))
