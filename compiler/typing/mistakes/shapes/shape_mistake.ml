open Basis
open Diagnostic
open Unrun_mistake
open Vector_mistake
open Argument_mistake

(* As a foreign function without arguments. *)
let of_nothing t =
  match Type.expand t with Function (argument, _) -> Type.expand argument = Tuple [] | _ -> false

(* The input of the proc around, if this function may well be of that. *)
let signal_of words t =
  match Type.expand t with
  | Function (argument, _) -> (
      match Type.expand argument with
      | Flexible _ when not (Show.needs_class words argument) -> None
      | _ -> Show.signal words argument)
  | _ -> None

(* The operand before, if what is expected is nothing but its type. *)
let operand_before (expected : Expected.t) =
  match expected.because with
  | Operand { other; other_type; _ } when Type.repr other_type == Type.repr expected.ty ->
      Some other
  | _ -> None

let of_a_sequence (expected : Expected.t) =
  match expected.because with Statement _ | Last_statement _ -> true | _ -> false

let is_maybe t =
  match Type.expand t with Data { tycon; _ } -> tycon = Environment.built_in "Maybe" | _ -> false

let is_number t = match Type.expand t with Number _ -> true | _ -> false

(* As in `f(x, y)`. *)
let separated_by_commas (expected : Expected.t) =
  match expected.because with
  | Parameter { position = 1; callee = Some name; _ } -> (
      match name.[0] with 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false)
  | _ -> false

let is_function t = match Type.expand t with Function _ -> true | _ -> false

(* Functions of a tuple, one after the other. *)
let composed words subject d =
  let parts =
    match (subject : Resolve.Ir.expr option) with
    | Some { desc = Tuple es; _ } ->
        List.map (fun (e : Resolve.Ir.expr) -> Show.quote words e.span) es
    | _ -> [ None ]
  in
  if List.mem None parts then hint "functions are composed by `.`: `f . g`" d
  else
    let text = String.concat " . " (List.map Option.get parts) in
    hint (Printf.sprintf "functions are composed by `.`: `%s`" text) d |> instead subject text

let is_a_parameter (expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some name; _ } ->
      not (List.mem name [ "+"; "-"; "*"; "/"; "^+^"; "^-^"; "*^" ])
  | _ -> false

(* A value of `return` alone, which any task could be. *)
let is_only_returned words t =
  match Environment.as_task t with
  | Some (input, output, _) -> (
      match (Type.expand input, Type.expand output) with
      | Flexible _, Flexible _ -> not (Show.needs_class words input || Show.needs_class words output)
      | _ -> false)
  | None -> false

(* For `not x > 0`. *)
let hint_to_group name operator =
  hint
    (Printf.sprintf "application binds tighter than `%s`: write `%s (… %s …)`" operator name
       operator)

(* Of a lambda that is an argument: what is expected is said of the whole of it. *)
let is_a_body ~(at : Span.t) (expected : Expected.t) =
  match expected.because with
  | Parameter { given; position; _ } -> (
      match List.nth_opt given (position - 1) with
      | Some { desc = Lambda _; span } -> Span.compare span at <> 0
      | _ -> false)
  | _ -> false

(* As `p.1`, which composes functions. *)
let is_selected (expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some "."; _ } | Operand { operator = "."; _ } -> true
  | _ -> false

let takes (expected : Expected.t) =
  match expected.because with Parameter { takes; _ } -> takes | _ -> 0

