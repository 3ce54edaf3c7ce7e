type t =
  | Bools of { true_ : bool; false_ : bool }
  | Ints of { least : int; most : int }
  | Floats of { least : float; most : float; nan : bool }
  | Constructors of (int * t list option) list

let bug format = Basis.Diagnostic.bug ~stage:"Flow.Range" format
let least_int = Int32.to_int Int32.min_int
let most_int = Int32.to_int Int32.max_int
let any_bool = Bools { true_ = true; false_ = true }
let any_int = Ints { least = least_int; most = most_int }
let any_float = Floats { least = neg_infinity; most = infinity; nan = true }

let rec anything (program : Ir.program) : Ir.ty -> t = function
  | Bool -> any_bool
  | Int -> any_int
  | Float -> any_float
  | Sum k -> Constructors (List.mapi (fun i _ -> (i, None)) program.sums.(k).constructors)
  | Array (_, element) -> anything program element
  | Foreign _ -> Constructors []

let anything_but_sums : Ir.ty -> t = function
  | Bool -> any_bool
  | Int -> any_int
  | Float -> any_float
  | Sum _ | Array _ | Foreign _ -> bug "an operation does not return a number"

let float x =
  if Float.is_nan x then Floats { least = infinity; most = neg_infinity; nan = true }
  else Floats { least = x; most = x; nan = false }

let of_constant : Ir.atom -> t option = function
  | Bool b -> Some (Bools { true_ = b; false_ = not b })
  | Int n -> Some (Ints { least = Int32.to_int n; most = Int32.to_int n })
  | Float x -> Some (float x)
  | Signal _ -> None

let zero = float 0.
let zero_or ~nan = Floats { least = 0.; most = 0.; nan }
let not_negative = Floats { least = 0.; most = infinity; nan = false }

let rec union merge a b =
  match (a, b) with
  | [], c | c, [] -> c
  | ((k, _) as x) :: xs, (l, _) :: _ when k < l -> x :: union merge xs b
  | (k, _) :: _, ((l, _) as y) :: ys when l < k -> y :: union merge a ys
  | (k, Some p) :: xs, (_, Some q) :: ys ->
      (k, Some (List.rev (List.rev_map2 merge p q))) :: union merge xs ys
  | (k, _) :: xs, _ :: ys -> (k, None) :: union merge xs ys

let rec join a b =
  match (a, b) with
  | Bools a, Bools b -> Bools { true_ = a.true_ || b.true_; false_ = a.false_ || b.false_ }
  | Ints a, Ints b -> Ints { least = min a.least b.least; most = max a.most b.most }
  | Floats a, Floats b ->
      Floats
        { least = Float.min a.least b.least; most = Float.max a.most b.most; nan = a.nan || b.nan }
  | Constructors a, Constructors b -> Constructors (union join a b)
  | (Bools _ | Ints _ | Floats _ | Constructors _), _ -> bug "values of different types"

let rec widen ~steps a b =
  match (a, b) with
  | Constructors a, Constructors b -> Constructors (union (widen ~steps) a b)
  | _ -> widened ~steps a (join a b)

and widened ~steps a joined =
  match (a, joined) with
  | Ints a, Ints j ->
      let below = List.fold_left (fun found n -> if n <= j.least then max found n else found) in
      let above = List.fold_left (fun found n -> if n >= j.most then min found n else found) in
      Ints
        {
          least = (if j.least < a.least then below least_int steps else a.least);
          most = (if j.most > a.most then above most_int steps else a.most);
        }
  | Floats a, Floats j ->
      Floats
        {
          least = (if j.least < a.least then neg_infinity else a.least);
          most = (if j.most > a.most then infinity else a.most);
          nan = j.nan;
        }
  | _, joined -> joined

let is_empty = function
  | Bools { true_; false_ } -> not (true_ || false_)
  | Ints { least; most } -> least > most
  | Floats { least; most; nan } -> least > most && not nan
  | Constructors _ -> false

let non_empty t = if is_empty t then None else Some t

(* The intersection. For a data type, keeps the constructors that both arguments have, with the
   payloads from the second argument. *)
let meet a b =
  match (a, b) with
  | Bools a, Bools b ->
      non_empty (Bools { true_ = a.true_ && b.true_; false_ = a.false_ && b.false_ })
  | Ints a, Ints b -> non_empty (Ints { least = max a.least b.least; most = min a.most b.most })
  | Floats a, Floats b ->
      let least = Float.max a.least b.least and most = Float.min a.most b.most in
      non_empty (Floats { least; most; nan = a.nan && b.nan })
  | Constructors a, Constructors b -> (
      match List.filter (fun (k, _) -> List.mem_assoc k a) b with
      | [] when a <> [] || b <> [] -> None
      | left -> Some (Constructors left))
  | (Bools _ | Ints _ | Floats _ | Constructors _), _ -> bug "values of different types"

let both a b = match (non_empty a, non_empty b) with Some a, Some b -> Some (a, b) | _ -> None

