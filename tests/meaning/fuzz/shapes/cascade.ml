open Choice

let f = Printf.sprintf
let small (values : Scope.t) = string_of_int (Random.State.int values.random 5)

(* A number that range analysis must treat as unbounded: from -infinity to infinity, or NaN. *)
let unbounded (values : Scope.t) n =
  let part () =
    one_of values.random
      [
        f "toFloat %s" n;
        f "(toFloat %s / 0)" n;
        f "(- toFloat %s / 0)" n;
        f "max 0 (toFloat %s / 0)" n;
      ]
  in
  f "(%s %s %s)" (part ()) (one_of values.random [ "+"; "-"; "*"; "/" ]) (part ())

let asked_of (values : Scope.t) n =
  let asked = if chance values.random 8 then unbounded values n else n in
  let asked = if chance values.random 20 then f "(max 0 %s)" asked else asked in
  f "(%s %s %s)" asked (one_of values.random [ "<"; "<="; ">"; ">="; "=="; "/=" ]) (small values)

let bool (values : Scope.t) =
  match (Scope.variable values Bool, Scope.variable values Int) with
  | Some b, _ when not (chance values.random 3) -> b
  | _, Some n when not (chance values.random 3) -> asked_of values n
  | _, _ -> Expression.expression values 1 Bool

let one_of_few ?by (values : Scope.t) =
  let chosen () =
    let condition = match by with Some b -> b | None -> bool values in
    let low = Random.State.int values.random 4 in
    let high = low + 1 + Random.State.int values.random (4 - low) in
    let first, second = if chance values.random 3 then (high, low) else (low, high) in
    f "(if %s then %d else %d)" condition first second
  in
  match (Random.State.int values.random 5, Scope.variable values Int) with
  | 0, Some n -> f "(%s %s 1)" n (one_of values.random [ "+"; "-" ])
  | 1, Some n -> n
  | (2 | 3), _ -> chosen ()
  | _, _ -> small values

(* {1 A program of modes} *)

(* A mode with two parameters, an Int and a Bool. *)
type mode = { name : string; number : string; flag : string }

let modes values =
  List.init
    (2 + Random.State.int values.Scope.random 5)
    (fun _ ->
      let fresh = Scope.fresh values in
      { name = fresh "m"; number = fresh "n"; flag = fresh "c" })

