let rec parameters (t : Type.t) =
  match Type.expand t with
  | Function (parameter, result) -> parameter :: parameters result
  | Signal_function (input, _) -> [ input ]
  | Flexible _ | Rigid _ | Number _ | Bool | String | Tuple _ | Data _ | Alias _ | Size _
  | Erroneous ->
      []

let representations_agree a b =
  match (Type.representation a, Type.representation b) with
  | Int, Float | Float, Int -> false
  | (Int | Float | Flexible_representation _ | Rigid_representation _), _ -> true

(* The types and units bound to the variables of the expected types. *)
type bound = {
  mutable types : (Type.flexible * Type.t) list;
  mutable units : (Units.t * Units.t) list;
}

let nothing_bound () = { types = []; units = [] }

(* Two expected units may depend on each other, such as `u` and `u/s`. *)
let units_agree bound wanted given =
  let fits (u, earlier) =
    Units.is_open earlier || Units.is_open given
    ||
    let ratio = Units.divide wanted u in
    Units.is_open ratio || Units.equal ratio (Units.divide given earlier)
  in
  if not (Units.is_open wanted) then Units.is_open given || Units.equal wanted given
  else
    List.for_all fits bound.units
    &&
    (bound.units <- (wanted, given) :: bound.units;
     true)

(* Could an argument of type [given] be intended where [wanted] is expected? All occurrences of a
   variable in the expected types must agree. [bound] records the bindings of the variables. *)
let rec agree bound wanted given =
  let all ws gs = List.compare_lengths ws gs = 0 && List.for_all2 (agree bound) ws gs in
  match (Type.expand wanted, Type.expand given) with
  | Flexible variable, given -> (
      match List.find_opt (fun (v, _) -> v == variable) bound.types with
      | Some (_, earlier) -> agree (nothing_bound ()) earlier given
      | None ->
          bound.types <- (variable, given) :: bound.types;
          true)
  | _, (Flexible _ | Erroneous) | Erroneous, _ -> true
  | Number (r, u), Number (r', u') -> representations_agree r r' && units_agree bound u u'
  | Tuple ws, Tuple gs -> all ws gs
  | Function (a, b), Function (a', b') | Signal_function (a, b), Signal_function (a', b') ->
      all [ a; b ] [ a'; b' ]
  | Data { tycon; arguments; _ }, Data { tycon = tycon'; arguments = arguments'; _ } ->
      tycon = tycon' && all arguments arguments'
  | Rigid a, Rigid b -> a.variable.id = b.variable.id
  | Bool, Bool | String, String -> true
  | Size n, Size n' -> n = n'
  | ( ( Number _ | Tuple _ | Function _ | Signal_function _ | Data _ | Rigid _ | Bool | String
      | Size _ | Alias _ ),
      _ ) ->
      false

let may_be ~wanted given = agree (nothing_bound ()) wanted given

(* Like [agree], but does not accept a given type that is unknown. *)
let surely ~unfit bound wanted given =
  match (Type.expand wanted, Type.expand given) with
  | Flexible _, _ -> (not (unfit ~wanted given)) && agree bound wanted given
  | _, (Flexible _ | Erroneous) -> false
  | _ -> agree bound wanted given

let exchanged ~unfit ~parameters ~given ~position =
  let alike a b =
    match (Type.expand a, Type.expand b) with
    | Number (_, u), Number (_, u') -> Units.equal u u'
    | _ -> false
  in
  (* a `0` fits any parameter, so the mismatch between Int and Float is the better explanation *)
  let is_open_number t =
    match Type.expand t with
    | Number (r, _) -> (
        match Type.representation r with Flexible_representation _ -> true | _ -> false)
    | _ -> false
  in
  let of_numbers =
    match (List.nth_opt parameters (position - 1), List.nth_opt given (position - 1)) with
    | Some wanted, Some given -> (
        match (Type.expand wanted, Type.expand given) with
        | Number (r, _), Number (r', _) -> not (representations_agree r r')
        | _ -> false)
    | _ -> false
  in
  let fit i =
    if i = position || i > List.length parameters then false
    else if is_open_number (List.nth given (i - 1)) && of_numbers then false
    else if alike (List.nth given (i - 1)) (List.nth given (position - 1)) then false
    else
      let moved j = if j = i then position else if j = position then i else j in
      let bound = nothing_bound () in
      List.mapi (fun j parameter -> (j + 1, parameter)) parameters
      |> List.for_all (fun (j, parameter) ->
             match List.nth_opt given (moved j - 1) with
             | Some ty when moved j <> j -> surely ~unfit bound parameter ty
             | Some ty -> agree bound parameter ty
             | None -> true)
  in
  if List.compare_lengths given parameters > 0 then None
  else List.find_opt fit (List.mapi (fun i _ -> i + 1) given)

let pair_exchanged ~unfit ~wanted:(a, b) (a', b') =
  let fits wanted given = agree (nothing_bound ()) wanted given && not (unfit ~wanted given) in
  let is_open t = match Type.expand t with Type.Flexible _ | Erroneous -> true | _ -> false in
  (not (fits a a' && fits b b'))
  && fits a b' && fits b a'
  (* two unknown types are not enough evidence of a swap *)
  && (not (is_open a' && is_open b'))
  && not (is_open a && is_open b)

let rotated ~unfit ~parameters ~given =
  let n = List.length given in
  let fits order =
    let bound = nothing_bound () in
    List.for_all2
      (fun parameter i -> surely ~unfit bound parameter (List.nth given (i - 1)))
      parameters order
  in
  if n < 3 || List.compare_length_with parameters n <> 0 then None
  else
    let by k = List.init n (fun i -> ((i + k) mod n) + 1) in
    List.find_opt fits [ by 1; by (n - 1) ]

let shifted ~unfit ~is_constrained ~parameters ~given ~position =
  let missing = List.length parameters - List.length given in
  let bound = nothing_bound () in
  let fits i ty =
    if i < position then agree bound (List.nth parameters (i - 1)) ty
    else
      let parameter = List.nth parameters (i - 1 + missing) in
      match (Type.expand parameter, Type.expand ty) with
      | _, (Flexible _ | Erroneous) -> false
      (* a variable fits anything, so it says nothing about this argument *)
      | Flexible _, _ when not (is_constrained parameter) -> false
      | _ -> surely ~unfit bound parameter ty
  in
  if missing > 0 && List.for_all Fun.id (List.mapi (fun i ty -> fits (i + 1) ty) given) then
    Some missing
  else None
