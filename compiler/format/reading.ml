open Syntax.Grammar
module Lexer = Syntax.Lexer
module Layout = Syntax.Layout

type t = {
  words : Word.t array;
  last : Word.comment list;
  layout : (Syntax.Grammar.token * bool) array;
}

(* {1 Comments} *)

let characters text start stop =
  let n = ref 0 in
  for i = start to stop - 1 do
    if not (Basis.Utf8.is_continuation text.[i]) then incr n
  done;
  !n

let is_blank c = c = ' ' || c = '\t' || c = '\r'

let without_trailing_blanks line =
  let n = ref (String.length line) in
  while !n > 0 && is_blank line.[!n - 1] do
    decr n
  done;
  String.sub line 0 !n

let trimmed comment =
  if String.contains comment '\n' then
    String.split_on_char '\n' comment |> List.map without_trailing_blanks |> String.concat "\n"
  else without_trailing_blanks comment

(* The offset after a comment: the end of the line, or the end of a block comment including nested
   ones. *)
let comment_stop text at =
  let n = String.length text in
  if text.[at] = '-' then
    match String.index_from_opt text at '\n' with Some stop -> stop | None -> n
  else
    let rec go depth i =
      if depth = 0 || i + 1 >= n then min i n
      else
        match (text.[i], text.[i + 1]) with
        | '{', '-' -> go (depth + 1) (i + 2)
        | '-', '}' -> go (depth - 1) (i + 2)
        | _ -> go depth (i + 1)
    in
    go 1 (at + 2)

