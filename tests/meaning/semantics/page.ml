type table = { line : int; rows : string list list }

type part =
  | Heading of { line : int; depth : int; text : string }
  | Block of { line : int; language : string; text : string }
  | Table of table
  | Text of { line : int; text : string }

let read file =
  let channel = open_in_bin file in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let starts prefix line =
  String.length line >= String.length prefix && String.sub line 0 (String.length prefix) = prefix

let drop n line = String.sub line n (String.length line - n)

(* A vertical bar after a backslash is part of a cell. *)
let cells row =
  let row = String.trim row in
  let rec go i cell found =
    if i >= String.length row then List.rev found
    else if row.[i] = '\\' && i + 1 < String.length row && row.[i + 1] = '|' then
      go (i + 2) (cell ^ "|") found
    else if row.[i] = '|' then go (i + 1) "" (String.trim cell :: found)
    else go (i + 1) (cell ^ String.make 1 row.[i]) found
  in
  go 1 "" []

let is_rule = List.for_all (fun cell -> cell = "---")

let depth line =
  let rec go n = if n < String.length line && line.[n] = '#' then go (n + 1) else n in
  go 0

let parts text =
  let rec go number found = function
    | [] -> List.rev found
    | line :: rest when starts "```" line ->
        let rec block n lines = function
          | end_ :: rest when end_ = "```" -> (n + 1, List.rev lines, rest)
          | inner :: rest -> block (n + 1) (inner :: lines) rest
          | [] -> failwith (Printf.sprintf "the block of line %d has no end" number)
        in
        let next, lines, rest = block (number + 1) [] rest in
        let text = String.concat "" (List.map (fun inner -> inner ^ "\n") lines) in
        go next (Block { line = number; language = drop 3 line; text } :: found) rest
    | line :: _ as lines when starts "|" line ->
        let rec table n rows = function
          | row :: rest when starts "|" row -> table (n + 1) (cells row :: rows) rest
          | rest -> (n, List.rev rows, rest)
        in
        let next, rows, rest = table number [] lines in
        let rows = List.filter (fun row -> not (is_rule row)) rows in
        go next (Table { line = number; rows } :: found) rest
    | line :: rest when String.trim line = "" -> go (number + 1) found rest
    | line :: rest ->
        let part =
          match depth line with
          | 0 -> Text { line = number; text = line }
          | depth -> Heading { line = number; depth; text = String.trim (drop depth line) }
        in
        go (number + 1) (part :: found) rest
  in
  go 1 [] (String.split_on_char '\n' text)

let code line =
  let rec odd = function _ :: inside :: rest -> inside :: odd rest | [] | [ _ ] -> [] in
  match String.split_on_char '`' line with
  | pieces when List.length pieces mod 2 = 1 -> odd pieces
  | _ -> []