let rec compared (operator : Ir.operator) a b holds =
  match (operator, a, b, holds) with
  | Less, Ints x, Ints y, true ->
      both
        (Ints { x with most = min x.most (y.most - 1) })
        (Ints { y with least = max y.least (x.least + 1) })
  | Less_equal, Ints x, Ints y, true ->
      both (Ints { x with most = min x.most y.most }) (Ints { y with least = max y.least x.least })
  | Less, Ints _, Ints _, false -> swapped Ir.Less_equal a b
  | Less_equal, Ints _, Ints _, false -> swapped Ir.Less a b
  | Equal, (Ints _ | Floats _), (Ints _ | Floats _), true -> (
      match meet a b with
      | Some (Floats same) ->
          let same = Floats { same with nan = false } in
          both same same
      | Some same -> Some (same, same)
      | None -> None)
  | Equal, Ints x, Ints y, false ->
      both (without x.least x.most y.least y.most) (without y.least y.most x.least x.most)
  | (Less | Less_equal), Floats x, Floats y, true ->
      both
        (Floats { x with most = Float.min x.most y.most; nan = false })
        (Floats { y with least = Float.max y.least x.least; nan = false })
  | (Less | Less_equal), Floats x, Floats y, false ->
      (* The comparison is also false if the other number is NaN. *)
      let x' = if y.nan then x.least else Float.max x.least y.least in
      let y' = if x.nan then y.most else Float.min y.most x.most in
      both (Floats { x with least = x' }) (Floats { y with most = y' })
  | _ -> Some (a, b)

and swapped operator a b = Option.map (fun (b, a) -> (a, b)) (compared operator b a true)

(* If the second range contains a single value that is a bound of the first range, removes that
   value from the first range. *)
and without least most other_least other_most =
  if other_least < other_most then Ints { least; most }
  else
    Ints
      {
        least = (if least = other_least then least + 1 else least);
        most = (if most = other_most then most - 1 else most);
      }

let may_be_true = function Bools b -> b.true_ | _ -> bug "a condition that is not a Bool"
let may_be_false = function Bools b -> b.false_ | _ -> bug "a condition that is not a Bool"

let has_constructor t k =
  match t with
  | Constructors ks ->
      Bools { true_ = List.mem_assoc k ks; false_ = List.exists (fun (other, _) -> other <> k) ks }
  | Bools _ | Ints _ | Floats _ -> bug "a constructor of a value that is not a sum"

let payload t k leaf =
  match t with
  | Constructors [ (only, Some leaves) ] when only = k -> List.nth_opt leaves leaf
  | Constructors _ -> None
  | Bools _ | Ints _ | Floats _ -> bug "the payload of a value that is not a sum"

(* The only value of a range, if it has exactly one. Excludes Float zeros, because a range does not
   distinguish their signs. *)
let constant : t -> Ir.atom option = function
  | Bools { true_ = true; false_ = false } -> Some (Bool true)
  | Bools { true_ = false; false_ = true } -> Some (Bool false)
  | Ints { least; most } when least = most -> Some (Int (Int32.of_int least))
  | Floats { least; most; nan = false } when least = most && least <> 0. -> Some (Float least)
  | Bools _ | Ints _ | Floats _ | Constructors _ -> None

let ints least most = if least < least_int || most > most_int then any_int else Ints { least; most }

(* Ignores bounds that are NaN. *)
let floats real ~nan bounds =
  let bounds =
    List.filter (fun x -> not (Float.is_nan x)) (List.map (Basis.Real.round real) bounds)
  in
  Floats
    {
      least = List.fold_left Float.min infinity bounds;
      most = List.fold_left Float.max neg_infinity bounds;
      nan;
    }

let corners f (a, b) (c, d) = [ f a c; f a d; f b c; f b d ]
let no_numbers least most = (least : float) > most
let has_zero least most = least <= 0. && most >= 0.
let has_infinity least most = least = neg_infinity || most = infinity

(* Rounding is monotonic, so applying the operation to the operands' bounds yields the bounds of the
   result. The result can be NaN if the ranges allow inf - inf, 0 * inf or inf / inf. The
   division 0 / 0 cannot occur, because divisors whose ranges contain 0 are not handled here. *)
