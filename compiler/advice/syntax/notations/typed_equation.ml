open Basis

type t = {
  first : int;
  start : int;
  stop : int;
  type_ : string;
  name : string;
  sign : string;
  value : string;
  in_a_let : bool;
}

let is_a_type text =
  text <> ""
  && Character.is_upper text.[0]
  && String.for_all (fun c -> Character.is_name c || String.contains " []()/^." c) text

let blanks line =
  let rec go i = if i < String.length line && line.[i] = ' ' then go (i + 1) else i in
  go 0

(* The right-hand side, without the `;` at its end and without the `in` of a `let`. *)
let value_of rest =
  let rest =
    String.trim (Option.fold (Text_place.find " -- " rest) ~none:rest ~some:(String.sub rest 0))
  in
  let rest = Option.fold (Text_place.find " in " rest) ~none:rest ~some:(String.sub rest 0) in
  let rest = Text_place.without_closing rest in
  let n = String.length rest in
  String.trim (if n > 0 && rest.[n - 1] = ';' then String.sub rest 0 (n - 1) else rest)

let rec without_needless line at =
  let rec stop i = if i < String.length line && line.[i] <> ' ' then stop (i + 1) else i in
  let last = stop at in
  if List.mem (String.sub line at (last - at)) Beginnings.needless then
    without_needless line (min (last + 1) (String.length line))
  else at

let split line sign =
  let line = line ^ " " in
  Option.map
    (fun at ->
      let rest = at + String.length sign in
      (String.trim sign, String.sub line 0 at, String.sub line rest (String.length line - rest)))
    (Text_place.find sign line)

let typed is_a_type line =
  let open Basis.Let_syntax.Option in
  (* the [=] or [<-] may be at the end of the line *)
  let line = line ^ " " in
  let* sign, left, rest =
    match split line " = " with Some it -> Some it | None -> split line " <- "
  in
  let left = String.trim left |> fun t -> String.make (blanks line) ' ' ^ t in
  let* last = String.rindex_opt left ' ' in
  let name = String.sub left (last + 1) (String.length left - last - 1) in
  let first = blanks line in
  let start = without_needless left first in
  let type_ = if start < last then String.trim (String.sub left start (last - start)) else "" in
  let in_a_let = String.starts_with ~prefix:"let " (String.trim left) in
  if Text_place.is_a_name name && is_a_type type_ then
    Some { first; start; stop = last + 1; type_; name; sign; value = value_of rest; in_a_let }
  else None

let of_line line = typed is_a_type line

let of_c line =
  let is_word word = word <> "" && String.for_all Character.is_name word in
  typed (fun text -> List.for_all is_word (String.split_on_char ' ' text)) line

let of_colon line =
  let open Basis.Let_syntax.Option in
  let* colon = String.index_opt line ':' in
  let name = String.trim (String.sub line 0 colon) in
  let* sign, type_, rest =
    split (String.sub line (colon + 1) (String.length line - colon - 1) ^ " ") " = "
  in
  let type_ = String.trim type_ in
  if Text_place.is_a_name name && is_a_type type_ then
    Some
      {
        first = blanks line;
        start = colon;
        stop = colon;
        type_;
        name;
        sign;
        value = value_of rest;
        in_a_let = false;
      }
  else None

let longest = 70

(* Is the text a whole expression, rather than one that continues on the next line? *)
let is_whole value =
  let count c = List.length (String.split_on_char c value) in
  let words = String.split_on_char ' ' value in
  let last = List.nth words (List.length words - 1) in
  count '(' = count ')'
  && count '[' = count ']'
  && List.mem "if" words = List.mem "else" words
  && (not (List.mem "case" words))
  && last <> ""
  && (Character.is_name last.[String.length last - 1]
     || List.mem last.[String.length last - 1] [ ')'; ']'; '}'; '"' ])

let equation { name; sign; value; _ } =
  let value = if (not (is_whole value)) || String.length value > longest then "…" else value in
  Printf.sprintf "%s %s %s" name sign value

let without_type typed = Printf.sprintf "write `%s`, without a type" (equation typed)

let advice typed =
  if typed.in_a_let then Printf.sprintf "write `let %s`, without a type" (equation typed)
  else if String.equal typed.sign "=" then
    Printf.sprintf "write `%s`; to give its type, write `%s :: %s` on a line of its own above it"
      (equation typed) typed.name typed.type_
  else without_type typed

let alone line =
  let line = String.trim line in
  Option.bind (String.rindex_opt line ' ') (fun last ->
      let type_ = String.trim (String.sub line 0 last) in
      let name = value_of (String.sub line (last + 1) (String.length line - last - 1)) in
      if Text_place.is_a_name name && is_a_type type_ then
        Some (Printf.sprintf "%s :: %s" name type_)
      else None)

let rec pairs = function
  | type_ :: name :: rest when is_a_type type_ && Text_place.is_a_name name ->
      Option.map (List.cons (type_, name)) (pairs rest)
  | [] -> Some []
  | _ -> None

let definition ~name ?(result = "…") ~value parameters =
  Printf.sprintf "write `%s = %s`, and put the types in a signature above it: `%s :: %s`"
    (String.concat " " (name :: List.map snd parameters))
    value name
    (String.concat " -> " (List.map fst parameters @ [ result ]))

let of_words line =
  let open Basis.Let_syntax.Option in
  let* _, left, rest = split line " = " in
  let blank = function '(' | ')' | ',' -> ' ' | c -> c in
  let words = List.filter (( <> ) "") (String.split_on_char ' ' (String.map blank left)) in
  let value = value_of rest in
  let value = if is_whole value && String.length value <= longest then value else "…" in
  let* name, result, parameters =
    match words with
    | name :: rest when Text_place.is_a_name name ->
        Option.map (fun all -> (name, None, all)) (pairs rest)
    | result :: name :: rest when is_a_type result && Text_place.is_a_name name ->
        Option.map (fun all -> (name, Some result, all)) (pairs rest)
    | _ -> None
  in
  if parameters = [] then None else Some (definition ~name ?result ~value parameters)

let of_parameters line =
  let open Basis.Let_syntax.Option in
  let* opening = String.index_opt line '(' in
  let* closing = String.index_from_opt line opening ')' in
  let name = String.trim (String.sub line 0 opening) in
  let* _, between, rest =
    split (String.sub line (closing + 1) (String.length line - closing - 1) ^ " ") "= "
  in
  let parameter text =
    match String.rindex_opt (String.trim text) ' ' with
    | Some last ->
        let text = String.trim text in
        let type_ = String.trim (String.sub text 0 last) in
        let name = String.sub text (last + 1) (String.length text - last - 1) in
        if Text_place.is_a_name name && is_a_type type_ then Some (type_, name) else None
    | None -> None
  in
  let all = String.split_on_char ',' (String.sub line (opening + 1) (closing - opening - 1)) in
  let parameters = List.filter_map parameter all in
  if
    Text_place.is_a_name name && String.trim between = "" && List.compare_lengths parameters all = 0
  then
    let value = value_of rest in
    let value = if is_whole value then value else "…" in
    let words = name :: List.map snd parameters in
    Some
      (Printf.sprintf "write `%s = %s`, and put the types in a signature above it: `%s :: %s -> …`"
         (String.concat " " words) value name
         (String.concat " -> " (List.map fst parameters)))
  else None
