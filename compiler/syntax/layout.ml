open Grammar

type block = Top | Let | Where | Do | Of | Rec
type opener = Block of block | Paren | Bracket | Brace | If | Then | Case
type origin = { by : Lexer.token; column : int }
type context = (opener * origin) list

(* The closing tokens that have a partner at this entry or below it. A bracket hides everything that
   was opened before it. *)
type reach = { bracket : opener option; let_ : bool; if_ : bool; then_ : bool; case : bool }

type entry = {
  opener : opener;
  by : Lexer.token;
  column : int;  (** column of the innermost block at this entry or below it *)
  reach : reach;
  depth : int;
}

type token = {
  token : Grammar.token;
  start : Lexing.position;
  stop : Lexing.position;
  made : bool;
  column : int;
  first : bool;
  around : entry list;
  last : bool;
}

type t = {
  lexer : Lexer.t;
  mutable stack : entry list;
      (** the bottom entry is [Block Top]; empty only before the first token *)
  mutable opening : (block * Lexer.token) option;  (** the next token opens this block *)
  mutable header : bool;  (** between [module] and its [where] *)
  mutable data : bool;  (** within a [data] declaration *)
  mutable item_start : bool;
      (** no token of the current item of the innermost block has been read *)
  mutable doc : string option;
      (** the doc comment to insert before the constructor after the next [|] or [=] *)
  mutable outer : entry list;  (** the stack before the current token *)
  mutable before : Lexing.position;  (** end of the last token from the text *)
  ready : token Queue.t;  (** tokens inserted by layout, and the tokens to return after them *)
}

exception Too_deep of Lexer.token

let deepest = 10_000

let create lexer =
  {
    lexer;
    stack = [];
    opening = None;
    header = false;
    data = false;
    item_start = true;
    doc = None;
    outer = [];
    before = Lexing.dummy_pos;
    ready = Queue.create ();
  }

let copy t = { t with lexer = Lexer.copy t.lexer; ready = Queue.copy t.ready }

let context token =
  let origin (entry : entry) = { by = entry.by; column = entry.column } in
  Basis.Long_list.map (fun (entry : entry) -> (entry.opener, origin entry)) token.around

let nothing = { bracket = None; let_ = false; if_ = false; then_ = false; case = false }

let push t opener by ~column =
  let below, depth =
    match t.stack with [] -> (nothing, 0) | entry :: _ -> (entry.reach, entry.depth)
  in
  if depth >= deepest then raise (Too_deep by);
  let reach =
    match opener with
    | Paren | Bracket | Brace -> { nothing with bracket = Some opener }
    | Block Let -> { below with let_ = true }
    | If -> { below with if_ = true }
    | Then -> { below with then_ = true }
    | Case -> { below with case = true }
    | Block (Top | Where | Do | Of | Rec) -> below
  in
  t.stack <- { opener; by; column; reach; depth = depth + 1 } :: t.stack

let block_column t = match t.stack with [] -> 0 | entry :: _ -> entry.column
let reach t = match t.stack with [] -> nothing | entry :: _ -> entry.reach

let emit t token =
  Queue.add
    {
      token;
      start = t.before;
      stop = t.before;
      made = true;
      column = 0;
      first = false;
      around = t.outer;
      last = false;
    }
    t.ready

(* Pops one entry. If the entry is a block, emits [CLOSE]. *)
let pop t =
  match t.stack with
  | [] -> ()
  | entry :: rest ->
      (match entry.opener with
      | Block _ -> emit t CLOSE
      | Paren | Bracket | Brace | If | Then | Case -> ());
      t.stack <- rest

let rec pop_until t found =
  match t.stack with
  | entry :: _ when not (found entry.opener) ->
      pop t;
      pop_until t found
  | _ -> ()

let is_block = function Block _ -> true | Paren | Bracket | Brace | If | Then | Case -> false
let is_bracket = function Paren | Bracket | Brace -> true | Block _ | If | Then | Case -> false

(* Starts a new item in the innermost block. Pops the openers that the old item contains, except
   blocks, and leaves them unmatched. *)
