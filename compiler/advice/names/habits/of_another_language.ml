open Basis

let explained (t : Unknown.t) hint = Diagnostic.hint "%s" hint (Other_meaning.diagnostic t)

(* {1 Notations} *)

(* `self.k` *)
let member t =
  Option.map
    (fun (whole, field) ->
      explained t (Printf.sprintf "Frob has no objects with methods: write `%s` alone" field)
      |> Diagnostic.write whole field)
    (Rewritten.member t)

(* `x = x + v * dt` *)
let integral t =
  Option.map
    (fun (x, integral, place) ->
      explained t
        (Printf.sprintf "for the sum over time, write `%s = %s`, which needs no time step" x
           integral)
      |> Diagnostic.write place integral)
    (Rewritten.integral t)

let symbol (t : Unknown.t) =
  match t.namespace with
  | Values | Constructors ->
      Option.bind (Phrasebook.find Operator t.name.text) (fun row -> row.replacement)
  | Types | Units | Classes -> None

let operator (t : Unknown.t) =
  Option.map
    (fun symbol ->
      let name = t.name.text in
      Diagnostic.error ~code:(Namespace.unknown t.namespace) ~at:t.name.span "Frob has no `%s`" name
      |> Diagnostic.hint "write `%s` instead of `%s`" symbol name
      |> Diagnostic.write t.name.span symbol)
    (symbol t)

let capital (t : Unknown.t) =
  if
    t.namespace = Constructors && Name_in_text.starts_an_equation ~text:(Unknown.text t) t.name.text
  then
    Some
      (explained t
         (Printf.sprintf "start the name of a value with a lower-case letter: `%s`"
            (Name_in_text.lower_case t.name.text)))
  else None

(* `f"{speed} m/s"` *)
let before_a_text (t : Unknown.t) =
  if t.namespace = Values && Name_in_text.after ~text:(Unknown.text t) t.name.span = '"' then
    Some
      (explained t
         (Printf.sprintf
            "remove `%s`: a string is only a label, so it cannot contain values; to see the value, \
             make it an output"
            t.name.text))
  else None

let call (t : Unknown.t) =
  Option.map
    (fun (whole, text) ->
      let is_an_argument = Name_in_text.is_an_argument ~text:(Unknown.text t) whole in
      let shown = if is_an_argument then Source.grouped text else text in
      let quote = if String.contains shown '`' then "``" else "`" in
      let instead =
        (* the error is at the step, but the fix replaces the whole quotient *)
        if Rewritten.is_time_step t.name.text && Span.line whole.start = Span.line whole.stop then
          Printf.sprintf " instead of `%s`" (Name_in_text.written ~text:(Unknown.text t) whole)
        else ""
      in
      Printf.sprintf "write %s%s%s%s%s" quote shown quote (Rewritten.import_of t text) instead
      |> Imports.without_imported t.module_.visible
      |> explained t
      |> Diagnostic.write whole (Source.grouped text))
    (Rewritten.call t)

(* {1 Words} *)

let last_element =
  "indices start at 0: to get the last element of a 3-element array, write `xs ! 2`"

(* `xs(end)`; elsewhere, `end` has a row in the phrasebook *)
let of_last_element (t : Unknown.t) =
  if
    t.namespace = Values && String.equal t.name.text "end"
    && Name_in_text.before ~text:(Unknown.text t) t.name.span = '('
  then Some (explained t last_element)
  else None

(* `total x = while (x > 0) { … }` *)
let loop (t : Unknown.t) =
  let line = Name_in_text.line_of (Unknown.text t) t.name.span in
  match (t.namespace, Other_loop.as_value line (Span.column t.name.span.start - 1)) with
  | Values, Some { word; hint; _ } when String.equal word t.name.text -> Some (explained t hint)
  | _ -> None

let place (t : Unknown.t) : Phrase.place option =
  match t.namespace with
  | Values -> Some Value
  | Constructors -> Some Constructor
  | Types -> Some Type
  | Classes -> Some Class
  | Units -> None

(* `None` in a definition whose signature has events, but no `Maybe` *)
let of_no_event (t : Unknown.t) =
  let row = if t.namespace = Constructors then Phrasebook.find Constructor t.name.text else None in
  let words =
    Option.fold
      (Name_in_text.signature ~text:(Unknown.text t) t.name.span)
      ~none:[]
      ~some:(fun line ->
        String.split_on_char ' ' (String.map (fun c -> if Character.is_name c then c else ' ') line))
  in
  match Option.bind row Phrasebook.name with
  | Some "Nothing" when List.mem "Event" words && not (List.mem "Maybe" words) ->
      Some
        (explained t "for an event that does not occur, write `NoEvent`"
        |> Diagnostic.write t.name.span "NoEvent")
  | Some _ | None -> None

