open Basis
open Grammar
open Found
open Syntax_hint

let span (t : Layout.token) = Build.span (t.start, t.stop)
let opener_span ({ by; _ } : Layout.origin) = Build.span (by.start, by.stop)

let written found =
  String.sub found.text found.token.start.pos_cnum
    (found.token.stop.pos_cnum - found.token.start.pos_cnum)

(* {1 What was found} *)

let item_of : Layout.block -> string = function
  | Top | Let | Where -> "definition"
  | Do | Rec -> "statement"
  | Of -> "branch"

(* Longer texts and names would drown the message. *)
let shortened text = if String.length text <= 30 then text else String.sub text 0 27 ^ "…"

let describe found =
  match found.token.token with
  | END when found.token.last -> "the end of the file"
  | (END | SEMICOLON) when found.token.made ->
      Printf.sprintf "the end of the %s" (item_of (innermost_block found.context))
  | CLOSE | OPEN -> "the end of the block"
  | DOC _ -> "a comment that documents"
  | STRING _ -> "a text"
  | BACKTICK -> "a backtick"
  | NUMBER _ -> Printf.sprintf "the number `%s`" (shortened (written found))
  | CLAIM _ | CHECK _ | LOWER _ | QUALIFIED_LOWER _ | UPPER _ | QUALIFIED_UPPER _ | FIELD _
  | OPERATOR _ | MINUS | SLASH | STAR | CARET | LPAREN | RPAREN | LBRACE | RBRACE | UNIT_BRACKET
  | LBRACKET | RBRACKET | COMMA | UNDERSCORE | AT | BACKSLASH | EQUAL | BAR | ARROW | LEFT_ARROW
  | TAIL | DOUBLE_ARROW | DOUBLE_COLON | LET | IN | WHERE | DO | OF | CASE | IF | THEN | ELSE | PROC
  | REC | LAMBDA_CASE | MODULE | IMPORT | QUALIFIED | AS | DATA | TYPE | UNIT | PRIMITIVE | FOREIGN
  | PARAM | CLASS | INSTANCE | SEMICOLON | END | BAD | RESERVED _ ->
      Printf.sprintf "`%s`" (shortened (written found))

