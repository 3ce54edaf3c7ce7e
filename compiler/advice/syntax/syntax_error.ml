open Basis
open Syntax
open Grammar
open Found
open Syntax_hint
open Syntax_topic

(* {1 Description of the unexpected token} *)

let item_of : Layout.block -> string = function
  | Top | Let | Where -> "definition"
  | Do | Rec -> "statement"
  | Of -> "branch"

(* Truncates long strings and names to keep the message readable. *)
let shortened text = if String.length text <= 30 then text else String.sub text 0 27 ^ "…"

let describe found =
  match found.token.token with
  | END when found.token.last -> "the end of the file"
  | (END | SEMICOLON) when found.token.made ->
      Printf.sprintf "the end of the %s" (item_of (innermost_block found.context))
  | CLOSE | OPEN -> "the end of the block"
  | DOC _ -> "a documentation comment"
  | STRING _ -> "a string"
  | BACKTICK -> "a backtick"
  | NUMBER _ -> Printf.sprintf "the number `%s`" (shortened (written found found.token))
  | CLAIM _ | CHECK _ | LOWER _ | QUALIFIED_LOWER _ | UPPER _ | QUALIFIED_UPPER _ | FIELD _
  | OPERATOR _ | MINUS | SLASH | STAR | CARET | LPAREN | RPAREN | LBRACE | RBRACE | UNIT_BRACKET
  | LBRACKET | RBRACKET | COMMA | UNDERSCORE | AT | BACKSLASH | EQUAL | BAR | ARROW | LEFT_ARROW
  | TAIL | DOUBLE_ARROW | DOUBLE_COLON | LET | IN | WHERE | DO | OF | CASE | IF | THEN | ELSE | PROC
  | REC | LAMBDA_CASE | MODULE | IMPORT | QUALIFIED | AS | DATA | TYPE | UNIT | PRIMITIVE | FOREIGN
  | PARAM | CLASS | INSTANCE | SEMICOLON | END | BAD | RESERVED _ ->
      Printf.sprintf "`%s`" (shortened (written found found.token))

(* {1 The message of the parser state} *)

let message found = State_message.of_state found.state

(* `==` in place of `=` in a definition, as in `speed == 0.3[m/s]`. *)
let compares_instead found =
  let of_line line =
    match String.split_on_char ' ' (String.trim line) with
    | name :: "==" :: _ :: _ ->
        Some
          (Printf.sprintf
             "write a single `=` to define a name, as in `%s = …`; `==` compares two values" name)
    | _ -> None
  in
  let bol = found.token.start.pos_bol in
  match of_line (first_line_of_definition found) with
  | Some hint -> Some hint
  | None -> of_line (between found bol (end_of_line found bol))

let starts_with_a_text found =
  let bol = found.token.start.pos_bol in
  let line = between found bol (end_of_line found bol) in
  line <> "" && line.[0] = '"'

(* A string at the left margin that was meant as a comment, such as `"drives ahead"`. *)
let text_alone found =
  if starts_with_a_text found then
    Some "write a comment as `-- …`, or as `-- | …` to document the definition below"
  else None

(* A C-style declaration without a value, such as `Velocity v`. *)
let type_before_name found =
  let bol = found.token.start.pos_bol in
  Option.map
    (Printf.sprintf "write the type after the name: `%s`")
    (Typed_equation.alone (between found bol (end_of_line found bol)))

let no_effect =
  suggestion No_effect
    "Frob does not call functions for their effects: write an equation that names a value, as in \
     `v = 0.3[m/s]`"

(* `proc i roMake …` without an arrow, or `proc x y -> …` with two inputs *)
let inputs_of_proc found =
  match (found.token.token, found.before) with
  | LOWER _, Some ({ token = LOWER x; _ } as input) when stands_after found "proc" input ->
      let line =
        between found found.token.start.pos_cnum (end_of_line found found.token.start.pos_cnum)
      in
      let rec inputs taken = function
        | "->" :: _ -> Some (List.rev taken)
        | word :: rest
          when word <> ""
               && Basis.Character.is_lower word.[0]
               && String.for_all Basis.Character.is_name word ->
            inputs (word :: taken) rest
        | _ -> None
      in
      Some
        (match inputs [ x ] (String.split_on_char ' ' line) with
        | Some all ->
            Printf.sprintf "a `proc` has one input: use a tuple, `proc (%s) -> …`"
              (String.concat ", " all)
        | None -> Printf.sprintf "put `->` after the input: `proc %s -> …`" x)
  | _ -> None

let rec trimmed found last =
  if last > 0 && is_blank (char_at found (last - 1)) then trimmed found (last - 1) else last

let lacks_else found =
  match (found.token.token, found.context) with
  | (END | SEMICOLON | CLOSE | RPAREN), (Layout.Then, _) :: _ -> true
  | _ -> false