(* `double :: n[u] -> n[u]` for `double :: Num a => a -> a` *)
let numeric_class (t : Unknown.t) =
  let type_ =
    match t.name.text with
    | "Num" | "Real" -> Some "n[u]"
    | "Fractional" | "Floating" | "RealFrac" | "RealFloat" -> Some "Float[u]"
    | "Integral" -> Some "Int[u]"
    | _ -> None
  in
  let signature () = Name_in_text.signature ~text:(Unknown.text t) t.name.span in
  match (t.namespace, type_) with
  | Classes, Some number ->
      Option.bind (signature ()) (fun line ->
          match (Text_place.find " :: " line, Text_place.find " => " line) with
          | Some colons, Some arrow -> (
              let context = String.sub line (colons + 4) (arrow - colons - 4) in
              let of_words c = if c = '(' || c = ')' then ' ' else c in
              match
                List.filter (( <> ) "") (String.split_on_char ' ' (String.map of_words context))
              with
              | [ class_; variable ] when class_ = t.name.text && Text_place.is_a_name variable ->
                  let ty = String.sub line (arrow + 4) (String.length line - arrow - 4) in
                  Some
                    (explained t
                       (Printf.sprintf "Frob has no numeric type classes: write `%s :: %s`"
                          (String.trim (String.sub line 0 colons))
                          (Phrasebook.with_arguments [ (variable, number) ] (String.trim ty))))
              | _ -> None)
          | _ -> None)
  | _ -> None

let word (t : Unknown.t) =
  let row = Option.bind (place t) (fun place -> Phrasebook.find place t.name.text) in
  Option.map
    (fun row ->
      explained t (Imports.without_imported t.module_.visible (Phrasebook.hint row))
      |> Option.fold (Phrasebook.name row) ~none:Fun.id ~some:(Diagnostic.write t.name.span))
    row

(* {1 C declarations} *)

(* The hint that shows how to write a C declaration in Frob. *)
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

let c_declaration t =
  Option.map
    (fun (d : Proc_signals.c_declaration) ->
      let hint =
        match (d.value, Typed_left.of_declaration t Typed_equation.of_c d) with
        | None, Some typed -> Typed_equation.without_type typed
        | _ -> of_c_declaration d
      in
      Other_meaning.diagnostic t
      |> Diagnostic.label ~at:d.head.span "this defines a function `%s`" d.head.text
      |> Diagnostic.hint "%s" hint)
    (Unknown.c_declaration t)

(* `get_param("speed", 0.3)`, `rospy.get_param("~speed")` or `nh.param("speed", 0.3)` *)
let parameter (t : Unknown.t) =
  let text = Unknown.text t in
  let reads word =
    List.mem word
      [
        "get_param";
        "getParam";
        "get_parameter";
        "declare_parameter";
        "param";
        "parameter";
        "getparam";
      ]
  in
  let stop = Text_place.offset text t.name.span.stop in
  let is_name = Character.is_name in
  let rec last i = if is_name (Text_place.char_at text i) then last (i + 1) else i in
  let after =
    if reads t.name.text then Some stop
    else if Text_place.char_at text stop = '.' then
      let next = last (stop + 1) in
      if reads (String.sub text (stop + 1) (next - stop - 1)) then Some next else None
    else None
  in
  if t.namespace <> Values then None
  else
    Option.map
      (fun found ->
        explained t (Other_parameter.hint text (Text_place.offset text t.name.span.start) found))
      (Option.bind after (Other_parameter.of_arguments text))

(* `millis() < 5000` *)
let clock (t : Unknown.t) =
  let open Let_syntax.Option in
  let* unit_ = match t.name.text with "millis" -> Some "ms" | "micros" -> Some "us" | _ -> None in
  let text = Unknown.text t in
  let rest_at at = String.sub text at (Text_place.end_of_line text at - at) in
  let stop = Text_place.offset text t.name.span.stop in
  let rest = rest_at stop in
  let skipped = if String.starts_with ~prefix:"()" rest then 2 else 0 in
  let rest = String.sub rest skipped (String.length rest - skipped) in
  match List.filter (( <> ) "") (String.split_on_char ' ' rest) with
  | (("<" | ">" | "<=" | ">=") as operator) :: limit :: _
    when Character.is_digit limit.[0] && String.starts_with ~prefix:" " rest ->
      let rec last i =
        if Character.is_digit (Text_place.char_at limit i) then last (i + 1) else i
      in
      let digits = String.sub limit 0 (last 0) in
      if List.mem (Text_place.char_at limit (last 0)) [ '['; '.' ] then None
      else
        Some
          (explained t
             (Printf.sprintf "`time ()` is the time since the start: write `time () %s %s[%s]`"
                operator digits unit_))
  | _ -> None

let rules =
  [
    parameter;
    clock;
    member;
    integral;
    operator;
    capital;
    before_a_text;
    call;
    of_last_element;
    loop;
    of_no_event;
    numeric_class;
    word;
    c_declaration;
  ]

let controller (t : Unknown.t) =
  Option.map
    (fun text ->
      Printf.sprintf "use `%s`, with `import Control`" text
      |> Imports.without_imported t.module_.visible
      |> explained t
      |> Diagnostic.note
           "each gain has its own unit, as in `0.5[1/s]`; `largest` is the maximum output")
    (Rewritten.controller t)