let shapes words ~subject ~at ~(expected : Expected.t) ~found =
  let text t = Show.described words t in
  let quote = Option.bind subject (fun (e : Resolve.Ir.expr) -> Show.quote words e.span) in
  let raw otherwise = Option.value quote ~default:otherwise in
  let written otherwise = Option.fold quote ~none:otherwise ~some:Source.grouped in
  let is_event = hint (Printf.sprintf "`isEvent %s` tells whether it occurs now" (written "e")) in
  match (Type.expand expected.ty, Type.expand found, operand_before expected) with
  | wanted, Signal_function _, _ when Environment.is_task wanted ->
      Task_mistake.task_and_signal_function words ~subject ~at ~expected ~found
  | Signal_function _, given, _ when Environment.is_task given ->
      Task_mistake.task_and_signal_function words ~subject ~at ~expected ~found
  | wanted, ((Number _ | Bool | String | Tuple _ | Data _ | Rigid _) as given), _
    when Environment.is_task wanted && (not (Environment.is_task given)) && of_a_sequence expected
    ->
      Task_mistake.no_task words ~subject ~at ~found
  | Data { tycon = { name = "Test"; _ }; _ }, Signal_function (input, _), _ ->
      let sf = written "sf" in
      error ~code:"E0301" ~at "a test is no signal function: it says how long that is to hold"
      |> here (Printf.sprintf "this is %s" (text found))
      |> hint
           (match Type.expand input with
           | Data { tycon = { name = "Truth"; _ }; _ } ->
               Printf.sprintf
                 "what is to hold in the simulator is a trial: `trial \"name\" = Trial { world = \
                  \"room.toml\", lasts = 10[s], seeds = 1 `to` 20, judge = %s }`"
                 (raw "sf")
           | _ -> Printf.sprintf "`during 10[s] %s` is a test" sf)
  | (Number _ | Bool | String | Tuple _ | Data _ | Rigid _), Signal_function (input, _), _ ->
      unrun words ~subject ~at ~wanted:expected.ty ~input ~found
      |> note (Printf.sprintf "expected %s" (text expected.ty))
  | Signal_function (input, _), (Number _ | Bool | String | Tuple _ | Data _ | Rigid _), Some other
    ->
      unrun words ~subject:(Some other) ~at:other.span ~wanted:found ~input ~found:expected.ty
      |> label ~at (Printf.sprintf "this is %s" (text found))
  | Signal_function _, _, None when Switch_mistake.of_a_mode words ~subject ~expected ~found <> None
    ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Option.get (Switch_mistake.of_a_mode words ~subject ~expected ~found))
  | Signal_function (_, wanted), Function (_, given), _
    when Environment.is_event wanted && Type.expand given = Bool ->
      error ~code:"E0304" ~at "expected a signal function, found a function: %s" (text found)
      |> hint
           (match Option.bind subject Plain_name.of_expr with
           | Some name -> Printf.sprintf "`proc x -> edge (%s x)` occurs when it becomes True" name
           | None -> "`proc x -> edge (f x)` occurs when `f x` becomes True")
  | Signal_function _, Function _, _ -> (
      error ~code:"E0304" ~at "expected a signal function, found a function: %s" (text found)
      |>
      match Option.bind subject (fun (e : Resolve.Ir.expr) -> Show.quote words e.span) with
      | Some text ->
          fun d ->
            let text = "arr " ^ Source.grouped text in
            hint (Printf.sprintf "`arr` makes a signal function of a function: `%s`" text) d
            |> instead subject text
      | None -> (
          match Show.quote words at with
          | Some text when text.[0] = '\\' ->
              hint
                "a signal function is written `proc x -> …`, with `proc` in place of `\\`; `arr` \
                 makes one of a function"
          | _ -> hint "`arr` makes a signal function of a function"))
  | Function _, Signal_function _, _ -> (
      let diagnostic =
        error ~code:"E0304" ~at "expected a function, found a signal function: %s" (text found)
      in
      match (expected.because, Type.expand expected.ty) with
      | _ when Switch_mistake.goes_on expected ->
          let sf = Option.bind subject (fun (e : Resolve.Ir.expr) -> Show.quote words e.span) in
          let text = "\\_ -> " ^ Option.value sf ~default:"…" in
          hint (Printf.sprintf "it is given a value, and may ignore it: `%s`" text) diagnostic
          |> if sf = None then Fun.id else instead subject text
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
  | _, Function _, _
    when of_a_sequence expected && Option.is_some (Output_mistake.hint_without_instance found) ->
      error ~code:"E0370" ~at "the statements of a `do` are tasks, but this is %s" (text found)
      |> hint
           (let output = Printf.sprintf "(roMake %s)" (written "(…)") in
            Printf.sprintf
              "`sleepT 1[s] %s` is a task that does so for a second, `constT %s` one that never \
               ends"
              output output)
  | (Data _ | Rigid _), (Function _ | Data _), _
    when Option.is_some (Output_mistake.hint ~subject ~expected:expected.ty ~found) ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Option.get (Output_mistake.hint ~subject ~expected:expected.ty ~found))
  | Number _, Function (from, _), _
    when Array_mistake.is_array from && Array_mistake.extreme words subject <> None ->
      error ~code:"E0301" ~at "expected %s, found the function %s" (text expected.ty) (text found)
      |> hint (Option.get (Array_mistake.extreme words subject))
  | (Number _ | Bool | String | Tuple _ | Data _), Function _, _ ->
      let missing = missing_arguments found in
      let d =
        error ~code:"E0301" ~at "expected %s, found the function %s" (text expected.ty) (text found)
      in
      let applied text d =
        let instead (e : Resolve.Ir.expr) =
          fix (Printf.sprintf "write `%s`" text) [ (e.span, "(" ^ text ^ ")") ] d
        in
        hint (Printf.sprintf "write `%s`" text) (Option.fold subject ~none:d ~some:instead)
      in
      let usual d =
        match Option.bind subject Plain_name.of_expr with
        | Some name when missing = 1 && of_nothing found -> applied (name ^ " ()") d
        | Some name when missing = 1 && signal_of words found <> None -> (
            let text = Printf.sprintf "%s %s" name (Option.get (signal_of words found)) in
            match expected.because with
            | Parameter { callee = Some f; position = 1; before = None; _ } ->
                hint
                  (Printf.sprintf
                     "write `%s (%s)`: what is applied stands in parentheses as an argument" f text)
                  d
            | _ -> applied text d)
        | Some name ->
            hint
              (Printf.sprintf "`%s` takes %d argument%s" name missing
                 (if missing = 1 then "" else "s"))
              d
        | None
          when missing = 1 && Environment.is_task expected.ty
               && Option.bind subject Plain_name.of_head = Some "sleepT" ->
            let cure = Printf.sprintf "%s restingOutput" (raw "sleepT 1[s]") in
            hint
              (Printf.sprintf "`%s` waits with the robot at rest; any other output may stand there"
                 cure)
              d
            |> fix (Printf.sprintf "write `%s`" cure) [ (at, cure) ]
        | None when declared words subject <> None ->
            let name, ty = Option.get (declared words subject) in
            hint
              (Printf.sprintf "%s missing, %s `%s :: %s`"
                 (if missing = 1 then "an argument is" else count missing ^ " are")
                 (match input_given words subject found with
                 | Some x -> Printf.sprintf "before `%s`:" x
                 | None -> "the last of")
                 name ty)
              d
        | None when missing = 1 -> hint "an argument is missing" d
        | None -> hint "some arguments are missing" d
      in
      Option.value (lacking_arguments words ~subject missing d) ~default:(usual d)
  | Function _, Function _, _
    when missing_arguments found > missing_arguments expected.ty
         && Option.is_some (Option.bind subject Plain_name.of_head) ->
      let too_many = missing_arguments found - missing_arguments expected.ty in
      error ~code:"E0301" ~at "expected a function of %s, found one of %d: %s"
        (count (missing_arguments expected.ty))
        (missing_arguments found) (text found)
      |> hint
           (Printf.sprintf "`%s` lacks %s"
              (Option.get (Option.bind subject Plain_name.of_head))
              (count too_many))
  | Number _, Data { tycon = { name = "Vec2" | "Vec3"; _ }; _ }, _
    when Option.is_some (vector_operator expected) ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           (Printf.sprintf "vectors have operators of their own: %s"
              (Option.get (vector_operator expected)))
  | Number _, _, _
    when Array_mistake.is_array found && Array_mistake.computed words ~subject expected <> None ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Option.get (Array_mistake.computed words ~subject expected))
  | Signal_function _, (Number _ | Bool | String | Tuple _ | Data _), None ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint "`constant e` is the signal function that always gives `e`"
  | Function _, Tuple (_ :: _), _ when is_selected expected ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           (Printf.sprintf
              "a tuple is taken apart by an equation, `(a, b) = %s`; of a pair there are `fst %s` \
               and `snd %s`"
              (raw "p") (raw "p") (raw "p"))
  | Data _, Number _, Some _ when Show.fields words expected.ty <> None ->
      let _, fields = Option.get (Show.fields words expected.ty) in
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           (Printf.sprintf "the other one is a record, with the fields %s: `r.%s`"
              (String.concat ", " (List.map (Printf.sprintf "`%s`") fields))
              (List.hd fields))
  | Function _, (Number _ | Bool | String | Data _), _ when is_a_body ~at expected ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           "the function is given one argument more: `_` behind its parameters leaves it unused, \
            as in `\\n _ -> …`"
  | Tuple (_ :: _ as wanted), (Number _ | Bool | Data _), _ when is_a_parameter expected ->
      let name = match expected.because with Parameter { callee = Some f; _ } -> f | _ -> "f" in
      let written =
        match expected.because with
        | Parameter { given; position; _ }
          when List.length given - position + 1 = List.length wanted ->
            List.map
              (fun (e : Resolve.Ir.expr) -> Show.quote words e.span)
              (List.filteri (fun i _ -> i >= position) given)
        | _ -> []
      in
      let before =
        match expected.because with
        | Parameter { given; position; _ } ->
            List.filteri (fun i _ -> i < position - 1) given
            |> List.map (fun (e : Resolve.Ir.expr) ->
                   " " ^ Option.fold (Show.quote words e.span) ~none:"…" ~some:Source.grouped)
            |> String.concat ""
        | _ -> ""
      in
      let other i _ =
        match List.nth_opt written i with
        | Some (Some text) -> text
        | Some None | None -> Variable_name.nth Variable_name.Type (i + 1)
      in
      let others = List.mapi other (List.tl wanted) in
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           (Printf.sprintf "`%s` takes one tuple of %d: `%s%s (%s)`" name (List.length wanted) name
              before
              (String.concat ", " (raw "a" :: others)))
  | Tuple (_ :: _ as wanted), Tuple (_ :: _ as given), _ when List.compare_lengths wanted given <> 0
    -> (
      error ~code:"E0301" ~at "expected a tuple of %d, found one of %d" (List.length wanted)
        (List.length given)
      |> (match subject with
         | Some { desc = Tuple _; _ } -> Fun.id
         | _ -> here (Printf.sprintf "this is %s" (text found)))
      |>
      match expected.because with
      | Parameter { callee = Some ("fst" | "snd"); _ } ->
          let parts = List.mapi (fun i _ -> Variable_name.nth Variable_name.Type i) given in
          hint
            (Printf.sprintf "an equation takes it apart: `(%s) = %s`" (String.concat ", " parts)
               (raw "p"))
      | Pattern _ ->
          let parts = List.mapi (fun i _ -> Variable_name.nth Variable_name.Type i) given in
          hint (Printf.sprintf "a pattern for it is `(%s)`" (String.concat ", " parts))
      | _ -> Fun.id)
  | Data _, Tuple (_ :: _ as given), _ when Array_mistake.is_array expected.ty ->
      let elements =
        match subject with
        | Some { desc = Tuple es; _ } ->
            List.map (fun (e : Resolve.Ir.expr) -> Show.quote words e.span) es
        | _ -> [ None ]
      in
      error ~code:"E0301" ~at "expected %s, found a tuple of %d" (text expected.ty)
        (List.length given)
      |> hint
           (if List.mem None elements then
              let parts = List.mapi (fun i _ -> Variable_name.nth Variable_name.Type i) given in
              let parts = String.concat ", " parts in
              Printf.sprintf
                "a tuple is taken apart by an equation, `(%s) = %s`; an array is written in \
                 brackets, `[%s]`"
                parts (raw "p") parts
            else
              Printf.sprintf "an array is written in brackets: `[%s]`"
                (String.concat ", " (List.map Option.get elements)))
  | Data { tycon = { name; _ }; _ }, Number _, _
    when Number_mistake.makes name (written "x") <> None ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Option.get (Number_mistake.makes name (written "x")))
  | Number _, Data _, _ when Show.fields words found <> None ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Record_mistake.parts words ~subject ~record:(written "r") found)
  | Number _, String, _ ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint "a text is a label: nothing is computed with it, and none is joined to another"
  | Tuple (_ :: _ as parts), given, _
    when Array_mistake.is_array given && Array_mistake.as_a_tuple words subject parts <> None ->
      let place, tuple = Option.get (Array_mistake.as_a_tuple words subject parts) in
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Printf.sprintf "a tuple stands in parentheses: `%s`" tuple)
      |> write place tuple
  | Bool, given, _ when Environment.is_task given && Task_mistake.beside_each_other expected <> None
    ->
      error ~code:"E0301" ~at "expected `Bool`, found %s" (text found)
      |> hint (Option.get (Task_mistake.beside_each_other expected))
  | (Function _ as lacking), Number _, Some ({ desc = Apply { style = Juxtaposed; _ }; _ } as e)
    when declared words (Some e) <> None && missing_arguments lacking = 1 ->
      let name, ty = Option.get (declared words (Some e)) in
      error ~code:"E0301" ~at:e.span "`%s` lacks an argument" name
      |> label ~at "so it is no number, as this is"
      |> hint (Printf.sprintf "the last one is missing: `%s :: %s`" name ty)
  | Data { arguments = [ n; _ ]; _ }, Data { arguments = [ n'; _ ]; _ }, _
    when Array_mistake.is_array expected.ty
         && Array_mistake.is_array found && Array_mistake.unlike_sizes n n' ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           (match subject with
           | Some { desc = Array elements; _ } ->
               Printf.sprintf "%d are written here; an array of as many has the type %s"
                 (List.length elements) (text found)
           | _ ->
               "the two have different numbers of elements; `take` and `drop` make an array of the \
                size that its type says")
  | _, given, _ when Array_mistake.mapped expected given <> None ->
      let name, of_what, place = Option.get (Array_mistake.mapped expected given) in
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Printf.sprintf "a function %s is applied by `%s`" of_what name)
      |> write place name
  | (Number _ | Bool | Data _ | Tuple (_ :: _)), given, _
    when Environment.is_task given && is_only_returned words given
         && not (Environment.is_task expected.ty) ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           "`return` makes a task: the value of a function or an equation is what stands behind \
            its `=`, without a `return`"
  | Data _, Data _, _ when Show.makers words expected.ty ~of_:found <> [] ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint
           (Printf.sprintf "%s makes one of such a value"
              (String.concat " or "
                 (List.map (Printf.sprintf "`%s`") (Show.makers words expected.ty ~of_:found))))
  | wanted, Number _, _ when is_a_parameter expected && vector words wanted <> None ->
      let elements = Option.to_list subject in
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint ("a vector has its fields by name: " ^ Option.get (vector words ~elements wanted))
  | Data _, (Number _ | Bool), _ when Record_mistake.built words expected <> None ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Option.get (Record_mistake.built words expected))
  | wanted, Data _, _ when Record_mistake.elements words ~wanted found <> None ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> hint (Option.get (Record_mistake.elements words ~wanted found))
  | wanted, Tuple (_ :: _ as types), _ when vector_fields words ~subject wanted types <> None ->
      error ~code:"E0301" ~at "expected %s, found a tuple of %d" (text expected.ty)
        (List.length types)
      |> hint
           ("a vector has its fields by name: "
           ^ Option.get (vector_fields words ~subject wanted types))
  | Function _, Tuple (_ :: _ :: _ as given), _ when List.for_all is_function given ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> composed words subject
  | (Function _ as wanted), (Number _ | Bool | Data _ | Tuple _), _ ->
      error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
      |> one_too_many words ~subject ~wanted
  | (Number _ | Bool | String | Data _), Tuple (_ :: _ as elements), _
    when separated_by_commas expected ->
      let name = match expected.because with Parameter { callee = Some f; _ } -> f | _ -> "f" in
      let written =
        match subject with
        | Some { desc = Tuple es; _ } ->
            List.map (fun (e : Resolve.Ir.expr) -> Show.quote words e.span) es
        | _ -> []
      in
      let argument i _ =
        match List.nth_opt written i with
        | Some (Some text) -> Source.grouped text
        | _ -> Variable_name.nth Variable_name.Type i
      in
      let arguments = List.mapi argument elements in
      error ~code:"E0301" ~at "expected %s, found a tuple of %d" (text expected.ty)
        (List.length elements)
      |> hint
           (match (takes expected, name) with
           | 1, "atan" ->
               Printf.sprintf "of two numbers it is `atan2 %s`" (String.concat " " arguments)
           | 1, _ -> Printf.sprintf "`%s` takes one argument, and no tuple" name
           | _ ->
               Printf.sprintf "several arguments stand side by side: `%s %s`" name
                 (String.concat " " arguments))
  | _ -> (
      let tasks =
        match (Environment.as_task expected.ty, Environment.as_task found) with
        | Some wanted, Some given ->
            Task_mistake.unlike_tasks words ~at ~because:expected.because wanted given
        | _ -> None
      in
      match (tasks, expected.because) with
      | Some diagnostic, _ -> diagnostic
      | None, because when Event_mistake.hint words ~subject ~expected ~found <> None ->
          (match because with
          | Value _ ->
              error ~code:"E0301" ~at "this pattern matches %s, but the value is %s" (text found)
                (text expected.ty)
          | Condition ->
              error ~code:"E0301" ~at "a condition must be `Bool`, but this is %s" (text found)
          | _ -> error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found))
          |> hint (Option.get (Event_mistake.hint words ~subject ~expected ~found))
      | None, Condition when Environment.is_task found ->
          error ~code:"E0301" ~at "a condition must be `Bool`, but this is %s" (text found)
          |> hint
               (Printf.sprintf
                  "the task runs on a line before, which names its result: `ok <- %s`, and here \
                   stands `ok`"
                  (raw "t"))
      | None, (Parameter _ | Operand _ | Field _ | Signature _ | Output _ | Branch _)
        when Show.choices words expected.ty <> [] ->
          error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
          |> hint
               (Printf.sprintf "it is %s%s"
                  (String.concat " or "
                     (List.map (Printf.sprintf "`%s`") (Show.choices words expected.ty)))
                  (match (Show.choices words expected.ty, Type.expand found) with
                  | [ _; _ ], Bool -> Printf.sprintf ", as in `if %s then … else …`" (raw "b")
                  | _ -> ""))
      | None, Condition when Truth_mistake.compared words ~subject found <> None ->
          error ~code:"E0301" ~at "a condition must be `Bool`, but this is %s" (text found)
          |> hint (Option.get (Truth_mistake.compared words ~subject found))
      | None, Condition ->
          error ~code:"E0301" ~at "a condition must be `Bool`, but this is %s" (text found)
          |> if Environment.is_event found then is_event else Fun.id
      | None, (Parameter _ | Operand _ | Output _ | Field _ | Signature _)
        when is_maybe found && not (is_maybe expected.ty) ->
          error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
          |> hint
               (Printf.sprintf "`fromMaybe x0 %s` is what is in it, and `x0` where there is nothing"
                  (written "m"))
      | None, _ when is_number expected.ty && Environment.is_event found ->
          error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
          |> hint
               (Printf.sprintf
                  "an event has a value only where it occurs: `hold x0 %s` is the latest one, at \
                   first `x0`%s"
                  (written "e")
                  (Option.fold
                     (Array_mistake.with_each words ~subject expected)
                     ~none:""
                     ~some:(Printf.sprintf "; `mapE %s` computes with each one")))
      | None, _
        when Type.expand expected.ty = Bool
             && Environment.is_event found
             && Truth_mistake.of_events words ~subject expected <> None ->
          error ~code:"E0301" ~at "expected `Bool`, found %s" (text found)
          |> hint (Option.get (Truth_mistake.of_events words ~subject expected))
      | None, _ when Environment.is_event expected.ty && Type.expand found = Bool ->
          error ~code:"E0301" ~at "expected %s, found `Bool`" (text expected.ty)
          |> hint
               (Printf.sprintf
                  "`edge %s` occurs when it becomes True, `when %s` wherever it is, each with \
                   `()`; `tag` gives it another value"
                  (written "b") (written "b"))
      | None, Parameter { before = Some operator; callee = Some name; _ }
        when Type.expand expected.ty = Bool ->
          error ~code:"E0301" ~at "expected `Bool`, found %s" (text found)
          |> hint_to_group name operator
      | None, Operand { operator = ("==" | "/=") as operator; other; _ }
        when Type.expand expected.ty = Bool
             && is_number found
             && Show.quote words other.span <> None ->
          let truth = Option.get (Show.quote words other.span) in
          let negated = Printf.sprintf "not %s" (Source.grouped truth) in
          error ~code:"E0301" ~at "expected `Bool`, found %s" (text found)
          |> hint
               (match (raw "1", operator) with
               | "1", "==" | "0", "/=" ->
                   Printf.sprintf "it is True or False by itself: write `%s`" truth
               | "0", "==" | "1", "/=" ->
                   Printf.sprintf "it is True or False by itself: write `%s`" negated
               | _ -> Printf.sprintf "it is True or False by itself: `%s`, or `%s`" truth negated)
      | None, Operand { operator; other = { desc = Apply { head; style = Juxtaposed; _ }; _ }; _ }
        when Type.expand expected.ty = Bool && Option.is_some (Plain_name.of_head head) ->
          error ~code:"E0301" ~at "expected `Bool`, found %s" (text found)
          |> hint_to_group (Option.get (Plain_name.of_head head)) operator
      | None, (Parameter { before = None; _ } | Operand { other = { desc = Apply _; _ }; _ })
        when Type.expand expected.ty = Bool && Truth_mistake.compared words ~subject found <> None
        ->
          error ~code:"E0301" ~at "expected `Bool`, found %s" (text found)
          |> hint (Option.get (Truth_mistake.compared words ~subject found))
      | None, Element _ ->
          error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found)
          |> hint
               "all elements of an array have one type; values of several types stand in a tuple, \
                `(a, b)`, or in a record"
      | None, Value _ ->
          error ~code:"E0301" ~at "this pattern matches %s, but the value is %s" (text found)
            (text expected.ty)
      | None, _ -> error ~code:"E0301" ~at "expected %s, found %s" (text expected.ty) (text found))
