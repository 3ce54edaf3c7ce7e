open Basis

type reason =
  | Unknown
  | Signature of { name : string; at : Span.t }
  | Annotation of Span.t
  | Parameter of {
      callee : string option;
      at : Span.t;
      position : int;
      decided_by : (Span.t * Type.t) option;
      before : string option;
    }
  | Operand of { operator : string; other : Resolve.Ir.expr; other_type : Type.t }
  | Branch of Span.t
  | Condition
  | Element of Span.t
  | Value of Span.t
  | Pattern of Span.t
  | Statement of Span.t option
  | Last_statement of reason
  | Uses of { name : string; at : Span.t }
  | Field of { name : string; at : Span.t }
  | Output of reason

type expected = { ty : Type.t; because : reason }
let expecting because ty = { ty; because }

type owned = { by : string; place : Span.t }
type owner = Ir.variable -> owned option

open Diagnostic

let name_of (e : Resolve.Ir.expr) =
  match e.desc with
  | Local { name; _ } | Global { name; _ } | Constructor { name; _ } -> Some name
  | Number _ | String _ | Tuple _ | Array _ | Apply _ | Negate _ | Power _ | If _ | Case _ | Let _
  | Lambda _ | Proc _ | Sequence _ | Record _ | Update _ | Field _ | Annotated _ ->
      None

(* A type in a sentence. A number whose representation is open needs no
   invented name for it. *)
let described words t =
  match Type.expand t with
  | Number (r, u) -> (
      let u = Units.resolve u in
      match (Type.representation r, Units.flexible_powers u) with
      | Flexible_representation _, [] ->
          if Units.equal u Units.one then "a number"
          else Printf.sprintf "a number of `%s`" (Show.measure words u)
      | Flexible_representation _, [ _ ]
        when Units.base_powers u = [] && Units.rigid_powers u = [] ->
          "a number"
      | _ -> Show.quoted words t)
  | _ -> Show.quoted words t

(* {1 The other place} *)

let decided words decided_by diagnostic =
  match decided_by with
  | Some (at, ty) ->
      label ~at (Printf.sprintf "because this is %s" (described words ty)) diagnostic
  | None -> diagnostic

let rec explain words reason (expected : Type.t) diagnostic =
  let is_here at = Span.compare at diagnostic.at = 0 in
  let label ~at text = if is_here at then Fun.id else label ~at text in
  match reason with
  | Unknown | Condition | Statement None -> diagnostic
  | Last_statement reason -> explain words reason expected diagnostic
  | Signature { name; at } ->
      label ~at (Printf.sprintf "the signature of `%s` asks for %s" name (described words expected))
        diagnostic
  | Annotation at ->
      label ~at (Printf.sprintf "the annotation asks for %s" (described words expected)) diagnostic
  | Parameter { callee; at; position; decided_by; _ } ->
      let callee = match callee with Some name -> "`" ^ name ^ "`" | None -> "this" in
      label ~at
        (Printf.sprintf "argument %d of %s is %s" position callee (described words expected))
        diagnostic
      |> decided words decided_by
  | Operand { other; other_type; _ } ->
      label ~at:other.span (Printf.sprintf "this is %s" (described words other_type)) diagnostic
  | Branch at ->
      label ~at (Printf.sprintf "this branch is %s" (described words expected)) diagnostic
  | Statement (Some at) ->
      label ~at (Printf.sprintf "so each task of this `do` is %s" (described words expected)) diagnostic
  | Element at ->
      label ~at (Printf.sprintf "the first element is %s" (described words expected)) diagnostic
  | Value at -> label ~at (Printf.sprintf "the value is %s" (described words expected)) diagnostic
  | Pattern at ->
      label ~at (Printf.sprintf "the pattern takes %s" (described words expected)) diagnostic
  | Uses { name; at } ->
      label ~at
        (Printf.sprintf "elsewhere `%s` is used as %s" name (described words expected))
        diagnostic
  | Output (Signature { name; at }) ->
      label ~at
        (Printf.sprintf "the signature of `%s` asks for the output %s" name
           (described words expected))
        diagnostic
  | Output (Parameter { callee; at; position; decided_by; _ }) ->
      let callee = match callee with Some name -> "`" ^ name ^ "`" | None -> "this" in
      label ~at
        (Printf.sprintf "argument %d of %s has the output %s" position callee
           (described words expected))
        diagnostic
      |> decided words decided_by
  | Output reason -> explain words reason expected diagnostic
  | Field { name; at } ->
      label ~at (Printf.sprintf "the field `%s` is %s" name (described words expected)) diagnostic

