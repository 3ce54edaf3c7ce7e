open Choice

type maker = { values : Scope.t; signal_function : Scope.t -> int -> Type.t -> Type.t -> string }

let f = Printf.sprintf
let still (values : Scope.t) = { values with run = None }

let time m =
  one_of m.values.random
    [
      "0"; "0.05[s]"; "0.1[s]"; "0.3[s]"; "1[s]"; "(-1[s])"; "(0[s] / 0.0)"; "(1[s] / 0.0)"; "1[us]";
    ]

let number m = one_of m.values.random [ "0"; "1"; "2"; "3"; "(-1)" ]
let literal m ty = Constant.literal m.values ty

(* A function that may use the values of the instant and the variables in [more]. *)
let lambda m ?(more = []) arguments fuel result =
  let values = still (Scope.bind more m.values) in
  let patterns = List.map (Pattern.any values) arguments in
  f "(\\%s -> %s)"
    (String.concat " " (List.map fst patterns))
    (Expression.expression (Scope.bind (List.concat_map snd patterns) values) fuel result)

(* {1 The event library} *)

let from_event m fuel payload b =
  let known = Type.event_payload b in
  let accumulate name result =
    f "(%s %s %s)" name (lambda m [ result; payload ] fuel result) (literal m result)
  in
  let same =
    if payload <> b then []
    else [ (4, fun () -> f "(%s %s)" (one_of m.values.random [ "hold"; "dHold" ]) (literal m b)) ]
  in
  same
  @ (if b = Int then [ (4, fun () -> "seenBefore") ] else [])
  @ [ (3, fun () -> accumulate (one_of m.values.random [ "accumHoldBy"; "dAccumHoldBy" ]) b) ]
  @
  match known with
  | None -> []
  | Some result ->
      [
        (3, fun () -> accumulate "accumBy" result);
        (5, fun () -> f "(onEvent %s)" (m.signal_function m.values (fuel - 1) payload result));
      ]
      @ (if result = Int then [ (4, fun () -> "count") ] else [])
      @
      if result <> payload then []
      else
        [
          ( 8,
            fun () ->
              one_of m.values.random
                [ "once"; "notYet"; f "(takeEvents %s)" (number m); f "(dropEvents %s)" (number m) ]
          );
        ]

let source m fuel (a : Type.t) b payload =
  let tagged sf = f "(%s >>> arr (\\e -> tag e %s))" sf (literal m payload) in
  let any =
    [
      (1, fun () -> "never");
      (2, fun () -> f "(now %s)" (literal m payload));
      (3, fun () -> tagged (f "%s %s" (one_of m.values.random [ "after"; "every" ]) (time m)));
      ( 3,
        fun () ->
          f "(%s >>> edgeTag %s)" (m.signal_function m.values (fuel - 1) a Bool) (literal m payload)
      );
      ( 4,
        fun () -> f "(sampleEvery %s %s)" (time m) (m.signal_function m.values (fuel - 1) a payload)
      );
    ]
  and by_input =
    match a with
    | Bool when payload = Type.unit ->
        [ (6, fun () -> one_of m.values.random [ "edge"; "falling"; "when"; "(edgeFrom False)" ]) ]
    | Bool -> [ (4, fun () -> f "(edgeTag %s)" (literal m payload)) ]
    | Tuple [ e; y ] when Type.event_payload e <> None && y = payload -> [ (8, fun () -> "sample") ]
    | Tuple [ e; y ] -> (
        match Type.event_payload e with
        | Some x when Type.Tuple [ x; y ] = payload -> [ (8, fun () -> "snapshot") ]
        | Some _ | None -> [])
    | Float | Measure _ | Int | Tuple _ | Array _ | Data _ -> []
  in
  (if a = payload then [ (4, fun () -> f "(change :: SF %s %s)" (Type.text a) (Type.text b)) ]
   else [])
  @ (if a = Type.maybe payload then [ (6, fun () -> "edgeJust") ] else [])
  @ by_input @ any

