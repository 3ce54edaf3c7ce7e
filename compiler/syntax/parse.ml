open Basis
module Automaton = Grammar.MenhirInterpreter

(* A file with this many broken items is probably not a Frob program. *)
let most_errors = 50

type reader = {
  mutable layout : Layout.t;
  sink : Diagnostic.sink;
  text : string;
  mutable cut : bool;
      (** The previous item was incomplete. If the current item ends before it defines anything, it
          is probably the rest of the previous item. *)
  mutable failed : bool;  (** the previous item had a syntax error *)
  mutable split : bool;
      (** An item ended at a `;` inside an open bracket. The closing bracket may follow in the next
          item. *)
  mutable defines : bool;  (** an [=] or [::] of this item has been read *)
  mutable tokens : int;  (** upper bound on the number of tokens in this item *)
}

let quote reader (span : Span.t) =
  let sources = Source.create () in
  Source.add sources ~file:span.file reader.text;
  Source.quote sources span

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

(* Parses an item with menhir's incremental automaton, which can be inspected at an error. *)
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
        | exception Reject.Rejected d ->
            Diagnostic.emit reader.sink d;
            (Failed, skip reader !token)
        | exception Reject.With_text explain ->
            Diagnostic.emit reader.sink (explain (quote reader));
            (Failed, skip reader !token)
        | exception Reject.Command { command; block } ->
            Syntax_error.command reader.sink ~text:reader.text ~command ~block !token;
            (Failed, skip reader !token))
    | Automaton.HandlingError env ->
        let state = Automaton.current_state_number env in
        let ended = !token.token = END in
        (* an item with a syntax error opened the bracket *)
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
        reader.cut <- ended && Found.expects_more before;
        let found = !token in
        let told, last = skip_line reader ~bad:false found found in
        if not (of_last || told) then
          Syntax_error.report reader.sink ~text:reader.text ~state ~before found;
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

(* Parses an item with the parser that menhir generates as code. It is several times as fast as the
   automaton, but does not provide information about an error. Its actions have no side effects, so
   the automaton can parse a faulty item again from its first character. Errors of the lexer, which
   then occur twice, are reported once (see {!Diagnostic.all}). *)
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
  | exception
      (Quick_grammar.Error | Bad_token | Reject.Rejected _ | Reject.With_text _ | Reject.Command _)
    ->
      reader.layout <- again;
      explained reader

let misplaced sink code span message hint =
  Diagnostic.emit sink (Diagnostic.error ~code ~at:span "%s" message |> Diagnostic.hint hint)

let too_deep sink at =
  Diagnostic.emit sink
    (Diagnostic.error ~code:"E0106" ~at "this is nested more than %d levels deep" Layout.deepest
    |> Diagnostic.hint "define the inner parts under their own names")

let levels_of_a_token = 4

(* Layout limits the nesting of brackets and blocks, but operators, arrows and other constructs nest
   too. A token adds only a few levels, so an item with few tokens cannot be too deep. *)
let check_depth reader declaration =
  if levels_of_a_token * reader.tokens > Layout.deepest then
    Option.iter (too_deep reader.sink) (Node.depth_exceeds Layout.deepest (Declaration declaration))

(* Collects the items of a program. All lists have the last element first. *)
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
            misplaced reader.sink "E0118" header.span "`module` must be at the beginning of a file"
              "move it to the first line, or remove it";
          ({ program with header = Some header }, errors)
      | Item (Import import) ->
          if program.declarations <> [] then
            misplaced reader.sink "E0118" import.span "an `import` must come before all definitions"
              "move it to the top of the file";
          ({ program with imports = import :: program.imports }, errors)
      | Item (Declaration d) ->
          check_depth reader d;
          ({ program with declarations = d :: program.declarations }, errors)
    in
    if last then program else collect reader program errors

let read sink ~file text =
  let layout = Layout.create (Lexer.create sink ~file text) in
  let empty : Ir.program = { file; header = None; imports = []; declarations = [] } in
  match
    collect
      {
        layout;
        sink;
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
      List.iter (Diagnostic.emit sink) clauses;
      Some { program with imports = List.rev program.imports; declarations }
  | exception Layout.Too_deep token ->
      too_deep sink (Build.span (token.start, token.stop));
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

let check_tabs sink ~file text =
  match String.index_opt text '\t' with
  | None -> ()
  | Some offset ->
      let count = ref 0 in
      String.iter (fun c -> if c = '\t' then incr count) text;
      let more = if !count = 1 then "" else Printf.sprintf " (%d in this file)" !count in
      Diagnostic.emit sink
        (Diagnostic.error ~code:"E0102" ~at:(span_at ~file text offset 1)
           "this is a tab, but only spaces are allowed, because indentation has a meaning%s" more
        |> Diagnostic.hint "set up your editor to insert spaces instead of tabs")

let program sink ~file text =
  match Utf8.first_error text with
  | Some offset ->
      Diagnostic.emit sink
        (Diagnostic.error ~code:"E0101" ~at:(span_at ~file text offset 1)
           "this file is not valid UTF-8: byte %d is not allowed here"
           (Char.code text.[offset])
        |> Diagnostic.hint "save the file as UTF-8 text");
      None
  | None -> (
      (* A separate sink for this file, to find out whether the file has errors. *)
      let own = Diagnostic.sink () in
      check_tabs own ~file text;
      let program = read own ~file text in
      List.iter (Diagnostic.emit sink) (Diagnostic.all own);
      match program with
      | Some program when not (Diagnostic.has_errors own) -> Some program
      | Some _ | None -> None)

let readable ~file text =
  let sink = Diagnostic.sink () in
  let program = if Utf8.first_error text <> None then None else read sink ~file text in
  (* a tree that is nested too deeply is not safe to traverse *)
  let is_too_deep (d : Diagnostic.t) = String.equal d.code "E0106" in
  if List.exists is_too_deep (Diagnostic.all sink) then None else program
