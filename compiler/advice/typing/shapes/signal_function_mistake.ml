open Basis
open Typing
open Diagnostic
open Shape_fact

let in_place_of_a_test fact =
  match (fact.wanted, fact.given) with
  | Data { tycon = { name = "Test"; _ }; _ }, (Number _ | String | Tuple _) ->
      Some
        (hinted fact
           "write a condition, such as `f 2 == 5`, or `during 1[s] sf` for a signal function")
  | Data { tycon = { name = "Test"; _ }; _ }, Signal_function (input, _) ->
      let sf = grouped fact "sf" in
      error ~code:"E0301" ~at:fact.at
        "expected a `Test`, which also says how long to run the signal function"
      |> here "this is %s" (found_text fact)
      |> hint "%s"
           (match Type.expand input with
           | Data { tycon = { name = "Truth"; _ }; _ } ->
               Printf.sprintf
                 "for a run in the simulator, write a trial: `trial \"name\" = Trial { world = \
                  \"room.toml\", lasts = 10[s], seeds = 1 `to` 20, judge = %s }`"
                 (raw fact "sf")
           | _ -> Printf.sprintf "use `during 10[s] %s`" sf)
      |> Option.some
  | _ -> None

let no_signal_function fact =
  error ~code:"E0304" ~at:fact.at "expected a signal function, found a function: %s"
    (found_text fact)

let condition_of_an_event fact =
  match (fact.wanted, fact.given) with
  | Signal_function (_, wanted), Signal_function (_, given)
    when Environment.is_event wanted && Type.expand given = Bool ->
      let d = different fact in
      Some
        (match source fact with
        | Some text ->
            let text = Printf.sprintf "(%s >>> edge)" (Source.grouped text) in
            hint
              "its output is a condition: to get an event that occurs when the condition becomes \
               True, write `%s`"
              text d
            |> write fact.at text
        | None ->
            hint
              "its output is a condition: to get an event that occurs when the condition becomes \
               True, write `edge` before the condition"
              d)
  | Signal_function (_, wanted), Function (_, given)
    when Environment.is_event wanted && Type.expand given = Bool ->
      no_signal_function fact
      |> hint "%s"
           (match name fact with
           | Some name ->
               Printf.sprintf
                 "use `proc x -> edge (%s x)`: its event occurs when the condition becomes True"
                 name
           | None -> "use `proc x -> edge (f x)`: its event occurs when `f x` becomes True")
      |> Option.some
  | _ -> None

(* The type that the context requires of the enclosing operator application. An argument between two
   backticks is inferred without its context. *)
let wanted_of_comparison words : Surroundings.enclosing list -> _ = function
  | { wanted = Some t; _ } :: _ -> Some t
  | { expr; wanted = None } :: { expr = outer; _ } :: _ -> (
      let rec spine (e : Resolve.Ir.expr) arguments =
        match e.desc with
        | Apply { head; argument; _ } -> spine head (argument :: arguments)
        | _ -> (e, arguments)
      in
      match spine outer [] with
      | { desc = Global g; _ }, arguments ->
          let parameters =
            Option.fold (Wording.declared_type words g) ~none:[] ~some:Wording.parameters
          in
          let is_it (a : Resolve.Ir.expr) = Span.compare a.span expr.span = 0 in
          List.mapi (fun i a -> if is_it a then List.nth_opt parameters i else None) arguments
          |> List.find_map Fun.id
      | _ -> None)
  | _ -> None

(* `batteryVoltage < 12[V]`, a comparison of a function with a value, in place of a signal function
   such as `proc i -> edge (batteryVoltage i < 12[V])`. *)
