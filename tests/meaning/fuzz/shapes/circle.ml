open Choice

let f = Printf.sprintf

(* A signal that remembers something about the late input of a mode. *)
let remembered (m : Reactive.maker) late y =
  match (late : Type.t) with
  | Float when chance m.values.random 2 -> f "integral %s / 1[s]" y
  | _ -> f "delay %s %s" (Constant.literal m.values late) y

let event (inside : Scope.t) m =
  match Random.State.int inside.random 5 with
  | 0 -> f "after %s ()" (Reactive.time m)
  | 1 -> f "every %s ()" (Reactive.time m)
  | _ ->
      f "%s (%s)"
        (one_of inside.random [ "when"; "edge"; "edgeFrom False" ])
        (Expression.expression inside 1 Bool)

(* The output of a mode. In two of three modes it depends on the time, which reveals a step that
   was made twice. *)
let shown (inside : Scope.t) ~now (b : Type.t) =
  let value () = Expression.expression inside 1 b in
  match (Random.State.int inside.random 3, b) with
  | 0, _ -> value ()
  | _, Float -> f "(%s + %s)" now (value ())
  | _, _ ->
      let limit = one_of inside.random [ "0.05"; "0.3"; "1"; "5" ] in
      f "(if %s < %s then %s else %s)" now limit (value ()) (value ())

(* A mode, and the ones after it. An event that leads on an instant later may use the late input
   directly. *)
let rec modes (m : Reactive.maker) a ~late b k =
  let random = m.values.random in
  let text, bound = Pattern.any m.values a in
  let y = Scope.fresh m.values "y" and before = Scope.fresh m.values "d" in
  let now = Scope.fresh m.values "q" in
  let inside =
    Scope.bind ((before, late) :: (now, Type.Float) :: bound) { m.values with run = None }
  in
  let shown = shown inside ~now b in
  let proc result =
    f "proc (%s, %s) -> let %s = (%s :: %s) in let %s = time () / 1[s] in %s" text y before
      (remembered m late y) (Type.text late) now result
  in
  if k = 0 then proc shown
  else
    let delayed = chance random 3 in
    let asking = if delayed then Scope.bind [ (y, late) ] inside else inside in
    let payload = Scope.any_type m.values in
    let name = Scope.fresh m.values "p" in
    let after = { m with values = Scope.bind [ (name, payload) ] m.values } in
    f "%s (%s) (\\%s -> %s)"
      (if delayed then "dSwitch" else "switch")
      (proc
         (f "(%s, mapE (\\_ -> (%s :: %s)) (%s))" shown
            (Expression.expression inside 1 payload)
            (Type.text payload) (event asking m)))
      name
      (modes after a ~late b (k - 1))

let machine (m : Reactive.maker) a ~late b =
  Scope.note m.values "machine in a circle";
  f "(%s)" (modes m a ~late b (1 + Random.State.int m.values.random 2))
