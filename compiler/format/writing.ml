(* A comment at the end of a line, or its continuation on the next line. *)
type behind = {
  comment : string;
  written : int;  (** its column in the source *)
  distance : int;  (** its distance from the preceding word in the source *)
  line : int;  (** its last line in the source *)
}

type line = {
  blank_before : bool;
  column : int;
  shift : int;  (** number of columns by which the line was moved to the right *)
  words : string;
  width : int;  (** width of [words] *)
  behind : behind option;
}

let empty = { blank_before = false; column = 0; shift = 0; words = ""; width = 0; behind = None }
let stop line = line.column + line.width

(* {1 Lines} *)

type state = {
  mutable done_ : line list;  (** finished lines, last one first *)
  mutable now : line option;
  buffer : Buffer.t;  (** the words of the current line *)
  mutable so_far : int;  (** the width of these words *)
  mutable last : Word.t option;
}

let finish state =
  Option.iter
    (fun line ->
      let line = { line with words = Buffer.contents state.buffer; width = state.so_far } in
      state.done_ <- line :: state.done_)
    state.now;
  Buffer.clear state.buffer;
  state.so_far <- 0;
  state.now <- None

let start state line =
  finish state;
  state.now <- Some line

let add state ~gap ~width text =
  for _ = 1 to gap do
    Buffer.add_char state.buffer ' '
  done;
  Buffer.add_string state.buffer text;
  state.so_far <- state.so_far + gap + width

let characters text =
  let n = ref 0 in
  String.iter (fun c -> if not (Basis.Utf8.is_continuation c) then incr n) text;
  !n

(* The column of a comment on its own line: the column of the next line if the comment and that line
   had the same column in the source; otherwise, the column of the block whose items the comment was
   aligned with. *)
let column_of (c : Word.comment) ~below ~ended =
  match below with
  | Some (written, column) when written = c.column -> column
  | _ -> (
      match (List.assoc_opt c.column ended, below) with
      | Some column, _ -> column
      | None, Some (written, column) when c.column < written || List.length ended <= 1 -> column
      | None, _ -> (
          match (List.find_opt (fun (written, _) -> written <= c.column) ended, below) with
          | Some (_, column), _ -> column
          | None, Some (_, column) -> column
          | None, None -> 0))

(* Whether a comment continues the one at the end of the previous line: it does if it is directly
   below that comment, in the same column. *)
let goes_on state (c : Word.comment) =
  match (state.now, state.done_) with
  | Some { behind = Some b; _ }, _ | None, { behind = Some b; _ } :: _ ->
      b.written = c.column && b.line + 1 = c.line && not c.blank_before
  | _ -> false

let comment state ~starts ~below ~ended (c : Word.comment) =
  if c.own_line then (
    let behind = goes_on state c in
    let line = { empty with blank_before = c.blank_before } in
    if behind then
      let b = { comment = c.text; written = c.column; distance = 1; line = c.last_line } in
      start state { line with behind = Some b }
    else start state { line with column = column_of c ~below ~ended };
    if not behind then add state ~gap:0 ~width:(characters c.text) c.text)
  else
    match state.now with
    | Some ({ behind = None; _ } as line) when starts ->
        let distance =
          match state.last with
          | Some w when w.line = c.line -> max 1 (c.column - w.column - w.width)
          | Some _ | None -> 1
        in
        let b = { comment = c.text; written = c.column; distance; line = c.last_line } in
        state.now <- Some { line with behind = Some b }
    | Some ({ behind = Some b; _ } as line) when starts ->
        let b = { b with comment = b.comment ^ " " ^ c.text; line = c.last_line } in
        state.now <- Some { line with behind = Some b }
    | _ -> add state ~gap:1 ~width:(characters c.text) c.text