(* The arguments that modes pass on: numbers chosen at run time, or literals only, for which the
   compiler can evaluate the next mode's condition. *)
type handed = Chosen | Literals

(* [paced]: no mode ends at its first instant, and the compiler can prove it. *)
type style = { hands : handed; paced : bool }

let truth (values : Scope.t) = one_of values.random [ "True"; "False" ]

(* Switches into the next mode or a later one, or into one of two. *)
let onward static hands ~handed:(n, c) later =
  let inside = Scope.bind [ (n, Type.Int); (c, Bool) ] static in
  let into mode =
    match hands with
    | Literals -> f "%s %s %s" mode.name (small inside) (truth inside)
    | Chosen ->
        let flag = if chance inside.random 2 then c else bool inside in
        f "%s %s %s" mode.name (one_of_few ~by:c inside) flag
  in
  let next () = if chance inside.random 2 then List.hd later else one_of inside.random later in
  match Random.State.int inside.random 4 with
  | (0 | 1) when hands = Literals ->
      f "if %s then %s else %s"
        (if chance inside.random 2 then c else bool inside)
        (into (next ()))
        (into (next ()))
  | 0 ->
      (* Either of the two may skip modes. *)
      let then_, else_ =
        if chance inside.random 2 then (into (one_of inside.random later), into (List.hd later))
        else (into (next ()), into (next ()))
      in
      f "if %s then %s else %s" (if chance inside.random 2 then c else bool inside) then_ else_
  | 1 ->
      let k = Scope.fresh inside "k" and mode = next () in
      f "let %s = %s in %s %s %s" k (one_of_few ~by:c inside) mode.name k c
  | _ -> into (next ())

(* A condition on a value that changes in the mode from instant to instant. *)
let timed (inside : Scope.t) number =
  let handed_on = f "(toFloat %s * 0.1[s])" number in
  let q = one_of inside.random [ "0"; "0.05[s]"; "0.1[s]"; "0.3[s]"; handed_on ] in
  match Random.State.int inside.random 5 with
  | 3 | 4 -> f "after %s ()" handed_on
  | 0 -> f "when (timeSince (%s) > %s)" (bool inside) q
  | 1 -> f "when (nanoseconds (timeSince (%s)) >= nanoseconds %s)" (bool inside) q
  | _ -> f "when (derivative (if %s then 1 else 0) * 1[s] > 0)" (bool inside)

(* The event that ends a mode. It mostly occurs at the mode's first instant, depending on its
   number. *)
let ends (inside : Scope.t) style { number; flag; _ } =
  let asked () =
    let asked = asked_of inside number in
    if chance inside.random 3 then f "not %s" asked else asked
  in
  match Random.State.int inside.random 16 with
  | k when style.paced ->
      if k < 11 then f "after (0.05[s] + abs (toFloat %s) * 0.1[s]) ()" number
      else f "edge %s" (bool inside)
  | 9 | 10 | 11 | 12 -> timed inside number
  | 13 | 14 | 15 -> Remembered.event inside (fun () -> bool inside)
  | 0 -> f "when (%s %s %s)" (bool inside) (one_of inside.random [ "&&"; "||" ]) (asked ())
  | 1 -> f "when %s" (bool inside)
  | 2 -> f "edge %s" (bool inside)
  | 3 -> f "when %s" flag
  | 4 -> "now () ()"
  | 5 -> f "when (%s %s %s)" (asked ()) (one_of inside.random [ "&&"; "||" ]) (asked ())
  | _ -> f "when (%s)" (asked ())

(* The output shows which mode runs. *)
let output (inside : Scope.t) k number =
  match Random.State.int inside.random 4 with
  | 0 -> f "%d + (%s)" (10 * k) (one_of_few inside)
  | 1 -> f "%d + %s" (10 * k) number
  | _ -> f "%d" (10 * k)

type input = { ty : Type.t; pattern : string; bound : (string * Type.t) list }

let signature name parameters input = f "%s :: %sSF %s Int\n" name parameters (Type.text input.ty)

let switch input style ~static ~shows ~event later =
  let inside = Scope.bind input.bound static in
  let n = Scope.fresh inside "n" and c = Scope.fresh inside "c" in
  f "%s (proc %s -> (%s, mapE (\\_ -> (%s, %s)) (%s))) (\\(%s, %s) -> %s)"
    (if chance inside.random 16 then "dSwitch" else "switch")
    input.pattern shows (one_of_few inside) (bool inside) event n c
    (onward static style.hands ~handed:(n, c) later)

(* The last mode, which never ends, and may run another of the program's machines. *)
let lasting input ~(inside : Scope.t) ~machines k number =
  let whole = Scope.fresh inside "i" in
  let shows =
    match (Random.State.int inside.random 4, machines) with
    | 0, _ :: _ -> f "%s %s - %d" (one_of inside.random machines) whole k
    | 1, _ -> f "delay %s (%s)" (small inside) (output inside k number)
    | _, _ -> output inside k number
  in
  f "proc %s@%s -> %s" whole input.pattern shows

let rec define values input style ~machines k = function
  | [] -> []
  | mode :: later ->
      let handed = [ (mode.number, Type.Int); (mode.flag, Type.Bool) ] in
      let static = Scope.bind handed values in
      let inside = Scope.bind input.bound static in
      let body =
        if later = [] then lasting input ~inside ~machines k mode.number
        else
          switch input style ~static ~shows:(output inside k mode.number)
            ~event:(ends inside style mode) later
      in
      f "%s%s %s %s = %s\n\n"
        (signature mode.name "Int -> Bool -> " input)
        mode.name mode.number mode.flag body
      :: define values input style ~machines (k + 1) later

(* Some modes, and a signal function that starts in the first one, either at once or at an event. *)
let machine values input ~alone ~machines =
  let modes = modes values in
  let start = Scope.fresh values "s" in
  let style =
    {
      hands = (if chance values.random 4 then Literals else Chosen);
      paced = chance values.random (if alone then 2 else 6);
    }
  in
  let begins =
    if chance values.random 2 then f "%s %s %s" (List.hd modes).name (small values) (truth values)
    else
      let inside = Scope.bind input.bound values in
      let event = if style.paced then "edge" else "when" in
      switch input style ~static:values ~shows:"0" ~event:(f "%s %s" event (bool inside)) modes
  in
  ( start,
    define values input style ~machines 1 modes
    @ [ f "%s%s = %s\n\n" (signature start "" input) start begins ] )

(* One machine for each element of an array. *)
let for_each values input start =
  Scope.note values "array of machines";
  let many = Scope.fresh values "s" and whole = Scope.fresh values "i" in
  let wholes = List.init (1 + Random.State.int values.Scope.random 3) (fun _ -> whole) in
  ( many,
    f "%s%s = proc %s -> foldl (\\a b -> 2 * a + b) 0 (mapSF %s [%s])\n\n" (signature many "" input)
      many whole start (String.concat ", " wholes) )

let definitions values ~input ~pattern:(pattern, bound) =
  Scope.note values "cascade of modes";
  let input = { ty = input; pattern; bound } in
  (* If there is only one machine, it may be the whole program, which then uses another
     representation of time. *)
  let alone = chance values.random 2 in
  let rec more k machines texts =
    if k = 0 then (String.concat "" texts, List.rev machines)
    else
      let start, text = machine values input ~alone ~machines in
      if chance values.random 8 then
        let many, definition = for_each values input start in
        more (k - 1) (many :: machines) (texts @ text @ [ definition ])
      else more (k - 1) (start :: machines) (texts @ text)
  in
  more (if alone then 1 else 2 + Random.State.int values.random 3) [] []