(* The reader's position in the text. *)
type place = {
  mutable line : int;
  mutable counted : int;
      (** an offset on this line; [characters] is the number of characters before it *)
  mutable characters : int;
  mutable fresh : bool;  (** nothing has been read on this line yet *)
  mutable blank_before : bool;  (** the previous line is empty *)
}

let newline place at =
  place.blank_before <- place.fresh;
  place.line <- place.line + 1;
  place.counted <- at + 1;
  place.characters <- 0;
  place.fresh <- true

let column place text at =
  place.characters <- place.characters + characters text place.counted at;
  place.counted <- at;
  place.characters

(* Reads the comments between two offsets. The text there contains only comments and white space. *)
let comments place text start stop =
  let found = ref [] and at = ref start in
  while !at < stop do
    match text.[!at] with
    | '\n' ->
        newline place !at;
        incr at
    | '-' | '{' ->
        let next = comment_stop text !at in
        let comment = trimmed (String.sub text !at (next - !at)) in
        let column = column place text !at in
        let line = place.line and own_line = place.fresh in
        let blank_before = own_line && place.blank_before in
        place.fresh <- false;
        for i = !at to next - 1 do
          if text.[i] = '\n' then newline place i
        done;
        place.fresh <- false;
        place.blank_before <- false;
        found :=
          { Word.text = comment; line; last_line = place.line; column; own_line; blank_before }
          :: !found;
        at := next
    | _ -> incr at
  done;
  List.rev !found

(* {1 Structure} *)

(* The layout tokens that were inserted before a token. *)
type made = { mutable closes : int; mutable opens : bool; mutable item : bool }

(* An open block or bracket. *)
type frame = { number : int; cases : bool; units : bool; opener : int; mutable types : bool }

type state = {
  mutable stack : frame list;
  mutable frames : int;
  mutable unit_declaration : bool;  (** inside a unit declaration, after its [=] *)
  mutable quoted : bool;  (** between backticks *)
  mutable operand : bool;  (** the previous word ends an operand, so a minus sign here is binary *)
}

let top () = { number = 0; cases = false; units = false; opener = -1; types = false }
let inside state = match state.stack with frame :: _ -> frame | [] -> top ()

let push state ~cases ~units ~opener =
  state.frames <- state.frames + 1;
  let types = opener >= 0 && (inside state).types in
  state.stack <- { number = state.frames; cases; units; opener; types } :: state.stack

let pop state = match state.stack with _ :: (_ :: _ as rest) -> state.stack <- rest | _ -> ()

let ends_operand = function
  | LOWER _ | UPPER _ | QUALIFIED_LOWER _ | QUALIFIED_UPPER _ | FIELD _ | NUMBER _ | STRING _
  | RPAREN | RBRACKET | RBRACE | UNDERSCORE | QUALIFIED | AS ->
      true
  | _ -> false

let no_words : Word.t array = [||]

(* {1 Words} *)

let is_closer = function RPAREN | RBRACKET | RBRACE -> true | _ -> false

let layout_of text =
  let layout = Layout.create (Lexer.create ignore ~file:"" text) in
  let rec go found =
    let token = Layout.next layout in
    let found = token :: found in
    if token.last then Array.of_list (List.rev found) else go found
  in
  go []

(* Removes repeated separators, which enclose empty items. *)
let without_empty_items (tokens : Layout.token array) =
  let add found (t : Layout.token) =
    match (t.token, found) with
    | SEMICOLON, (SEMICOLON, _) :: _ | END, (END, _) :: _ -> found
    | _ -> (t.token, t.made) :: found
  in
  Array.of_list (List.rev (Array.fold_left add [] tokens))

let lexed text =
  let lexer = Lexer.create ignore ~file:"" text in
  let rec go found =
    let token = Lexer.next lexer in
    match token.token with END -> Array.of_list (List.rev found) | _ -> go (token :: found)
  in
  go []

type reader = {
  text : string;
  tokens : Lexer.token array;
  laid_out : Layout.token array;
  state : state;
  place : place;
  mutable from : int;  (** the offset after the previous word *)
  mutable next : int;  (** index of the next layout token *)
  partner : int array;  (** for a bracket, the index of its partner; -1 for other words *)
  commas_first : bool array;  (** whether a bracket contains a comma at the start of a line *)
}

(* Collects the layout tokens before a word, but not before a semicolon in the source. *)
let made_before r index (token : Lexer.token) =
  let at = token.start.pos_cnum in
  let made = { closes = 0; opens = false; item = index = 0 } in
  let rec take () =
    let token : Layout.token = r.laid_out.(r.next) in
    if token.made || token.start.pos_cnum < at then (
      r.next <- r.next + 1;
      (match token.token with
      | OPEN -> made.opens <- true
      | CLOSE when made.opens -> made.opens <- false
      | CLOSE -> made.closes <- made.closes + 1
      | SEMICOLON | END -> made.item <- true
      | _ -> ());
      take ())
    else if token.start.pos_cnum = at then r.next <- r.next + 1
  in
  (match token.token with SEMICOLON -> () | _ -> take ());
  made

(* Opens and closes the blocks before a word. *)
let enter_blocks r index made =
  let state = r.state in
  let before = if index = 0 then END else r.tokens.(index - 1).token in
  for _ = 1 to made.closes do
    pop state
  done;
  if made.opens then
    push state
      ~cases:(match before with OF | LAMBDA_CASE -> true | _ -> false)
      ~units:false ~opener:(-1);
  if made.item || made.opens then (
    state.unit_declaration <- false;
    state.operand <- false;
    (inside state).types <- false)

let close_bracket r index =
  let opener = (inside r.state).opener in
  if opener >= 0 then (
    r.partner.(opener) <- index;
    r.partner.(index) <- opener);
  pop r.state

(* Updates the state for the words after this one. *)
let open_after r index (token : Lexer.token) frame =
  let { number; units; opener; types; cases = _ } = frame in
  match token.token with
  | UNIT_BRACKET -> push r.state ~cases:false ~units:true ~opener:index
  | LPAREN | LBRACKET | LBRACE -> push r.state ~cases:false ~units ~opener:index
  | EQUAL when index >= 2 && r.tokens.(index - 2).token = UNIT && number = 0 ->
      r.state.unit_declaration <- true
  | DOUBLE_COLON -> frame.types <- true
  | COMMA | EQUAL -> frame.types <- opener >= 0 && types && token.token = COMMA
  | _ -> ()

let word r index (token : Lexer.token) : Word.t =
  let state = r.state and place = r.place in
  let at = token.start.pos_cnum and stop = token.stop.pos_cnum in
  let comments = comments place r.text r.from at in
  let first = token.first and blank_before = place.fresh && place.blank_before in
  r.from <- stop;
  place.fresh <- false;
  place.blank_before <- false;
  let made = made_before r index token in
  enter_blocks r index made;
  if is_closer token.token then close_bracket r index;
  let ({ number; cases; units; opener; types } as frame) = inside state in
  if token.token = COMMA && first && opener >= 0 then r.commas_first.(opener) <- true;
  let quoted = state.quoted in
  if token.token = BACKTICK then state.quoted <- not quoted;
  let prefix = token.token = MINUS && not state.operand in
  state.operand <- (not quoted) && ends_operand token.token;
  let in_unit = units || state.unit_declaration || token.token = UNIT_BRACKET in
  open_after r index token frame;
  let written = String.sub r.text at (stop - at) in
  {
    token;
    text = written;
    width = characters written 0 (String.length written);
    line = place.line;
    column = column place r.text at;
    comments;
    blank_before;
    closes = made.closes;
    opens = made.opens;
    item = made.item || made.opens;
    frame = number;
    partner = -1;
    of_cases = cases;
    in_unit;
    prefix;
    in_quotes = quoted;
    in_type = types;
    commas_first = false;
    starts = first;
    gap = 0;
  }

let reader text =
  let tokens = lexed text in
  let n = Array.length tokens in
  {
    text;
    tokens;
    laid_out = layout_of text;
    state =
      { stack = [ top () ]; frames = 0; unit_declaration = false; quoted = false; operand = false };
    place = { line = 1; counted = 0; characters = 0; fresh = true; blank_before = false };
    from = 0;
    next = 0;
    partner = Array.make n (-1);
    commas_first = Array.make n false;
  }

let text text =
  let r = reader text in
  let start = if String.starts_with ~prefix:"\xef\xbb\xbf" text then 3 else 0 in
  r.from <- start;
  r.place.counted <- start;
  let words = if r.tokens = [||] then no_words else Array.mapi (word r) r.tokens in
  Array.iteri
    (fun i (w : Word.t) ->
      let other = r.partner.(i) in
      if other >= 0 then (
        w.partner <- other;
        w.commas_first <- r.commas_first.(min i other)))
    words;
  let last = comments r.place text r.from (String.length text) in
  { words; last; layout = without_empty_items r.laid_out }