let lines (read : Reading.t) (placed : Indentation.t) =
  let state = { done_ = []; now = None; buffer = Buffer.create 128; so_far = 0; last = None } in
  Array.iteri
    (fun i (w : Word.t) ->
      let starts = i = 0 || w.starts in
      let below = Some (w.column, placed.columns.(i)) in
      List.iter (comment state ~starts ~below ~ended:placed.ended.(i)) w.comments;
      if starts then (
        let column = placed.columns.(i) in
        start state { empty with blank_before = w.blank_before; column; shift = column - w.column };
        add state ~gap:0 ~width:w.width w.text)
      else add state ~gap:w.gap ~width:w.width w.text;
      state.last <- Some w)
    read.words;
  let ended = placed.ended.(Array.length read.words) in
  List.iter (comment state ~starts:true ~below:None ~ended) read.last;
  finish state;
  Array.of_list (List.rev state.done_)

(* {1 Comments at the ends of lines} *)

(* Groups comments that were aligned in the source: for each line, the index of the first line of
   its group, or -1. *)
let groups lines =
  let n = Array.length lines in
  let written i = Option.map (fun b -> b.written) lines.(i).behind in
  let group = Array.make n (-1) in
  for i = 0 to n - 1 do
    if lines.(i).behind <> None then
      group.(i) <-
        (if i > 0 && written (i - 1) = written i && not lines.(i).blank_before then group.(i - 1)
         else i)
  done;
  group

let least_distance = 2

(* The maximum number of columns by which a single comment may move to align with a neighbouring
   group. *)
let most_joining = 6

let column_of_group lines members =
  match members with
  | [ i ] ->
      let distance = (Option.get lines.(i).behind).distance in
      stop lines.(i) + distance
  | members ->
      let behind i = Option.get lines.(i).behind in
      let first = lines.(List.hd members) in
      let of_words = List.filter (fun i -> lines.(i).width > 0) members in
      let distance =
        List.fold_left (fun least i -> min least (behind i).distance) least_distance of_words
      in
      List.fold_left
        (fun column i -> max column (stop lines.(i) + distance))
        ((behind (List.hd members)).written + first.shift)
        of_words

(* The column of each comment at the end of a line. A single comment next to an aligned group joins
   it if there is room. *)
let columns lines =
  let n = Array.length lines in
  let group = groups lines in
  let members = Hashtbl.create 16 in
  for i = n - 1 downto 0 do
    if group.(i) >= 0 then
      Hashtbl.replace members group.(i)
        (i :: Option.value (Hashtbl.find_opt members group.(i)) ~default:[])
  done;
  let size g = List.length (Hashtbl.find members g) in
  let column = Array.make n 0 and several = Array.make n false in
  for i = 0 to n - 1 do
    if group.(i) = i then
      let members = Hashtbl.find members i in
      let at = column_of_group lines members in
      let is_several = size i > 1 in
      List.iter
        (fun k ->
          column.(k) <- at;
          several.(k) <- is_several)
        members
  done;
  let join i beside =
    if
      beside >= 0 && beside < n
      && group.(i) >= 0
      && group.(beside) >= 0
      && (not several.(i))
      && several.(beside)
      && stop lines.(i) < column.(beside)
      && abs (column.(i) - column.(beside)) <= most_joining
      && not lines.(max i beside).blank_before
    then (
      column.(i) <- column.(beside);
      several.(i) <- true)
  in
  for i = 0 to n - 1 do
    join i (i - 1)
  done;
  for i = n - 1 downto 0 do
    join i (i + 1)
  done;
  column

let text read placed =
  let lines = lines read placed in
  let columns = columns lines in
  let result = Buffer.create 4096 in
  let blanks n =
    for _ = 1 to n do
      Buffer.add_char result ' '
    done
  in
  Array.iteri
    (fun i (line : line) ->
      if line.blank_before && i > 0 then Buffer.add_char result '\n';
      if line.words <> "" then (
        blanks line.column;
        Buffer.add_string result line.words);
      Option.iter
        (fun b ->
          blanks (columns.(i) - if line.words = "" then 0 else stop line);
          Buffer.add_string result b.comment)
        line.behind;
      Buffer.add_char result '\n')
    lines;
  Buffer.contents result
