open Choice

let f = Printf.sprintf

(* A condition whose value is usually known at the start of the program, and changes later. *)
let rec turn_of (inside : Scope.t) =
  let before ty =
    f "delay %s %s" (Constant.literal inside ty) (Expression.expression inside 0 ty)
  in
  match Random.State.int inside.random 10 with
  | 0 | 1 -> "atStart ()"
  | 2 | 3 | 4 -> f "(atStart () || %s)" (turn_of inside)
  | 5 | 6 -> f "(%s)" (before Bool)
  | 7 -> f "((%s) > 2)" (before Int)
  | 8 -> "elapsed 0.3[s] ()"
  | _ -> Expression.expression inside 1 Bool

let number (inside : Scope.t) ty =
  if chance inside.random 2 then Constant.literal inside ty else Expression.expression inside 1 ty

let other_than inside before (ty : Type.t) =
  match ty with
  | Int -> f "%s + %d" before (1 + Random.State.int inside.Scope.random 3)
  | Bool -> f "not %s" before
  | Float -> f "0.5 * %s + %s" before (number inside ty)
  | Measure _ | Tuple _ | Array _ | Data _ -> before

(* A signal computed from the first remembered value, for the others to use. Writes that share
   one `If` may need it after the write of the value that it reads. *)
type shared = { name : string; ty : Type.t }

let of_shared inside { name; ty } (wanted : Type.t) =
  let number = number inside wanted in
  match (ty, wanted) with
  | Int, Float -> f "toFloat %s - %s" name number
  | Float, Int -> f "%s - round %s" number name
  | _, Bool -> f "%s > %s" name (Constant.literal inside ty)
  | _, _ -> f "%s + %s" name number

(* A signal that remembers its value; the value an instant ago has a name too. If it changes only
   at some instants, the C writes it only to the state, and outputs read it from there. *)
let kept ~lasting ~turn ?shared (inside : Scope.t) (name, ty) before =
  let next () =
    match shared with
    | Some shared when not (chance inside.random 5) -> of_shared inside shared ty
    | Some _ | None ->
        if chance inside.random 2 then number inside ty else other_than inside before ty
  in
  let value =
    if lasting then
      let start, later = if chance inside.random 4 then (before, next ()) else (next (), before) in
      f "if %s then %s else %s" (turn ()) start later
    else if chance inside.random 3 then next ()
    else f "if %s then %s else %s" (turn ()) (number inside ty) (next ())
  in
  [ f "%s = %s" name value; f "%s = delay %s %s" before (Constant.literal inside ty) name ]

(* A Bool whose value is known where a condition holds, or where it does not. *)
let settled (inside : Scope.t) name condition =
  let other = Expression.expression inside 0 Bool in
  let condition = if chance inside.random 3 then condition else f "not %s" condition in
  let operator = one_of inside.random [ "&&"; "||" ] in
  let a, b = if chance inside.random 2 then (condition, other) else (other, condition) in
  f "%s = delay %s (%s %s %s)" name (Constant.literal inside Bool) a operator b

(* Only these signals may depend on the time. *)
let moving (inside : Scope.t) name =
  let of_what =
    if chance inside.random 4 then Constant.literal inside Float
    else Expression.expression inside 1 Float
  in
  if chance inside.random 4 then f "%s = integral (%s) / 1[s]" name of_what
  else f "%s = 1[s] * derivative (%s)" name of_what

let make values ~pattern:(pattern, bound) =
  Scope.note values "small root";
  let random = values.Scope.random in
  let signals =
    List.init
      (1 + Random.State.int random 4)
      (fun _ -> (Scope.fresh values "v", one_of random [ Type.Int; Int; Float; Bool ]))
  in
  let befores = List.map (fun (_, ty) -> (Scope.fresh values "d", ty)) signals in
  (* Signals use only the previous values of other signals, so there are no loops within an
     instant. *)
  let inside = Scope.bind (befores @ bound) values in
  let lasting = not (chance random 3) in
  let first, others = (List.hd signals, List.tl signals) in
  let shared =
    if snd first <> Type.Bool && List.compare_length_with others 1 > 0 && chance random 2 then
      Some { name = Scope.fresh values "e"; ty = snd first }
    else None
  in
  let conditions =
    if Option.is_some shared || chance random 2 then [ Scope.fresh values "c" ] else []
  in
  let turn () =
    match conditions with
    | [ condition ] when Option.is_some shared || not (chance random 4) -> condition
    | _ -> turn_of inside
  in
  let before_first = fst (List.hd befores) in
  let is_shared = Option.is_some shared in
  let of_first = kept ~lasting:(lasting && not is_shared) ~turn inside first before_first in
  let kept signal (before, _) =
    kept ~lasting:(lasting || is_shared) ~turn ?shared inside signal before
  in
  let of_others = List.concat (List.map2 kept others (List.tl befores)) in
  let sharing { name; ty } =
    f "%s = %s" name
      (if ty = Type.Int then f "3 * %s + %s" before_first (number inside ty)
       else f "0.5 * %s - %s" before_first (number inside ty))
  in
  let equations = of_first @ of_others @ List.map sharing (Option.to_list shared) in
  let asked condition =
    f "%s = %s" condition
      (if chance random 2 then Expression.expression inside 1 Bool else turn_of inside)
  in
  let settling = List.map (fun condition -> (Scope.fresh values "w", condition)) conditions in
  let equations =
    equations @ List.map asked conditions
    @ List.map (fun (name, condition) -> settled inside name condition) settling
  in
  let movements = if chance random 3 then [ Scope.fresh values "m" ] else [] in
  let equations = equations @ List.map (moving inside) movements in
  let shown =
    List.filteri (fun k _ -> k = 0 || Option.is_some shared || not (chance random 3)) signals
    @ List.map (fun name -> (name, Type.Float)) movements
    @ List.map (fun (name, _) -> (name, Type.Bool)) settling
  in
  ( f "proc %s -> (%s) where\n%s" pattern
      (String.concat ", " (List.map fst shown))
      (String.concat "\n" (List.map (fun text -> "    " ^ text) (shuffled random equations))),
    List.map snd shown )
