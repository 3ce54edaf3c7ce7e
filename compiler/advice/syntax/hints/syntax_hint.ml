open Basis
open Syntax
open Grammar
open Found

(* {1 Lines that begin like code in another language} *)

let text = Syntax_topic.text

(* `Robot (setVelTR)` for `from Robot import setVelTR`. *)
let python_import found =
  let bol = found.token.start.pos_bol in
  let module_ = between found bol found.token.start.pos_cnum in
  let module_ = String.trim (String.sub module_ 4 (String.length module_ - 4)) in
  let names =
    between found found.token.stop.pos_cnum (end_of_line found found.token.stop.pos_cnum)
  in
  let is_name =
    String.for_all (function
      | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | ',' | ' ' -> true
      | _ -> false)
  in
  if module_ = "" || not (is_name module_) then "Robot"
  else
    let module_ = String.capitalize_ascii module_ in
    if names = "" || not (is_name names) then module_ else Printf.sprintf "%s (%s)" module_ names

(* `math` in `from math import sqrt` *)
let first_module found bol = part found (first_word_from found (snd (word_from found bol)))

(* If the definition or the current line begins like code in another language: where it begins, and
   the hint. *)
let beginning found =
  let start = found.token.start in
  let bol = start_of_definition found in
  let above = String.split_on_char '\n' (String.sub found.text bol (start.pos_cnum - bol)) in
  let definition =
    { start with pos_bol = bol; pos_lnum = start.pos_lnum + 1 - List.length above }
  in
  match part found (word_from found bol) with
  | "void" -> Some (definition, Beginnings.no_procedures)
  | "function" ->
      let hint =
        match Other_definition.of_matlab found.text bol with
        | Some d ->
            Diagnostic.suggestion "%s; a block ends where its indentation ends"
              (Other_definition.advice d)
        | None -> Beginnings.by_equation
      in
      Some (definition, hint)
  | ("struct" | "typedef") when Other_definition.record found.text bol <> None ->
      let text = Option.get (Other_definition.record found.text bol) in
      Some (definition, Beginnings.declare_a_record text)
  | "enum" when Other_definition.enumeration found.text bol <> None ->
      let text = Option.get (Other_definition.enumeration found.text bol) in
      Some (definition, Diagnostic.suggestion "declare an enumeration with `data`: `%s`" text)
  | "from" when found.token.token = IMPORT ->
      Some
        ( start,
          let line = between found bol start.pos_cnum in
          let module_ =
            match String.split_on_char ' ' line with
            | _ :: module_ :: _ -> List.hd (String.split_on_char '.' module_)
            | _ -> first_module found bol
          in
          if List.mem module_ [ "math"; "cmath"; "numpy" ] then
            text
              "remove the import: mathematical functions are built in, as in `sin x` and `sqrt x`"
          else if Import_hint.of_library module_ <> None then
            text (Option.get (Import_hint.of_library module_))
          else Diagnostic.suggestion "use `import %s`" (python_import found) )
  | _ ->
      let word = part found (first_word_from found start.pos_bol) in
      let line = between found start.pos_bol (end_of_line found start.pos_bol) in
      let hint =
        match Beginnings.rounds line with
        | _ when Beginnings.is_forever line -> Some (text Beginnings.forever)
        | Some rounds when innermost_block found.context = Do ->
            Some (text (Beginnings.repeated rounds))
        | Some _ | None -> None
      in
      let hint =
        match hint with
        | Some hint -> Some hint
        | None when List.mem word [ "for"; "foreach" ] ->
            Some (text (Other_loop.over_array found.text start.pos_bol))
        | None -> Beginnings.of_word word
      in
      Option.map (fun hint -> (start, hint)) hint

(* {1 Rules}

   The hint comes from the first rule that applies, so the order defines the priority:

   - Constructs that certainly belong to another language come first, whatever Frob expects at that
     token.
   - A rule for a token in one context, such as an `=` in the braces of a record, comes before the
     rule for that token in any context.
   - The indentation rules come last: they apply only if nothing else explains the token. *)

