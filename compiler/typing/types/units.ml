type t = {
  base : (Ir.Global.t * Rational.t) list;
  rigid : (rigid * Rational.t) list;
  flexible : (flexible * Rational.t) list;
}
(* Each list is sorted and has no zero powers. *)

and rigid = { variable : Ir.variable; depth : int }
and flexible = { id : int; mutable depth : int; mutable solution : t option }

let one = { base = []; rigid = []; flexible = [] }
let is_one = function { base = []; rigid = []; flexible = [] } -> true | _ -> false
let base unit_ = { one with base = [ (unit_, Rational.one) ] }
let of_rigid variable = { one with rigid = [ (variable, Rational.one) ] }
let fresh ~id ~depth = { one with flexible = [ ({ id; depth; solution = None }, Rational.one) ] }

let by_name (a : Ir.Global.t) (b : Ir.Global.t) =
  match String.compare a.name b.name with 0 -> String.compare a.module_ b.module_ | order -> order

let by_variable (a : rigid) (b : rigid) = Int.compare a.variable.id b.variable.id
let by_id (a : flexible) (b : flexible) = Int.compare a.id b.id

let rec merge by a b =
  match (a, b) with
  | [], rest | rest, [] -> rest
  | (x, p) :: a', (y, q) :: b' ->
      let order = by x y in
      if order < 0 then (x, p) :: merge by a' b
      else if order > 0 then (y, q) :: merge by a b'
      else
        let sum = Rational.add p q in
        let rest = merge by a' b' in
        if Rational.is_zero sum then rest else (x, sum) :: rest

let multiply a b =
  if is_one a then b
  else if is_one b then a
  else
    {
      base = merge by_name a.base b.base;
      rigid = merge by_variable a.rigid b.rigid;
      flexible = merge by_id a.flexible b.flexible;
    }

let power unit_ exponent =
  if Rational.is_zero exponent || is_one unit_ then one
  else if Rational.equal exponent Rational.one then unit_
  else
    let raise_ powers = List.map (fun (x, p) -> (x, Rational.multiply p exponent)) powers in
    { base = raise_ unit_.base; rigid = raise_ unit_.rigid; flexible = raise_ unit_.flexible }

let divide a b = multiply a (power b (Rational.of_int (-1)))

let rec is_resolved = function
  | [] -> true
  | ({ solution = None; _ }, _) :: rest -> is_resolved rest
  | ({ solution = Some _; _ }, _) :: _ -> false

let rec resolve unit_ =
  match unit_ with
  | { base = []; rigid = []; flexible = [ (({ solution = Some found; _ } as x), power) ] }
    when Rational.equal power Rational.one ->
      let solution = resolve found in
      if solution != found then x.solution <- Some solution;
      solution
  | _ when is_resolved unit_.flexible -> unit_
  | _ ->
      List.fold_left
        (fun product (x, p) ->
          match x.solution with
          | None -> multiply product { one with flexible = [ (x, p) ] }
          | Some solution ->
              let solution = resolve solution in
              x.solution <- Some solution;
              multiply product (power solution p))
        { unit_ with flexible = [] } unit_.flexible

(* Compares units that have no unsolved variables. *)
let same a b =
  let same_powers by = List.equal (fun (x, p) (y, q) -> by x y = 0 && Rational.equal p q) in
  same_powers by_name a.base b.base && same_powers by_variable a.rigid b.rigid

let equal a b =
  let a = resolve a and b = resolve b in
  match (a.flexible, b.flexible) with [], [] -> same a b | _, _ -> is_one (divide a b)

let is_open unit_ = (resolve unit_).flexible <> []
let deepest rigid = List.fold_left (fun depth ((r : rigid), _) -> max depth r.depth) 0 rigid

(* The variable to eliminate is the innermost one, so that outer variables do not become dependent
   on it; among equally deep variables, the newest. *)
let is_before (x : flexible) (y : flexible) = y.depth > x.depth || (y.depth = x.depth && y.id > x.id)

let pivot = function
  | [] -> None
  | first :: rest ->
      let better (x, p) (y, q) = if is_before x y then (y, q) else (x, p) in
      Some (List.fold_left better first rest)

(* Solves [x^exponent * rest = 1] for [x]. *)
let solve ((x : flexible), exponent) product =
  let rest = { product with flexible = List.filter (fun (y, _) -> y != x) product.flexible } in
  x.solution <- Some (power rest (Rational.negate (Rational.inverse exponent)))

let unify a b =
  let a = resolve a and b = resolve b in
  a == b
  ||
  match (a, b) with
  | { flexible = []; _ }, { flexible = []; _ } -> same a b
  (* Fast path: in almost all cases, at least one of the two is a single variable. *)
  | { base = []; rigid = []; flexible = [ (x, power) ] }, ({ flexible = []; _ } as other)
  | ({ flexible = []; _ } as other), { base = []; rigid = []; flexible = [ (x, power) ] }
    when Rational.equal power Rational.one ->
      let fits = x.depth >= deepest other.rigid in
      if fits then x.solution <- Some other;
      fits
  | ( { base = []; rigid = []; flexible = [ (x, power) ] },
      { base = []; rigid = []; flexible = [ (y, power') ] } )
    when Rational.(equal power one && equal power' one) ->
      if x != y then if is_before x y then y.solution <- Some a else x.solution <- Some b;
      true
  | _, _ -> (
      let quotient = divide a b in
      match pivot quotient.flexible with
      | None -> is_one quotient
      | Some ((x : flexible), _) when x.depth < deepest quotient.rigid -> false
      | Some (x, exponent) ->
          solve (x, exponent) quotient;
          true)

let lower ~depth unit_ =
  let unit_ = resolve unit_ in
  List.iter (fun ((x : flexible), _) -> x.depth <- min x.depth depth) unit_.flexible;
  deepest unit_.rigid <= depth

let base_powers unit_ = unit_.base
let rigid_powers unit_ = unit_.rigid
let flexible_powers unit_ = List.map (fun ((x : flexible), p) -> (x.id, p)) unit_.flexible

let generalize ~fresh unit_ =
  let unit_ = resolve unit_ in
  match pivot unit_.flexible with
  | None -> None
  | Some (x, exponent) ->
      let variable = fresh () in
      solve (x, exponent) (divide unit_ (of_rigid variable));
      Some variable

let substitute replacement unit_ =
  let unit_ = resolve unit_ in
  match unit_.rigid with
  | [] -> unit_
  | rigid ->
      List.fold_left
        (fun product ((r : rigid), p) ->
          match replacement r.variable.id with
          | None -> multiply product { one with rigid = [ (r, p) ] }
          | Some by -> multiply product (power by p))
        { unit_ with rigid = [] } rigid

let to_ir unit_ : Ir.unit_ =
  let unit_ = resolve unit_ in
  { base = unit_.base; variables = List.map (fun ((r : rigid), p) -> (r.variable, p)) unit_.rigid }