(* A variable's own definition is the other place if there is no better one. *)
let explain_subject subject reason diagnostic =
  match (subject, reason) with
  | Some ({ desc = Local local; _ } : Resolve.Ir.expr), (Unknown | Condition | Statement None)
    when Span.compare local.span diagnostic.at <> 0 ->
      label ~at:local.span (Printf.sprintf "`%s` is bound here" local.name) diagnostic
  | _ -> diagnostic

(* {1 Units} *)

(* Written as an angle and nothing else: which is a number without a unit. *)
let angle : Resolve.Ir.unit_ option -> string option = function
  | Some { factors = [ (Declared { name = ("deg" | "rad") as name; _ }, _) ]; _ } -> Some name
  | Some _ | None -> None

let is_per_second words u = String.equal (Show.measure words u) "1/s"

(* A plain number written where one with a unit is needed. *)
let unit_of_literal words ~subject ~(expected : expected) (wanted, given) diagnostic =
  let write (e : Resolve.Ir.expr option) unit_ =
    match e with
    | Some { desc = Number { digits; unit_ = None; _ }; _ }
      when Units.flexible_powers unit_ = [] && Units.rigid_powers unit_ = [] ->
        Some (Printf.sprintf "write `%s[%s]` if that is its unit" digits (Show.measure words unit_))
    | Some { desc = Number { digits; unit_ = written; _ }; _ } when is_per_second words unit_ ->
        let per_second angle =
          Printf.sprintf "write `%s[%s/s]` if that is how far it turns in a second" digits angle
        in
        Option.map per_second (angle written)
    | _ -> None
  in
  let other = match expected.because with Operand { other; _ } -> Some other | _ -> None in
  let is_one u = Units.equal u Units.one in
  let text =
    if is_one given then write subject wanted else if is_one wanted then write other given else None
  in
  Option.fold ~none:diagnostic ~some:(fun text -> hint text diagnostic) text

let units words ~subject ~at ~(expected : expected) ~found (wanted, given) =
  let text = Show.measure words and is_one u = Units.equal u Units.one in
  let error format = error ~code:"E0320" ~at format in
  let diagnostic =
    match expected.because with
    | Operand { operator; _ } ->
        error "the operands of `%s` have different units: `%s` and `%s`" operator (text wanted)
          (text given)
    | _ when is_one wanted -> error "expected no unit, found `%s`" (text given)
    | _ when is_one given -> error "expected the unit `%s`, found none" (text wanted)
    | _ -> error "expected the unit `%s`, found `%s`" (text wanted) (text given)
  in
  let is_number t = match Type.expand t with Number _ -> true | _ -> false in
  let diagnostic =
    here (Printf.sprintf "this is %s" (described words found)) diagnostic
    |> unit_of_literal words ~subject ~expected (wanted, given)
  in
  if is_number expected.ty && is_number found then diagnostic
  else
    note
      (Printf.sprintf "expected %s, found %s" (described words expected.ty) (described words found))
      diagnostic

(* {1 Signatures that promise too much} *)

let type_meant (variable : Ir.variable) =
  match String.capitalize_ascii variable.name with
  | ( "Float" | "Double" | "Int" | "Integer" | "Bool" | "String" | "Time" | "Distance" | "Velocity"
    | "Acceleration" | "Angle" ) as type_ ->
      Some type_
  | _ -> None

let variable_like_a_type ~at (variable : Ir.variable) =
  Option.map
    (fun type_ ->
      warning ~code:"W0302" ~at "`%s` is a variable here, and stands for every type" variable.name
      |> hint (Printf.sprintf "the type is `%s`" type_))
    (type_meant variable)

let too_general owner ~at ~kind (variable : Ir.variable) needed =
  let diagnostic =
    error ~code:"E0306" ~at "the signature promises every %s `%s`, but the definition needs %s" kind
      variable.name needed
  in
  (match owner variable with
  | Some { by; place } ->
      label ~at:place (Printf.sprintf "`%s` is any %s in %s" variable.name kind by)
        diagnostic
  | None -> diagnostic)
  |>
  match type_meant variable with
  | Some type_ ->
      hint (Printf.sprintf "the type is `%s`; a name in lower case stands for every %s" type_ kind)
  | None -> Fun.id

let kind_word (r : Type.rigid) = match r.kind with Of_types -> "type" | Of_sizes -> "size"
let needed words t = Printf.sprintf "it to be %s" (described words t)

(* A single unit variable of a signature against a unit without any. *)
let promised_unit (a, b) =
  let alone u =
    match (Units.base_powers u, Units.rigid_powers u, Units.flexible_powers u) with
    | [], [ (r, p) ], [] when Rational.equal p Rational.one -> Some r
    | _ -> None
  in
  match (alone a, alone b) with
  | Some r, _ when Units.rigid_powers b = [] -> Some (r, b)
  | _, Some r when Units.rigid_powers a = [] -> Some (r, a)
  | _ -> None

(* {1 Types of another shape} *)

let rec head_name (e : Resolve.Ir.expr) =
  match e.desc with Apply { head; style = Juxtaposed; _ } -> head_name head | _ -> name_of e

let hint_to_run subject input =
  let on_unit = match Type.expand input with Flexible _ | Tuple [] -> true | _ -> false in
  match (Option.bind subject head_name, on_unit) with
  | Some name, false when Option.bind subject name_of = None ->
      hint (Printf.sprintf "run it on a signal, its last argument: `%s … x`" name)
  | Some name, true when Option.bind subject name_of = None ->
      hint (Printf.sprintf "run it on `()`, its last argument: `%s … ()`" name)
  | Some name, true -> hint (Printf.sprintf "run it on `()`: `%s ()`" name)
  | Some name, false -> hint (Printf.sprintf "run it on a signal, as in `%s x`" name)
  | None, true -> hint "run it on `()`"
  | None, false -> hint "run it on a signal"

let rec missing_arguments t =
  match Type.expand t with Function (_, result) -> 1 + missing_arguments result | _ -> 0

let unrun words ~subject ~at ~input ~found =
  error ~code:"E0303" ~at "a signal function stands where the value of its signal is needed"
  |> here (Printf.sprintf "this is %s" (described words found))
  |> hint_to_run subject input

(* The operand before, if what is expected is nothing but its type. *)
let operand_before (expected : expected) =
  match expected.because with
  | Operand { other; other_type; _ } when Type.repr other_type == Type.repr expected.ty -> Some other
  | _ -> None

let of_a_sequence expected =
  match expected.because with Statement _ | Last_statement _ -> true | _ -> false

let is_event t =
  match Type.expand t with
  | Data { tycon; _ } -> tycon = Environment.built_in "Event"
  | _ -> false

let is_number t = match Type.expand t with Number _ -> true | _ -> false

(* As in `f(x, y)`. *)
let separated_by_commas expected =
  match expected.because with Parameter { position = 1; callee = Some _; _ } -> true | _ -> false

(* Of a place, written as a pair. *)
let vector_fields wanted elements =
  match (wanted, List.length elements) with
  | Type.Data { tycon = { name = "Vec2"; _ }; _ }, 2 -> Some "`Vec2 { x = a, y = b }`"
  | Type.Data { tycon = { name = "Vec3"; _ }; _ }, 3 -> Some "`Vec3 { x = a, y = b, z = c }`"
  | _ -> None

let vector_operator expected =
  match expected.because with
  | Parameter { callee = Some operator; _ } | Operand { operator; _ } -> (
      match operator with
      | "+" -> Some "`^+^`"
      | "-" -> Some "`^-^`"
      | "*" -> Some "`*^` with the number first, and `dot`"
      | _ -> None)
  | _ -> None

let ends_a_mode expected =
  match expected.because with
  | Parameter { position = 1; callee = Some ("switch" | "dSwitch" | "mkTask"); _ } -> true
  | _ -> false

let is_pair t = match Type.expand t with Tuple [ _; _ ] -> true | Flexible _ -> true | _ -> false

(* For `not x > 0`. *)
let hint_to_group name operator =
  hint
    (Printf.sprintf "application binds tighter than `%s`: write `%s (… %s …)`"
       operator name operator)

(* A task, by what goes in, comes out and what it ends with. *)
let as_task t =
  match Type.expand t with
  | Data { tycon; arguments = [ input; output; result ]; _ } when tycon = Environment.task ->
      Some (input, output, result)
  | _ -> None

let is_task t = as_task t <> None

(* How a signal function becomes a task: it ends at its event, or never. *)
let to_task subject output =
  let name = match Option.bind subject name_of with Some name -> name | None -> "sf" in
  match Type.expand output with
  | Tuple [ _; last ] when is_event last ->
      hint (Printf.sprintf "`mkTask %s` is the task that ends when its event occurs" name)
  | _ ->
      hint
        (Printf.sprintf
           "`mkTask (%s &&& event)` ends when the event occurs; `mkTask (%s &&& never)` never does" name
           name)

let task_and_signal_function words ~subject ~at ~found =
  match Type.expand found with
  | Signal_function (_, output) ->
      error ~code:"E0371" ~at "a signal function stands where a task is needed"
      |> here (Printf.sprintf "this is %s" (described words found))
      |> to_task subject output
  | _ ->
      let name = match Option.bind subject name_of with Some name -> name | None -> "t" in
      error ~code:"E0371" ~at "a task stands where a signal function is needed"
      |> here (Printf.sprintf "this is %s" (described words found))
      |> hint
           (Printf.sprintf
              "`runTask %s` is a signal function: `Left` its output while it runs, then `Right` its \
               result"
              name)

(* Two tasks that differ in one thing. *)
let unlike_tasks words ~at (input, output, result) (input', output', result') =
  let differ a b =
    match Type.expand a with
    | Flexible _ -> false
    | _ -> not (String.equal (described words a) (described words b))
  in
  let says format a b = Some (Printf.sprintf format (described words a) (described words b)) in
  let text =
    match (differ input input', differ output output', differ result result') with
    | false, false, true ->
        says "expected a task that ends with %s, but this one ends with %s" result result'
    | false, true, false ->
        says "expected a task whose output is %s, but that of this one is %s" output output'
    | true, false, false ->
        says "expected a task whose input is %s, but that of this one is %s" input input'
    | _ -> None
  in
  Option.map (fun text -> error ~code:"E0301" ~at "%s" text) text

let no_task words ~subject ~at ~found =
  error ~code:"E0370" ~at "the statements of a `do` are tasks, but this is %s" (described words found)
  |> hint
       (match Option.bind subject name_of with
       | Some name -> Printf.sprintf "`return %s` is the task that ends at once with it" name
       | None -> "`let x = …` names a value; `return x` is the task that ends at once with it")

let shapes words ~subject ~at ~(expected : expected) ~found =
  let text t = described words t in
  match (Type.expand expected.ty, Type.expand found, operand_before expected) with
  | wanted, Signal_function _, _ when is_task wanted ->
      task_and_signal_function words ~subject ~at ~found
  | Signal_function _, given, _ when is_task given ->
      task_and_signal_function words ~subject ~at ~found
  | wanted, (Number _ | Bool | String | Tuple _ | Data _ | Rigid _ as given), _
    when is_task wanted && (not (is_task given)) && of_a_sequence expected ->
      no_task words ~subject ~at ~found
  | (Number _ | Bool | String | Tuple _ | Data _ | Rigid _), Signal_function (input, _), _ ->
      unrun words ~subject ~at ~input ~found |> note (Printf.sprintf "expected %s" (text expected.ty))
  | Signal_function (input, _), (Number _ | Bool | String | Tuple _ | Data _ | Rigid _), Some other
    ->
      unrun words ~subject:(Some other) ~at:other.span ~input ~found:expected.ty
      |> label ~at (Printf.sprintf "this is %s" (text found))
  | Signal_function (_, wanted), Signal_function (_, given), _
    when ends_a_mode expected && is_pair wanted && not (is_pair given) ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint "it gives its output together with the event that ends it, as `sf &&& e` does"
  | Signal_function _, Function _, _ ->
      error ~code:"E0304" ~at "expected a signal function, found a function: %s" (text found)
      |> hint "`arr` makes a signal function of a function"
  | Function _, Signal_function _, _ -> (
      let diagnostic =
        error ~code:"E0304" ~at "expected a function, found a signal function: %s" (text found)
      in
      match (expected.because, Type.expand expected.ty) with
      | Parameter { callee = Some "arr"; _ }, _ -> hint "leave out `arr`" diagnostic
      | Parameter { callee = Some "map"; _ }, _ ->
          hint "`mapSF` runs a signal function on each element" diagnostic
      | Parameter { callee = Some "."; _ }, _ ->
          hint "signal functions are composed with `>>>`, from left to right" diagnostic
      | Parameter { callee = Some name; _ }, _ ->
          hint
            (Printf.sprintf "if `%s` is to run it, the signature of `%s` must ask for an `SF`" name
               name)
            diagnostic
      | Signature _, Function (input, output) ->
          hint
            (Printf.sprintf "the type of such a signal function is %s"
               (text (Signal_function (input, output))))
            diagnostic
      | _ -> diagnostic)
  | (Number _ | Bool | String | Tuple _ | Data _), Function _, _ ->
      let missing = missing_arguments found in
      error ~code:"E0301" ~at "expected %s, found the function %s" (text expected.ty) (text found)
      |> hint
           (match Option.bind subject name_of with
           | Some name ->
               Printf.sprintf "`%s` takes %d argument%s" name missing
                 (if missing = 1 then "" else "s")
           | None ->
               if missing = 1 then "an argument is missing" else "some arguments are missing")
  | Number _, Data { tycon = { name = "Vec2" | "Vec3"; _ }; _ }, _ when Option.is_some (vector_operator expected) ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           (Printf.sprintf "vectors have operators of their own: %s"
              (Option.get (vector_operator expected)))
  | Signal_function _, (Number _ | Bool | String | Tuple _ | Data _), None ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint "`constant e` is the signal function that always gives `e`"
  | Tuple (_ :: _ as wanted), Tuple (_ :: _ as given), _
    when List.compare_lengths wanted given <> 0 ->
      error ~code:"E0301" ~at "expected a tuple of %d, found one of %d" (List.length wanted)
        (List.length given)
      |> (match subject with
         | Some { desc = Tuple _; _ } -> Fun.id
         | _ -> here (Printf.sprintf "this is %s" (text found)))
  | wanted, Tuple (_ :: _ as elements), _ when vector_fields wanted elements <> None ->
      error ~code:"E0301" ~at "expected %s, found a tuple of %d" (text expected.ty)
        (List.length elements)
      |> hint (Printf.sprintf "a vector has its fields by name: %s" (Option.get (vector_fields wanted elements)))
  | (Number _ | Bool | String | Data _), Tuple (_ :: _ as elements), _ when separated_by_commas expected ->
      let name = match expected.because with Parameter { callee = Some f; _ } -> f | _ -> "f" in
      let arguments = List.mapi (fun i _ -> Variable_name.nth Variable_name.Type i) elements in
      error ~code:"E0301" ~at "expected %s, found a tuple of %d" (text expected.ty)
        (List.length elements)
      |> hint
           (Printf.sprintf "several arguments stand side by side: `%s %s`" name
              (String.concat " " arguments))
  | _ -> (
      let tasks =
        match (as_task expected.ty, as_task found) with
        | Some wanted, Some given -> unlike_tasks words ~at wanted given
        | _ -> None
      in
      match (tasks, expected.because) with
      | Some diagnostic, _ -> diagnostic
      | None, Condition ->
          error ~code:"E0301" ~at "a condition must be `Bool`, but this is %s" (text found)
          |> if is_event found then hint "`isEvent e` tells whether it occurs now" else Fun.id
      | None, _ when is_number expected.ty && is_event found ->
          error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
          |> hint "an event has a value only where it occurs: `hold x0 e` is the latest one, at first `x0`"
      | None, Parameter { before = Some operator; callee = Some name; _ }
        when Type.expand expected.ty = Bool ->
          error ~code:"E0301" ~at "expected `Bool`, found %s" (text found)
          |> hint_to_group name operator
      | None, Operand { operator; other = { desc = Apply { head; style = Juxtaposed; _ }; _ }; _ }
        when Type.expand expected.ty = Bool && Option.is_some (head_name head) ->
          error ~code:"E0301" ~at "expected `Bool`, found %s" (text found)
          |> hint_to_group (Option.get (head_name head)) operator
      | None, Value _ ->
          error ~code:"E0301" ~at "this pattern matches %s, but the value is %s" (text found)
            (text expected.ty)
      | None, _ -> error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found))

(* Between Int and Float the unit is no matter, unless it is known. *)
let without_open_unit t =
  match Type.expand t with
  | Number (r, u)
    when Units.flexible_powers u <> [] && Units.base_powers u = [] && Units.rigid_powers u = [] ->
      Type.Number (r, Units.one)
  | _ -> t

let to_float (e : Resolve.Ir.expr option) =
  match Option.bind e name_of with
  | Some name -> Printf.sprintf "write `toFloat %s`" name
  | None -> "`toFloat` makes a `Float` of an `Int`"

let to_int (e : Resolve.Ir.expr option) =
  let whole digits =
    match String.index_opt digits '.' with
    | Some point
      when String.for_all (fun c -> c = '0')
             (String.sub digits (point + 1) (String.length digits - point - 1)) ->
        Some (String.sub digits 0 point)
    | Some _ | None -> None
  in
  match e with
  | Some { desc = Number { digits; unit_ = None; _ }; _ } when whole digits <> None ->
      Printf.sprintf "a whole number has no point: `%s`" (Option.get (whole digits))
  | _ -> "`round`, `floor`, `ceiling` and `truncate` make an `Int` of a `Float`"

let representations words ~subject ~at ~(expected : expected) ~found (wanted, given) =
  let text = Show.representation words in
  let found = without_open_unit found in
  let plain () =
    error ~code:"E0312" ~at "expected %s, found %s" (described words expected.ty)
      (described words found)
  in
  match (expected.because, (wanted : Type.representation), (given : Type.representation)) with
  | Operand { operator; other; _ }, Float, Int | Operand { operator; other; _ }, Int, Float ->
      let number = if given = Int then subject else Some other in
      error ~code:"E0312" ~at "the operands of `%s` are %s and %s" operator
        (described words expected.ty) (described words found)
      |> here (Printf.sprintf "this is %s" (described words found))
      |> hint (to_float number)
  | Parameter { callee = Some "/"; _ }, Float, Int ->
      plain () |> hint "`div` divides whole numbers" |> hint (to_float subject)
  | _, Float, Int -> plain () |> hint (to_float subject)
  | _, Int, Float -> plain () |> hint (to_int subject)
  | _ ->
      plain ()
      |> note (Printf.sprintf "`%s` and `%s` are different representations" (text wanted) (text given))

let mismatch words owner ~subject ~at ~(expected : expected) ~found (clash : Unify.clash) =
  (* names of signatures first, so that no invented name repeats one *)
  (match described words expected.ty with
  | "a number" -> ()
  | _ -> ignore (Show.type_ words expected.ty));
  let finish diagnostic =
    diagnostic |> explain words expected.because expected.ty
    |> explain_subject subject expected.because
  in
  match clash with
  | Different_units (wanted, given) -> (
      match promised_unit (wanted, given) with
      | Some (r, unit_) ->
          too_general owner ~at ~kind:"unit" r.variable
            (Printf.sprintf "it to be `%s`" (Show.measure words unit_))
          |> here (Printf.sprintf "this is %s" (described words found))
      | None -> finish (units words ~subject ~at ~expected ~found (wanted, given)))
  | Different_representations (Rigid_representation r, other)
  | Different_representations (other, Rigid_representation r) ->
      too_general owner ~at ~kind:"representation" r.variable
        (Printf.sprintf "it to be `%s`" (Show.representation words other))
  | Different_representations (wanted, given) ->
      let because =
        match expected.because with
        | Operand o -> Operand { o with other_type = without_open_unit o.other_type }
        | because -> because
      in
      let expected = { ty = without_open_unit expected.ty; because } in
      representations words ~subject ~at ~expected ~found (wanted, given)
      |> explain words because expected.ty
      |> explain_subject subject because
  | Different (Rigid r, other) | Different (other, Rigid r) -> (
      match (Type.expand expected.ty, Type.expand found) with
      | _, Signal_function _ | _, Function _ when Type.expand found == other ->
          finish (shapes words ~subject ~at ~expected ~found)
      | _ -> too_general owner ~at ~kind:(kind_word r) r.variable (needed words other))
  | Different _ -> finish (shapes words ~subject ~at ~expected ~found)
  | Infinite _ ->
      finish
        (error ~code:"E0305" ~at "this would need an infinite type: expected %s, found %s"
           (described words expected.ty) (described words found))
  | Escaping ->
      finish
        (error ~code:"E0306" ~at
           "a signature's variable cannot depend on what is outside: expected %s, found %s"
           (described words expected.ty) (described words found))
  | Out_of_range ->
      error ~code:"E0323" ~at "the exponent of a unit is too large"

(* {1 Heads} *)

let negative_argument words ~(minus : Span.t) (function_ : Resolve.Ir.expr) ty =
  let name = Option.value (name_of function_) ~default:"f" in
  error ~code:"E0301" ~at:minus "this `-` subtracts from a function"
  |> label ~at:function_.span (Printf.sprintf "this is %s" (described words ty))
  |> hint (Printf.sprintf "a negative argument needs parentheses: `%s (-1)`" name)


let not_a_function words ~(head : Resolve.Ir.expr) ~position ~at left =
  let callee = match name_of head with Some name -> "`" ^ name ^ "`" | None -> "this" in
  let diagnostic =
    if position = 1 then
      error ~code:"E0302" ~at:head.span "%s is %s, not a function" callee (described words left)
      |> label ~at "it is given an argument here"
    else
      error ~code:"E0302" ~at "%s takes %d argument%s, but is given more" callee (position - 1)
        (if position = 2 then "" else "s")
      |> here "one too many"
      |> label ~at:head.span
           (Printf.sprintf "with %s the result is %s"
              (if position = 2 then "one argument" else Printf.sprintf "%d arguments" (position - 1))
              (described words left))
  in
  if is_task left then
    hint "a task is run by `runTask`: `runTask t` is a signal function" diagnostic
  else diagnostic

let not_a_signal_function words ~(head : Resolve.Ir.expr) found =
  let diagnostic =
    error ~code:"E0304" ~at:head.span "`-<` needs a signal function, but this is %s"
      (described words found)
  in
  match Type.expand found with
  | Function _ -> hint "`arr` makes a signal function of a function" diagnostic
  | _ -> diagnostic

let too_large ~at what =
  Diagnostic.error ~code:"E0316" ~at "the type of %s is too large" what
  |> Diagnostic.note
       (Printf.sprintf "a type has up to %d parts, nested up to %d deep" Final.most_parts
          Final.deepest)
