open Basis
open Typing

let suggest (name : Syntax.Ir.name) known diagnostic =
  match Suggest.closest name.text known with
  | Some near ->
      Diagnostic.hint "did you mean `%s`?" near diagnostic |> Diagnostic.write name.span near
  | None -> diagnostic

(* The constructor that has this field, in a type with several constructors. *)
let one_of_several environment ty name =
  match Type.expand ty with
  | Data { tycon; _ } -> (
      match (Environment.type_ environment tycon).definition with
      | Data { constructors; _ } ->
          List.find_opt (fun (c : Ir.constructor) -> List.mem_assoc name c.fields) constructors
      | Alias _ | Builtin | Foreign -> None)
  | _ -> None

(* The function or signal function of this name: its kind, the types of its parameters, and the type
   of its input. *)
let of_that_name words (name : Syntax.Ir.name) =
  let found earlier (_, ty) =
    match Type.expand ty with
    | Type.Function _ -> Some ("function", Wording.parameters ty)
    | Signal_function _ -> Some ("signal function", Wording.parameters ty)
    | _ -> earlier
  in
  List.fold_left found None (Wording.named words name.text)

(* The arguments in parentheses after the name, as in `e.hold(0)`, and the end of the call. *)
let called_with words (name : Syntax.Ir.name) =
  let stop = name.span.stop in
  Option.bind
    (Source.line (Wording.sources words) name.span.file (Span.line stop))
    (fun line ->
      let first = Span.column stop - 1 in
      let n = String.length line in
      let rec go i depth from arguments =
        if i >= n then None
        else
          let argument () = String.trim (String.sub line from (i - from)) in
          match line.[i] with
          | '(' | '[' | '{' -> go (i + 1) (depth + 1) from arguments
          | ')' when depth = 0 -> Some (List.rev (argument () :: arguments), i + 1 - first)
          | ')' | ']' | '}' -> go (i + 1) (depth - 1) from arguments
          | ',' when depth = 0 -> go (i + 1) depth (i + 1) (argument () :: arguments)
          | _ -> go (i + 1) depth from arguments
      in
      if first >= n || line.[first] <> '(' then None
      else
        Option.map
          (fun (arguments, length) -> (List.filter (( <> ) "") arguments, Span.forward length stop))
          (go (first + 1) 0 (first + 1) []))

(* A function call with the record as an argument, as in `hold 0 e` for `e.hold(0)`. The record
   becomes the argument for the last parameter of its type or, if there is none, for the last
   parameter. *)
let as_a_call parameters ty ~name ~record arguments =
  let is_alike p =
    match (Type.expand p, Option.map Type.expand ty) with
    | Data { tycon; _ }, Some (Data { tycon = other; _ }) -> tycon = other
    | Number _, Some (Number _) | Bool, Some Bool -> true
    | _ -> false
  in
  let last = List.length parameters - 1 in
  let place =
    List.mapi (fun i p -> (i, p)) parameters
    |> List.rev
    |> List.find_opt (fun (_, p) -> is_alike p)
    |> Option.fold ~none:last ~some:fst
  in
  let rec insert i arguments =
    if i = place then record :: arguments
    else
      match arguments with
      | [] -> "…" :: insert (i + 1) []
      | first :: rest -> first :: insert (i + 1) rest
  in
  String.concat " " (name :: insert 0 (List.map Source.grouped arguments))

(* The field of a pose that other libraries give this name. *)
let field_of_that_meaning words name ty =
  let meant =
    match name with
    | "theta" | "yaw" | "angle" | "orientation" | "direction" | "bearing" | "th" -> "heading"
    | "pos" | "location" | "point" | "translation" -> "position"
    | _ -> ""
  in
  match Wording.fields words ty with
  | Some ("Pose", fields) when List.mem meant fields -> Some meant
  | _ -> None

(* A function or signal function of that name, used with field syntax by mistake. *)
let as_a_function words ?ty (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) diagnostic =
  match of_that_name words name with
  | None ->
      Option.map
        (fun row -> Diagnostic.hint "%s" (Phrasebook.hint row) diagnostic)
        (Phrasebook.find Robot name.text)
  | Some (kind, parameters) ->
      let argument = Wording.argument_or "x" words record in
      let arguments, stop = Option.value (called_with words name) ~default:([], name.span.stop) in
      let text = as_a_call parameters ty ~name:name.text ~record:argument arguments in
      Some
        (Diagnostic.hint "`%s` is a %s: write `%s`" name.text kind text diagnostic
        |>
        if List.mem "…" (String.split_on_char ' ' text) then Fun.id
        else
          Diagnostic.fix
            (Printf.sprintf "write `%s`" text)
            [ ({ (Span.merge record.span name.span) with stop }, Printf.sprintf "(%s)" text) ])

