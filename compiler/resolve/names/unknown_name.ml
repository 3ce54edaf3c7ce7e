open Basis
open Interface
open Scope

(* Explains a name that exists in another namespace: `Velocity 3` uses a type as a constructor. *)
let other_meaning t space (name : Syntax.Ir.name) diagnostic =
  if String.equal space.noun "constructor" && size_named t name <> None then
    let n = Option.get (size_named t name) in
    Diagnostic.note
      (Printf.sprintf "`%s` is a size: use it in types and expressions, not in patterns" name.text)
      diagnostic
    |> Diagnostic.hint (Printf.sprintf "write the number: `%d`" n)
  else if String.equal space.noun "constructor" && is_known t tycons name.text then
    Diagnostic.note (Printf.sprintf "`%s` is a type, not a constructor" name.text) diagnostic
  else if String.equal space.noun "type" && is_known t constructors name.text then
    Diagnostic.note (Printf.sprintf "`%s` is a constructor, not a type" name.text) diagnostic
  else if String.equal space.noun "name" && String_map.mem name.text (Lazy.force t.records) then
    let owners = String_map.find name.text (Lazy.force t.records) in
    let owners = List.map (fun (r : tycon) -> Printf.sprintf "`%s`" r.global.name) owners in
    let owners = List.filteri (fun i _ -> i < 3) (List.sort_uniq String.compare owners) in
    Diagnostic.note
      (Printf.sprintf
         "`%s` is a field of %s: write `r.%s`; as a function, `\\r -> r.%s`; as a signal function, \
          `proc r -> r.%s`"
         name.text (Enumeration.all owners) name.text name.text name.text)
      diagnostic
  else if String.equal space.noun "name" && is_known t units name.text then
    Diagnostic.note
      (Printf.sprintf "`%s` is a unit: write it in brackets directly after a number, as in `3[%s]`"
         name.text name.text)
      diagnostic
  else diagnostic

(* An alternative spelling of the name. Values and constructors differ only in the case of the first
   letter (`true`, `Speed`), and units are written as symbols. *)
let other_writing t space name =
  if String.equal space.noun "unit" then Unit_word.symbol name
  else
    let known space other = if is_known t space other then Some other else None in
    match space.noun with
    | "name" -> known constructors (String.capitalize_ascii name)
    | "constructor" -> known values (String.uncapitalize_ascii name)
    | _ -> None

(* Words that are operators in other languages. *)
let operator_word space name =
  match (space.noun, name) with
  | ("name" | "constructor"), ("and" | "AND") -> Some "&&"
  | ("name" | "constructor"), ("or" | "OR") -> Some "||"
  | "name", "xor" -> Some "/="
  | "name", "is" -> Some "=="
  | _ -> None

(* The name in a hint such as "write `return`", which suggests only another name. *)
let only_a_name hint =
  let is_inner = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' -> true | _ -> false in
  match String.split_on_char '`' hint with
  | [ "write "; name; "" ] when String.for_all is_inner name -> Some name
  | _ -> None

let of_last_element =
  "to get the last element of an array, write its index, as in `xs ! 2` for the third: the first \
   is `xs ! 0`"

let from_elsewhere ?(after = ' ') space name =
  match space.noun with
  | "name" when String.equal name "end" && after = '(' -> Some of_last_element
  | "name" -> Other_languages.value name
  | "constructor" -> Other_languages.constructor name
  | "type class" -> Other_languages.class_ name
  | "type" -> Other_languages.type_ name
  | _ -> None

let no_input =
  "only a `proc` has a name for the robot's input, as in `proc i -> …`; in a task, write `d <- ask \
   frontSonar` to read it once"

(* `int m = n + 1`, which parses as the definition of a function `int`. *)
let c_type_before t (name : Syntax.Ir.name) =
  let is_it (d : Proc_signals.c_declaration) = String.equal d.declared.text name.text in
  List.find_opt is_it (Lazy.force t.c_declarations)

