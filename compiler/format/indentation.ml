open Syntax.Grammar

type t = { columns : int array; ended : (int * int) list array }

(* Indentation of a block relative to the line that opens it, and of a continuation line. *)
let step = 4

(* Indentation of [then], [else] and [where] at the start of a line. *)
let half_step = 2

type bracket = {
  column : int;
  first : bool;  (** whether the bracket is the first word on its line *)
  mutable content : int option;  (** the column of the word after it on the same line *)
  mutable element : int option;  (** the column of the last element that starts a line *)
  is_record : bool;
  commas_first : bool;
}

type kind =
  | Block of { mutable column : int option; mutable written : int; in_ : int option }
      (** [in_]: the column of the [let] that opened the block, if it is the first word on its line
      *)
  | Bracket of bracket
  | If of { then_ : int; blocks : int; mutable else_ : int }
      (** the columns of [then] and [else], and of the line relative to which blocks inside them are
          indented *)
  | Else

type frame = {
  kind : kind;
  mutable base : int;
      (** the column of the line from which continuation lines in this frame are indented *)
  mutable bar : (int * int) option;
      (** the columns, in the source and in the result, of the last [|], or of the [=] of a data
          declaration if there is no [|] yet *)
}

type state = {
  mutable stack : frame list;
  mutable line : int;  (** the column of the current line *)
  mutable base : int;
      (** the column relative to which blocks and brackets opened on this line are indented *)
  mutable opened_by : int;  (** the index of the word that opens the next block *)
  mutable let_ : int option;  (** the column of that word if it is a [let] *)
}

let file () = { kind = Block { column = Some 0; written = 0; in_ = None }; base = 0; bar = None }
let inside state = match state.stack with frame :: _ -> frame | [] -> file ()
let pop state = match state.stack with _ :: (_ :: _ as rest) -> state.stack <- rest | _ -> ()
let push state kind ~base = state.stack <- { kind; base; bar = None } :: state.stack

let rec pop_until state found =
  match state.stack with
  | frame :: _ :: _ when not (found frame.kind) ->
      pop state;
      pop_until state found
  | _ -> ()

let is_block = function Block _ -> true | Bracket _ | If _ | Else -> false
let is_closed_by_comma = function If _ | Else -> true | Block _ | Bracket _ -> false

(* The innermost frame that is not an [if]. *)
let rec around = function
  | { kind = If _ | Else; _ } :: rest -> around rest
  | frame :: _ -> frame
  | [] -> file ()

(* Closes the frames that end before a word. Returns the last of them, and the columns of the closed
   blocks and of the block that contains the word. *)
let close state (w : Word.t) =
  let last = ref None and blocks = ref [] in
  let take () =
    last := Some (inside state);
    (match (inside state).kind with
    | Block { column = Some column; written; _ } -> blocks := (written, column) :: !blocks
    | _ -> ());
    pop state
  in
  for _ = 1 to w.closes do
    pop_until state is_block;
    take ()
  done;
  if w.item && not w.opens then pop_until state is_block;
  (match w.token.token with
  | THEN -> pop_until state (function If _ | Block _ | Bracket _ -> true | Else -> false)
  | ELSE -> pop_until state (function If _ | Block _ | Bracket _ -> true | Else -> false)
  | COMMA | WHERE -> pop_until state (fun kind -> not (is_closed_by_comma kind))
  | RPAREN | RBRACKET | RBRACE -> (
      pop_until state (fun kind -> not (is_closed_by_comma kind));
      match (inside state).kind with Bracket _ -> take () | Block _ | If _ | Else -> ())
  | _ -> ());
  (match (around state.stack).kind with
  | Block { column = Some column; written; _ } -> blocks := (written, column) :: !blocks
  | _ -> ());
  (!last, List.rev !blocks)

(* {1 The column of a line} *)

(* The column relative to which a [where] is indented. Inside a list or record, this is the column
   of the current element if it starts a line. *)
let base_of_where (frame : frame) =
  match frame.kind with
  | Bracket { element = Some column; _ } -> column
  | Bracket _ | Block _ | If _ | Else -> frame.base

let of_item state =
  match state.stack with
  | { kind = Block { column = Some column; _ }; _ } :: _ -> column
  | _ :: outer ->
      let below = around outer in
      if state.opened_by = 1 then base_of_where below + step else max state.base below.base + step
  | [] -> 0

let begins_element (words : Word.t array) i =
  match words.(i - 1).token.token with
  | COMMA | LPAREN | LBRACKET | LBRACE | UNIT_BRACKET -> true
  | _ -> false

(* The column of a line that starts or continues an element of a list inside brackets. *)
let in_bracket (bracket : bracket) ~base ~begins =
  match (begins, bracket.content, bracket.element) with
  | true, Some column, _ -> column
  | false, _, Some column when bracket.is_record && not bracket.commas_first -> column + step
  | _ -> base + step

