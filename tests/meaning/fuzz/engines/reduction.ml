let lines text = String.split_on_char '\n' text

let paragraphs text =
  let close own found =
    match own with [] -> found | _ -> String.concat "\n" (List.rev own) :: found
  in
  let rec go own found = function
    | [] -> List.rev (close own found)
    | "" :: lines -> go [] (close own found) lines
    | line :: lines -> go (line :: own) found lines
  in
  go [] [] (lines text)

let without_some ~separator parts good =
  let rec drop first count = function
    | [] -> []
    | part :: parts ->
        if first > 0 then part :: drop (first - 1) count parts
        else if count > 0 then drop 0 (count - 1) parts
        else part :: parts
  in
  let rec search parts chunk first =
    let length = List.length parts in
    if first >= length then if chunk > 1 then search parts (chunk / 2) 0 else parts
    else
      let fewer = drop first chunk parts in
      if good (String.concat separator fewer) then search fewer chunk first
      else search parts chunk (first + chunk)
  in
  search parts (max 1 (List.length parts / 2)) 0

(* {1 Parentheses} *)

let opens c = c = '(' || c = '[' || c = '{'
let closes c = c = ')' || c = ']' || c = '}'

(* The index of the bracket that closes the one at [i]. *)
let partner text i =
  let rec go i depth =
    if i >= String.length text then None
    else if opens text.[i] then go (i + 1) (depth + 1)
    else if closes text.[i] then if depth = 1 then Some i else go (i + 1) (depth - 1)
    else go (i + 1) depth
  in
  go i 0

(* Splits a text at separators outside all brackets. *)
let split text separators =
  let pieces = ref [] and start = ref 0 and depth = ref 0 in
  let close i =
    if i > !start then pieces := String.sub text !start (i - !start) :: !pieces;
    start := i + 1
  in
  String.iteri
    (fun i c ->
      if opens c then incr depth
      else if closes c then decr depth
      else if !depth = 0 && List.mem c separators then close i)
    text;
  close (String.length text);
  List.rev !pieces

let is_bracketed piece = String.length piece > 1 && opens piece.[0]

let is_word piece =
  String.length piece > 0
  && String.for_all
       (fun c ->
         ('a' <= c && c <= 'z')
         || ('A' <= c && c <= 'Z')
         || ('0' <= c && c <= '9')
         || c = '.' || c = '_')
       piece

let is_keyword piece =
  List.mem piece [ "if"; "then"; "else"; "case"; "of"; "let"; "in"; "do"; "proc"; "where" ]

(* Replacements for an expression of any type. *)
let simplest =
  [ "()"; "0"; "True"; "False"; "NoEvent"; "Nothing"; "1"; "1.5"; "[0]"; "identity"; "never" ]

(* The text before the first [word] outside all brackets. *)
let before word pieces =
  let rec go own = function
    | [] -> None
    | piece :: _ when String.equal piece word -> Some (List.rev own)
    | piece :: others -> go (piece :: own) others
  in
  go [] pieces

let without_each joined pieces =
  List.mapi (fun k _ -> joined (List.filteri (fun i _ -> i <> k) pieces)) pieces

(* Smaller replacements for a text in brackets. *)
let instead group =
  let inside = String.sub group 1 (String.length group - 2) in
  let words = split inside [ ' '; ',' ] in
  let parts = List.filter (fun p -> is_bracketed p || (is_word p && not (is_keyword p))) words in
  let unannotated =
    match before "::" (split inside [ ' ' ]) with
    | Some pieces -> [ "(" ^ String.concat " " pieces ^ ")" ]
    | None -> []
  in
  let fewer_branches =
    match split inside [ ';' ] with
    | [] | [ _ ] -> []
    | first :: branches ->
        List.map
          (fun branches -> "(" ^ String.concat ";" (first :: branches) ^ ")")
          (without_each Fun.id branches)
  in
  List.filter
    (fun text -> String.length text < String.length group)
    (simplest @ parts @ unannotated @ fewer_branches)

let at text i =
  let rec find i =
    if i >= String.length text then None
    else if opens text.[i] && text.[i] <> '{' then
      match partner text i with
      | Some last ->
          let group = String.sub text i (last - i + 1) in
          let start = String.sub text 0 i
          and rest = String.sub text (last + 1) (String.length text - last - 1) in
          Some (i, List.map (fun other -> start ^ other ^ rest) (instead group))
      | None -> find (i + 1)
    else find (i + 1)
  in
  find i
