open Basis
open Typing
open Diagnostic
open Shape_fact
open Unrun_mistake

(* The head of an application and its declared type. *)
let rec declared words (e : Resolve.Ir.expr option) =
  match e with
  | Some { desc = Apply { head; style = Juxtaposed; _ }; _ } -> declared words (Some head)
  | Some { desc = Global g; _ } -> Option.map (fun ty -> (g.name, ty)) (Wording.declared words g)
  | _ -> None

let rec missing_arguments t =
  match Type.expand t with Function (_, result) -> 1 + missing_arguments result | _ -> 0

(* {1 A function where a value is expected} *)

(* `foldl max row` with an initial value inserted *)
let start_lacking fact ~missing (e : Resolve.Ir.expr) =
  let quote = Wording.argument fact.words in
  match (fact.wanted, fact.given, Plain_name.of_head e, List.map quote (arguments_of e)) with
  | Number _, Function (_, result), Some "foldl", [ Some f; Some xs ]
    when missing = 1 && Array_mistake.is_array result ->
      Some (Printf.sprintf "foldl %s 0 %s" f xs)
  | _ -> None

(* Reports the missing arguments at the definition of the local name that refers to the application.
   *)
let missing_in_definition fact ~missing d =
  match fact.subject with
  | Some { desc = Local x; _ }
    when Option.bind (Wording.definition fact.words x) (start_lacking fact ~missing) <> None ->
      let e = Option.get (Wording.definition fact.words x) in
      let text = Option.get (start_lacking fact ~missing e) in
      label ~at:e.span "this is `%s`; it lacks its second argument" x.name d
      |> hint "`foldl` needs an initial value: write `%s`" text
      |> write e.span text |> Option.some
  | Some { desc = Local x; _ } -> (
      match Option.map (fun e -> (e, Plain_name.of_head e)) (Wording.definition fact.words x) with
      | Some (({ desc = Apply _; _ } as e), Some head) ->
          let all = missing + List.length (arguments_of e) in
          label ~at:e.span "this is `%s`; it lacks %s" x.name (count missing) d
          |> hint "%s"
               (match declared fact.words (Some e) with
               | Some (_, ty) when List.compare_length_with (arguments_of e) 0 > 0 ->
                   Printf.sprintf "`%s` takes %s: `%s :: %s`" head (count all) head ty
               | _ -> Printf.sprintf "`%s` takes %s" head (count all))
          |> Option.some
      | _ -> None)
  | _ -> None

(* Suggests replacing the name with the application. *)
let applied fact text d = hint "write `%s`" text (Unrun_mistake.instead fact.subject text d)