let of_line state (words : Word.t array) i closed =
  let w = words.(i) in
  let frame = inside state in
  if w.item then of_item state
  else
    match (w.token.token, frame.kind, closed) with
    | THEN, If { then_; _ }, _ -> then_
    | ELSE, If { else_; _ }, _ -> else_
    | IN, _, Some { kind = Block { in_ = Some column; _ }; _ } -> column
    | WHERE, _, _ -> base_of_where frame + half_step
    | (IN | OF), _, _ -> frame.base + half_step
    | (RPAREN | RBRACKET | RBRACE), _, Some { kind = Bracket b; base; _ } ->
        if b.first || b.commas_first then b.column else if b.content = None then base else b.column
    | COMMA, Bracket b, _ -> b.column
    | BAR, _, _ -> (
        match frame.bar with
        | Some (written, column) when written = w.column -> column
        | _ -> frame.base + step)
    | _, Bracket b, _ -> in_bracket b ~base:frame.base ~begins:(begins_element words i)
    | _ -> frame.base + step

(* {1 All lines} *)

let starts_line (words : Word.t array) state i column =
  let w = words.(i) in
  let frame = inside state in
  state.line <- column;
  state.base <- column;
  match (w.token.token, frame.kind) with
  | (THEN | ELSE), If choice ->
      state.base <- column - (choice.then_ - choice.blocks);
      frame.base <- column;
      choice.else_ <- column
  | _, Bracket bracket when i > 0 && begins_element words i -> bracket.element <- Some column
  | _ -> ()

(* For each word, the index of the last word on its line. *)
let ends (words : Word.t array) =
  let n = Array.length words in
  let ends = Array.make n (n - 1) in
  for i = n - 2 downto 0 do
    ends.(i) <- (if words.(i + 1).starts then i else ends.(i + 1))
  done;
  ends

(* Records the column of a word in its frame before its line is broken: a block gets the column of
   its first item, and a bracket gets the column of its first word if that word is on the same
   line. *)
let place state (words : Word.t array) i ~column =
  let w = words.(i) in
  match (inside state).kind with
  | Block block when w.item ->
      if block.column = None then (
        block.column <- Some column;
        block.written <- w.column);
      let column = Option.value block.column ~default:column in
      (inside state).base <- column;
      (inside state).bar <- None;
      state.base <- column
  | Bracket ({ content = None; _ } as b) when not w.starts -> (
      match words.(i - 1).token.token with
      | LPAREN | LBRACKET | LBRACE | UNIT_BRACKET -> b.content <- Some column
      | _ -> ())
  | _ -> ()

(* Opens the frame that a word at [column] starts, if any. *)
let enter state (words : Word.t array) i ~column =
  let w = words.(i) in
  let frame = inside state and first = i = 0 || w.starts in
  match w.token.token with
  | LPAREN | LBRACKET | UNIT_BRACKET | LBRACE ->
      let is_record = w.token.token = LBRACE and commas_first = w.commas_first in
      push state ~base:state.base
        (Bracket { column; first; content = None; element = None; is_record; commas_first })
  | IF ->
      let then_, blocks, else_ =
        if first then (column + half_step, column, column + half_step)
        else if words.(i - 1).token.token = ELSE && words.(i - 1).starts then
          (state.line + half_step, state.line, state.line)
        else (frame.base + step, frame.base + step, frame.base + step)
      in
      push state ~base:frame.base (If { then_; blocks; else_ })
  | ELSE ->
      let base = frame.base in
      (match frame.kind with If _ -> pop state | Block _ | Bracket _ | Else -> ());
      push state ~base Else
  | BAR -> frame.bar <- Some (w.column, column)
  | EQUAL when frame.bar = None -> frame.bar <- Some (w.column, column)
  | _ -> ()

(* Records the keyword that opens the next block, if this word is such a keyword. *)
let announce state (words : Word.t array) i ~column =
  let w = words.(i) in
  match w.token.token with
  | WHERE ->
      state.opened_by <- 1;
      state.let_ <- None
  | DO | OF | LAMBDA_CASE | REC ->
      state.opened_by <- 0;
      state.let_ <- None
  | LET ->
      state.opened_by <- 0;
      state.let_ <- (if i = 0 || w.starts then Some column else None)
  | _ -> ()

let lines ~break (words : Word.t array) =
  let n = Array.length words in
  let ends = ends words in
  let columns = Array.make n 0 and ended = Array.make (n + 1) [] in
  let state = { stack = [ file () ]; line = 0; base = 0; opened_by = 0; let_ = None } in
  let at = ref 0 in
  for i = 0 to n - 1 do
    let w = words.(i) in
    let closed, blocks = close state w in
    ended.(i) <- blocks;
    if w.opens then
      push state (Block { column = None; written = w.column; in_ = state.let_ }) ~base:0;
    if i = 0 || w.starts then (
      let column = of_line state words i closed in
      columns.(i) <- column;
      at := column;
      starts_line words state i column)
    else at := !at + w.gap;
    let column = !at in
    place state words i ~column;
    (if break && (i = 0 || w.starts) then
       let outer = (inside state).base + step and inner = state.base + step in
       Breaking.line words ~first:i ~last:ends.(i) ~column ~outer ~inner);
    enter state words i ~column;
    announce state words i ~column;
    at := !at + w.width
  done;
  let rec blocks = function
    | [] -> []
    | { kind = Block { column = Some column; written; _ }; _ } :: rest ->
        (written, column) :: blocks rest
    | _ :: rest -> blocks rest
  in
  ended.(n) <- blocks state.stack;
  { columns; ended }
