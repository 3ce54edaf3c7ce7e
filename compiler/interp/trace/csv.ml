type t = {
  read : unit -> char option;
  mutable peeked : char option option;  (** what has been looked at *)
  mutable next_line : int;
}

type cell = { column : int; text : string }
type row = { line : int; cells : cell list }
type problem = Unreadable of string | Unclosed_quote | Late_quote | Zero_byte

exception Problem of problem

let peek t =
  match t.peeked with
  | Some c -> c
  | None ->
      let c =
        try t.read () with Sys_error reason -> raise_notrace (Problem (Unreadable reason))
      in
      t.peeked <- Some c;
      c

let advance t = t.peeked <- None
let line t = t.next_line
let reader read = { read; peeked = None; next_line = 1 }

(* A line ends with LF or CRLF. *)
let next_char t =
  let c = peek t in
  advance t;
  if c = Some '\r' && peek t = Some '\n' then (
    advance t;
    Some '\n')
  else c

let skip_byte_order_mark t =
  if peek t = Some '\xef' then
    for _ = 1 to 3 do
      ignore (peek t);
      advance t
    done

(* A row under way. *)
type building = {
  mutable finished : cell list;  (** the last one first *)
  mutable start : int option;  (** where the cell under way starts *)
  mutable column : int;  (** of the next character *)
  mutable blank : bool;  (** the cell under way has begun, with nothing but blanks *)
  text : Buffer.t;  (** of the cell under way *)
}

let finish_cell b =
  let column = Option.value b.start ~default:b.column in
  b.finished <- { column; text = Buffer.contents b.text } :: b.finished;
  b.start <- None;
  b.blank <- false;
  Buffer.clear b.text

(* From behind the opening quote to behind the closing one. *)
let rec quoted t b =
  match next_char t with
  | None -> raise_notrace (Problem Unclosed_quote)
  | Some '\000' -> raise_notrace (Problem Zero_byte)
  | Some '"' when peek t = Some '"' ->
      advance t;
      b.column <- b.column + 2;
      Buffer.add_char b.text '"';
      quoted t b
  | Some '"' -> b.column <- b.column + 1
  | Some c ->
      if c = '\n' then t.next_line <- t.next_line + 1;
      b.column <- b.column + 1;
      Buffer.add_char b.text c;
      quoted t b

(* Whether there is a row. *)
let rec characters t b =
  match next_char t with
  | None ->
      let is_row = b.finished <> [] || b.start <> None in
      if is_row then finish_cell b;
      is_row
  | Some '\000' -> raise_notrace (Problem Zero_byte)
  | Some '\n' ->
      t.next_line <- t.next_line + 1;
      finish_cell b;
      true
  | Some ',' ->
      finish_cell b;
      b.column <- b.column + 1;
      characters t b
  | Some '"' when b.start = None ->
      b.column <- b.column + 1;
      b.start <- Some b.column;
      quoted t b;
      characters t b
  | Some '"' when b.blank -> raise_notrace (Problem Late_quote)
  | Some c ->
      b.blank <- (b.start = None || b.blank) && (c = ' ' || c = '\t');
      if b.start = None then b.start <- Some b.column;
      b.column <- b.column + 1;
      Buffer.add_char b.text c;
      characters t b

let rec next t =
  let b = { finished = []; start = None; column = 1; blank = false; text = Buffer.create 80 } in
  let first_line = t.next_line in
  match
    if first_line = 1 && t.peeked = None then skip_byte_order_mark t;
    characters t b
  with
  | false -> Ok None
  | true -> (
      match b.finished with
      | [ { text = ""; _ } ] -> next t (* an empty line *)
      | cells -> Ok (Some { line = first_line; cells = List.rev cells }))
  | exception Problem problem ->
      let under_way =
        match b.start with
        | Some column -> [ { column; text = Buffer.contents b.text } ]
        | None -> []
      in
      Error ({ line = first_line; cells = List.rev_append b.finished under_way }, problem)