(* The type and the value to suggest in place of a declaration in the notation of C. *)
let of_c_declaration (d : Proc_signals.c_declaration) =
  let text = d.declared.text in
  let name =
    if String.equal text (String.uppercase_ascii text) then String.lowercase_ascii text
    else String.uncapitalize_ascii text
  in
  let type_ =
    match d.type_ with
    | "bool" | "boolean" -> "Bool"
    | "float" | "double" | "const" | "auto" | "var" | "let" -> "Float"
    | _ -> "Int"
  in
  match d.value with
  | Some value ->
      Printf.sprintf "declare it as `%s :: %s` and, on the next line, `%s = %s`" name type_ name
        value
  | None when List.mem d.head.text [ "var"; "let"; "auto"; "val"; "const" ] && d.type_ = d.head.text
    ->
      Printf.sprintf "remove `%s` before `%s`" d.head.text text
  | None ->
      Printf.sprintf
        "remove the words before `%s`, and write its type on the line above: `%s :: %s`" text name
        type_

let is_no_type =
  "write the class before `=>` and use a type variable, as in `(HasSonar i, DiffDrive o) => SF i o`"

(* `SF HasSonar DiffDrive` uses classes as types; reported once per signature. *)
let report_class t (name : Syntax.Ir.name) =
  let same (d : Diagnostic.t) =
    List.mem is_no_type d.hints && Span.line d.at.start = Span.line name.span.start
  in
  if not (Context.is_told t.context same) then
    Diagnostic.error ~code:"E0207" ~at:name.span "`%s` is a class, not a type" name.text
    |> Diagnostic.hint is_no_type |> Context.emit t.context

(* `0.5 m/s`, a unit without brackets. Only its first name is reported. *)
let report_unit t (name : Syntax.Ir.name)
    ({ number; measure; whole; is_first } : Name_in_text.unit_) =
  let text = Printf.sprintf "%s[%s]" number measure in
  if is_first then
    Diagnostic.error ~code:"E0205" ~at:name.span "the unit `%s` needs brackets" measure
    |> Diagnostic.hint (Printf.sprintf "write it directly after its number: `%s`" text)
    |> Diagnostic.fix ~safe:true (Printf.sprintf "write `%s`" text) [ (whole, text) ]
    |> Context.emit t.context

(* The hint without the imports that the module already has. *)
let without_imported t hint =
  let words (import : import) =
    if import.unqualified then Some (Printf.sprintf ", with `import %s`" import.module_) else None
  in
  let remove hint part =
    let n = String.length part in
    let rec find i =
      if i + n > String.length hint then hint
      else if String.equal (String.sub hint i n) part then
        String.sub hint 0 i ^ String.sub hint (i + n) (String.length hint - i - n)
      else find (i + 1)
    in
    find 0
  in
  List.fold_left remove hint (List.filter_map words t.imports)