(* {1 The state's message} *)

let message_of_state state =
  match Grammar_messages.message state with
  | text -> (
      let lines = List.filter (( <> ) "") (String.split_on_char '\n' text) in
      let prefix = "hint: " in
      let n = String.length prefix in
      let hint line =
        if String.length line > n && String.sub line 0 n = prefix then
          Some (String.sub line n (String.length line - n))
        else None
      in
      match lines with
      | expected :: rest -> (expected, List.filter_map hint rest)
      | [] -> Diagnostic.bug ~stage:"Syntax.Parse" "state %d has an empty message" state)
  | exception Not_found -> Diagnostic.bug ~stage:"Syntax.Parse" "state %d has no message" state

(* What stands for a call, as `setVelTR(0.2, 0)`, is taken for a left side. *)
let called_for_its_effect = "expected `=` after the left side of a definition"

(* `speed == 0.3[m/s]`, alone on its lines. *)
let compares_instead found =
  let of_line line =
    match String.split_on_char ' ' (String.trim line) with
    | name :: "==" :: _ :: _ ->
        Some (Printf.sprintf "`==` compares; a definition is written with one `=`: `%s = …`" name)
    | _ -> None
  in
  let bol = found.token.start.pos_bol in
  match of_line (first_line_of_definition found) with
  | Some hint -> Some hint
  | None -> of_line (between found bol (end_of_line found bol))

let starts_with_a_text found =
  let bol = found.token.start.pos_bol in
  bol < String.length found.text && found.text.[bol] = '"'

(* `"drives ahead"` at the left edge *)
let text_alone found =
  if starts_with_a_text found then
    Some "a comment is `-- …`, and `-- | …` before a definition describes it"
  else None

let no_effect =
  "nothing is called for its effect: an equation gives a value a name, as in `v = 0.3[m/s]`"

(* Of a `proc` or a lambda. *)
let awaits_arrow expected =
  List.exists
    (fun prefix -> String.starts_with ~prefix expected)
    [ "expected `->` after the input"; "expected `->` or one more parameter" ]

let lacks_else found =
  match (found.token.token, found.context) with
  | (END | SEMICOLON | CLOSE | RPAREN), (Layout.Then, _) :: _ -> true
  | _ -> false

(* What is written in place of the token, where nothing else can be meant. *)
let cured found =
  match (found.token.token, found.before) with
  | DO, Some { token = LOWER _ | UPPER _ | NUMBER _ | RPAREN | RBRACKET | QUALIFIED_LOWER _; _ } ->
      Diagnostic.write (span found.token) "$ do"
  | EQUAL, Some _ when awaits_arrow (fst (message_of_state found.state)) ->
      Diagnostic.write (span found.token) "->"
  | EQUAL, Some _
    when compares found.context && is_blank (char_at found (found.token.start.pos_cnum - 1)) ->
      Diagnostic.write (span found.token) "=="
  | _ -> Fun.id

let plain found =
  let expected, state_hints = message_of_state found.state in
  let d =
    match foreign found with
    | Some (text, at) -> Diagnostic.error ~code:"E0110" ~at "Frob has no `%s`" text
    | None ->
        Diagnostic.error ~code:"E0110" ~at:(span found.token) "%s, found %s" expected
          (describe found)
  in
  let hints =
    match hint found ~state_hints with
    | [] when String.equal expected called_for_its_effect ->
        [
          (match compares_instead found with
          | Some hint -> hint
          | None -> Option.value (text_alone found) ~default:no_effect);
        ]
    | _ :: _ when found.token.token = EQUAL && awaits_arrow expected ->
        [ "`->` leads from the input to what comes out; an equation has `=`" ]
    | _ when found.token.token = WHERE && awaits_arrow expected ->
        [ "the output comes first, and then its equations: `proc x -> y where`" ]
    | _ when lacks_else found && innermost_block found.context = Do && names_before found "return"
      ->
        [
          "a `return` ends only what it is the last of: what else is to be done stands in the \
           other branch, below `else do`";
        ]
    | hints when lacks_else found && innermost_block found.context <> Do ->
        List.map
          (fun _ -> "every `if` has both `then` and `else`, since it always has a value")
          hints
    | hints -> hints
  in
  List.fold_left (fun d hint -> Diagnostic.hint hint d) d hints |> cured found |> other_place found

(* {1 Brackets} *)

let opening : Layout.opener -> (string * string) option = function
  | Paren -> Some ("(", ")")
  | Bracket -> Some ("[", "]")
  | Brace -> Some ("{", "}")
  | Block _ | If | Then | Case -> None

(* The innermost bracket that no block hides. *)
let rec open_bracket : Layout.context -> ((string * string) * Layout.origin) option = function
  | (Block _, _) :: _ | [] -> None
  | (opener, by) :: rest -> (
      match opening opener with Some pair -> Some (pair, by) | None -> open_bracket rest)

(* The innermost bracket, at the end of an item: all blocks in it have ended. *)
let rec bracket_of_item : Layout.context -> ((string * string) * Layout.origin) option = function
  | (Block (Let | Where | Do | Of | Rec), _) :: rest -> bracket_of_item rest
  | context -> open_bracket context

(* Brackets behind this one, in its line, where the text breaks off. *)
let holds_others found (opener : Lexer.token) =
  let first = opener.stop.pos_cnum in
  let length = found.token.start.pos_cnum - first in
  length > 0
  &&
  let text = String.sub found.text first length in
  String.exists (function '(' | '[' | '{' -> true | _ -> false) text
  && not (String.contains (String.trim text) '\n')

let unclosed found ((opener, closer), by) =
  Diagnostic.error ~code:"E0111" ~at:(opener_span by) "this `%s` is never closed" opener
  |> Diagnostic.label ~at:(span found.token) (Printf.sprintf "a `%s` belongs before this" closer)
  |> (if holds_others found by.Layout.by && char_at found found.token.start.pos_cnum <> ';' then
        Diagnostic.hint
          (Printf.sprintf
             "each `%s` closes the last bracket that is still open: if this one was to be closed \
              where it is, then a bracket in it is not"
             closer)
      else Fun.id)
  |>
  let at = found.token.start.pos_cnum in
  if at < String.length found.text && found.text.[at] = ';' then
    match opener with
    | "(" ->
        Diagnostic.hint
          "a `;` ends a definition; tasks one after the other stand in a `do`, each on a line of \
           its own"
    | "{" -> Diagnostic.hint "a `;` ends a definition; there is a `,` between two fields"
    | "[" ->
        Diagnostic.hint
          "a `;` ends a definition; there is a `,` between two elements, and rows are arrays: \
           `[[1, 2], [3, 4]]`"
    | _ -> Fun.id
  else Fun.id

let bracket found =
  match found.token.token with
  | RPAREN | RBRACKET | RBRACE -> (
      let closer = written found in
      match open_bracket found.context with
      | Some ((opener, right), by) when right <> closer ->
          Some
            (Diagnostic.error ~code:"E0111" ~at:(span found.token) "`%s` cannot close `%s`" closer
               opener
            |> Diagnostic.label ~at:(opener_span by) (Printf.sprintf "expected `%s` for this" right)
            )
      | Some _ -> None
      | None ->
          if
            List.exists
              (fun (o, _) -> match opening o with Some (_, c) -> c = closer | None -> false)
              found.context
          then None
          else
            Some
              (Diagnostic.error ~code:"E0111" ~at:(span found.token) "this `%s` closes nothing"
                 closer))
  | END when not (expects_more found.before) ->
      Option.map (unclosed found) (bracket_of_item found.context)
  | END | SEMICOLON | CLOSE | WHERE | IN | THEN | ELSE | OF ->
      Option.map (unclosed found) (open_bracket found.context)
  | _ -> None

(* {1 What Frob does not have, or not here} *)

let absent found format =
  Printf.ksprintf
    (fun what ->
      Diagnostic.error ~code:"E0112" ~at:(span found.token) "%s of this version of Frob" what)
    format

(* The `if` or `case` between this place and the [do] around it. *)
let rec choice : Layout.context -> Layout.origin option = function
  | ((If | Then | Case | Block Of), by) :: rest -> (
      match choice_around rest with true -> Some by | false -> choice rest)
  | ((Paren | Bracket | Brace | Block _), _) :: _ | [] -> None

and choice_around = function
  | (Layout.Block (Do | Rec), _) :: _ -> true
  | ((If | Then | Case | Block Of), _) :: rest -> choice_around rest
  | ((Paren | Bracket | Brace | Block (Top | Let | Where)), _) :: _ | [] -> false

let choice_of_commands found =
  match found.token.token with
  | TAIL | LEFT_ARROW ->
      Option.map
        (fun by ->
          Diagnostic.error ~code:"E0116" ~at:(span found.token)
            "`if` and `case` cannot choose between commands"
          |> Diagnostic.label ~at:(opener_span by) "the choice"
          |> Diagnostic.hint
               (Printf.sprintf
                  "choose the value, as in `%s -< if c then a else b`, or run both and choose \
                   between what they give"
                  (match found.before with
                  | Some { token = LOWER sf; _ } when found.token.token = TAIL -> sf
                  | _ -> "y <- sf")))
        (choice found.context)
  | _ -> None

(* Does this bracket hold a letter, so hardly an index? *)
let holds_a_unit found =
  let i = found.token.stop.pos_cnum in
  i < String.length found.text
  && match found.text.[i] with 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false

(* Does the line up to here hold a name and its type, and no more? *)
let ends_a_signature found =
  let start = found.token.start.pos_bol in
  let line = String.sub found.text start (found.token.start.pos_cnum - start) in
  let has_type =
    List.exists
      (fun i -> line.[i] = ':' && line.[i + 1] = ':')
      (List.init (max 0 (String.length line - 1)) Fun.id)
  in
  has_type && not (String.exists (function '=' | '{' | '(' | '\\' -> true | _ -> false) line)

(* The word, and the classes behind it: one, or several in parentheses. *)
let of_deriving found =
  let text = found.text and stop = found.token.stop.pos_cnum in
  let rec skip is i = if i < String.length text && is text.[i] then skip is (i + 1) else i in
  let is_name = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false in
  let first = skip (Char.equal ' ') stop in
  let last =
    if first < String.length text && text.[first] = '(' then
      let close = skip (fun c -> c <> ')' && c <> '\n') first in
      if close < String.length text && text.[close] = ')' then close + 1 else stop
    else skip is_name first
  in
  let at = span found.token in
  { at with stop = Span.forward (last - stop) at.stop }

(* `let x = 1` at the left edge. *)
let is_a_top_let found =
  match found.token.token with
  | END | SEMICOLON -> part found (word_from found (start_of_definition found)) = "let"
  | _ -> false

(* `[x * 2 for x in xs]` *)
let for_each found =
  match found.context with
  | (Bracket, { by; _ }) :: _ when found.token.token = IN -> (
      let inside = between found by.stop.pos_cnum found.token.start.pos_cnum in
      let rest =
        between found found.token.stop.pos_cnum (end_of_line found found.token.stop.pos_cnum)
      in
      match (List.rev (String.split_on_char ' ' inside), String.split_on_char ']' rest) with
      | x :: "for" :: element, xs :: _ ->
          Some (String.concat " " (List.rev element), x, String.trim xs)
      | _ -> None)
  | _ -> None

(* What a `[` directly behind a name holds, and where it ends. *)
let index found =
  let start = found.token.stop.pos_cnum in
  match String.index_from_opt found.text start ']' with
  | Some stop ->
      let inside = String.sub found.text start (stop - start) in
      if inside <> "" && String.for_all is_digit inside then Some (inside, stop + 1) else None
  | None -> None

let missing found =
  match (found.token.token, found.before) with
  | _ when is_a_top_let found ->
      let bol = start_of_definition found in
      let line = first_line_of_definition found in
      let own = String.trim (String.sub line 3 (String.length line - 3)) in
      let start =
        {
          found.token.start with
          pos_bol = bol;
          pos_cnum = bol;
          pos_lnum = found.token.start.pos_lnum - lines_between found bol found.token.start.pos_cnum;
        }
      in
      let at = Build.span (start, { start with pos_cnum = bol + 3 }) in
      Some
        (Diagnostic.error ~code:"E0110" ~at "a definition at the left edge has no `let` before it"
        |> Diagnostic.hint
             (if String.length own > 50 then "leave it out" else Printf.sprintf "write `%s`" own)
        |> Diagnostic.fix "leave it out"
             [ (Build.span (start, { start with pos_cnum = bol + 4 }), "") ])
  | ( (THEN | ELSE | IF | IN | OF | WHERE | DO | CASE | LET | TYPE | DATA | MODULE | CLASS | REC),
      Some { token = BACKTICK; _ } ) ->
      Some
        (Diagnostic.error ~code:"E0110" ~at:(span found.token) "%s" (reserved_word (written found)))
  | IN, _ when for_each found <> None ->
      let element, x, xs = Option.get (for_each found) in
      Some
        (Diagnostic.error ~code:"E0110" ~at:(span found.token) "no array is made by a `for`"
        |> Diagnostic.hint
             (Printf.sprintf "each element is computed with by `map (\\%s -> %s) %s`" x element
                (Source.grouped xs)))
  | UNIT_BRACKET, Some ({ token = LOWER _ | FIELD _ | QUALIFIED_LOWER _; _ } as name)
    when index found <> None ->
      let digits, stop = Option.get (index found) in
      let name = word_before found name.stop.pos_cnum in
      let whole = Build.span (found.token.start, { found.token.stop with pos_cnum = stop }) in
      Some
        (Diagnostic.error ~code:"E0110" ~at:(span found.token)
           "a `[` directly after a name starts no index and no array"
        |> Diagnostic.hint
             (Printf.sprintf
                "an element of an array is `(%s ! %s)`; a tuple is taken apart by an equation, \
                 `(a, b) = %s`, and an argument needs a blank before it"
                name digits name)
        |> Diagnostic.write whole (" ! " ^ digits))
  | EQUAL, Some _ when ends_a_signature found ->
      Some
        (Diagnostic.error ~code:"E0110" ~at:(span found.token)
           "expected `->`, or the end of the type, found `=`"
        |> Diagnostic.hint "the definition stands on a line of its own, below its type")
  | RESERVED "deriving", _ ->
      Some
        (absent found "`deriving` is not part"
        |> Diagnostic.hint "leave it out: `==` and `<` work on all data without functions"
        |> Diagnostic.fix ~safe:true "leave it out" [ (of_deriving found, "") ])
  | RESERVED "newtype", _ ->
      Some
        (absent found "`newtype` is not part"
        |> Diagnostic.hint "`data` makes a new type, and one with a single field costs nothing"
        |> Diagnostic.write (span found.token) "data")
  | RESERVED word, _ -> Some (absent found "`%s` is not part" word)
  | UNIT_BRACKET, Some { token = LOWER _ | FIELD _ | QUALIFIED_LOWER _; _ } when holds_a_unit found
    ->
      Some
        (Diagnostic.error ~code:"E0110" ~at:(span found.token)
           "a unit stands on a number written out or on a type, not on a name"
        |> Diagnostic.hint
             "a value has its unit already; to give one to a plain number, multiply: `x * 1[m]`")
  | UNIT_BRACKET, Some { token = LOWER _ | FIELD _ | QUALIFIED_LOWER _; _ } ->
      Some
        (Diagnostic.error ~code:"E0110" ~at:(span found.token)
           "a `[` directly after a name starts no index and no array"
        |> Diagnostic.hint
             "an element of an array is written `xs ! 0`, a tuple is taken apart by an equation, \
              `(a, b) = p`; an argument needs a blank before it")
  | LBRACKET, Some { token = DOUBLE_COLON | ARROW; _ } ->
      Some
        (Diagnostic.error ~code:"E0110" ~at:(span found.token)
           "the type of an array is not written in brackets"
        |> Diagnostic.hint "it has the size first, as in `Array 4 Float`")
  | LBRACKET, Some { token = UPPER _ | LOWER _ | QUALIFIED_UPPER _; _ } ->
      Some
        (Diagnostic.error ~code:"E0110" ~at:(span found.token) "a `[` cannot stand here"
        |> Diagnostic.hint
             "a unit directly follows its type, as in `Float[m]`; the type of an array is `Array 4 \
              Float`")
  | _ -> None

let said_once = [ own_operator; Beginnings.no_procedures; Beginnings.by_equation; no_effect ]

let report sink ~text ~state ~before token =
  let found = { text; state; before; token; context = Layout.context token } in
  let first_of list = List.find_map (fun explain -> explain found) list in
  let d =
    match first_of [ choice_of_commands; Lacking.diagnostic; missing; bracket ] with
    | Some d -> d
    | None -> plain found
  in
  (* What is said of the whole program is said once. *)
  let told (other : Diagnostic.t) = other.code = d.code && other.hints = d.hints in
  let once = List.exists (fun hint -> List.mem hint said_once) d.hints in
  (* a block in braces, of which the lines are no definitions *)
  let in_braces (other : Diagnostic.t) = List.mem by_indentation other.hints in
  let of_block = List.mem no_effect d.hints && List.exists in_braces (Diagnostic.all sink) in
  if not (of_block || (once && List.exists told (Diagnostic.all sink))) then Diagnostic.emit sink d