let texts rules =
  let rule (rule : Found.rule) found = Option.map text (rule found) in
  List.map rule rules

let habits =
  texts [ Choice_hint.of_assignments ]
  @ [ (fun found -> Option.map snd (beginning found)); Operator_hint.foreign ]

let imports =
  texts
    Import_hint.
      [
        path;
        mathematics;
        of_python;
        capital;
        Declaration_hint.choices;
        of_haskell;
        with_points;
        hiding;
        exposing;
      ]

let declarations =
  let open Declaration_hint in
  texts
    [
      Choice_hint.matched;
      Choice_hint.after_value;
      Choice_hint.when_for_if;
      Choice_hint.double_arrow;
      Choice_hint.if_in_a_guard;
      Choice_hint.separated_guards;
      Choice_hint.membership;
      Equation_hint.split_by_value;
      Equation_hint.outside_do;
      Equation_hint.outside_proc;
      defined_word;
      without_where;
      type_of_choices;
      Operator_hint.row;
      foreign_import;
      without_value;
    ]
  @ [ alias ]
  @ texts
      [
        capital;
        Choice_hint.branch;
        Type_hint.with_parameters;
        Type_hint.unit_without_brackets;
        Type_hint.in_another_notation;
        Type_hint.contexts;
        Type_hint.list;
        Type_hint.split_arrow;
        Type_hint.parameters;
        Choice_hint.in_braces;
      ]

let equations_and_fields =
  [ Indentation_hint.equations_before_output ]
  @ texts
      [
        Equation_hint.changed;
        Equation_hint.in_a_choice;
        Equation_hint.keyword_argument;
        Equation_hint.changed_field;
        Equation_hint.statement;
      ]
  @ [ Record_hint.changed_copy ]
  @ texts
      [
        Record_hint.constructor_of_data;
        Record_hint.type_before_name;
        Record_hint.without_names;
        Record_hint.with_points;
        Record_hint.in_a_unit;
        Equation_hint.without_parentheses;
        Equation_hint.two_names;
        Equation_hint.comparison;
        Type_hint.capital;
        Record_hint.without_comma;
        Record_hint.typed;
        Expression_hint.do_argument;
        Expression_hint.lambda_argument;
      ]
  @ [ Record_hint.block_in_braces ]
  @ texts [ Record_hint.without_equation ]

let expressions =
  texts
    [
      Expression_hint.pattern_of_proc;
      Choice_hint.otherwise;
      Choice_hint.without_then;
      Choice_hint.tuple_in_a_branch;
      Choice_hint.chain;
      Expression_hint.fat_arrow;
      Expression_hint.function_handle;
      Expression_hint.list_comprehension;
      Operator_hint.member;
      Record_hint.changed;
      Record_hint.strict;
      Choice_hint.guards_after_if;
      Choice_hint.absolute_value;
      Declaration_hint.local;
      Type_hint.pointer;
      Type_hint.size;
      Choice_hint.equation_before_guards;
      Record_hint.capital;
      Choice_hint.without_of;
      Indentation_hint.of_where;
    ]

let general =
  texts
    [
      Operator_hint.negation;
      Operator_hint.decimal_comma;
      Operator_hint.before_point;
      Operator_hint.after_point;
      Operator_hint.comment;
    ]
  @ [ Operator_hint.own ]
  @ texts
      [
        Operator_hint.pipe;
        Operator_hint.disjunction;
        Declaration_hint.word_as_name;
        Indentation_hint.not_indented;
        Indentation_hint.misplaced_line;
        Equation_hint.comma;
      ]

let rules = habits @ imports @ declarations @ equations_and_fields @ expressions @ general
let of_token found = List.find_map (fun rule -> rule found) rules