(* The message for a word or a notation of another language. *)
let of_another_language t space (name : Syntax.Ir.name) diagnostic =
  let preceding = Name_in_text.before ~text:t.text name.span in
  let following = Name_in_text.after ~text:t.text name.span in
  match operator_word space name.text with
  | None when String.equal space.noun "name" && Rewritten.member t name <> None ->
      let whole, field = Option.get (Rewritten.member t name) in
      Diagnostic.hint
        (Printf.sprintf "Frob has no objects with methods: write `%s` alone" field)
        diagnostic
      |> Diagnostic.write whole field |> Option.some
  | None when String.equal space.noun "name" && Rewritten.integral t name <> None ->
      let x, integral, place = Option.get (Rewritten.integral t name) in
      Diagnostic.hint
        (Printf.sprintf "for the sum over time, write `%s = %s`, which needs no time step" x
           integral)
        diagnostic
      |> Diagnostic.write place integral |> Option.some
  | Some symbol ->
      Diagnostic.error ~code:space.unknown ~at:name.span "Frob has no `%s`" name.text
      |> Diagnostic.hint (Printf.sprintf "write `%s` instead of `%s`" symbol name.text)
      |> Diagnostic.write name.span symbol |> Option.some
  | None
    when String.equal space.noun "constructor"
         && Name_in_text.starts_an_equation ~text:t.text name.text ->
      Diagnostic.hint
        (Printf.sprintf "start the name of a value with a lower-case letter: `%s`"
           (Name_in_text.lower_case name.text))
        diagnostic
      |> Option.some
  | None when String.equal space.noun "name" && following = '"' ->
      Diagnostic.hint
        (Printf.sprintf
           "remove `%s`: a text is only a label, so it cannot contain values; make the value an \
            output"
           name.text)
        diagnostic
      |> Option.some
  | None -> (
      match
        ( Rewritten.call t space name,
          from_elsewhere ~after:preceding space name.text,
          c_type_before t name )
      with
      | Some (whole, text), _, _ ->
          let source = Rewritten.import_of t name text in
          Diagnostic.hint
            (without_imported t (Printf.sprintf "write `%s`%s" text source))
            diagnostic
          |> Diagnostic.write whole (Source.grouped text)
          |> Option.some
      | None, Some text, _ ->
          Diagnostic.hint (without_imported t text) diagnostic
          |> Option.fold (only_a_name text) ~none:Fun.id ~some:(Diagnostic.write name.span)
          |> Option.some
      | None, None, Some declaration ->
          Diagnostic.label ~at:declaration.head.span
            (Printf.sprintf "this defines a function `%s`" declaration.head.text)
            diagnostic
          |> Diagnostic.hint (of_c_declaration declaration)
          |> Option.some
      | None, None, None -> None)

(* The message for a controller with three gains as arguments. *)
let of_a_controller t (name : Syntax.Ir.name) diagnostic =
  Option.map
    (fun (_, text) ->
      let text = Printf.sprintf "use `%s`, with `import Control`" text in
      Diagnostic.hint (without_imported t text) diagnostic
      |> Diagnostic.note
           "each gain has its unit, such as `0.5[1/s]`, and `largest` is the largest output")
    (Rewritten.controller t name)

(* The hint for a signal of another `proc`. *)
let of_another_proc t (signal : Proc_signals.t) (name : Syntax.Ir.name) =
  match
    ( Name_in_text.equation ~text:t.text signal.name.span,
      Name_in_text.definition ~text:t.text name.span )
  with
  | Some equation, Some (definition, has_where) ->
      Printf.sprintf
        "a signal can only be used inside its `proc`: %s, or make the value a part of this \
         `proc`'s input"
        (if has_where then Printf.sprintf "add `%s` to the `where` of `%s`" equation definition
         else
           Printf.sprintf "add a `where` to the `proc` in `%s`, and `%s` below it" definition
             equation)
  | _ ->
      Printf.sprintf
        "a signal can only be used inside its `proc`: move the equation to the `where` of that \
         `proc`, or write a signal function, `proc %s -> …`"
        name.text

let of_ended_proc ({ text; edits } : Ended_proc.hint) diagnostic =
  Diagnostic.hint text diagnostic |> if edits = [] then Fun.id else Diagnostic.fix text edits

(* An import whose list of names does not contain this one, although the module exports it. *)
let incomplete_import t space name =
  let lacks (import : Syntax.Ir.import) =
    match import.items with
    | Some _ when not import.qualified ->
        List.exists
          (fun (m : of_library) ->
            String.equal m.module_ import.module_.text
            && String_table.mem (space.table m.names) name)
          (Lazy.force t.elsewhere)
    | Some _ | None -> false
  in
  List.find_opt lacks t.syntax.imports