(* An event that carries functions, which may have captured signals. *)
let accumulated_functions m fuel a b =
  let values = still m.values in
  Scope.note values "event of functions";
  let names, b =
    match Type.event_payload b with
    | Some result -> ([ "accum" ], result)
    | None -> ([ "accumHold"; "dAccumHold" ], b)
  in
  let text, bound = Pattern.any values a in
  let payload = Scope.any_type values in
  let inside = Scope.bind bound values in
  f "(proc %s -> %s %s (mapE %s (%s :: %s)))" text (one_of m.values.random names) (literal m b)
    (lambda m ~more:bound [ payload; b ] fuel b)
    (Expression.expression inside fuel (Type.event payload))
    (Type.text (Type.event payload))

(* {1 Switches} *)

let switch m = one_of m.values.random [ "switch"; "dSwitch" ]

(* An event that comes and goes, often with a value of the input. *)
let lively m fuel a payload =
  let text, bound = Pattern.any m.values a in
  let inside = Scope.bind bound (still m.values) in
  let condition () =
    match
      (Random.State.int m.values.random 4, Scope.variable inside Int, Scope.variable inside Bool)
    with
    | 0, Some n, _ -> Cascade.asked_of inside n
    | 1, _, Some b -> b
    | _, _, _ -> Expression.expression inside fuel Bool
  in
  let event =
    match Random.State.int m.values.random 8 with
    | 0 -> f "every %s ()" (time m)
    | 6 | 7 -> Remembered.event m.values condition
    | 1 -> f "after %s ()" (time m)
    | 2 -> f "edge %s" (condition ())
    | 3 -> f "when %s" (condition ())
    | 4 -> f "now () ()"
    | _ -> f "edgeFrom False %s" (condition ())
  in
  f "(proc %s -> mapE (\\_ -> %s) (%s))" text (Expression.expression inside fuel payload) event

let ending m ~slow fuel a b payload =
  let body =
    if chance m.values.random 3 then
      m.signal_function m.values fuel a (Tuple [ b; Type.event payload ])
    else f "(%s &&& %s)" (m.signal_function m.values (fuel - 1) a b) (lively m (fuel - 1) a payload)
  in
  if slow then f "(%s >>> second notYet)" body else body

let mode m ~earlier ~continuation fuel a b =
  let payload = Scope.any_type m.values in
  let body = ending m ~slow:earlier fuel a b payload in
  let holds_switch =
    match Str.search_forward (Str.regexp "[sS]witch ") body 0 with
    | _ -> true
    | exception Not_found -> false
  in
  if holds_switch then Scope.note m.values "switch in a switch";
  let text, bound = Pattern.any m.values payload in
  f "(%s %s (\\%s -> %s))" (switch m) body text (continuation (Scope.bind bound m.values))

let once_switched m fuel a b =
  mode m ~earlier:false fuel a b ~continuation:(fun values ->
      m.signal_function values (fuel - 1) a b)

(* Nested switches, several of which may occur at one instant: each passes on a number, which the
   next one usually tests. *)
let rec cascade m ?latest fuel a b =
  let random = m.values.random in
  let text, bound = Pattern.any m.values a in
  let inside = Scope.bind bound (still m.values) in
  let asked =
    match (latest, Scope.variable inside Int) with
    | Some n, _ when not (chance random 4) -> Cascade.asked_of inside n
    | _, Some n -> Cascade.asked_of inside n
    | _, None -> Expression.expression inside 1 Bool
  in
  let n = Scope.fresh m.values "n" and c = Scope.fresh m.values "c" in
  let handed = Scope.bind [ (n, Type.Int); (c, Bool) ] m.values in
  (* The compiler knows more about a value that is computed after the event. *)
  let made, latest, values =
    if chance random 3 then ("", n, handed)
    else
      let k = Scope.fresh m.values "k" in
      ( f "let %s = %s in " k (Cascade.one_of_few ~by:c handed),
        k,
        Scope.bind [ (k, Type.Int) ] handed )
  in
  let after =
    if fuel > 0 && not (chance random 3) then cascade { m with values } ~latest (fuel - 1) a b
    else m.signal_function values (fuel - 1) a b
  in
  f "(%s (proc %s -> (%s, mapE (\\_ -> (%s, %s)) (%s %s))) (\\(%s, %s) -> %s%s))" (switch m) text
    (Expression.expression inside 1 b)
    (Cascade.one_of_few inside) (Cascade.bool inside)
    (one_of random [ "when"; "edgeFrom False" ])
    asked n c made after