(* Rewrites the statement `if ok then t` as `whenT ok (t)`, if it is on one line. *)
let task_without_else found =
  let stop = trimmed found found.token.start.pos_cnum in
  let bol =
    Option.fold (String.rindex_from_opt found.text (max 0 (stop - 1)) '\n') ~none:0 ~some:succ
  in
  let line = between found bol stop in
  let words = String.split_on_char ' ' line in
  match words with
  | "if" :: rest when innermost_block found.context = Do && String.length line < 80 -> (
      let rec split before = function
        | "then" :: after -> Some (List.rev before, after)
        | word :: after -> split (word :: before) after
        | [] -> None
      in
      match split [] rest with
      | Some ((_ :: _ as condition), (_ :: _ as task))
        when not (List.exists (fun w -> List.mem w [ "return"; "do"; "else"; "=" ]) task) ->
          let text words = Source.grouped (String.concat " " words) in
          Some (Printf.sprintf "whenT %s %s" (text condition) (text task))
      | _ -> None)
  | _ -> None

(* Replaces a line `if condition then` above several statements with `whenT condition $ do`. *)
let block_without_else found =
  match found.context with
  | (Layout.Then, { by; _ }) :: _ when innermost_block found.context = Do -> (
      match
        String.split_on_char ' '
          (between found by.start.pos_cnum (end_of_line found by.start.pos_cnum))
      with
      | "if" :: rest -> (
          match List.rev rest with
          | "then" :: (_ :: _ as condition) ->
              let condition = String.concat " " (List.rev condition) in
              Some (Printf.sprintf "whenT %s $ do" (Source.grouped condition))
          | _ -> None)
      | _ -> None)
  | _ -> None

(* Adds the fix that replaces the token, if only one replacement makes sense. *)
let with_fix found =
  match (found.token.token, found.before) with
  | DO, Some { token = LOWER _ | UPPER _ | NUMBER _ | RPAREN | RBRACKET | QUALIFIED_LOWER _; _ } ->
      Diagnostic.write (span found.token) "$ do"
  | EQUAL, Some _ when (message found).expects = Arrow -> Diagnostic.write (span found.token) "->"
  | DOUBLE_ARROW, Some _ when Expression_hint.fat_arrow found <> None ->
      Diagnostic.write (span found.token) "->"
  | EQUAL, Some _
    when compares found.context && is_blank (char_at found (found.token.start.pos_cnum - 1)) ->
      Diagnostic.write (span found.token) "=="
  | OPERATOR "!", _ when Operator_hint.negation found <> None -> (
      match Operator_hint.negated found with
      | Some (text, stop) ->
          let start = found.token.start in
          Diagnostic.write (Build.span (start, { start with pos_cnum = stop })) text
      | None -> Diagnostic.write (span found.token) "not ")
  | BAR, _ when Operator_hint.disjunction found <> None -> Diagnostic.write (span found.token) "||"
  | SLASH, _ when Operator_hint.starts_a_comment found ->
      let stop = { found.token.stop with pos_cnum = found.token.stop.pos_cnum + 1 } in
      Diagnostic.write (Build.span (found.token.start, stop)) "--"
  | _ -> Fun.id

let plain found =
  let { State_message.expected; hints = state_hints; expects } = message found in
  let d =
    match foreign found with
    | Some (text, at) ->
        Diagnostic.error ~code:"E0110" ~at "Frob has no `%s`" text
        |> if text = "function" then Diagnostic.about Function_keyword else Fun.id
    | None when found.token.token = OPERATOR "!" && Operator_hint.negation found <> None ->
        Diagnostic.error ~code:"E0110" ~at:(span found.token) "Frob has no prefix `!`"
    | None when Operator_hint.disjunction found <> None ->
        Diagnostic.error ~code:"E0110" ~at:(span found.token) "Frob has no `|` operator"
    | None ->
        Diagnostic.error ~code:"E0110" ~at:(span found.token) "%s, found %s" expected
          (describe found)
  in
  let hints =
    match hint found ~state_hints with
    (* a call such as `setVelTR(0.2, 0)` is parsed as a left-hand side *)
    | [] when expects = Equals ->
        let rules = [ compares_instead; text_alone; type_before_name ] in
        [ Option.fold (List.find_map (fun rule -> rule found) rules) ~none:no_effect ~some:text ]
    | _ :: _ when found.token.token = EQUAL && expects = Arrow ->
        [ text "write `->` between the input and the output; `=` is for equations" ]
    | _ when expects = Arrow && inputs_of_proc found <> None ->
        [ text (Option.get (inputs_of_proc found)) ]
    | _ when found.token.token = WHERE && expects = Arrow ->
        [ text "write the output before `where`: `proc x -> y where`" ]
    | _ when lacks_else found && innermost_block found.context = Do && names_before found "return"
      ->
        [
          text
            "`return` does not end the task early: put the remaining statements into the other \
             branch, below `else do`";
        ]
    | _ when lacks_else found && task_without_else found <> None ->
        [
          Diagnostic.suggestion
            "to run a task only if a condition holds, write `%s`; to choose between two tasks, add \
             an `else`"
            (Option.get (task_without_else found));
        ]
    | _ when lacks_else found && block_without_else found <> None ->
        [
          Diagnostic.suggestion
            "to run these tasks only if the condition holds, replace the `if` line with `%s`; to \
             choose between two blocks of tasks, add an `else`"
            (Option.get (block_without_else found));
        ]
    | hints when lacks_else found && innermost_block found.context <> Do ->
        List.map (fun _ -> text "add an `else`: every `if` has a value") hints
    | hints -> hints
  in
  List.fold_left (fun d hint -> Diagnostic.suggest hint d) d hints
  |> with_fix found |> other_place found