(* `setSpeed 0.3[m/s] 0` of another language, with the arguments of [setVelTR]. *)
let speeds_in_text t (name : Syntax.Ir.name) =
  match Name_in_text.application ~text:t.text name.span with
  | Some (whole, ([ _; _ ] as arguments)) ->
      Some (whole, String.concat " " ("setVelTR" :: arguments))
  | Some _ | None -> None

(* Explains the name of a sensor in another language, applied to the input: `speed i`. *)
let of_a_reading t (name : Syntax.Ir.name) =
  match Name_in_text.application ~text:t.text name.span with
  | Some (whole, [ (("i" | "input") as input) ]) ->
      Option.map
        (fun reading -> (whole, Printf.sprintf reading input))
        (Other_languages.reading name.text)
  | Some _ | None -> None

(* The known name in `v_prev`, `prevV` or `lastV`. *)
let is_previous t ~locals (name : Syntax.Ir.name) =
  let is_signal base =
    List.mem base (Lazy.force locals) || String_table.mem (values.table t.own) base
  in
  List.find_opt is_signal (Other_languages.current name.text)

(* The hint for a word that other robot libraries use, and the text to write in its place, if that
   is certain. *)
let of_robot t ~locals (name : Syntax.Ir.name) =
  match (of_a_reading t name, is_previous t ~locals name) with
  | Some (whole, text), _ -> Some (Printf.sprintf "write `%s`" text, Some (whole, text))
  | None, Some base ->
      Some
        ( Printf.sprintf
            "for the value of `%s` one instant ago, write `delay 0 %s`, where 0 is the initial \
             value"
            base base,
          None )
  | None, None when Name_in_text.is_index ~text:t.text name.span ->
      Some
        ( "for the value of a signal `x` one instant ago, write `delay 0 x`, where 0 is the \
           initial value",
          None )
  | None, None -> (
      match Other_languages.robot name.text with
      | Some hint when Other_languages.is_of_speed name.text -> (
          match speeds_in_text t name with
          | Some (whole, text) when Name_in_text.follows ~text:t.text "roMake (" name.span ->
              Some
                ( Printf.sprintf "write `%s`, which sets the speed and the turn rate" text,
                  Some (whole, text) )
          | Some _ | None -> Some (hint, None))
      | Some hint -> Some (hint, None)
      | None -> None)

(* The hint for a name that nothing else explains. *)
let with_suggestion t space ~locals (name : Syntax.Ir.name) diagnostic =
  let n = String.length name.text in
  let base = String.sub name.text 0 (max 0 (n - 1)) in
  let signature = Option.value (Name_in_text.signature ~text:t.text name.span) ~default:"" in
  if
    String.equal space.noun "name"
    && String.ends_with ~suffix:"'" name.text
    && List.mem base (visible_names t space locals)
    && List.exists (String.equal "Matrix") (String.split_on_char ' ' signature)
  then
    let text = Printf.sprintf "(transpose %s)" base in
    Diagnostic.hint
      (without_imported t
         (Printf.sprintf
            "a `'` is a part of the name: for the transpose of `%s`, write `%s`, with `import \
             Matrix`"
            base text))
      diagnostic
    |> Diagnostic.write name.span text
  else
    let suggested =
      Context.suggest t.context name.text (lazy (visible_names t space locals)) diagnostic
    in
    let is_certain = of_a_reading t name <> None || is_previous t ~locals name <> None in
    match
      match name.text with
      | ("i" | "input" | "sensors") when suggested.hints = [] -> Some (no_input, None)
      | _ -> of_robot t ~locals name
    with
    | Some (hint, edit) when String.equal space.noun "name" && (suggested.hints = [] || is_certain)
      ->
        Diagnostic.hint hint diagnostic
        |> Option.fold edit ~none:Fun.id ~some:(fun (at, text) -> Diagnostic.write at text)
    | Some _ | None -> suggested