let separate t =
  let rec blocks = function
    | entry :: rest when not (is_block entry.opener) -> blocks rest
    | stack -> stack
  in
  t.stack <- blocks t.stack;
  t.item_start <- true;
  match t.stack with
  | { opener = Block Top; _ } :: _ ->
      t.data <- false;
      t.header <- false;
      emit t END
  | _ -> emit t SEMICOLON

let rec at_top = function
  | [] -> true
  | { opener = Block Top; _ } :: _ -> true
  | { opener = Block _; _ } :: _ -> false
  | _ :: rest -> at_top rest

(* Applies the layout rule to the first token of a line. *)
let rec line_starts t column =
  if at_top t.stack then (if column <= block_column t then separate t)
  else if column = block_column t then separate t
  else if column < block_column t then (
    pop_until t is_block;
    pop t;
    line_starts t column)

(* Recognizes the opener that this token closes, if there is one. *)
let partner t (token : Grammar.token) : (opener -> bool) option =
  let reach = reach t in
  let if_ found test = if found then Some test else None in
  match token with
  | IN -> if_ reach.let_ (function Block Let -> true | _ -> false)
  | THEN -> if_ reach.if_ (function If -> true | _ -> false)
  | ELSE -> if_ reach.then_ (function Then -> true | _ -> false)
  | OF -> if_ reach.case (function Case -> true | _ -> false)
  | COMMA -> if_ (Option.is_some reach.bracket) is_bracket
  | RPAREN -> if_ (match reach.bracket with Some Paren -> true | _ -> false) is_bracket
  | RBRACKET -> if_ (match reach.bracket with Some Bracket -> true | _ -> false) is_bracket
  | RBRACE -> if_ (match reach.bracket with Some Brace -> true | _ -> false) is_bracket
  | _ -> None

(* A [where] at the item column of a block closes that block. It also closes a [do], because
   statements cannot have a [where]. *)
let rec where_closes t (token : Lexer.token) =
  match t.stack with
  | { opener = Block (Do | Rec); _ } :: _ ->
      pop t;
      where_closes t token
  | _ when token.first && (not (at_top t.stack)) && token.column <= block_column t ->
      pop_until t is_block;
      pop t;
      where_closes t token
  | _ -> ()

let of_text t (token : Lexer.token) ~last =
  {
    token = token.token;
    start = token.start;
    stop = token.stop;
    made = false;
    column = token.column;
    first = token.first;
    around = t.outer;
    last;
  }

let emit_doc t (token : Lexer.token) =
  let of_item =
    match (t.stack, token.token) with
    | _, (MODULE | IMPORT | END) -> false
    | { opener = Block (Top | Let | Where); _ } :: _, _ -> t.item_start
    | _ -> false
  in
  let doc = match token.doc with None -> t.doc | Some _ as doc -> doc in
  let of_constructor = t.data && t.doc <> None in
  t.doc <- None;
  match (doc, token.token) with
  | Some _, (BAR | EQUAL) when t.data -> t.doc <- doc
  | Some text, _ when of_item || of_constructor ->
      Queue.add
        {
          token = DOC text;
          start = token.start;
          stop = token.start;
          made = true;
          column = 0;
          first = false;
          around = t.outer;
          last = false;
        }
        t.ready
  | _ -> ()

(* Pushes an entry if the token is an opener. Called after the inserted tokens before it have been
   emitted. [if_]: the [if] that a [then] belongs to. *)
let opens t (token : Lexer.token) ~if_ =
  let column = block_column t in
  match token.token with
  | LPAREN -> push t Paren token ~column
  | UNIT_BRACKET | LBRACKET -> push t Bracket token ~column
  | LBRACE -> push t Brace token ~column
  | IF -> push t If token ~column
  | THEN -> push t Then if_ ~column
  | CASE -> push t Case token ~column
  | LAMBDA_CASE -> t.opening <- Some (Of, token)
  | LET -> t.opening <- Some (Let, token)
  | WHERE when t.header ->
      t.header <- false;
      t.stack <- [];
      t.opening <- Some (Top, token)
  | WHERE -> t.opening <- Some (Where, token)
  | DO -> t.opening <- Some (Do, token)
  | OF -> t.opening <- Some (Of, token)
  | REC -> t.opening <- Some (Rec, token)
  | _ -> ()