(* {1 `if` and `case` with commands in their branches} *)

(* The `if` or `case` between this place and the enclosing [do]. *)
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
          |> Diagnostic.label ~at:(opener_span by) "this chooses between commands"
          |> Diagnostic.hint
               "choose the input, as in `%s -< if c then a else b`, or run both commands and \
                choose between their outputs"
               (match found.before with
               | Some { token = LOWER sf; _ } when found.token.token = TAIL -> sf
               | _ -> "y <- sf"))
        (choice found.context)
  | _ -> None

(* {1 Commands in a `do` of tasks} *)

(* The command's line, split where the command starts. *)
let around_command found (command : Span.t) =
  let line = List.nth (String.split_on_char '\n' found.text) (Span.line command.start - 1) in
  let column = Span.column command.start - 1 in
  (String.sub line 0 column, String.sub line column (String.length line - column))

(* The condition before the `then` that ends at this offset, if it is on the same line. *)
let condition_before found last =
  let bol = Option.fold (String.rindex_from_opt found.text last '\n') ~none:0 ~some:succ in
  match String.split_on_char ' ' (between found bol last) with
  | "if" :: (_ :: _ as rest) -> (
      match List.rev rest with
      | "then" :: (_ :: _ as condition) -> Some (String.concat " " (List.rev condition))
      | _ -> None)
  | _ -> None

(* A command in a branch of a `proc`, such as `x <- integral -< v`. *)
let command_in_a_branch found ~command ~(block : Lexing.position) =
  let before, after = around_command found command in
  let name =
    match List.rev (String.split_on_char ' ' (String.trim before)) with
    | "<-" :: name :: _ -> name
    | _ -> "y"
  in
  let d =
    Diagnostic.error ~code:"E0116" ~at:command "a branch of a `proc` cannot contain commands"
    |> Diagnostic.label
         ~at:(Build.span (block, { block with pos_cnum = block.pos_cnum + 2 }))
         "this `do` is in a branch"
  in
  match (condition_before found block.pos_cnum, String.split_on_char '-' after) with
  | Some condition, [ sf; rest ] when String.starts_with ~prefix:"< " rest ->
      let sf = String.trim sf
      and input = String.trim (String.sub rest 2 (String.length rest - 2)) in
      Diagnostic.hint
        "choose the input, and run the command at every instant: `%s <- %s -< if %s then %s else 0`"
        name sf condition input d
      |> Diagnostic.hint
           "to restart the signal function whenever the condition becomes True: `%s <- resetOn %s \
            -< (%s, edge %s)`"
           name (Source.grouped sf) input (Source.grouped condition)
  | _, sf :: _ :: _ when String.equal (String.trim sf) "returnA" ->
      Diagnostic.hint "choose the value: `returnA -< if c then a else b`" d
  | _ ->
      Diagnostic.hint
        "choose the input, and run the command at every instant: `y <- sf -< if c then a else b`" d
      |> Diagnostic.hint "to change to another signal function at an event, use `switch`"

let command ~text ~command ~(block : Lexing.position) token =
  let is_around ((_, { by; _ }) : Layout.opener * Layout.origin) =
    by.start.pos_cnum < block.pos_cnum
  in
  let context = List.filter is_around (Layout.context token) in
  let found = { text; state = 0; before = None; token; context } in
  let is_in_a_branch = List.mem (word_before found block.pos_cnum) [ "then"; "else" ] in
  if is_in_a_branch && Equation_hint.of_a_proc found then command_in_a_branch found ~command ~block
  else
    Diagnostic.error ~code:"E0116" ~at:command "`-<` is only allowed in the `do` of a `proc`"
    |> Diagnostic.label
         ~at:(Build.span (block, { block with pos_cnum = block.pos_cnum + 2 }))
         "this `do` does not directly follow `proc … ->`, so its statements are tasks"
    |> Diagnostic.hint
         "for a signal function, write all statements in one `do` after `proc x ->`; a task needs \
          no `-<`"

(* {1 Function definitions in the style of other languages} *)

let first_position found bol =
  {
    found.token.start with
    pos_bol = bol;
    pos_cnum = bol;
    pos_lnum = found.token.start.pos_lnum - lines_between found bol found.token.start.pos_cnum;
  }

(* A function definition in the style of C or JavaScript, such as `float f(float x) { return x;
   }`. *)
let function_of_c found =
  let bol = start_of_definition found in
  Option.map
    (fun (d : Other_definition.t) ->
      let start = first_position found bol in
      let at = Build.span (start, { start with pos_cnum = snd d.head }) in
      Diagnostic.error ~code:"E0110" ~at "this function definition is not valid Frob syntax"
      |> Diagnostic.hint "%s" (Other_definition.advice d))
    (match Other_definition.of_c found.text bol with
    | Some d -> Some d
    | None -> Other_definition.of_javascript found.text bol)

(* Is this the `{` below the first line of a C function? *)
let is_body_of_c found =
  match (found.token.token, found.before) with
  | LBRACE, None ->
      (* the last nonempty line before this offset *)
      let rec line_above stop =
        if stop <= 1 then (0, "")
        else
          let last = stop - 1 in
          let bol =
            Option.fold (String.rindex_from_opt found.text (last - 1) '\n') ~none:0 ~some:succ
          in
          match between found bol last with "" -> line_above bol | line -> (bol, line)
      in
      let start = found.token.start.pos_bol in
      start > 0
      &&
      let bol, line = line_above start in
      String.starts_with ~prefix:"void " line || Other_definition.of_c found.text bol <> None
  | _ -> false

(* {1 Waiting} *)

(* A call that is meant to wait, such as `delay(1000)`, on a separate line. *)
let waiting found =
  match found.before with
  | Some { start; _ }
    when (message found).expects = Equals
         && foreign found = None
         && Beginnings.waits (part found (first_word_from found start.pos_bol)) ->
      let first, last = first_word_from found start.pos_bol in
      let at offset = { start with pos_cnum = offset } in
      Diagnostic.error ~code:"E0110"
        ~at:(Build.span (at first, at last))
        "an equation cannot wait: it holds at every instant"
      |> Diagnostic.suggest Beginnings.waiting
      |> Option.some
  | _ -> None

(* {1 Operators of the program} *)

(* An operator that the program defines, in its definition or in a use. *)
let own_operator found =
  Option.map
    (fun (operator, first) ->
      let start = { found.token.start with pos_cnum = first } in
      let stop = { start with pos_cnum = first + String.length operator } in
      Diagnostic.error ~code:"E0110" ~at:(Build.span (start, stop)) "Frob has no `%s`" operator
      |> Diagnostic.suggest
           (suggestion Own_operator
              ("programs cannot define operators: " ^ Own_operator.advice found.text operator)))
    (Own_operator.defined found.text found.token.start.pos_cnum)

let explained ~told:earlier found =
  let first_of list = List.find_map (fun explain -> explain found) list in
  let d =
    match
      first_of
        [
          own_operator;
          function_of_c;
          choice_of_commands;
          Lacking.diagnostic;
          Other_construct.diagnostic;
          Bracket_mistake.report;
          waiting;
        ]
    with
    | Some d -> d
    | None -> plain found
  in
  let is_about (other : Diagnostic.t) topic = List.mem topic (Diagnostic.topics other) in
  let was_told topic = List.exists (fun other -> is_about other topic) earlier in
  (* A hint about the whole program is reported only once. *)
  let repeats (topic : Diagnostic.topic) =
    let told (other : Diagnostic.t) =
      is_about other topic
      &&
      match topic with
      | Shared (Record_declaration _) -> true
      | Shared _ -> String.equal other.code d.code
      | _ -> false
    in
    List.exists told earlier
  in
  (* The lines of a block in braces are not definitions, so they are not reported separately. *)
  let is_a_call = List.exists (is_about d) [ Shared No_effect; Shared Waiting ] in
  let of_block = is_a_call && was_told Block_in_braces in
  let ends_function = is_about d (Shared End_of_block) && was_told Function_keyword in
  (* the closing brace of a record update that was already reported, `{ p with x = 1; y = 2 }` *)
  let ends_copy = found.token.token = RBRACE && d.code = "E0111" && was_told Changed_copy in
  if of_block || ends_function || ends_copy || List.exists repeats (Diagnostic.topics d) then None
  else Some d

let unexpected ~told ~text ~state ~before token =
  let found = { text; state; before; token; context = Layout.context token } in
  if is_body_of_c found then None else explained ~told found
