open Choice

let f = Printf.sprintf
let still (values : Scope.t) = { values with run = None }
let value (m : Reactive.maker) fuel ty = Expression.expression (still m.values) fuel ty
let any (m : Reactive.maker) = Scope.any_type m.values

(* The result type of a task, often one that combinators produce. *)
let any_result (m : Reactive.maker) =
  match Random.State.int m.values.random 6 with
  | 0 | 1 -> Type.unit
  | 2 -> Type.maybe (any m)
  | 3 -> Type.either (any m) (any m)
  | 4 -> Type.Tuple [ any m; any m ]
  | _ -> any m

let with_values (m : Reactive.maker) bound = { m with values = Scope.bind bound m.values }
let annotated text ty = f "(%s :: %s)" text (Type.text ty)

let lambda (m : Reactive.maker) fuel argument result =
  let values = still m.values in
  let text, bound = Pattern.any values argument in
  f "(\\%s -> %s)" text (Expression.expression (Scope.bind bound values) fuel result)

let times (m : Reactive.maker) = one_of m.values.random [ "0"; "1"; "2"; "3"; "(-1)" ]

(* A positive constant time. *)
let delay_time (m : Reactive.maker) = one_of m.values.random [ "0.05[s]"; "0.3[s]"; "1[us]" ]

let rec task (m : Reactive.maker) ~slow fuel a b (c : Type.t) =
  let random = m.values.random in
  let sub ?(slow = slow) = task m ~slow (fuel - 1) in
  let ended = [ (3, fun () -> f "(mkTask %s)" (Reactive.ending m ~slow (max 1 fuel) a b c)) ] in
  let at_once =
    if slow then []
    else
      (3, fun () -> f "(return %s)" (annotated (value m 1 c) c))
      :: ( (if fuel > 0 then 2 else 0),
           fun () -> f "(untilRight %s)" (m.signal_function m.values (fuel - 1) a (Type.either b c))
         )
      :: ( (if fuel > 0 then 2 else 0),
           fun () -> f "(ask %s)" (m.signal_function m.values (fuel - 1) a c) )
      :: (if a = c then [ (3, fun () -> "snapT") ] else [])
  in
  let of_nothing =
    if c <> Type.unit then []
    else
      let q = if slow then delay_time m else Reactive.time m in
      [ (4, fun () -> f "(sleepT %s %s)" q (value m 1 b)) ]
  in
  let deeper =
    if fuel <= 0 then []
    else
      [
        (6, fun () -> sequence m ~slow fuel a b c);
        (3, fun () -> chosen m ~slow fuel a b c);
        ((if slow then 0 else 2), fun () -> local m fuel a b c);
        (2, fun () -> f "(if %s then %s else %s)" (value m 1 Bool) (sub a b c) (sub a b c));
        ( 1,
          fun () ->
            let other = any_result m in
            f "(mapT %s %s)" (lambda m 2 other c) (sub a b other) );
        ( 1,
          fun () ->
            let other = any m in
            f "(mapOutput %s %s)" (lambda m 2 other b) (sub a other c) );
        (2, fun () -> side_by_side m ~slow fuel a b c);
        (1, fun () -> f "(forever %s)" (sub ~slow:true a b (any_result m)));
        (1, fun () -> f "(constT %s)" (value m 1 b));
      ]
      @ by_result m ~slow fuel a b c
  in
  (weighted random (ended @ at_once @ of_nothing @ deeper)) ()

(* The first task takes the time. *)
and sequence m ~slow fuel a b c =
  let first = any_result m in
  let text, bound = Pattern.any m.values first in
  let before = task m ~slow (fuel - 1) a b first in
  let rest m = task m ~slow:false (fuel - 1) a b c in
  if chance m.values.random 4 then f "(do %s; %s)" before (rest m)
  else f "(do %s <- %s; %s)" text before (rest (with_values m bound))

(* Chooses the second task when the first one has ended. *)
and chosen m ~slow fuel a b c =
  let by = Scope.fresh m.values "c" in
  let first = Reactive.ending m ~slow (max 1 (fuel - 1)) a b Type.Bool in
  let rest () = task m ~slow:false (fuel - 1) a b c in
  f "(do %s <- mkTask %s; if %s then %s else %s)" by first by (rest ()) (rest ())

