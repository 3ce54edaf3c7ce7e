type t = {
  read : unit -> char option;
  separator : char;
  mutable peeked : char option option;  (** the next character, if it has already been read *)
  mutable next_line : int;
  mutable length : int;  (** length of the current row, in bytes *)
}

let longest = 16 * 1024 * 1024
let most_cells = 1_000_000

type cell = { column : int; text : string }
type row = { line : int; cells : cell list }
type problem = Unreadable of string | Unclosed_quote | Late_quote | Zero_byte | Too_long

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

let advance t =
  t.peeked <- None;
  t.length <- t.length + 1;
  if t.length > longest then raise_notrace (Problem Too_long)

let line t = t.next_line
let reader ?(separator = ',') read = { read; separator; peeked = None; next_line = 1; length = 0 }

(* Reads a character; turns CRLF into LF. *)
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

(* The row being read. *)
type building = {
  mutable count : int;  (** number of finished cells *)
  mutable finished : cell list;  (** finished cells, in reverse order *)
  mutable start : int option;  (** column where the current cell starts *)
  mutable column : int;  (** column of the next character *)
  mutable blank : bool;  (** whether the current cell is all whitespace so far *)
  text : Buffer.t;  (** text of the current cell *)
}

let finish_cell b =
  let column = Option.value b.start ~default:b.column in
  b.finished <- { column; text = Buffer.contents b.text } :: b.finished;
  b.count <- b.count + 1;
  if b.count > most_cells then raise_notrace (Problem Too_long);
  b.start <- None;
  b.blank <- false;
  Buffer.clear b.text

(* Reads the rest of a quoted cell, including the closing quote. *)
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

(* Reads the rest of a row. Returns false if the file ends before a row begins. *)
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
  | Some c when c = t.separator ->
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
  let text = Buffer.create 80 in
  let b = { count = 0; finished = []; start = None; column = 1; blank = false; text } in
  let first_line = t.next_line in
  t.length <- 0;
  match
    if first_line = 1 && t.peeked = None then skip_byte_order_mark t;
    characters t b
  with
  | false -> Ok None
  | true -> (
      match b.finished with
      | [ { text = ""; _ } ] -> next t (* skips an empty line *)
      | cells -> Ok (Some { line = first_line; cells = List.rev cells }))
  | exception Problem problem ->
      let under_way =
        match b.start with
        | Some column -> [ { column; text = Buffer.contents b.text } ]
        | None -> []
      in
      Error ({ line = first_line; cells = List.rev_append b.finished under_way }, problem)