(* [assert], [test] and similar words are keywords only at the start of a definition and before a
   string, because no definition starts with a name followed by a string. *)
let contextual t (token : Lexer.token) : Grammar.token =
  let block =
    match t.stack with
    | { opener = Block ((Top | Let | Where) as block); _ } :: _ when t.item_start -> Some block
    | _ -> None
  in
  let word : Grammar.token =
    match (token.token, block) with
    | LOWER "assert", Some _ -> CLAIM Assert
    | LOWER "assume", Some _ -> CLAIM Assume
    | LOWER "test", Some Top -> CHECK Test
    | LOWER "trial", Some Top -> CHECK Trial
    | other, _ -> other
  in
  match word with (CLAIM _ | CHECK _) when Lexer.text_follows t.lexer -> word | _ -> token.token

(* Processes a token from the text. Returns the token to pass on after the inserted tokens. *)
let ordinary t (token : Lexer.token) =
  let if_ = ref token in
  (match partner t token.token with
  | Some found -> (
      pop_until t found;
      (match t.stack with { opener = If; by; _ } :: _ -> if_ := by | _ -> ());
      match token.token with COMMA -> () | _ -> pop t)
  | None -> (
      match token.token with
      | WHERE when t.header -> ()
      | WHERE ->
          where_closes t token;
          if token.first && at_top t.stack && token.column <= block_column t then separate t
      | SEMICOLON -> separate t
      | _ -> if token.first then line_starts t token.column));
  let token = { token with token = contextual t token } in
  match token.token with
  | SEMICOLON -> None
  | _ ->
      emit_doc t token;
      (match token.token with
      | MODULE when t.item_start && at_top t.stack -> t.header <- true
      | DATA when t.item_start && at_top t.stack -> t.data <- true
      | _ -> ());
      t.item_start <- false;
      opens t token ~if_:!if_;
      Some (of_text t token ~last:false)

let finish t (token : Lexer.token) =
  let rec close () =
    match t.stack with
    | [] | [ { opener = Block Top; _ } ] -> ()
    | { opener = Block _; _ } :: _ ->
        pop t;
        close ()
    | _ when at_top t.stack -> ()
    | _ ->
        pop t;
        close ()
  in
  (match t.opening with
  | Some (Top, _) -> emit t END
  | Some _ ->
      emit t OPEN;
      emit t CLOSE
  | None -> ());
  t.opening <- None;
  close ();
  of_text t { token with start = t.before; stop = t.before } ~last:true

(* The token after [where] and similar keywords opens the block if its column is greater than that
   of the enclosing block. Otherwise the block is empty. *)
let opened t block by (token : Lexer.token) =
  t.opening <- None;
  match block with
  | Top ->
      (* this token ends the header *)
      emit t END;
      push t (Block Top) by ~column:token.column;
      t.item_start <- true;
      ordinary t { token with first = false }
  | Let | Where | Do | Of | Rec ->
      emit t OPEN;
      if token.column > block_column t then (
        push t (Block block) by ~column:token.column;
        t.item_start <- true;
        ordinary t { token with first = false })
      else (
        emit t CLOSE;
        ordinary t token)

let advance t =
  let token = Lexer.next t.lexer in
  (* Skips the assignment if nothing changes, because storing a pointer triggers the garbage
     collector's write barrier. *)
  if t.outer != t.stack then t.outer <- t.stack;
  if t.before == Lexing.dummy_pos then t.before <- token.start;
  (match (t.stack, t.opening) with
  | [], None when not t.header ->
      push t (Block Top) token ~column:token.column;
      t.item_start <- true
  | _, _ -> ());
  let passed =
    match (token.token, t.opening) with
    | END, _ -> Some (finish t token)
    | _, Some (block, by) -> opened t block by token
    | _, None -> ordinary t token
  in
  t.before <- token.stop;
  passed

let rec next t =
  match Queue.take_opt t.ready with
  | Some token -> token
  | None -> (
      match advance t with
      | Some token when Queue.is_empty t.ready -> token
      | Some token ->
          Queue.add token t.ready;
          next t
      | None -> next t)
