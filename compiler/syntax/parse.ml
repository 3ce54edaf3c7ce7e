open Basis
module Automaton = Grammar.MenhirInterpreter

(* A file with this many broken items is probably not a Frob program. *)
let most_errors = 50

type reader = {
  mutable layout : Layout.t;
  report : Fact.problem -> unit;
  text : string;
  mutable cut : bool;
      (** Whether the previous item was incomplete. If so, and if the current item ends before it
          defines anything, it is probably the rest of the previous item. *)
  mutable failed : bool;  (** the previous item had a syntax error *)
  mutable split : bool;
      (** An item ended at a `;` inside an open bracket. The closing bracket may follow in the next
          item. *)
  mutable defines : bool;  (** whether an [=] or [::] of this item has been read *)
  mutable tokens : int;  (** an upper bound on the number of tokens in this item *)
}

let next reader =
  reader.tokens <- reader.tokens + 1;
  Layout.next reader.layout

(* Skips the rest of the item that contains this token. *)
let rec skip reader (token : Layout.token) =
  match token.token with END -> token.last | _ -> skip reader (next reader)

(* Like {!skip}. Also returns whether the token's line contains an unexpected character, which the
   lexer has already reported. *)
let rec skip_line reader ~bad (at : Layout.token) (token : Layout.token) =
  let bad = bad || (token.token = BAD && token.start.pos_lnum = at.start.pos_lnum) in
  match token.token with END -> (bad, token.last) | _ -> skip_line reader ~bad at (next reader)

type outcome = Item of Surface.item | Failed

(* Does an explicit `;` end the item here? *)
let is_semicolon reader (token : Layout.token) =
  let at = token.start.pos_cnum in
  at < String.length reader.text && reader.text.[at] = ';'

(* Is an expression, type or definition that ends with this token always incomplete? *)
let expects_more : Layout.token option -> bool = function
  | Some
      {
        token =
          ( EQUAL | ARROW | DOUBLE_COLON | DOUBLE_ARROW | OPERATOR _ | MINUS | STAR | SLASH | CARET
          | BAR | IF | THEN | ELSE | IN | CASE | COMMA | TAIL );
        _;
      } ->
      true
  | Some _ | None -> false

(* Parses an item with menhir's incremental automaton, whose state can be inspected after an
   error. *)
let explained reader =
  reader.defines <- false;
  let token = ref (next reader) in
  let start = !token.start in
  let supply () =
    let t = !token in
    (t.token, t.start, t.stop)
  in
  let rec run before checkpoint =
    match checkpoint with
    | Automaton.InputNeeded _ -> (
        match !token.token with
        | BAD -> (Failed, skip reader !token)
        | _ -> run before (Automaton.offer checkpoint (supply ())))
    | Automaton.Shifting _ | Automaton.AboutToReduce _ -> (
        match Automaton.resume checkpoint with
        | checkpoint -> advance before checkpoint
        | exception Reject.Rejected reason ->
            reader.report (Rejected reason);
            (Failed, skip reader !token)
        | exception Reject.Command { command; block } ->
            reader.report (Command_in_task { command; block; token = !token });
            (Failed, skip reader !token))
    | Automaton.HandlingError env ->
        let state = Automaton.current_state_number env in
        let ended = !token.token = END in
        (* whether an earlier item with a syntax error opened the bracket that this token closes *)
        let rest_of_last =
          match (before, !token.token) with
          | None, (RPAREN | RBRACKET | RBRACE) -> reader.failed
          | Some _, token when reader.split && start.pos_cnum > start.pos_bol ->
              if token = RBRACE then reader.split <- false;
              true
          | _ -> false
        in
        if ended && is_semicolon reader !token then reader.split <- true;
        let of_last = (reader.cut && ended && not reader.defines) || rest_of_last in
        reader.cut <- ended && expects_more before;
        let found = !token in
        let told, last = skip_line reader ~bad:false found found in
        if not (of_last || told) then reader.report (Unexpected { state; before; token = found });
        (Failed, last)
    | Automaton.Accepted item ->
        reader.cut <- false;
        (Item item, !token.last)
    | Automaton.Rejected -> (Failed, skip reader !token)
  (* after shifting a token, reads the next one *)
  and advance before checkpoint =
    match checkpoint with
    | Automaton.InputNeeded _ ->
        let shifted = !token in
        (match shifted.token with EQUAL | DOUBLE_COLON | BAR -> reader.defines <- true | _ -> ());
        token := next reader;
        run (Some shifted) checkpoint
    | Automaton.Shifting _ | Automaton.AboutToReduce _ | Automaton.HandlingError _
    | Automaton.Accepted _ | Automaton.Rejected ->
        run before checkpoint
  in
  run None (Grammar.Incremental.item start)

exception Bad_token