(* Local modes that start each other, either a limited number of times or each after some time.
   They capture variables in scope. *)
let local_modes m fuel a b =
  let values = m.values in
  let go = Scope.fresh values "go" and up = Scope.fresh values "go" in
  let often = Random.State.int values.random 3 and slow = chance values.random 2 in
  let counting name next =
    let n = Scope.fresh values "n" in
    let m = { m with values = Scope.bind [ (n, Type.Int) ] values } in
    let first = ending m ~slow (fuel - 1) a b (Scope.any_type values) in
    let next = f "%s (%s + 1)" next n in
    let next =
      if slow && name = go then next
      else f "if %s >= %d then %s else %s" n often (m.signal_function m.values (fuel - 1) a b) next
    in
    (n, f "%s %s (\\_ -> %s)" (switch m) first next)
  in
  let definitions =
    if chance values.random 2 then
      let n, mode = counting go go in
      f "%s %s = %s" go n mode
    else
      let n, mode = counting go up in
      let n', mode' = counting up go in
      f "(%s, %s) = (\\%s -> %s, \\%s -> %s)" go up n mode n' mode'
  in
  Scope.note values "local modes that start each other";
  f "(let %s in (%s (%d :: Int) :: SF %s %s))" definitions go
    (Random.State.int values.random 3 - 1)
    (Type.text a) (Type.text b)

(* A periodic event; the compiler may know the period. *)
let ticks m =
  match Random.State.int m.values.random 3 with
  | 0 -> f "(ticks %s)" (Expression.expression (still m.values) 1 Type.Float)
  | 1 -> f "(ticks (nanoseconds %s))" (time m)
  | _ ->
      f "(ticks %s)" (one_of m.values.random [ "200000000.5"; "0.9"; "1"; "1000000000000000000.0" ])

(* Switches into the signal function that an event carries. *)
let brought m fuel a b =
  Scope.note m.values "switch into the signal function of an event";
  let text, bound = Pattern.any m.values a in
  let inside = Scope.bind bound (still m.values) in
  let payload = Scope.any_type m.values in
  let whole = Scope.fresh m.values "w" in
  let pattern, more = Pattern.any inside payload in
  let after = Scope.fresh m.values "q" in
  f "(%s (proc %s@%s -> (%s, mapE (\\%s -> %s) (%s %s))) (\\%s -> %s))" (switch m) whole text
    (Expression.expression inside 1 b)
    pattern
    (m.signal_function (Scope.bind more inside) (fuel - 1) a b)
    (lively m (fuel - 1) a payload)
    whole after after

let parenthesized ty text = f "(%s :: %s)" text (Type.text ty)

(* A signal function that is restarted or replaced at events; the replacement captures signals. *)
let replaced m fuel a b =
  let text, bound = Pattern.any m.values a in
  let whole = Scope.fresh m.values "w" in
  let inside = Scope.bind ((whole, a) :: bound) (still m.values) in
  let inner = Scope.any_type m.values and payload = Scope.any_type m.values in
  let event =
    if chance m.values.random 3 then
      let ty = Type.event payload in
      parenthesized ty (Expression.expression inside fuel ty)
    else f "(%s %s)" (lively m (fuel - 1) a payload) whole
  in
  let input = Expression.expression inside fuel inner in
  let first = m.signal_function m.values (fuel - 1) inner b in
  if chance m.values.random 3 then
    f "(proc %s@%s -> resetOn %s (%s, tag %s ()))" whole text first input event
  else
    let pattern, more = Pattern.any inside payload in
    Scope.note m.values "event of signal functions";
    let brought = Scope.bind more inside in
    f "(proc %s@%s -> %s %s (%s, mapE (\\%s -> %s) %s))" whole text
      (one_of m.values.random [ "rSwitch"; "drSwitch" ])
      first input pattern
      (m.signal_function brought (fuel - 1) inner b)
      event