let rec takes_an_array (t : Type.t) =
  match Type.expand t with
  | Function (parameter, result) -> (
      match Type.expand parameter with
      | Data { tycon; _ } when tycon = Environment.array -> true
      | _ -> takes_an_array result)
  | _ -> false

let is_of_arrays words (name : Syntax.Ir.name) =
  List.exists (fun (_, ty) -> takes_an_array ty) (Wording.named words name.text)

(* The field of this record that is itself a record with the wanted field. *)
let field_within words ty name =
  let has (_, (field_type : Ir.ty)) =
    match field_type with
    | Data { tycon; _ } ->
        Option.fold
          (Environment.record_of (Wording.environment words) tycon)
          ~none:false
          ~some:(fun constructor -> Environment.position constructor name <> None)
    | _ -> false
  in
  match Type.expand ty with
  | Data { tycon; _ } ->
      Option.bind
        (Environment.record_of (Wording.environment words) tycon)
        (fun constructor -> Option.map fst (List.find_opt has constructor.ir.fields))
  | _ -> None

let path words ty name =
  let own =
    match Type.expand ty with
    | Data { tycon; _ } ->
        Option.bind
          (Environment.record_of (Wording.environment words) tycon)
          (fun constructor -> Environment.position constructor name)
    | _ -> None
  in
  match (own, field_within words ty name) with
  | Some _, _ -> Some name
  | None, Some field -> Some (field ^ "." ^ name)
  | None, None -> None

let is_known t = match Type.expand t with Flexible _ | Erroneous -> false | _ -> true

let has_field words t (name : Syntax.Ir.name) =
  Option.fold (Wording.fields words t) ~none:false ~some:(fun (_, fields) ->
      List.mem name.text fields)

(* Names used in other languages to test whether a value is present. *)
let is_a_test = function
  | "occurred" | "occurs" | "happened" | "fired" | "triggered" | "isSet" | "is_set" | "isPresent"
  | "is_present" | "hasValue" | "has_value" | "isSome" | "is_some" | "isJust" | "isEvent" ->
      true
  | _ -> false

(* The hint for using the value that an event or a `Maybe` may contain. *)
let of_a_content (name : Syntax.Ir.name) ~grouped ~lacks_it t content =
  let start =
    match Option.map Type.expand content with
    | Some (Number _) -> "0"
    | Some Bool -> "False"
    | _ -> "x0"
  in
  let is_event = Environment.is_event t in
  if is_event && lacks_it && is_a_test name.text then
    Printf.sprintf "write `isEvent %s`, which is True when the event occurs" grouped
  else if lacks_it && is_a_test name.text then
    Printf.sprintf "write `maybe False (const True) %s`, which is True if there is a value" grouped
  else if is_event && lacks_it then
    Printf.sprintf
      "an event has a value only when it occurs: write `hold %s %s` for its latest value, which is \
       %s at first"
      start grouped start
  else if lacks_it then
    Printf.sprintf
      "the value may be missing: write `fromMaybe %s %s`, where `%s` replaces a missing value" start
      grouped start
  else if is_event then
    Printf.sprintf
      "an event has a value only when it occurs: write `mapE (\\x -> x.%s) %s` for an event with \
       its `%s`; to keep the latest value, apply `hold x0` to that event, where `x0` is the \
       initial value"
      name.text grouped name.text
  else
    Printf.sprintf
      "the value may be missing: write `maybe x0 (\\x -> x.%s) %s`, where `x0` replaces a missing \
       value"
      name.text grouped

(* Handles types that do not have fields themselves but produce values that may have fields, such as
   signal functions. *)