let comparison_without_input fact =
  let takes_one t =
    match Type.expand t with
    | Type.Signal_function _ -> true
    | Function (_, result) -> ( match Type.expand result with Function _ -> false | _ -> true)
    | _ -> false
  in
  let is_name (e : Resolve.Ir.expr) = Plain_name.of_expr e <> None in
  let enclosing = Wording.enclosing fact.words in
  match (fact.expected.because, other_operand fact, fact.subject, enclosing) with
  | Operand { operator; _ }, Some left, Some right, { expr; _ } :: around
    when List.mem operator [ "<"; "<="; ">"; ">="; "=="; "/=" ] -> (
      let applied =
        if takes_one fact.wanted && is_name left && not (takes_one fact.given) then Some left
        else if takes_one fact.given && is_name right && not (takes_one fact.wanted) then Some right
        else None
      in
      let quote (e : Resolve.Ir.expr) =
        let input = match applied with Some f when f == e -> " i" | _ -> "" in
        Option.map (fun text -> text ^ input) (Wording.quote fact.words e.span)
      in
      let wanted = Option.map Type.expand (wanted_of_comparison fact.words enclosing) in
      match (applied, wanted, quote left, quote right) with
      | Some f, Some (Signal_function (_, output)), Some a, Some b ->
          let name = Option.get (Plain_name.of_expr f) in
          let comparison = Printf.sprintf "%s %s %s" a operator b in
          let text, wanted =
            if Environment.is_event output then
              ( Printf.sprintf "proc i -> edge (%s)" comparison,
                "a signal function whose output is an event" )
            else (Printf.sprintf "proc i -> %s" comparison, "a signal function")
          in
          let text = if around = [] then text else "(" ^ text ^ ")" in
          error ~code:"E0301" ~at:f.span "`%s` lacks its input" name
          |> (if f == left then label ~at:right.span "it is compared with this value" else Fun.id)
          |> hint "this place needs %s: write `%s`" wanted text
          |> write expr.span text |> Option.some
      | _ -> None)
  | _ -> None

(* The hint for a function in the program that must be a `proc` because it runs signal functions,
   such as `drive i = f (frontSonar i)`. *)
let as_a_proc fact =
  let rec runs (e : Resolve.Ir.expr) =
    match e.desc with
    | Apply { head = { desc = Global g; _ } as head; argument; _ } ->
        (match Option.map Type.expand (Wording.declared_type fact.words g) with
        | Some (Signal_function _) -> true
        | _ -> false)
        || runs head || runs argument
    | Apply { head; argument; _ } -> runs head || runs argument
    | If { condition; then_; else_ } -> List.exists runs [ condition; then_; else_ ]
    | Negate e | Field { record = e; _ } -> runs e
    | _ -> false
  in
  match (fact.subject, fact.given) with
  | Some { desc = Global g; _ }, Function (a, b) -> (
      match Wording.binding fact.words g with
      | Some { parameters = [ p ]; body = { guards = [ { condition = None; value } ]; where }; _ }
        when runs value
             || List.exists
                  (fun (group : Resolve.Ir.binding_group) ->
                    List.exists
                      (fun (b : Resolve.Ir.binding) ->
                        List.exists (fun (g : Resolve.Ir.guarded) -> runs g.value) b.body.guards)
                      group.bindings)
                  where.groups ->
          let type_ t = Source.grouped (Wording.type_ fact.words t) in
          Option.map
            (fun x ->
              Printf.sprintf
                "`%s` runs signal functions, so it must be a signal function itself: write `%s :: \
                 SF %s %s` and `%s = proc %s -> …`"
                g.name g.name (type_ a) (type_ b) g.name x)
            (Wording.quote fact.words p.span)
      | Some _ | None -> None)
  | _ -> None

(* `\\i -> e` in place of `proc i -> e` *)
let lambda_for_proc fact =
  match (fact.wanted, fact.given, Wording.quote fact.words fact.at) with
  | Signal_function _, Function _, Some text when text.[0] = '\\' -> (
      match String.index_opt text '>' with
      | Some arrow when arrow > 2 && text.[arrow - 1] = '-' ->
          let x = String.trim (String.sub text 1 (arrow - 2)) in
          let stop = Span.forward (arrow + 1) fact.at.start in
          no_signal_function fact
          |> hint "write `proc %s -> …` in place of `\\%s -> …`" x x
          |> fix
               (Printf.sprintf "write `proc %s -> …`" x)
               [ ({ fact.at with stop }, Printf.sprintf "proc %s ->" x) ]
          |> Option.some
      | Some _ | None -> None)
  | _ -> None