(* Parses an item with menhir's code back end. This parser is several times as fast as the
   automaton, but does not provide information about an error. Its actions have no side effects, so
   the automaton can parse a faulty item again from its first character. The lexer then finds each
   error twice, but it is reported only once (see {!Diagnostic.all}). *)
let item reader =
  let again = Layout.copy reader.layout in
  reader.tokens <- 0;
  let first = next reader in
  let at_first = ref true and last = ref first.last in
  let buffer = Lexing.from_string "" in
  buffer.lex_curr_p <- first.start;
  let supply (buffer : Lexing.lexbuf) =
    let token = if !at_first then first else next reader in
    at_first := false;
    last := token.last;
    (match token.token with BAD -> raise Bad_token | _ -> ());
    buffer.lex_start_p <- token.start;
    buffer.lex_curr_p <- token.stop;
    token.token
  in
  match Quick_grammar.item supply buffer with
  | item ->
      reader.cut <- false;
      (Item item, !last)
  | exception (Quick_grammar.Error | Bad_token | Reject.Rejected _ | Reject.Command _) ->
      reader.layout <- again;
      explained reader

let levels_of_a_token = 4

(* Layout limits the nesting of brackets and blocks, but operators, arrows and other constructs can
   be nested, too. Each token adds only a few levels, so an item with few tokens cannot be nested
   too deeply. *)
let check_depth reader declaration =
  if levels_of_a_token * reader.tokens > Layout.deepest then
    Option.iter
      (fun at -> reader.report (Too_deep at))
      (Node.depth_exceeds Layout.deepest (Declaration declaration))

(* Collects the items of a program. All lists are in reverse order. *)
let rec collect reader (program : Ir.program) errors =
  if errors >= most_errors then program
  else
    let outcome, last = item reader in
    (match outcome with
    | Failed -> reader.failed <- true
    | Item Nothing -> ()
    | Item (Header _ | Import _ | Declaration _) -> reader.failed <- false);
    let program, errors =
      match outcome with
      | Failed -> (program, errors + 1)
      | Item Nothing -> (program, errors)
      | Item (Header header) ->
          if program.header <> None || program.imports <> [] || program.declarations <> [] then
            reader.report (Misplaced_header header.span);
          ({ program with header = Some header }, errors)
      | Item (Import import) ->
          if program.declarations <> [] then reader.report (Misplaced_import import.span);
          ({ program with imports = import :: program.imports }, errors)
      | Item (Declaration d) ->
          check_depth reader d;
          ({ program with declarations = d :: program.declarations }, errors)
    in
    if last then program else collect reader program errors

let read report ~file text =
  let lexical fact = report (Fact.Lexical fact) in
  let layout = Layout.create (Lexer.create lexical ~file text) in
  let empty : Ir.program = { file; header = None; imports = []; declarations = [] } in
  match
    collect
      {
        layout;
        report;
        text;
        cut = false;
        failed = false;
        split = false;
        defines = false;
        tokens = 0;
      }
      empty 0
  with
  | program ->
      let declarations, clauses = Clauses.joined (List.rev program.declarations) in
      List.iter (fun reason -> report (Fact.Rejected reason)) clauses;
      Some { program with imports = List.rev program.imports; declarations }
  | exception Layout.Too_deep token ->
      report (Too_deep (Build.span (token.start, token.stop)));
      None

(* The span of [length] bytes at an offset. *)
let span_at ~file text offset length =
  let line = ref 1 and line_start = ref 0 in
  String.iteri
    (fun i c ->
      if i < offset && c = '\n' then (
        incr line;
        line_start := i + 1))
    text;
  let column = offset - !line_start + 1 in
  Span.make ~file
    ~start:(Span.position ~line:!line ~column)
    ~stop:(Span.position ~line:!line ~column:(column + length))

let check_tabs report ~file text =
  match String.index_opt text '\t' with
  | None -> ()
  | Some offset ->
      let count = ref 0 in
      String.iter (fun c -> if c = '\t' then incr count) text;
      report (Fact.Tabs { at = span_at ~file text offset 1; count = !count })

let program facts ~file text =
  let has_errors = ref false in
  let report problem =
    has_errors := true;
    Facts.report facts { Fact.text; problem }
  in
  match Utf8.first_error text with
  | Some offset ->
      report (Not_utf8 { at = span_at ~file text offset 1; byte = text.[offset] });
      None
  | None ->
      check_tabs report ~file text;
      let program = read report ~file text in
      if !has_errors then None else program

let readable ~file text =
  let is_too_deep = ref false in
  (* it is not safe to traverse a tree that is nested too deeply *)
  let report : Fact.problem -> unit = function Too_deep _ -> is_too_deep := true | _ -> () in
  let program = if Utf8.first_error text <> None then None else read report ~file text in
  if !is_too_deep then None else program