let through words (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) ty d =
  let text = Option.value (Wording.quote words record.span) ~default:"x" in
  let grouped = Source.grouped text in
  let whole = Span.merge record.span name.span in
  match Type.expand ty with
  | Signal_function (input, output) ->
      let signal = Option.value (Wording.signal words input) ~default:"()" in
      let applied = Printf.sprintf "%s %s" text signal in
      let has_it =
        Option.fold (Wording.fields words output) ~none:false ~some:(fun (_, fields) ->
            List.mem name.text fields)
      in
      let fixed = if has_it then Printf.sprintf "(%s).%s" applied name.text else applied in
      Some
        (Diagnostic.hint "it is a signal function; its output %s `%s`"
           (if has_it then "has this field:" else "is")
           fixed d
        |>
        if String.equal text grouped then
          Diagnostic.fix
            (Printf.sprintf "write `%s`" fixed)
            [ (whole, if has_it then fixed else "(" ^ fixed ^ ")") ]
        else Fun.id)
  | t when Environment.is_event t || Event_mistake.is_maybe t -> (
      let content = Event_mistake.content t in
      let lacks_it =
        Option.fold content ~none:false ~some:(fun t -> is_known t && not (has_field words t name))
      in
      match if lacks_it then as_a_function words ~ty name ~record d else None with
      | Some d when of_that_name words name <> None -> Some d
      | _ -> Some (Diagnostic.hint "%s" (of_a_content name ~grouped ~lacks_it t content) d))
  | Data { tycon; _ }
    when tycon = Environment.array && List.mem name.text [ "size"; "length"; "count"; "len" ] ->
      Some (Diagnostic.hint "`length` is a function: write `length %s`" grouped d)
  | Data { tycon; _ } when tycon = Environment.array && not (is_of_arrays words name) ->
      Some
        (Diagnostic.hint
           "for the field of the first element, write `(%s ! 0).%s`; for the fields of all \
            elements, write `map (\\x -> x.%s) %s`"
           grouped name.text name.text grouped d)
  | _ -> None