(* Explains a signal whose `proc` is in this definition, but ends before the name. *)
let of_this_proc (signal : Proc_signals.t) ~of_proc ~second_where ~has_where diagnostic =
  Diagnostic.label ~at:signal.name.span
    (Printf.sprintf "this `%s` is a signal of the `proc`" signal.name.text)
    diagnostic
  |>
  match Lazy.force of_proc with
  | Some hint when not signal.of_do -> of_ended_proc hint
  | None when (not signal.of_do) && second_where ->
      Diagnostic.hint
        "this second `where` belongs to the whole definition, so it cannot use signals: move its \
         equations into the first `where`"
  | Some _ | None ->
      Diagnostic.hint
        (if signal.of_do then
           "a `where` after `do` belongs to the whole definition and cannot use signals: write a \
            `let` in the `do`"
         else if has_where then
           "the `proc` ends at the bracket before this `where`, which therefore cannot use its \
            signals: move that bracket to the end of the last equation"
         else
           "a `proc` ends at the bracket or comma that follows it; its signals cannot be used \
            after that, nor in a `where` after that")

(* The name with the qualifier of a module that is imported with `qualified`. *)
let qualified_name t space (name : Syntax.Ir.name) =
  let has (i : import) =
    (not i.unqualified) && (not (is_implied i)) && String_table.mem (space.table i.names) name.text
  in
  match List.find_opt has t.imports with
  | Some { qualifiers = q :: _; _ } -> Some (q ^ "." ^ name.text)
  | Some _ | None -> None

(* Is it in an equation of the `where` of the definition? *)
let is_in_a_where t (name : Syntax.Ir.name) =
  match
    (Name_in_text.assigned ~text:t.text name.span, Name_in_text.definition ~text:t.text name.span)
  with
  | Some (x, _, _), Some (whole, has_where) -> has_where && not (String.equal x whole)
  | _ -> false

let report_unknown_name t space ~locals ~signals (name : Syntax.Ir.name) =
  let diagnostic =
    Diagnostic.error ~code:space.unknown ~at:name.span "unknown %s `%s`" space.noun name.text
    |> if c_type_before t name = None then other_meaning t space name else Fun.id
  in
  let is_value = String.equal space.noun "name" in
  let is_it (signal : Proc_signals.t) = String.equal signal.name.text name.text in
  let of_other_proc =
    lazy (if is_value then List.find_opt is_it (Lazy.force t.signals) else None)
  in
  let has (m : of_library) = String_table.mem (space.table m.names) name.text in
  let with_it =
    let all = List.filter has (Lazy.force t.elsewhere) in
    match List.filter (fun m -> m.gathers) all with [] -> all | gathering -> gathering
  in
  let by_qualifier = qualified_name t space name in
  let imports = List.map (fun (m : of_library) -> Printf.sprintf "import %s" m.module_) with_it in
  let signal = List.find_opt is_it (Lazy.force signals) in
  let of_proc =
    lazy
      (if not (is_value && (List.mem name.text [ "i"; "input"; "sensors" ] || signal <> None)) then
         None
       else
         match Ended_proc.without_name t.syntax name with
         | Some hint -> Some hint
         | None -> Ended_proc.of_switch ~text:t.text t.syntax name)
  in
  let other =
    if is_value && Other_languages.robot name.text <> None then None
    else other_writing t space name.text
  in
  let diagnostic =
    match (with_it, other, signal) with
    | _ when of_a_controller t name diagnostic <> None ->
        Option.get (of_a_controller t name diagnostic)
    | _ when by_qualifier <> None ->
        let text = Option.get by_qualifier in
        Diagnostic.hint
          (Printf.sprintf "it is imported under its module's name: write `%s`" text)
          diagnostic
        |> Diagnostic.write name.span text
    | _, _, Some signal ->
        let second_where = Ended_proc.is_in_second_where t.syntax name in
        let has_where = is_in_a_where t name in
        of_this_proc signal ~of_proc ~second_where ~has_where diagnostic
    | _ :: _, _, None -> diagnostic
    | [], None, None when Lazy.force of_proc <> None ->
        of_ended_proc (Option.get (Lazy.force of_proc)) diagnostic
    | [], Some other, None ->
        Diagnostic.hint (Printf.sprintf "did you mean `%s`?" other) diagnostic
        |> Diagnostic.write name.span other
    | [], None, None -> (
        match (of_another_language t space name diagnostic, Lazy.force of_other_proc) with
        | Some explained, _ -> explained
        | None, Some signal ->
            Diagnostic.label ~at:signal.name.span
              (Printf.sprintf "this `%s` is a signal of a `proc`" name.text)
              diagnostic
            |> Diagnostic.hint (of_another_proc t signal name)
        | None, None -> with_suggestion t space ~locals name diagnostic)
  in
  (* the definition has already been reported *)
  let told =
    match space.noun with
    | "constructor" -> List.mem name.text (Lazy.force t.in_capitals)
    | "name" -> List.mem name.text (Lazy.force t.without_definition)
    | _ -> false
  in
  if told then ()
  else if Rewritten.controller t name <> None then Context.emit t.context diagnostic
  else if by_qualifier <> None then Context.emit t.context diagnostic
  else if String.equal space.noun "type" && is_known t classes name.text then report_class t name
  else if with_it <> [] && signal = None then
    let listed = incomplete_import t space name.text in
    Context.not_imported t.context
      { imports; listed; code = space.unknown; noun = space.noun; name }
  else Context.emit t.context diagnostic

