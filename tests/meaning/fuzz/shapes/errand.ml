open Choice

let f = Printf.sprintf

type program = {
  input : Type.t;
  timed : bool;  (** whether its tasks may output the time, for which the C needs another clock *)
}

let float (inside : Scope.t) =
  match Scope.variable inside Float with
  | Some x when not (chance inside.random 4) -> x
  | Some _ | None -> Expression.expression inside 1 Float

(* A stateful signal. Its first value usually differs from the value that it would have if it had
   run before. *)
let kept p (inside : Scope.t) =
  match Random.State.int inside.random (if p.timed then 5 else 4) with
  | 0 | 1 -> f "(delay %s %s)" (Constant.literal inside Float) (float inside)
  | 2 -> f "(integral %s / 1[s])" (float inside)
  | 3 -> f "(1[s] * derivative %s)" (float inside)
  | _ -> "(time () / 1[s])"

let shown p (inside : Scope.t) =
  match Random.State.int inside.random 4 with
  | 0 when p.timed -> "time () / 1[s]"
  | 0 -> kept p inside
  | 1 -> f "(%s + %s)" (kept p inside) (float inside)
  | _ -> float inside

(* Most conditions hold at some instants and not at others; some hold almost never. *)
let condition (inside : Scope.t) =
  match Random.State.int inside.random 6 with
  | 0 | 1 -> f "%s > %s" (float inside) (Constant.literal inside Float)
  | 2 -> f "%s > 9.5" (float inside)
  | _ -> Cascade.bool inside

let proc p (values : Scope.t) body =
  let text, bound = Pattern.any values p.input in
  f "proc %s -> %s" text (body (Scope.bind bound values))

let time (values : Scope.t) = one_of values.random [ "0.05[s]"; "0.3[s]"; "1[s]"; "1[us]" ]

(* The result of every task is a Float. *)
let rec task p (values : Scope.t) ~slow fuel =
  let random = values.Scope.random in
  let sub ?(slow = slow) ?(values = values) () = task p values ~slow (fuel - 1) in
  let until_event () =
    let body inside =
      let event = f "%s (%s)" (one_of random [ "when"; "when"; "edge" ]) (condition inside) in
      let event = f "mapE (\\_ -> %s) (%s)" (float inside) event in
      f "(%s, %s)" (shown p inside) (if slow then f "notYet (%s)" event else event)
    in
    f "(mkTask (%s))" (proc p values body)
  and until_right () =
    let body inside =
      f "if %s then Right %s else Left %s" (condition inside) (float inside) (float inside)
    in
    f "(untilRight (%s))" (proc p values body)
  and at_once () =
    Scope.note values "task with state that ends at once";
    if chance random 2 then f "(ask (%s))" (proc p values (kept p))
    else f "(untilRight (%s))" (proc p values (fun inside -> f "Right %s" (kept p inside)))
  and sleep () = f "(do sleepT %s %s; return %s)" (time values) (float values) (float values)
  and then_ before =
    let result = Scope.fresh values "r" in
    let values = Scope.bind [ (result, Type.Float) ] values in
    f "(do %s <- %s; %s)" result before (sub ~slow:false ~values ())
  in
  let choice ~slow () =
    f "(if %s then %s else %s)" (condition values) (sub ~slow ()) (sub ~slow ())
  in
  let simple = [ (4, until_event); (1, sleep) ] in
  let quick =
    if slow then []
    else [ (2, until_right); (3, at_once); (1, fun () -> f "(return %s)" (float values)) ]
  in
  let deeper =
    if fuel <= 0 then []
    else
      [
        (5, fun () -> then_ (sub ()));
        (2, fun () -> then_ (choice ~slow ()));
        (2, choice ~slow);
        (2, fun () -> within p values ~slow (fuel - 1));
      ]
  in
  (weighted random (simple @ quick @ deeper)) ()

(* A task inside another task, which ends when the inner one does. *)
and within p values ~slow fuel =
  Scope.note values "task inside a task";
  let inner = f "runTask %s" (task p values ~slow fuel) in
  if chance values.Scope.random 2 then f "(untilRight (%s))" inner
  else f "(untilRight (identity >>> %s))" inner

let definitions values ~input =
  Scope.note values "task that is the whole program";
  let p = { input; timed = chance values.Scope.random 2 } in
  let name = Scope.fresh values "t" and start = Scope.fresh values "s" in
  let task =
    match Random.State.int values.random 3 with
    | 0 -> task p values ~slow:false 3
    | 1 -> f "forever %s" (task p values ~slow:true 3)
    | _ ->
        let result = Scope.fresh values "r" in
        let inside = Scope.bind [ (result, Type.Float) ] values in
        f "forever (do %s <- %s; %s)" result (task p values ~slow:true 1)
          (task p inside ~slow:false 3)
  in
  let types result = f "%s Float %s" (Type.text input) result in
  ( f "%s :: Task %s\n%s = %s\n\n%s :: SF %s %s\n%s = runTask %s\n\n" name (types "Float") name task
      start (Type.text input)
      (Type.text (Type.either Float Float))
      start name,
    start )