(* {1 Hints with a lower priority than the hints of the automaton's state} *)

(* Is the opening brace followed by a name and this sign? The sign is `=` for a record value and
   `::` for a record type. *)
let opens_fields found sign =
  let rec skip accepts i =
    if accepts (char_at found i) && i < String.length found.text then skip accepts (i + 1) else i
  in
  let name = skip (fun c -> c = ' ') found.token.stop.pos_cnum in
  let stop = skip Basis.Character.is_name name in
  let at = skip is_blank stop in
  stop > name
  && at + String.length sign <= String.length found.text
  && String.equal (String.sub found.text at (String.length sign)) sign

(* Hints used if neither the token nor the state suggests a better one. *)
let usual found =
  match found.token.token with
  | ARROW -> (
      match found.context with
      | ((Block (Top | Let | Where) | Paren), _) :: _ ->
          Some (text (Expression_hint.arrow_function found))
      | _ -> None)
  | DOUBLE_ARROW when opens_with Layout.Paren found.context && not (names_before found "::") ->
      Some (text (Expression_hint.arrow_function found))
  | LBRACE when opens_fields found "=" -> Some (text (Record_hint.without_constructor found))
  | LBRACE when opens_fields found "::" && first_word found = "type" ->
      Some (Beginnings.declare_a_record "data Pose = Pose { heading :: Angle }")
  | LBRACE -> Some (Indentation_hint.without_braces found)
  | DOUBLE_COLON -> Some (text (Type_hint.misplaced found))
  | _ -> None

let hint found ~state_hints =
  match (of_token found, state_hints, usual found) with
  | Some hint, _, _ -> [ hint ]
  | None, (_ :: _ as hints), _ -> List.map text hints
  | None, [], Some hint -> [ hint ]
  | None, [], None -> []

(* The operator from another language that contains the token. *)
let foreign_operator_around found =
  let is_foreign =
    match (found.token.token, found.before) with
    | BAR, _ -> is_symbol (after found)
    | SLASH, _ when Operator_hint.starts_a_comment found -> true
    | EQUAL, Some { token = OPERATOR "=="; _ } -> Operator_hint.foreign found <> None
    | EQUAL, Some _ -> Equation_hint.changed found <> None
    | _ -> Operator_hint.foreign found <> None
  in
  let rec first i = if is_symbol (char_at found (i - 1)) then first (i - 1) else i in
  let rec last i = if is_symbol (char_at found i) then last (i + 1) else i in
  if is_foreign then Some (first found.token.start.pos_cnum, last found.token.stop.pos_cnum)
  else None

(* The `elif` before this `then`. *)
let else_if found =
  let stop = found.token.start.pos_cnum in
  let rec words i =
    if i < found.token.start.pos_bol then None
    else
      let ((_, last) as word) = word_from found i in
      if List.mem (part found word) [ "elif"; "elsif"; "elseif" ] && last < stop then Some word
      else words (i - 1)
  in
  match found.token.token with
  | THEN when opens_with Layout.Then found.context -> words stop
  | _ -> None

(* The `std::` that ends with this `::` token. *)
let namespace found =
  match (found.token.token, found.before) with
  | DOUBLE_COLON, Some ({ token = LOWER _ | UPPER _; _ } as before)
    when is_adjacent found before && Basis.Character.is_lower (after found) ->
      Some (before.start.pos_cnum, found.token.stop.pos_cnum)
  | _ -> None

let foreign found =
  let at (line : Lexing.position) ((first, last) as it) =
    let there offset = { line with pos_cnum = offset } in
    (part found it, Build.span (there first, there last))
  in
  let here = found.token.start in
  match (beginning found, foreign_operator_around found) with
  | Some (line, _), _ -> Some (at line (first_word_from found line.pos_bol))
  | None, Some it -> Some (at here it)
  | None, None ->
      Option.map (at here) (match namespace found with Some it -> Some it | None -> else_if found)

let other_place found diagnostic =
  match found.context with
  | (((If | Then | Case) as opener), { by; _ }) :: _
    when by.start.pos_lnum <> found.token.start.pos_lnum ->
      let word = match opener with Case -> "case" | _ -> "if" in
      Diagnostic.label ~at:(Build.span (by.start, by.stop)) "this `%s`" word diagnostic
  | _ -> diagnostic