(* A local task that continues as itself, like [Reactive.local_modes]. *)
and local m fuel a b c =
  let values = m.Reactive.values in
  let go = Scope.fresh values "go" and n = Scope.fresh values "n" in
  let m = { m with values = Scope.bind [ (n, Type.Int) ] values } in
  let often = Random.State.int values.random 3 and first = any_result m in
  let before = task m ~slow:(chance values.random 2) (fuel - 1) a b first in
  let last = task m ~slow:false (fuel - 1) a b c in
  Scope.note values "local task that starts itself";
  f
    "(let %s %s = (do %s; if %s >= %d then %s else %s (%s + 1)) in (%s (0 :: Int) :: Task %s %s \
     %s))"
    go n before n often last go n go (Type.text a) (Type.text b) (Type.text c)

and side_by_side m ~slow fuel a b c =
  let output = any m and output' = any m and result = any m and result' = any m in
  let sub slow = task m ~slow (fuel - 1) a in
  let both = chance m.values.random 2 in
  let shown, ends =
    if both then
      ( Type.Tuple [ Type.either output result; Type.either output' result' ],
        Type.Tuple [ result; result' ] )
    else (Type.Tuple [ output; output' ], Type.either result result')
  in
  (* [both] takes time if one of its tasks does, [race] only if both do. *)
  f "(mapOutput %s (mapT %s (%s %s %s)))" (lambda m 2 shown b) (lambda m 2 ends c)
    (if both then "both" else "race")
    (sub slow output result)
    (sub (slow && not both) output' result')

and by_result m ~slow fuel a b (c : Type.t) =
  let sub ?(slow = slow) = task m ~slow (fuel - 1) in
  let until () =
    let shown = Type.Tuple [ b; Bool ] in
    f "(untilT %s)" (m.signal_function m.values (fuel - 1) a shown)
  in
  let observed () =
    match c with
    | Tuple [ result; seen ] ->
        [
          ( 6,
            fun () ->
              f "(withSF %s %s)" (sub a b result) (m.signal_function m.values (fuel - 1) a seen) );
        ]
    | _ -> []
  and perhaps () =
    match c with
    | Data { constructors = [ { name = "Nothing"; _ }; { fields = [ (_, result) ]; _ } ]; _ } ->
        let q = if slow then delay_time m else Reactive.time m in
        (6, fun () -> f "(timeOut %s %s)" (sub a b result) q)
        ::
        (* With a limit of 0 attempts or less, retryT ends at its first instant. *)
        (if slow then [] else [ (3, fun () -> f "(retryT %s %s)" (times m) (sub ~slow:true a b c)) ])
    | Data
        {
          constructors = [ { fields = [ (_, result) ]; _ }; { fields = [ (_, reason) ]; name } ];
          _;
        }
      when name = "Right" ->
        let stop = m.signal_function m.values (fuel - 1) a (Type.event reason) in
        let stop = if slow then f "(%s >>> notYet)" stop else stop in
        [ (6, fun () -> f "(abortWhen %s %s)" (sub a b result) stop) ]
    | _ -> []
  and repeated () =
    if c <> Type.unit then []
    else if slow then [ (4, until) ]
    else
      let x = any m in
      let text, bound = Pattern.any m.values x in
      let array = Type.Array (1 + Random.State.int m.values.random 3, x) in
      [
        (3, until);
        (2, fun () -> f "(repeatT %s %s)" (times m) (sub ~slow:true a b (any_result m)));
        ( 2,
          fun () ->
            let condition = m.signal_function m.values (fuel - 1) a Type.Bool in
            f "(whileT %s %s)" condition (sub ~slow:true a b (any_result m)) );
        ( 2,
          fun () ->
            f "(forEachT %s (\\%s -> %s))"
              (annotated (value m 1 array) array)
              text
              (task (with_values m bound) ~slow:true (fuel - 1) a b (any_result m)) );
        ( 4,
          fun () ->
            f "(%s %s %s)"
              (one_of m.values.random [ "whenT"; "unlessT" ])
              (value m 1 Bool) (sub a b Type.unit) );
      ]
  in
  observed () @ perhaps () @ repeated ()

let alternatives (m : Reactive.maker) fuel a b =
  let weight = m.values.bias.tasks in
  let whole : (int * (unit -> string)) list =
    match (b : Type.t) with
    | Data
        {
          constructors =
            [ { name = "Left"; fields = [ (_, output) ] }; { fields = [ (_, result) ]; _ } ];
          _;
        } ->
        [ (3 * weight, fun () -> f "(runTask %s)" (task m ~slow:false (fuel - 1) a output result)) ]
    | _ -> []
  and followed () =
    let result = any_result m in
    let text, bound = Pattern.any m.values result in
    f "(thenSF %s (\\%s -> %s))"
      (task m ~slow:false (fuel - 1) a b result)
      text
      (m.signal_function (Scope.bind bound m.values) (fuel - 1) a b)
  in
  if fuel <= 0 then [] else (weight, followed) :: whole