let on_floats real (operator : Ir.operator) (al, ah, a_nan) (bl, bh, b_nan) : t option =
  let nan = a_nan || b_nan in
  let sum (bl, bh) =
    let opposed = (ah = infinity && bl = neg_infinity) || (al = neg_infinity && bh = infinity) in
    let bounds = [ al +. bl; ah +. bh ] in
    if List.exists Float.is_nan bounds then any_float else floats real ~nan:(nan || opposed) bounds
  in
  if no_numbers al ah || no_numbers bl bh then None
  else
    match operator with
    | Add -> Some (sum (bl, bh))
    | Subtract -> Some (sum (-.bh, -.bl))
    | Multiply ->
        let vanishing =
          (has_zero al ah && has_infinity bl bh) || (has_infinity al ah && has_zero bl bh)
        in
        (* Uses 0 for a corner 0 * inf, because the product of 0 and any finite number is 0. *)
        let times x y = if x = 0. || y = 0. then 0. else x *. y in
        Some (floats real ~nan:(nan || vanishing) (corners times (al, ah) (bl, bh)))
    | Divide when bl > 0. || bh < 0. ->
        let nan = nan || (has_infinity al ah && has_infinity bl bh) in
        (* x / inf is 0 for all finite x. *)
        let inside = if has_infinity bl bh then [ 0. ] else [] in
        Some (floats real ~nan (inside @ corners ( /. ) (al, ah) (bl, bh)))
    | Minimum -> Some (floats real ~nan [ Float.min al bl; Float.min ah bh ])
    | Maximum -> Some (floats real ~nan [ Float.max al bl; Float.max ah bh ])
    | Less -> Some (Bools { true_ = al < bh; false_ = ah >= bl || nan })
    | Less_equal -> Some (Bools { true_ = al <= bh; false_ = ah > bl || nan })
    | Equal ->
        let true_ = al <= bh && bl <= ah in
        Some (Bools { true_; false_ = nan || not (al = ah && bl = bh && al = bl) })
    | _ -> None

let on_ints (operator : Ir.operator) (al, ah) (bl, bh) : t option =
  match operator with
  | Add -> Some (ints (al + bl) (ah + bh))
  | Subtract -> Some (ints (al - bh) (ah - bl))
  | Multiply ->
      let all = corners ( * ) (al, ah) (bl, bh) in
      Some (ints (List.fold_left min max_int all) (List.fold_left max min_int all))
  | Minimum -> Some (Ints { least = min al bl; most = min ah bh })
  | Maximum -> Some (Ints { least = max al bl; most = max ah bh })
  | Less -> Some (Bools { true_ = al < bh; false_ = ah >= bl })
  | Less_equal -> Some (Bools { true_ = al <= bh; false_ = ah > bl })
  | Equal ->
      Some (Bools { true_ = al <= bh && bl <= ah; false_ = not (al = ah && bl = bh && al = bl) })
  | _ -> None

let is_zero least most = least = 0. && most = 0.

let on_ranges real (operator : Ir.operator) arguments =
  match (operator, arguments) with
  | Elementary Hypot, [ Floats a; Floats b ] ->
      let most = if is_zero a.least a.most && is_zero b.least b.most then 0. else infinity in
      Some (Floats { least = 0.; most; nan = a.nan || b.nan })
  | Elementary Sqrt, [ Floats a ] when a.least <= a.most && a.most >= 0. ->
      Some
        (floats real
           ~nan:(a.nan || a.least < 0.)
           [ Float.sqrt (Float.max 0. a.least); Float.sqrt a.most ])
  | Elementary Floor_float, [ Floats a ] when a.least <= a.most ->
      Some (Floats { a with least = Float.floor a.least; most = Float.floor a.most })
  | Elementary Ceiling_float, [ Floats a ] when a.least <= a.most ->
      Some (Floats { a with least = Float.ceil a.least; most = Float.ceil a.most })
  | Elementary Nanoseconds, [ Floats a ] when a.least <= a.most ->
      let ns = Clock.nanoseconds real in
      Some (Floats { a with least = ns a.least; most = ns a.most })
  | And, [ Bools a; Bools b ] ->
      Some (Bools { true_ = a.true_ && b.true_; false_ = a.false_ || b.false_ })
  | Or, [ Bools a; Bools b ] ->
      Some (Bools { true_ = a.true_ || b.true_; false_ = a.false_ && b.false_ })
  | Equal, [ Bools a; Bools b ] ->
      Some
        (Bools
           {
             true_ = (a.true_ && b.true_) || (a.false_ && b.false_);
             false_ = (a.true_ && b.false_) || (a.false_ && b.true_);
           })
  | Not, [ Bools a ] -> Some (Bools { true_ = a.false_; false_ = a.true_ })
  | Negate, [ Floats a ] -> Some (Floats { a with least = -.a.most; most = -.a.least })
  | Absolute, [ Floats a ] when a.least <= a.most ->
      let most = Float.max (Float.abs a.least) (Float.abs a.most) in
      let least = if a.least > 0. then a.least else if a.most < 0. then -.a.most else 0. in
      Some (Floats { a with least; most })
  | To_float, [ Ints a ] ->
      Some (floats real ~nan:false [ float_of_int a.least; float_of_int a.most ])
  | _, [ Floats a; Floats b ] ->
      on_floats real operator (a.least, a.most, a.nan) (b.least, b.most, b.nan)
  | _, [ Ints a; Ints b ] -> on_ints operator (a.least, a.most) (b.least, b.most)
  | _, _ -> None

let operation real operator arguments ty =
  let constants = List.filter_map constant arguments in
  let folded =
    if List.compare_lengths constants arguments = 0 then
      Option.bind (Fold.operation real operator constants) of_constant
    else None
  in
  match folded with
  | Some known -> known
  | None -> (
      match on_ranges real operator arguments with
      | Some known -> known
      | None -> anything_but_sums ty)
