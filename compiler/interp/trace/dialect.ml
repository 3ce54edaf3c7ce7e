type t = {
  separator : char;
  decimal_comma : bool;
  time_column : string option;
  columns : (string * string) list;
}

let ours = { separator = ','; decimal_comma = false; time_column = None; columns = [] }
let names t = t.time_column <> None || t.columns <> []

let arguments t =
  (if t.separator = ',' then [] else [ "--separator"; String.make 1 t.separator ])
  @ (if t.decimal_comma then [ "--decimal-comma" ] else [])
  @ Option.fold ~none:[] ~some:(fun name -> [ "--time-column"; name ]) t.time_column
  @ List.concat_map (fun (name, column) -> [ "--column"; name ^ "=" ^ column ]) t.columns

(* {1 Translating} *)

let position holds list =
  let rec from k = function
    | [] -> None
    | first :: rest -> if holds first then Some k else from (k + 1) rest
  in
  from 0 list

let to_front k list =
  match List.nth_opt list k with
  | Some one when k > 0 -> one :: List.filteri (fun i _ -> i <> k) list
  | Some _ | None -> list

type name = Theirs of string | Ours of string

let text (Theirs name | Ours name) = name

let separator_hint t names =
  let first = List.hd names in
  let has c = t.separator <> c && String.contains first c in
  if has ';' then Some "; its columns are separated by semicolons: add `--separator ';'`"
  else if has '\t' then Some "; its columns are separated by tabs: add `--separator tab`"
  else if has ',' then Some "; its columns are separated by commas: remove `--separator`"
  else None

let header t names =
  let find option column names =
    match position (( = ) (Theirs column)) names with
    | Some k -> Ok k
    | None ->
        let quoted name = Printf.sprintf "`%s`" (text name) in
        Error
          (Printf.sprintf "there is no column `%s` for `%s`; the columns are %s%s" column option
             (String.concat ", " (List.map quoted names))
             (Option.value ~default:"" (separator_hint t (List.map text names))))
  in
  let open Basis.Let_syntax.Result in
  let rename k name names = List.mapi (fun i one -> if i = k then Ours name else one) names in
  let names = List.map (fun name -> Theirs name) names in
  let* time =
    Option.fold t.time_column ~none:(Ok 0) ~some:(fun column -> find "--time-column" column names)
  in
  let* names =
    List.fold_left
      (fun names (name, column) ->
        let* names = names in
        let* k = find "--column" column names in
        Ok (rename k name names))
      (Ok names) t.columns
  in
  let names = to_front time names in
  Ok (time, List.map text (if t.time_column = None then names else rename 0 "time" names))

let decimal_comma text =
  let n = String.length text in
  let rec digits k = if k < n && text.[k] >= '0' && text.[k] <= '9' then digits (k + 1) else k in
  let is_digit k = digits k > k in
  let sign k = if k < n && (text.[k] = '-' || text.[k] = '+') then k + 1 else k in
  let comma = digits (sign 0) in
  if not (comma < n && text.[comma] = ',' && is_digit (comma + 1)) then None
  else
    let rest = digits (comma + 1) in
    let is_number =
      rest = n
      || (text.[rest] = 'e' || text.[rest] = 'E')
         &&
         let exponent = sign (rest + 1) in
         is_digit exponent && digits exponent = n
    in
    if is_number then Some comma else None

let cell t text =
  match if t.decimal_comma then decimal_comma text else None with
  | Some comma -> String.mapi (fun i c -> if i = comma then '.' else c) text
  | None -> text

(* {1 Suggesting options} *)

let has_word word name =
  let name = String.lowercase_ascii name and n = String.length word in
  let rec from k = k + n <= String.length name && (String.sub name k n = word || from (k + 1)) in
  from 0

let is_word words name = List.mem (String.lowercase_ascii name) words

let looks_like_time names =
  let like name =
    has_word "time" name || has_word "stamp" name || is_word [ "t"; "sec"; "secs"; "seconds" ] name
  in
  match List.find_opt (is_word [ "time" ]) names with
  | Some name -> Some name
  | None -> List.find_opt like names

let time_hint t names =
  match (separator_hint t names, looks_like_time names) with
  | Some hint, _ -> hint
  | None, None -> "; to choose the column with the times, add `--time-column NAME`"
  | None, Some name ->
      Printf.sprintf "; to choose the column with the times, add `--time-column %s`"
        (Basis.Printable.word name)

let column_hint ~missing ~unknown =
  match unknown with
  | [] -> ""
  | _ ->
      let column = match unknown with [ one ] -> one | _ -> "NAME" in
      Printf.sprintf "; to read it from another column, add `--column %s`"
        (Basis.Printable.word (missing ^ "=" ^ column))

let width_hint t ~width ~cells =
  if cells <= width then ""
  else if t.decimal_comma && t.separator = ',' then
    "; if numbers have a decimal comma, put them in double quotes, or separate the cells by `;` \
     and add `--separator ';'`"
  else "; put a cell that contains a comma in double quotes"

let number_hint t text =
  if (not t.decimal_comma) && decimal_comma text <> None then
    "; for numbers with a decimal comma, add `--decimal-comma`"
  else ""
