open Basis
open Typing
open Diagnostic
open Shape_fact

let ends_a_mode (expected : Expected.t) =
  match expected.because with
  | Parameter { position = 1; callee = Some ("switch" | "dSwitch" | "mkTask"); _ } -> true
  | _ -> false

let goes_on (expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some ("switch" | "dSwitch" | "initially" | "thenSF"); _ } -> true
  | _ -> false

let is_pair t = match Type.expand t with Tuple [ _; _ ] | Flexible _ -> true | _ -> false

let is_unrun_event t =
  match Type.expand t with Signal_function (_, o) -> Environment.is_event o | _ -> false

(* The type given in place of a mode's event, if the mode returns a pair. *)
let in_place_of_the_event wanted given =
  match (Type.expand wanted, Type.expand given) with
  | Tuple [ _; event ], Tuple [ _; other ] when Environment.is_event event -> Some other
  | _ -> None

let by_an_event =
  "end the mode with an event: `edge b` occurs when `b` becomes True, `when b` whenever `b` is True"

(* A function defined in the program, applied to one argument. *)
let of_a_local_function (e : Resolve.Ir.expr option) =
  match e with
  | Some { desc = Apply { head; argument; style = Juxtaposed }; _ } -> (
      match head.desc with
      | Local x -> Some (x.name, argument.span)
      | Global g when not (String.equal g.module_ "Prelude") -> Some (g.name, argument.span)
      | _ -> None)
  | _ -> None

let callee (expected : Expected.t) =
  match expected.because with Parameter { callee = Some name; _ } -> name | _ -> "switch"

let input words t =
  match Type.expand t with
  | Type.Signal_function (input, _) -> Option.value (Wording.signal words input) ~default:"x"
  | _ -> "x"

(* The event in the output of the mode, if it is `after` or `every`. *)
let event_of fact =
  let value =
    match fact.subject with
    | Some { desc = Global g; _ } -> (
        match Wording.binding fact.words g with
        | Some { parameters = []; body = { guards = [ { value; _ } ]; _ }; _ } -> Some value
        | Some _ | None -> None)
    | subject -> subject
  in
  match value with
  | Some { desc = Proc { body = { output = { desc = Tuple [ _; event ]; _ }; _ }; _ }; _ } -> (
      match (Plain_name.of_head event, Wording.quote fact.words event.span) with
      | Some ("after" | "every"), Some text -> Some text
      | _ -> None)
  | _ -> None

(* A signal function whose output is not a pair, or is a pair without an event. *)
let hint_for_an_output fact wanted given =
  if is_pair wanted && not (is_pair given) then
    Some
      (let is_application =
         match fact.subject with
         | Some { desc = Apply { style = Juxtaposed; _ }; _ } -> true
         | Some _ | None -> false
       in
       Printf.sprintf
         "return the output and the event that ends the mode: `(%s &&& after 1[s])` ends it after \
          1 s; to end it when a condition `c` becomes True, return a pair, `(…, edge c)`"
         (if is_application then raw fact "sf" else grouped fact "sf"))
  else
    match in_place_of_the_event wanted given with
    | Some other when is_unrun_event other ->
        Some
          (match event_of fact with
          | Some event -> Printf.sprintf "run the event's signal function on `()`: `%s ()`" event
          | None -> "run the event's signal function on a signal, as in `after 5[s] ()`")
    | Some other when Type.expand other = Bool -> Some by_an_event
    | _ -> None

(* The hint for one of the program's functions applied to the signal. *)
let hint_for_a_function fact (name, argument) =
  let argument = Option.value (Wording.quote fact.words argument) ~default:"x" in
  Printf.sprintf
    "`switch` needs a signal function: define `%s = proc %s -> …`, and write `switch %s … %s`" name
    argument name argument

(* A pair of an output and an event in place of the mode that returns them. *)
let hint_for_a_pair fact =
  let callee = callee fact.expected in
  let x = input fact.words fact.expected.ty in
  let quote (e : Resolve.Ir.expr) = Wording.quote fact.words e.span in
  (* `(proc i -> output, event)`: the pair should be inside the `proc` *)
  let x, pair, run =
    match fact.subject with
    | Some
        {
          desc =
            Tuple
              [
                { desc = Proc { input; body = { output; equations = { groups = []; _ } } }; _ };
                event;
              ];
          _;
        } ->
        let text e = Option.value (quote e) ~default:"…" in
        ( Option.value (Wording.quote fact.words input.span) ~default:x,
          Printf.sprintf "(%s, %s)" (text output) (text event),
          "" )
    | _ -> (x, raw fact "(output, event)", Printf.sprintf ", and run that on `%s`" x)
  in
  let others =
    match fact.expected.because with
    | Parameter { given = _ :: others; _ } -> all (List.map quote others)
    | _ -> None
  in
  match others with
  | Some (_ :: _ as others) when not (String.equal run "") ->
      Printf.sprintf "`%s` needs a signal function that returns the pair: write `%s`" callee
        (String.concat " "
           ((callee :: [ Printf.sprintf "(proc %s -> %s)" x pair ])
           @ List.map Source.grouped others @ [ x ]))
  | Some _ | None ->
      Printf.sprintf
        "`%s` needs a signal function that returns the pair: write `%s (proc %s -> %s) …`%s" callee
        callee x pair run

let next_mode fact =
  match (fact.expected.because, fact.wanted, fact.given) with
  | ( Parameter { callee = Some (("switch" | "dSwitch") as name); position = 2; _ },
      Function (_, next),
      Function (_, other) )
    when match (Type.expand next, Type.expand other) with
         | Signal_function _, (Number _ | Bool | Data _ | Tuple _) -> true
         | _ -> false ->
      Some
        (hinted fact
           "the second argument of `%s` takes the value of the event and returns the next mode: \
            `\\_ -> …`; the event itself belongs in the output of the first argument, as in \
            `(output, edge b)`"
           name)
  | _ -> None

let hint_for_a_mode fact =
  match (fact.wanted, fact.given, of_a_local_function fact.subject) with
  | Signal_function (_, wanted), Signal_function (_, given), _ ->
      hint_for_an_output fact wanted given
  | Signal_function _, (Number _ | Bool | String | Tuple _ | Data _), Some f ->
      Some (hint_for_a_function fact f)
  | Signal_function _, Tuple [ _; _ ], None -> Some (hint_for_a_pair fact)
  | _ -> None

(* The output of a mode that lacks the event: shows how to write both. *)
let with_an_event output = Printf.sprintf "(%s, after 1[s] ())" output

let ends_it output =
  Printf.sprintf
    "`%s` ends the mode after 1 s, and `(…, edge c)` ends it when a condition `c` becomes True"
    (with_an_event output)

let needs_an_event callee output =
  Printf.sprintf "the first argument of `%s` must return a pair of an output and an event: %s"
    callee (ends_it output)

(* `switch (proc x -> x) …`: type inference took `x` for the pair of an output and an event. *)
let input_as_pair fact =
  match (fact.wanted, fact.given, fact.subject) with
  | ( Signal_function (wanted, _),
      Signal_function (given, _),
      Some
        {
          desc =
            Apply
              {
                head =
                  {
                    desc =
                      Apply
                        {
                          head = { desc = Global { name = ("switch" | "dSwitch") as name; _ }; _ };
                          argument = { desc = Proc { body = { output; _ }; _ }; _ };
                          _;
                        };
                    _;
                  };
                _;
              };
          _;
        } )
    when (not (is_pair wanted))
         && is_pair given
         && match Type.expand given with Tuple [ _; e ] -> Environment.is_event e | _ -> false ->
      let text = Option.value (Wording.quote fact.words output.span) ~default:"output" in
      error ~code:"E0301" ~at:output.span "this mode of `%s` does not return an event" name
      |> hint "%s" (needs_an_event name text)
      |> write output.span (with_an_event text)
      |> Option.some
  | _ -> None

(* A mode whose output lacks the event, as in `switch (proc x -> x + 1) …`. *)
let output_without_event fact =
  match (fact.expected.because, fact.wanted, fact.given) with
  | ( Output
        (Parameter { position = 1; callee = Some (("switch" | "dSwitch" | "mkTask") as name); _ }),
      Tuple [ _; event ],
      (Number _ | Bool | Data _) )
    when Environment.is_event event
         && not (Environment.is_event fact.found || Environment.is_task fact.found) ->
      let text = raw fact "output" in
      Some (hinted fact "%s" (needs_an_event name text) |> write fact.at (with_an_event text))
  | _ -> None

let mode fact =
  match (fact.wanted, other_operand fact) with
  | Signal_function _, None when ends_a_mode fact.expected ->
      Option.map (hinted fact "%s") (hint_for_a_mode fact)
  | _ -> None

let three_arguments words ~name ~at arguments =
  let raw (e : Resolve.Ir.expr) otherwise =
    Option.value (Wording.quote words e.span) ~default:otherwise
  in
  let text e otherwise = Source.grouped (raw e otherwise) in
  match arguments with
  | (first, mode) :: (second, event) :: (third, next) :: rest -> (
      let first' = text first "mode" and second' = text second "event" in
      let x = input words mode in
      let applied =
        match first.desc with Apply { style = Juxtaposed; _ } -> raw first "mode" | _ -> first'
      in
      let beside e = Some (Printf.sprintf "(proc %s -> (%s %s, %s))" x applied x e) in
      let first' =
        match Type.expand event with
        | Data _ when Environment.is_event event -> beside (raw second "event")
        | Bool -> beside ("edge " ^ second')
        | Signal_function (_, o) when Environment.is_event o ->
            Some (Printf.sprintf "(%s &&& %s)" first' second')
        | Signal_function (_, o) when Type.expand o = Bool ->
            Some (Printf.sprintf "(%s &&& (%s >>> edge))" first' second')
        | Function (_, o) when Type.expand o = Bool ->
            beside (Printf.sprintf "edge (%s %s)" second' x)
        | Function (_, o) when Environment.is_event o -> beside (Printf.sprintf "%s %s" second' x)
        | _ -> None
      in
      let next =
        match Type.expand next with
        | Signal_function _ -> Printf.sprintf "(\\_ -> %s)" (raw third "next")
        | _ -> text third "next"
      in
      let rest = List.map (fun (e, _) -> text e "…") rest in
      match first' with
      | None -> None
      | Some first' ->
          let fixed = String.concat " " (name :: first' :: next :: rest) in
          let d =
            error ~code:"E0301" ~at:second.span "the event of `%s` is not a separate argument" name
            |> label ~at:first.span "this mode must return the event together with its output"
            |> hint "write `%s`" fixed
          in
          Some (if String.contains fixed '\n' then d else write at fixed d))
  | _ -> None