let report t space ~locals ~signals (name : Syntax.Ir.name) =
  if Context.holds_many t.context then
    (* Finding advice takes time, and no user reads that much of it. *)
    Diagnostic.error ~code:space.unknown ~at:name.span "unknown %s `%s`" space.noun name.text
    |> Context.emit t.context
  else
    match Rewritten.unit_after_number t space name with
    | Some measure -> report_unit t name measure
    | None -> report_unknown_name t space ~locals ~signals name

(* `Mode.Drive`, where `Mode` is a type and not a module. *)
let is_of_a_type t (qualifier : Syntax.Ir.name) (name : Syntax.Ir.name) =
  is_known t tycons qualifier.text && is_known t constructors name.text

let report_module t (qualifier : Syntax.Ir.name) (name : Syntax.Ir.name) =
  let of_library (m : of_library) = String.equal m.module_ qualifier.text in
  let diagnostic =
    Diagnostic.error ~code:"E0215" ~at:qualifier.span "no module `%s` is imported here"
      qualifier.text
  in
  (if List.exists of_library (Lazy.force t.elsewhere) then
     Diagnostic.hint
       (Printf.sprintf "it is in the library: `import qualified %s`" qualifier.text)
       diagnostic
     |> Context.add_import t.syntax (Printf.sprintf "import qualified %s" qualifier.text)
   else if is_of_a_type t qualifier name then
     let title = Printf.sprintf "remove `%s.`" qualifier.text in
     Diagnostic.hint
       (Printf.sprintf "`%s` is a type; write its constructors without it: %s" qualifier.text title)
       diagnostic
     |> Diagnostic.fix title [ ({ qualifier.span with stop = name.span.start }, "") ]
   else
     match Other_languages.qualifier qualifier.text with
     | Some hint -> (
         let whole = { qualifier.span with stop = name.span.stop } in
         match Name_in_text.call ~text:t.text whole with
         | Some (at, text) when Syntax.Other_notation.expression text <> None ->
             Diagnostic.hint
               (Printf.sprintf "mathematical functions are built in: write `%s`" text)
               diagnostic
             |> Diagnostic.write at (Source.grouped text)
         | Some _ | None -> Diagnostic.hint hint diagnostic)
     | None ->
         let imported =
           lazy
             (List.filter (fun i -> not (is_implied i)) t.imports
             |> List.concat_map (fun (i : import) -> i.qualifiers))
         in
         Context.suggest t.context qualifier.text imported diagnostic)
  |> Context.emit t.context
