open Choice

let f = Printf.sprintf

type mode = { name : string; a : string; b : string }

(* The function of two numbers that the program uses everywhere. *)
let measure random =
  let k = one_of random [ "3"; "0.5"; "(-1)"; "0" ]
  and l = one_of random [ "1"; "2.5"; "(-0.25)" ] in
  let either x y = if chance random 2 then f "(%s - %s)" x y else f "(%s - %s)" y x in
  let kinds =
    [
      (fun a b -> f "hypot %s %s" (either a k) (either b l));
      (fun a b -> f "abs %s" (either a b));
      (fun a b -> f "cos %s" (either a b));
      (fun a b -> f "abs (signum %s) + abs %s" (either a b) (either a b));
      (fun a b -> f "max (%s * %s) %s" k a b);
      (fun a b -> f "sqrt (abs %s) + %s" (either a b) l);
      (fun a b -> f "(if %s < %s then %s * %s else %s)" a b a l b);
    ]
  in
  let kind = one_of random kinds in
  fun a b -> f "(%s)" (kind a b)

let float (inside : Scope.t) =
  match Scope.variable inside Float with
  | Some x when not (chance inside.random 6) -> x
  | Some _ | None -> Expression.expression inside 1 Float

let shows (inside : Scope.t) measure { a; b; _ } =
  match Random.State.int inside.random 7 with
  | 0 -> f "delay 0 %s" (measure a b)
  | 4 -> f "%s - %s" a b
  | 1 -> f "%s + %s" (float inside) (measure a b)
  | 2 -> f "%s + %s" (float inside) a
  | 3 -> measure a b
  | _ -> float inside

let asked (inside : Scope.t) measure { a; b; _ } (x, y) =
  match Random.State.int inside.random 5 with
  | 0 -> f "%s < %s" (measure x y) (measure a b)
  | 1 -> f "%s < 2" (measure x y)
  | 2 -> f "%s < 1 || %s" (measure x y) (Cascade.bool inside)
  | 3 -> f "%s < %s" (measure a b) (float inside)
  | _ -> Cascade.bool inside

(* A condition that is expensive enough for a branch. *)
let much (inside : Scope.t) measure { a; b; _ } (x, y) =
  let of_ a b =
    match Random.State.int inside.random 3 with
    | 0 -> measure a b
    | 1 -> f "hypot %s %s" a b
    | _ -> f "%s / (1 + abs %s)" a b
  in
  let more, less = if chance inside.random 2 then (of_ x y, of_ a b) else (of_ x b, of_ a y) in
  match Random.State.int inside.random 3 with
  | 0 -> f "%s < %s" more less
  | 1 -> f "%s < %s" more (float inside)
  | _ -> f "%s < %s * %s" less more more

let handed (inside : Scope.t) mode (p, q) =
  match Random.State.int inside.random 8 with
  | 0 | 1 | 2 -> f "%s %s" mode.a mode.b
  | 3 -> f "%s %s" mode.a q
  | 4 -> "2 (-1)"
  | _ -> f "%s %s" p q

(* The event that leads on, its target, and the arguments for it. *)
let way ?(keeps = false) (inside : Scope.t) mode later ~edge ~asked ~event_of (x, y) =
  let p = Scope.fresh inside "p" and q = Scope.fresh inside "q" in
  let next = if chance inside.random 3 then one_of inside.random later else List.hd later in
  let event = f "%s (%s)" (if edge then "edge" else "when") asked in
  ( f "mapE (\\_ -> %s) (%s)" (event_of (f "(%s, %s)" x y)) event,
    f "\\(%s, %s) -> %s %s" p q next.name
      (if keeps && not (chance inside.random 4) then f "%s %s" p q else handed inside mode (p, q))
  )

let rec define scope (pattern, bound) ~signature measure = function
  | [] -> []
  | mode :: later ->
      let inside = Scope.bind bound scope in
      let shows = shows inside measure mode in
      let body =
        if later = [] then f "proc %s -> %s" pattern shows
        else
          let xy () = (float inside, float inside) in
          let values = xy () in
          let edge () = chance inside.random 3 in
          let event, to_ =
            if chance inside.random 3 then
              let asked = asked inside measure mode values in
              way inside mode later ~edge:(edge ()) ~asked ~event_of:Fun.id values
            else (
              Scope.note scope "mode that ends in two ways";
              let first_asked =
                if chance inside.random 3 then asked inside measure mode values
                else f "%s < %s" (float inside) (float inside)
              in
              let others = xy () in
              let second_asked =
                if chance inside.random 3 then asked inside measure mode others
                else much inside measure mode others
              in
              (* The second condition may include the first one. *)
              let also = chance inside.random 2 in
              let second_asked =
                if also then f "%s || %s" first_asked second_asked else second_asked
              in
              let edge () = (not also) && edge () in
              let first, to_first =
                way ~keeps:true inside mode later ~edge:(edge ()) ~asked:first_asked
                  ~event_of:(f "Left %s") values
              in
              let second, to_second =
                way inside mode later ~edge:(edge ()) ~asked:second_asked ~event_of:(f "Right %s")
                  others
              in
              (f "mergeE (%s) (%s)" first second, f "either (%s) (%s)" to_first to_second))
          in
          f "switch (proc %s -> (%s, %s)) (%s)" pattern shows event to_
      in
      f "%s%s %s %s = %s\n\n"
        (signature mode.name "Float -> Float -> ")
        mode.name mode.a mode.b body
      :: define scope (pattern, bound) ~signature measure later

let definitions values ~input ~pattern =
  Scope.note values "modes that hand on";
  let fresh = Scope.fresh values in
  let modes =
    List.init
      (2 + Random.State.int values.random 4)
      (fun _ -> { name = fresh "h"; a = fresh "a"; b = fresh "b" })
  in
  let signature name parameters = f "%s :: %sSF %s Float\n" name parameters (Type.text input) in
  let start = fresh "s" in
  let begins = f "%s%s = %s 1 2\n\n" (signature start "") start (List.hd modes).name in
  let measure = measure values.random in
  (String.concat "" (define values pattern ~signature measure modes @ [ begins ]), start)
