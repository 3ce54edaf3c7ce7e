open Choice
open Scope

type binding = { name : string; ty : Type.t; text : string }

type makers = {
  expression : Scope.t -> int -> Type.t -> string;
  instances : (Type.t -> Type.t -> string) option;
}

let f = Printf.sprintf
let annotated = Constant.annotated

(* Uses few types, so that a result of one loop often occurs in the body of the next. *)
let element s usual = if chance s.random 6 then any_type s else one_of s.random usual

(* A function of the elements. It mostly uses its parameters and the chain's earlier results, and
   only a few other variables in scope. *)
let lambda s makers arguments result =
  let named = List.map (fun ty -> (fresh s "e", ty)) arguments in
  let inside = bind named { s with run = None } in
  f "(\\%s -> %s)"
    (String.concat " " (List.map fst named))
    (annotated (makers.expression inside (1 + Random.State.int s.random 2) result) result)

(* Returns 0 for some of the elements. *)
let or_zero s makers u =
  let e = fresh s "e" in
  let inside = bind [ (e, u) ] { s with run = None } in
  f "(\\%s -> if %s then %s else %s)" e (makers.expression inside 1 Bool)
    (annotated (makers.expression inside 1 Float) Float)
    (one_of s.random [ "0"; "0"; "(-0)" ])

(* Makes all elements NaN at the instants at which a number is negative. *)
let lost s makers (a, _) =
  let e = fresh s "e" in
  let number =
    match variable s Float with
    | Some x -> x
    | None -> makers.expression { s with run = None } 1 Float
  in
  f "map (\\%s -> %s %s sqrt %s) %s" e e (one_of s.random [ "+"; "*" ]) (annotated number Float) a

(* Prefers the most recent elements of the list. *)
let latest s list =
  one_of s.random (List.filteri (fun k _ -> k = 0 || not (chance s.random 3)) list)

(* Annotated with their types, which may not be known otherwise, for example for a parameter. *)
let arrays_of n variables =
  List.filter_map
    (fun (name, (ty : Type.t)) ->
      match ty with Array (k, t) when k = n -> Some (annotated name ty, t) | _ -> None)
    variables

let new_array s makers ~n arrays (t : Type.t) =
  let any () = latest s arrays in
  let lambda = lambda s makers in
  let value ty = annotated (makers.expression { s with run = None } 1 ty) ty in
  let index () = one_of s.random [ value Int; f "%d" (Random.State.int s.random n) ] in
  let of_one make = match arrays with [] -> None | _ -> Some (make (any ())) in
  let made =
    match Random.State.int s.random 13 with
    | 0 | 1 | 2 ->
        of_one (fun (a, u) ->
            let each =
              if t = Float && chance s.random 3 then or_zero s makers u else lambda [ u ] t
            in
            f "map %s %s" each a)
    | 3 -> of_one (fun (a, u) -> f "imap %s %s" (lambda [ Int; u ] t) a)
    | 4 | 5 | 6 ->
        of_one (fun (a, u) ->
            let b, v = any () in
            f "zipWith %s %s %s" (lambda [ u; v ] t) a b)
    | 7 | 8 -> of_one (fun (a, u) -> f "scanl %s %s %s" (lambda [ t; u ] t) (value t) a)
    | 9 -> (
        match List.filter (fun (_, u) -> u = t) arrays with
        | [] -> None
        | same -> Some (f "replace %s %s %s" (index ()) (value t) (fst (latest s same))))
    | 11 when t = Float -> Option.map (lost s makers) (List.find_opt (fun (_, u) -> u = t) arrays)
    | 10 ->
        Option.bind makers.instances (fun instance ->
            of_one (fun (a, u) -> f "(mapSF %s) %s" (instance u t) a))
    | _ -> None
  in
  match made with Some text -> text | None -> f "generate %s" (lambda [ Int ] t)

let fold s makers (a, u) result =
  let value = annotated (makers.expression { s with run = None } 0 result) result in
  f "foldl %s %s %s" (lambda s makers [ result; u ] result) value a

(* Two results at once, which often start or continue with equal values. *)
let fold_of_two s makers (a, u) result =
  let first = fresh s "r" and second = fresh s "r" and e = fresh s "e" in
  let inside = bind [ (e, u); (first, result); (second, result) ] { s with run = None } in
  let value () =
    one_of s.random [ first; second; annotated (makers.expression inside 1 result) result ]
  in
  let two value =
    let x = value () in
    f "(%s, %s)" x (if chance s.random 2 then x else value ())
  in
  let start () = annotated (Constant.literal s result) result in
  f "foldl (\\(%s, %s) %s -> if %s then %s else %s) %s %s" first second e
    (makers.expression inside 1 Bool) (two value) (two value) (two start) a