(* By convention, the names of robots' input records end in `Input`. *)
let is_an_input ty =
  match Type.expand ty with
  | Data { tycon; _ } -> String.ends_with ~suffix:"Input" tycon.name
  | _ -> false

let is_a_tuple ty = match Type.expand ty with Tuple [ _; _ ] -> true | _ -> false

(* `p.x`, where `p` is a pair of coordinates. *)
let of_a_tuple words (name : Syntax.Ir.name) (record : Resolve.Ir.expr) d =
  let elements =
    match (Bare_number.value words record).desc with
    | Tuple [ a; b ] -> (Wording.quote words a.span, Wording.quote words b.span)
    | _ -> (None, None)
  in
  match (name.text, elements) with
  | ("x" | "y"), (Some x, Some y) ->
      Diagnostic.hint
        "a pair has no fields: write a point as `Vec2 { x = %s, y = %s }`, with `import Geometry`" x
        y d
  | _ ->
      Diagnostic.hint "a pair has no fields: take it apart with an equation such as `(a, b) = %s`"
        (Option.value (Wording.quote words record.span) ~default:"p")
        d

(* `i.scan`, where `i` is the input of a robot. *)
let of_an_input (record : Resolve.Ir.expr) d =
  let i = match record.desc with Local x -> x.name | _ -> "i" in
  Diagnostic.hint
    "a robot's sensors are signal functions of its input: write `frontSonar %s` for the distance \
     in front, or `sonars %s` for all sonars"
    i i d

let is_input_of_a_proc words (record : Resolve.Ir.expr) =
  match record.desc with Local x -> Wording.is_input words x.name | _ -> false

(* The constructor of this type, if it is a record type that has the field. *)
let takes_a_record words input field =
  match Wording.fields words input with
  | Some (constructor, fields) when List.mem field fields -> Some constructor
  | Some _ | None -> None

(* The type of quantity that a field with this name usually contains. *)
let usual_type = function
  | "distance" | "dist" | "range" | "depth" | "length" | "d" | "r" -> Some "Float[m]"
  | "speed" | "velocity" | "vel" | "v" -> Some "Float[m/s]"
  | "time" | "stamp" | "timestamp" | "duration" | "t" -> Some "Float[s]"
  | "omega" | "turn" | "turnRate" | "angularVelocity" | "yawRate" | "w" -> Some "Float[1/s]"
  | "angle" | "bearing" | "heading" | "theta" | "direction" | "yaw" -> Some "Float"
  | "voltage" | "volts" -> Some "Float[V]"
  | _ -> None

(* The field whose type fits the quantity that the name describes, if there is exactly one. *)
let of_the_same_quantity words ty name =
  match (Type.expand ty, usual_type name) with
  | Data { tycon; _ }, Some type_ ->
      Option.bind
        (Environment.record_of (Wording.environment words) tycon)
        (fun constructor ->
          let is_it (_, field) = String.equal (Show.ty field) type_ in
          match List.filter is_it constructor.ir.fields with
          | [ (field, _) ] -> Some field
          | _ -> None)
  | _ -> None

let of_record words (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) ty known =
  let described = Wording.described words ty in
  let error format = Diagnostic.error ~code:"E0310" ~at:name.span format in
  (match one_of_several (Wording.environment words) ty name.text with
  | Some { constructor; _ } ->
      error "not every %s has the field `%s`" described name.text
      |> Diagnostic.hint "only `%s` has it: use a `case` with the pattern `%s { %s = x }`"
           constructor.name constructor.name name.text
  | None -> (
      let d = error "%s has no field `%s`" described name.text in
      let usual () =
        let begins field =
          let rec common i =
            if i < String.length name.text && i < String.length field && name.text.[i] = field.[i]
            then common (i + 1)
            else i
          in
          let n = common 0 in
          String.length name.text > 2 && (n = String.length name.text || n >= 4)
        in
        match (Suggest.closest name.text known, known) with
        | None, _ when List.length (List.filter begins known) = 1 ->
            let field = List.find begins known in
            Diagnostic.hint "did you mean `%s`?" field d |> Diagnostic.write name.span field
        | None, _ :: _ when List.compare_length_with known 8 <= 0 -> (
            let fields = List.map (Printf.sprintf "`%s`") known in
            let d = Diagnostic.note "its fields: %s" (String.concat ", " fields) d in
            match of_the_same_quantity words ty name.text with
            | Some field ->
                Diagnostic.hint "did you mean `%s`?" field d |> Diagnostic.write name.span field
            | None -> d)
        | _ -> suggest name known d
      in
      match (Type.expand ty, Wording.quote words record.span) with
      | Function (input, _), Some f when takes_a_record words input name.text <> None ->
          let constructor = Option.get (takes_a_record words input name.text) in
          Diagnostic.hint "`%s` takes the record as an argument: use `%s (%s { %s = … })`" f f
            constructor name.text d
      | Function (input, _), Some f when Wording.signal words input <> None ->
          let applied = Printf.sprintf "(%s %s)" f (Option.get (Wording.signal words input)) in
          let text = Printf.sprintf "%s.%s" applied name.text in
          Diagnostic.hint "`%s` is a function: write `%s`" f text d
          |> Diagnostic.fix (Printf.sprintf "write `%s`" text) [ (record.span, applied) ]
      | _, Some text when field_of_that_meaning words name.text ty <> None ->
          let field = Option.get (field_of_that_meaning words name.text ty) in
          Diagnostic.hint "write `%s.%s`" (Source.grouped text) field d
          |> Diagnostic.write name.span field
      | _, Some text when field_within words ty name.text <> None ->
          let field = Option.get (field_within words ty name.text) in
          let fixed = Printf.sprintf "%s.%s.%s" (Source.grouped text) field name.text in
          Diagnostic.hint "its part `%s` has this field: write `%s`" field fixed d
          |> Diagnostic.fix
               (Printf.sprintf "write `%s`" fixed)
               [ (name.span, field ^ "." ^ name.text) ]
      | _ -> (
          match through words name ~record ty d with
          | Some d -> d
          | None -> (
              match as_a_function words name ~record d with
              | Some d -> d
              | None when is_a_tuple ty -> of_a_tuple words name record d
              | None when is_an_input ty -> of_an_input record d
              | None -> usual ()))))
  |> Diagnostic.label ~at:record.span "this is %s" described

let of_no_type words (name : Syntax.Ir.name) ~record =
  let d =
    Diagnostic.error ~code:"E0310" ~at:name.span "no type in scope has a field `%s`" name.text
  in
  match as_a_function words name ~record d with
  | Some d -> d
  | None when is_input_of_a_proc words record -> of_an_input record d
  | None -> suggest name (Environment.field_names (Wording.environment words)) d

let of_several_types (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) candidates =
  let names = List.map (fun (g : Ir.Global.t) -> "`" ^ g.name ^ "`") candidates in
  Diagnostic.error ~code:"E0311" ~at:name.span
    "several types have a field `%s`, and nothing determines which one you mean" name.text
  |> Diagnostic.label ~at:record.span "the type of this is unknown"
  |> Diagnostic.note "types with such a field: %s" (String.concat ", " names)
  |> Diagnostic.hint "give the definition a signature"

(* `robotPose i.heading`, which was meant as a field of `robotPose i`. *)
let of_argument words ~at (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) function_ =
  let record = Option.value (Wording.quote words record.span) ~default:"r" in
  Diagnostic.error ~code:"E0310" ~at
    "field access binds tighter than function application: this is a field of `%s`" record
  |> Diagnostic.hint "for a field of the result of `%s`, write `(%s %s).%s`" function_ function_
       record name.text

(* An array function that is called like a method. *)
let called_as_method words ({ at; record; field; arguments } : Application_fact.method_call) d =
  let quote = Wording.argument words in
  let texts = List.map quote (arguments @ [ record ]) in
  if (not (is_of_arrays words field)) || List.mem None texts then d
  else
    let text = String.concat " " (field.text :: List.map Option.get texts) in
    Diagnostic.hint "`%s` is a function: write `%s`" field.text text
      { d with hints = []; fixes = [] }
    |> Diagnostic.fix (Printf.sprintf "write `%s`" text) [ (at, "(" ^ text ^ ")") ]