(* The parameters of a function that returns a signal function. *)
let rec lacking t =
  match Type.expand t with
  | Function (parameter, result) ->
      Option.map (fun parameters -> parameter :: parameters) (lacking result)
  | Signal_function _ -> Some []
  | _ -> None

(* A value for a parameter: a definition in the program that has this type, or an example. *)
let value fact t =
  match (Wording.values fact.words t ~file:fact.at.file, Type.expand t) with
  | name :: _, _ -> name
  | [], Number (_, u) when Units.is_open u || Units.rigid_powers u <> [] -> "…"
  | [], Number (_, u) when Units.equal u Units.one -> "1"
  | [], Number _ when String.equal (Wording.type_ fact.words t) "AngularVelocity" -> "1[rad/s]"
  | [], Number (_, u) -> Printf.sprintf "1[%s]" (Wording.measure fact.words u)
  | [], Bool -> "True"
  | [], Tuple [] -> "()"
  | [], _ -> "…"

(* Is the head a definition without a signature? In a program with errors, its inferred type may be
   wrong, too. *)
let rec is_inferred fact (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply { head; _ } -> is_inferred fact head
  | Global g -> (
      match Wording.binding fact.words g with
      | Some { signature = None; parameters = []; _ } -> true
      | Some _ | None -> false)
  | _ -> false

(* `reactimateRobot follow`, where `follow` takes arguments and returns a signal function *)
let without_arguments fact =
  match (fact.wanted, lacking fact.found, Option.bind fact.subject Plain_name.of_head) with
  | Signal_function _, Some (_ :: _ as parameters), Some name
    when not (Option.fold fact.subject ~none:false ~some:(is_inferred fact)) ->
      let given = Option.fold fact.subject ~none:[] ~some:Unrun_mistake.arguments_of in
      let what =
        match (given, parameters) with
        | [], [ only ] -> "its argument, " ^ Wording.described fact.words only
        | _, [ only ] -> "its last argument, " ^ Wording.described fact.words only
        | _, several -> Unrun_mistake.count (List.length several)
      in
      let values = List.map (value fact) parameters in
      let text = String.concat " " (raw fact name :: values) in
      let d = no_signal_function fact |> hint "`%s` lacks %s: write `%s`" name what text in
      Some (if List.mem "…" values then d else Unrun_mistake.instead fact.subject text d)
  | _ -> None

let function_not_lifted fact =
  match (fact.wanted, fact.given, source fact) with
  | Signal_function _, Function _, _ when without_arguments fact <> None -> without_arguments fact
  | Signal_function _, Function _, _ when lambda_for_proc fact <> None -> lambda_for_proc fact
  | Signal_function _, Function _, _ when as_a_proc fact <> None ->
      Some (hint "%s" (Option.get (as_a_proc fact)) (no_signal_function fact))
  | Signal_function _, Function _, Some text ->
      let text = "arr " ^ Source.grouped text in
      no_signal_function fact
      |> hint "use `arr` to turn a function into a signal function: `%s`" text
      |> Unrun_mistake.instead fact.subject text
      |> Option.some
  | Signal_function _, Function _, None ->
      no_signal_function fact
      |> hint "%s"
           (match Wording.quote fact.words fact.at with
           | Some text when text.[0] = '\\' ->
               "write `proc x -> …` with `proc` instead of `\\`, or use `arr` to turn a function \
                into a signal function"
           | _ -> "use `arr` to turn a function into a signal function")
      |> Option.some
  | _ -> None

(* The hint for a signal function where a function is required. If it is an argument, the hint
   depends on the callee. *)
let by_its_use fact =
  match (fact.expected.because, fact.wanted) with
  | Parameter { callee = Some "arr"; _ }, _ -> Some "remove `arr`"
  | Parameter { callee = Some "map"; _ }, _ ->
      Some "use `mapSF` to run a signal function on each element"
  | Parameter { callee = Some "."; given = [ last; first ]; _ }, _
    when Wording.quote fact.words last.span <> None && Wording.quote fact.words first.span <> None
    ->
      let text (e : Resolve.Ir.expr) = Option.get (Wording.quote fact.words e.span) in
      Some
        (Printf.sprintf "compose signal functions from left to right with `>>>`: `%s >>> %s`"
           (text first) (text last))
  | Parameter { callee = Some "."; _ }, _ ->
      Some "use `>>>` to compose signal functions, from left to right"
  | Parameter { callee = Some name; _ }, _ ->
      Some
        (Printf.sprintf
           "if `%s` should run the signal function, give the parameter an `SF` type in the \
            signature of `%s`"
           name name)
  | Signature _, Function (input, output) ->
      Some
        (Printf.sprintf "if you want a signal function, change the type to %s"
           (Wording.described fact.words (Signal_function (input, output))))
  | _ -> None

(* `drive = switch go drive`, where the last argument determines the inferred type of `drive`. *)
let next_mode fact =
  match (fact.expected.because, fact.subject) with
  | ( Uses { name; _ },
      Some
        {
          desc =
            Apply
              {
                head = { desc = Apply { head; argument = mode; _ }; _ };
                argument = { desc = Global { name = next; _ } | Local { name = next; _ }; _ };
                _;
              };
          _;
        } )
    when String.equal name next -> (
      match (head.desc, Wording.quote fact.words mode.span) with
      | Global { name = ("switch" | "dSwitch") as switch; _ }, Some mode ->
          Some (Printf.sprintf "%s %s (\\_ -> %s)" switch (Source.grouped mode) next)
      | _ -> None)
  | _ -> None

let in_place_of_a_function fact =
  match (fact.wanted, fact.given) with
  | Function _, Signal_function _ ->
      let d =
        error ~code:"E0304" ~at:fact.at "expected a function, found a signal function: %s"
          (found_text fact)
      in
      Some
        (if Switch_mistake.goes_on fact.expected then
           let text = "\\_ -> " ^ raw fact "…" in
           hint "write a function that ignores its argument: `(%s)`" text d
           |> if source fact = None then Fun.id else Unrun_mistake.instead fact.subject text
         else
           match next_mode fact with
           | Some text ->
               hint "the second argument of `switch` is a function of the event's value: use `%s`"
                 text d
           | None -> Option.fold (by_its_use fact) ~none:d ~some:(fun text -> hint "%s" text d))
  | _ -> None

(* `x > 0 &&& x < 1` *)
let conditions fact =
  match (fact.wanted, fact.given, fact.expected.because) with
  | Signal_function _, Bool, Parameter { callee = Some (("&&&" | "***") as operator); _ } ->
      Some
        (error ~code:"E0301" ~at:fact.at "`%s` combines signal functions, but this is a condition"
           operator
        |> hint "to combine two conditions, write `&&`")
  | _ -> None

(* `switch c a b` with a condition `c` *)
let choice fact =
  match (fact.wanted, fact.given, fact.expected.because) with
  | ( Signal_function _,
      Bool,
      Parameter { callee = Some ("switch" | "dSwitch"); position = 1; given; _ } ) ->
      let text (e : Resolve.Ir.expr) = Wording.quote fact.words e.span in
      Some
        (match List.map text given with
        | [ Some c; Some a; Some b ] ->
            hinted fact "to choose a value based on a condition, write `if %s then %s else %s`" c a
              b
        | _ -> hinted fact "to choose a value based on a condition, write `if c then a else b`")
  | _ -> None

let constant fact =
  match (fact.wanted, fact.given, other_operand fact) with
  | Signal_function _, (Number _ | Bool | String | Tuple _ | Data _), None ->
      Some (hinted fact "use `constant e` for a signal function that always returns `e`")
  | _ -> None