let new_value s makers ~n arrays usual : Type.t * string =
  let ((a, u) as array) = latest s arrays in
  match Random.State.int s.random 9 with
  | 7 ->
      let result = one_of s.random usual in
      (Tuple [ result; result ], fold_of_two s makers array result)
  | (0 | 8) when u = Type.Float && not (chance s.random 3) ->
      let name = one_of s.random [ "minimumBy"; "maximumBy" ] in
      let looked_at = if chance s.random 2 then f "(%s)" (lost s makers array) else a in
      let limit = annotated (makers.expression { s with run = None } 0 Float) Float in
      let limit = if chance s.random 2 then annotated (Constant.literal s Float) Float else limit in
      let operator = one_of s.random [ "<"; "<"; "<="; ">"; ">"; ">="; "==" ] in
      (Bool, f "(%s id %s) %s %s" name looked_at operator limit)
  | 0 ->
      let name = one_of s.random [ "minimumBy"; "maximumBy" ] in
      (u, f "%s %s %s" name (lambda s makers [ u ] (one_of s.random [ Type.Float; Int ])) a)
  | 1 -> (Bool, f "%s %s %s" (one_of s.random [ "any"; "all" ]) (lambda s makers [ u ] Bool) a)
  | 2 -> (u, f "%s ! %d" a (Random.State.int s.random n))
  | _ ->
      let result = element s usual in
      (result, fold s makers array result)

(* The compiler unrolls loops over short arrays. *)
let size s =
  let known =
    List.filter_map
      (fun (_, (ty : Type.t)) -> match ty with Array (n, _) -> Some n | _ -> None)
      s.variables
  in
  if known <> [] && chance s.random 2 then one_of s.random known
  else one_of s.random [ 2; 3; 4; 5; 6; 7; 12 ]

let make s makers ?last n =
  note s "chain of array functions";
  let usual = [ one_of s.random [ Type.Float; Int ]; one_of s.random [ Type.Float; Int; Bool ] ] in
  let rec go known found k =
    let arrays = arrays_of n known.variables in
    let add ty text =
      let name = fresh s "c" in
      let binding = { name; ty; text = annotated text ty } in
      go (bind [ (name, ty) ] known) (binding :: found) (k - 1)
    in
    let add_array t = add (Type.Array (n, t)) (new_array known makers ~n arrays t) in
    if k < 0 then List.rev found
    else if k = 0 then match last with Some t -> add_array t | None -> List.rev found
    else if arrays = [] || not (chance s.random 3) then add_array (element s usual)
    else
      let ty, text = new_value known makers ~n arrays usual in
      add ty text
  in
  let near k (_, (ty : Type.t)) =
    k < 3 || match ty with Array (size, _) -> size = n | _ -> false
  in
  go { s with variables = List.filteri near s.variables } [] (3 + Random.State.int s.random 5)

(* {1 Results of the chain} *)

(* Converts an element to a number that distinguishes it from others. *)
let number (ty : Type.t) e =
  match ty with
  | Float -> Some (f "round (64.0 * %s)" e)
  | Measure u -> Some (f "round (64.0 * (%s / 1[%s]))" e (Type.unit_text u))
  | Int -> Some e
  | Bool -> Some (f "(if %s then 1 else 0)" e)
  | Tuple _ | Array _ | Data _ -> None

(* Depends on the order, to detect exchanged elements. *)
let digest (name, (ty : Type.t)) =
  match ty with
  | Array (_, t) ->
      Option.map (fun e -> f "foldl (\\h e -> 31 * h + %s) 7 %s" e name) (number t "e")
  | Tuple [ t; u ] -> (
      match (number t (f "fst %s" name), number u (f "snd %s" name)) with
      | Some x, Some y -> Some (f "(%s) - 5 * (%s)" x y)
      | _, _ -> None)
  | Float | Measure _ | Int | Bool | Tuple _ | Data _ -> number ty name

let result s makers bindings (ty : Type.t) =
  let variables = List.rev_map (fun b -> (b.name, b.ty)) bindings in
  let inside = bind variables { s with run = None } in
  let digests = List.filter_map digest (List.filteri (fun k _ -> k < 4) variables) in
  let whole = f "(%s)" (String.concat " + 17 * " (List.map (f "(%s)") ("0" :: digests))) in
  match ty with
  | Int when not (chance s.random 4) -> whole
  | Float when not (chance s.random 4) -> f "toFloat %s" whole
  | Bool when not (chance s.random 4) -> f "(mod %s 3 == 0)" whole
  | _ -> makers.expression inside 2 ty