(* An input of the enclosing proc that could be this function's argument. *)
let signal_of words t =
  match Type.expand t with
  | Type.Function (argument, _) -> (
      match Type.expand argument with
      | Flexible _ when not (Wording.needs_class words argument) -> None
      | _ -> Wording.signal words argument)
  | _ -> None

(* A function that takes `()`, like a foreign function without arguments. *)
let missing_unit fact ~missing d =
  match (name fact, fact.given) with
  | Some name, Function (argument, _) when missing = 1 && Type.expand argument = Tuple [] ->
      Some (applied fact (name ^ " ()") d)
  | _ -> None

(* A function whose only missing argument could be an input of the enclosing proc. *)
let missing_signal fact ~missing d =
  match (name fact, signal_of fact.words fact.found) with
  | Some name, Some signal when missing = 1 ->
      let text = Printf.sprintf "%s %s" name signal in
      Some
        (match fact.expected.because with
        | Parameter { callee = Some f; position = 1; before = None; _ } ->
            hint ~topic:(Call f) "put parentheses around the argument: `%s (%s)`" f text d
        | _ -> applied fact text d)
  | _ -> None

let missing_after_name fact ~missing d =
  Option.map
    (fun name -> hint "`%s` takes %d argument%s" name missing (if missing = 1 then "" else "s") d)
    (name fact)

(* `sleepT 1[s]` without the output. *)
let missing_output fact ~missing d =
  match Option.bind fact.subject Plain_name.of_head with
  | Some "sleepT" when missing = 1 && Environment.is_task fact.expected.ty ->
      let fixed = Printf.sprintf "%s restingOutput" (raw fact "sleepT 1[s]") in
      Diagnostic.message "`sleepT` lacks its last argument, the output during that time" d
      |> hint "add an output: `%s` waits with the robot at rest" fixed
      |> fix (Printf.sprintf "write `%s`" fixed) [ (fact.at, fixed) ]
      |> Option.some
  | _ -> None

(* The last argument, if it is the input of the enclosing proc and the last parameter, which still
   lacks an argument, could have its type. Then the arguments before it are missing. *)
let input_given fact =
  let rec last t =
    match Type.expand t with
    | Type.Function (parameter, result) -> (
        match last result with None -> Some parameter | later -> later)
    | _ -> None
  in
  match (fact.subject, Option.map Type.expand (last fact.found)) with
  | Some { desc = Apply { argument = { desc = Local x; _ }; _ }; _ }, Some (Flexible _)
    when Wording.is_input fact.words x.name ->
      Some x.name
  | _ -> None

let ordinal = function
  | 1 -> "first"
  | 2 -> "second"
  | 3 -> "third"
  | 4 -> "fourth"
  | n -> Printf.sprintf "%dth" n

(* The function that is applied, and the names of its parameters, if each is a plain name. *)
let rec with_names words (e : Resolve.Ir.expr option) =
  match e with
  | Some { desc = Apply { head; style = Juxtaposed; _ }; _ } -> with_names words (Some head)
  | Some { desc = Global g; _ } ->
      let name (p : Resolve.Ir.pattern) = match p.desc with Bound x -> Some x.name | _ -> None in
      Option.bind (Wording.binding words g) (fun (b : Resolve.Ir.binding) ->
          Option.map (fun names -> (g.name, names)) (all (List.map name b.parameters)))
  | _ -> None

(* The declared types of the parameters of the function that is applied. *)
let rec parameters_of words (e : Resolve.Ir.expr option) =
  match e with
  | Some { desc = Apply { head; style = Juxtaposed; _ }; _ } -> parameters_of words (Some head)
  | Some { desc = Global g; _ } ->
      Option.fold (Wording.declared_type words g) ~none:[] ~some:Wording.parameters
  | _ -> []

(* Lists the parameters that lack an argument, by their names in the definition. If the last
   argument is a signal of the enclosing proc, it is probably meant for the last parameter. *)
let missing_by_name fact ~missing d =
  let given = Option.fold fact.subject ~none:[] ~some:arguments_of in
  let quote = Wording.argument fact.words in
  match (with_names fact.words fact.subject, all (List.map quote given), List.rev given) with
  | Some (f, names), Some texts, last :: _
    when List.compare_length_with names (List.length given + missing) = 0 && missing <= 2 ->
      let n = List.length given in
      let types = parameters_of fact.words fact.subject in
      let fits_the_last (x : Resolve.Ir.Local.t) =
        match (List.assoc_opt x.name (Wording.inputs fact.words), List.rev types) with
        | Some input, last :: _ -> (
            match (Type.expand input, Type.expand last) with
            | Number (_, u), Number (_, v)
              when not (Units.is_open u || Units.is_open v || Units.rigid_powers v <> []) ->
                Units.equal u v
            | _ -> true)
        | _ -> true
      in
      let is_signal =
        match last.desc with
        | Local x -> Wording.is_input fact.words x.name && fits_the_last x
        | _ -> false
      in
      (* `smaller a` for `smaller a b`, where the input has the same name as the first parameter *)
      let is_at_its_place =
        match (last.desc, List.nth_opt names (n - 1)) with
        | Local x, Some name -> String.equal x.name name
        | _ -> false
      in
      let kept = if is_signal && not is_at_its_place then n - 1 else n in
      let lacking = List.filteri (fun i _ -> i >= kept && i < kept + missing) names in
      (* show the name of a missing string in quotes, as a label *)
      let written i name =
        match Option.map Type.expand (List.nth_opt types (kept + i)) with
        | Some Type.String -> Printf.sprintf "%S" name
        | _ -> name
      in
      let shown =
        List.filteri (fun i _ -> i < kept) texts
        @ List.mapi written lacking
        @ List.filteri (fun i _ -> i >= kept) texts
      in
      Some
        (hint "`%s` takes %s, `%s`, but %s missing here: write, for example, `%s`" f
           (count (List.length names))
           (String.concat " " (f :: names))
           (Enumeration.all (List.map (Printf.sprintf "`%s`") lacking)
           ^ if missing = 1 then " is" else " are")
           (String.concat " " (f :: shown))
           d)
  | _ -> None

let missing_by_signature fact ~missing d =
  Option.map
    (fun (name, ty) ->
      hint "%s"
        (match (input_given fact, Option.map arguments_of fact.subject) with
        | None, Some (_ :: _ as given) when missing = 1 ->
            Printf.sprintf "the %s argument of `%s` is missing: `%s :: %s`"
              (ordinal (List.length given + 1))
              name name ty
        | x, _ ->
            Printf.sprintf "%s missing %s `%s :: %s`"
              (if missing = 1 then "an argument is" else count missing ^ " are")
              (match x with Some x -> Printf.sprintf "before `%s`:" x | None -> "at the end:")
              name ty)
        d)
    (declared fact.words fact.subject)

let missing_somewhere _ ~missing d =
  Some
    (hint "%s" (if missing = 1 then "an argument is missing" else "some arguments are missing") d)

(* The first hint that applies is used. Hints that name the missing argument come before those that
   only count arguments. *)
let hints_for_missing =
  [
    missing_in_definition;
    missing_unit;
    missing_signal;
    missing_after_name;
    missing_output;
    missing_by_name;
    missing_by_signature;
    missing_somewhere;
  ]

let missing fact =
  match (fact.wanted, fact.given) with
  | (Number _ | Bool | String | Tuple _ | Data _), Function _ ->
      let missing = missing_arguments fact.found in
      let d =
        error ~code:"E0301" ~at:fact.at "expected %s, found the function %s" (expected_text fact)
          (found_text fact)
      in
      List.find_map (fun hinted -> hinted fact ~missing d) hints_for_missing
  | _ -> None

(* {1 A function where another function is expected} *)

let more_missing_than_expected fact =
  let wanted = missing_arguments fact.expected.ty and given = missing_arguments fact.found in
  match (fact.wanted, fact.given, Option.bind fact.subject Plain_name.of_head) with
  | Function _, Function _, Some head when given > wanted ->
      error ~code:"E0301" ~at:fact.at
        "expected a function that takes %s, found one that takes %d: %s" (count wanted) given
        (found_text fact)
      |> hint "%s"
           (match (given - wanted, fact.given, Option.map arguments_of fact.subject) with
           | 1, Function (parameter, _), Some (_ :: _ as written) ->
               Printf.sprintf "`%s` lacks its %s argument, %s%s" head
                 (ordinal (List.length written + 1))
                 (Wording.described fact.words parameter)
                 (match (Type.expand parameter, source fact) with
                 | Number _, Some text -> Printf.sprintf ": write `%s 0`, for example" text
                 | _ -> "")
           | lacking, _, _ -> Printf.sprintf "`%s` lacks %s" head (count lacking))
      |> Option.some
  | _ -> None

(* {1 A value where a function is expected} *)

(* Is this the body of a lambda that is an argument? Then the expected type belongs to the whole
   lambda. *)
let is_a_body fact =
  match fact.expected.because with
  | Parameter { given; position; _ } -> (
      match List.nth_opt given (position - 1) with
      | Some { desc = Lambda _; span } -> Span.compare span fact.at <> 0
      | _ -> false)
  | _ -> false

(* The lambda with one more parameter. *)
let with_one_more fact =
  match fact.expected.because with
  | Parameter { given; position; _ } -> (
      match List.nth_opt given (position - 1) with
      | Some { desc = Lambda { parameters; body }; _ } ->
          let texts =
            List.map (fun (p : Resolve.Ir.pattern) -> Wording.quote fact.words p.span) parameters
          in
          Option.bind (all texts) (fun texts ->
              Option.map
                (Printf.sprintf "\\%s _ -> %s" (String.concat " " texts))
                (Wording.quote fact.words body.span))
      | _ -> None)
  | _ -> None

let lambda_with_too_few_parameters fact =
  match (fact.wanted, fact.given) with
  | Function _, (Number _ | Bool | String | Data _) when is_a_body fact ->
      Some
        (hinted fact
           "the function receives one more argument: add a parameter, or `_` if you do not need \
            it, as in `%s`"
           (Option.value (with_one_more fact) ~default:"\\n _ -> …"))
  | _ -> None

let missing_in_an_operand fact =
  match (fact.wanted, fact.given, other_operand fact) with
  | ( Function (from, _),
      Number _,
      Some
        {
          desc =
            Apply { head = { desc = Global { name = ("max" | "min") as name; _ }; _ }; argument; _ };
          span;
        } )
    when Array_mistake.is_array from ->
      let xs = Wording.argument_or "xs" fact.words argument in
      let fixed = Printf.sprintf "%simumBy id %s" name xs in
      error ~code:"E0301" ~at:span "`%s` takes two values, not an array" name
      |> hint "for the %s of all elements, write `%s`"
           (if String.equal name "min" then "least" else "greatest")
           fixed
      |> write span fixed |> Option.some
  | Function _, Number _, Some ({ desc = Apply { style = Juxtaposed; _ }; _ } as e)
    when missing_arguments fact.wanted = 1 ->
      Option.map
        (fun (name, ty) ->
          error ~code:"E0301" ~at:e.span "`%s` lacks an argument" name
          |> label ~at:fact.at "but this is a number"
          |> hint "add the last argument: `%s :: %s`" name ty)
        (declared fact.words (Some e))
  | _ -> None

let is_function t = match Type.expand t with Type.Function _ -> true | _ -> false

let composed fact =
  match (fact.wanted, fact.given) with
  | Function _, Tuple (_ :: _ :: _ as given) when List.for_all is_function given ->
      Some
        (match all (elements fact) with
        | None -> hinted fact "compose functions with `.`: `f . g`"
        | Some parts ->
            let text = String.concat " . " parts in
            hinted fact "compose functions with `.`: `%s`" text |> instead fact.subject text)
  | _ -> None

let one_too_many fact =
  match (fact.wanted, fact.given, fact.subject) with
  | ( Function _,
      (Number _ | Bool | Data _ | Tuple _),
      Some ({ desc = Apply { style = Juxtaposed; head; _ }; _ } as e) ) -> (
      match (Plain_name.of_head e, Wording.quote fact.words head.span) with
      | Some name, Some text ->
          Some
            (hinted fact "`%s` has one argument too many here: write `%s` for the function" name
               text)
      | _ -> Some (different fact))
  | Function _, (Number _ | Bool | Data _ | Tuple _), _ -> Some (different fact)
  | _ -> None

(* {1 A value where the preceding argument is expected} *)

let fits_next fact head ~position =
  match List.nth_opt (parameters_of fact.words (Some head)) position with
  | Some next ->
      (Environment.is_event next && Environment.is_event fact.found)
      || (Type.expand next = Bool && fact.given = Bool)
  | None -> false

let missing_before fact =
  match fact.expected.because with
  | Parameter { callee = Some f; head = Some head; given; takes; position; _ }
    when List.length given < takes && fits_next fact head ~position ->
      let text = Wording.argument_or "…" fact.words in
      let start = match fact.wanted with Number _ -> "0" | Bool -> "False" | _ -> "x0" in
      let before = List.filteri (fun i _ -> i < position - 1) given in
      let after = List.filteri (fun i _ -> i >= position - 1) given in
      let whole = (f :: List.map text before) @ (start :: List.map text after) in
      Some
        (hinted ~topic:(Call f) fact "an argument is missing before this one, %s: write `%s`"
           (expected_text fact) (String.concat " " whole))
  | _ -> None
