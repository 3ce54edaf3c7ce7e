open Syntax

type t = {
  text : string;
  state : int;
  before : Layout.token option;
  token : Layout.token;
  context : Layout.context;
}

type rule = t -> string option

let rec innermost : Layout.context -> (Layout.block * Layout.origin) option = function
  | (Block block, origin) :: _ -> Some (block, origin)
  | ((Paren | Bracket | Brace | If | Then | Case), _) :: rest -> innermost rest
  | [] -> None

let innermost_block context = match innermost context with Some (block, _) -> block | None -> Top

let written found (t : Layout.token) =
  String.sub found.text t.start.pos_cnum (t.stop.pos_cnum - t.start.pos_cnum)

let char_at found offset =
  if offset >= 0 && offset < String.length found.text then found.text.[offset] else '\n'

let after found = char_at found found.token.stop.pos_cnum
let is_blank = function ' ' | '\t' | '\n' | '\r' -> true | _ -> false
let is_symbol c = String.contains "+-*/^=<>&|!.@:$" c

let in_brackets : Layout.context -> bool = function
  | ((Paren | Bracket | Brace), _) :: _ -> true
  | _ -> false

let opens_with opener : Layout.context -> bool = function
  | (innermost, _) :: _ -> innermost = opener
  | [] -> false

(* Does the context require a value, so that a definition cannot occur here? *)
let compares : Layout.context -> bool = function
  | ((Paren | If | Then | Case), _) :: _ -> true
  | ((Bracket | Brace | Block _), _) :: _ | [] -> false

let is_adjacent found (before : Layout.token) = before.stop.pos_cnum = found.token.start.pos_cnum

(* The start and end of the word at this offset. *)
let word_from found first =
  let rec stop i = match char_at found i with 'a' .. 'z' | 'A' .. 'Z' -> stop (i + 1) | _ -> i in
  (first, stop first)

let rec first_word_from found i =
  if char_at found i = ' ' then first_word_from found (i + 1) else word_from found i

let part found (first, last) = String.sub found.text first (last - first)

(* The word at the left margin of the token's line, often a keyword from another language. *)
let first_word found = part found (word_from found found.token.start.pos_bol)
let first_word_of_line found = part found (first_word_from found found.token.start.pos_bol)

(* The word before this offset, possibly separated from it by whitespace. *)
let word_before found offset =
  let rec blanks i = if i > 0 && is_blank (char_at found (i - 1)) then blanks (i - 1) else i in
  let stop = blanks offset in
  let rec start i =
    match char_at found (i - 1) with
    | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> start (i - 1)
    | _ -> i
  in
  let start = start stop in
  String.sub found.text start (stop - start)

let stands_after found word (t : Layout.token) =
  String.equal (word_before found t.start.pos_cnum) word

(* The start of the top-level definition that contains the token. *)
let start_of_definition found =
  let rec start i =
    if i = 0 then 0
    else if found.text.[i - 1] = '\n' && not (is_blank (char_at found i)) then i
    else start (i - 1)
  in
  start found.token.start.pos_bol

let first_line_of_definition found =
  let first = start_of_definition found in
  let last =
    Option.value (String.index_from_opt found.text first '\n') ~default:(String.length found.text)
  in
  String.sub found.text first (last - first)

let between found first last = String.trim (String.sub found.text first (max 0 (last - first)))

(* The end of the line that contains this offset. *)
let rec end_of_line found i = if char_at found i = '\n' then i else end_of_line found (i + 1)

let lines_between found first last =
  let count = ref 0 in
  String.iter (fun c -> if c = '\n' then incr count) (String.sub found.text first (last - first));
  !count

let names_before found word =
  let start = found.token.start.pos_bol in
  let line = String.sub found.text start (found.token.start.pos_cnum - start) in
  List.mem word (String.split_on_char ' ' line)

let span (t : Layout.token) = Build.span (t.start, t.stop)
let opener_span ({ by; _ } : Layout.origin) = Build.span (by.start, by.stop)