let initially m fuel a b =
  let text, bound = Pattern.any m.values a in
  f "(initially (\\%s -> %s))" text (m.signal_function (Scope.bind bound m.values) (fuel - 1) a b)

(* Compositions through an event, which produce types that few other constructs do. *)
let composed m fuel a (b : Type.t) =
  let event payload = lively m (fuel - 1) a payload in
  let value ty = m.signal_function m.values (fuel - 1) a ty in
  let any () = Scope.any_type m.values in
  let through payload = weighted m.values.random (from_event m fuel payload b) () in
  let through_event () =
    let payload = if chance m.values.random 2 then b else any () in
    f "(%s >>> %s)" (event payload) (through payload)
  in
  let onto_event payload =
    match (Random.State.int m.values.random 5, payload) with
    | 3, _ -> f "(%s >>> edgeJust)" (value (Type.maybe payload))
    | 4, Type.Tuple [] ->
        f "(%s >>> %s)" (value Bool) (one_of m.values.random [ "edge"; "falling"; "when" ])
    | 0, Type.Tuple [ x; y ] -> f "((%s &&& %s) >>> snapshot)" (event x) (value y)
    | 0, _ -> f "((%s &&& %s) >>> sample)" (event (any ())) (value payload)
    | 1, _ -> f "(%s >>> %s)" (event payload) (through payload)
    | _, _ -> event payload
  in
  [ (2, through_event) ]
  @ (match Type.event_payload b with
    | Some payload -> [ (6, fun () -> onto_event payload) ]
    | None -> [])
  @ (if b = Bool then [ (3, fun () -> f "(elapsed %s)" (time m)); (3, fun () -> ticks m) ] else [])
  @ (if b = Int then [ (2, fun () -> f "(%s >>> count >>> hold 0)" (event (any ()))) ] else [])
  @ [
      ( 1,
        fun () ->
          let better = f "(atBest %s)" (lambda m [ Float; Float ] (min fuel 2) Bool) in
          f "((%s &&& %s) >>> %s)" (value b) (value Float)
            (one_of m.values.random [ "atMin"; "atMax"; better ]) );
    ]

let alternatives m fuel a b =
  let { Bias.library; switches; _ } = m.values.bias in
  let scaled weight = List.map (fun (w, make) -> (w * weight, make)) in
  let events =
    (match Type.event_payload b with Some payload -> source m fuel a b payload | None -> [])
    @ (match Type.event_payload a with Some payload -> from_event m fuel payload b | None -> [])
    @ composed m fuel a b
    @ [ (1, fun () -> accumulated_functions m fuel a b) ]
    @
    match a with
    | Tuple [ x; (Float | Measure _ | Int) ] when x = b ->
        let key = match a with Tuple [ _; key ] -> key | _ -> Type.Float in
        [
          (3, fun () -> one_of m.values.random [ "atMin"; "atMax" ]);
          (2, fun () -> f "(atBest %s)" (lambda m [ key; key ] (min fuel 2) Bool));
        ]
    | Float | Measure _ | Int | Bool | Tuple _ | Array _ | Data _ -> []
  and switching =
    [
      (3, fun () -> once_switched m fuel a b);
      (2, fun () -> cascade m fuel a b);
      (2, fun () -> local_modes m fuel a b);
      (3, fun () -> replaced m fuel a b);
      (1, fun () -> initially m fuel a b);
      (1, fun () -> brought m fuel a b);
    ]
  in
  if fuel <= 0 then [] else scaled library events @ scaled switches switching
