module Ir = Typing.Ir

type t = { units : (int * Ir.unit_) list; types : (int * Ir.ty) list }

let empty = { units = []; types = [] }

(* {1 Units} *)

let product factors : Ir.unit_ =
  let add sum (key, power) =
    let before = Option.value (List.assoc_opt key sum) ~default:Typing.Rational.zero in
    (key, Typing.Rational.add before power) :: List.remove_assoc key sum
  in
  let all select =
    List.concat_map select factors |> List.fold_left add []
    |> List.filter (fun (_, power) -> not (Typing.Rational.is_zero power))
    |> List.sort compare
  in
  { base = all (fun (u : Ir.unit_) -> u.base); variables = all (fun u -> u.variables) }

let power (u : Ir.unit_) exponent : Ir.unit_ =
  let raise_ (x, p) = (x, Typing.Rational.multiply p exponent) in
  { base = List.map raise_ u.base; variables = List.map raise_ u.variables }

let in_unit units (u : Ir.unit_) =
  let variable ((v : Ir.variable), exponent) =
    match List.assoc_opt v.id units with
    | Some unit_ -> power unit_ exponent
    | None -> { base = []; variables = [ (v, exponent) ] }
  in
  product ({ u with variables = [] } :: List.map variable u.variables)

(* {1 Types} *)

let rec apply t (ty : Ir.ty) : Ir.ty =
  let go = apply t in
  match ty with
  | Variable v -> Option.value (List.assoc_opt v.id t.types) ~default:ty
  | Number (representation, unit_) -> Number (representation, in_unit t.units unit_)
  | Bool | String | Size _ -> ty
  | Tuple parts -> Tuple (List.map go parts)
  | Function (a, b) -> Function (go a, go b)
  | Signal_function (a, b) -> Signal_function (go a, go b)
  | Data d ->
      Data
        { d with units = List.map (in_unit t.units) d.units; arguments = List.map go d.arguments }

let union a b = { units = a.units @ b.units; types = a.types @ b.types }

let data ~unit_parameters units ~type_parameters arguments =
  let ids = List.map (fun (v : Ir.variable) -> v.id) in
  {
    units = List.combine (ids unit_parameters) units;
    types = List.combine (ids type_parameters) arguments;
  }

let without variables t =
  let others list =
    List.filter
      (fun (id, _) -> not (List.exists (fun (v : Ir.variable) -> v.id = id) variables))
      list
  in
  { units = others t.units; types = others t.types }

(* {1 Matching} *)

(* Solves equations between units. An equation with only one unknown variable determines its
   value. *)
let rec solve t equations =
  let unknown (general : Ir.unit_) =
    List.filter (fun ((v : Ir.variable), _) -> not (List.mem_assoc v.id t.units)) general.variables
  in
  let known, rest =
    List.partition (fun (general, _) -> List.length (unknown general) = 1) equations
  in
  match known with
  | [] -> t
  | (general, specific) :: others ->
      let (v : Ir.variable), exponent = List.hd (unknown general) in
      let factor =
        power { base = []; variables = [ (v, exponent) ] } (Typing.Rational.of_int (-1))
      in
      let others_of_general = in_unit t.units (product [ general; factor ]) in
      let quotient = product [ specific; power others_of_general (Typing.Rational.of_int (-1)) ] in
      let value = power quotient (Typing.Rational.inverse exponent) in
      solve { t with units = (v.id, value) :: t.units } (others @ rest)

let rec pairs (t, equations) (general : Ir.ty) (specific : Ir.ty) =
  match (general, specific) with
  | Variable v, ty when not (List.mem_assoc v.id t.types) ->
      ({ t with types = (v.id, ty) :: t.types }, equations)
  | Number (_, a), Number (_, b) -> (t, (a, b) :: equations)
  | Tuple a, Tuple b when List.compare_lengths a b = 0 -> List.fold_left2 pairs (t, equations) a b
  | Function (a, b), Function (c, d) | Signal_function (a, b), Signal_function (c, d) ->
      pairs (pairs (t, equations) a c) b d
  | Data a, Data b
    when a.tycon = b.tycon
         && List.compare_lengths a.units b.units = 0
         && List.compare_lengths a.arguments b.arguments = 0 ->
      List.fold_left2 pairs (t, List.combine a.units b.units @ equations) a.arguments b.arguments
  | _ -> (t, equations)

let matching general specific =
  let t, equations = pairs (empty, []) general specific in
  solve t equations
