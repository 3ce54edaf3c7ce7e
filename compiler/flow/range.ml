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
  | Sum _ | Array _ | Foreign _ -> bug "an operation gives what is no number"

let float x =
  if Float.is_nan x then Floats { least = infinity; most = neg_infinity; nan = true }
  else Floats { least = x; most = x; nan = false }

let of_constant : Ir.atom -> t option = function
  | Bool b -> Some (Bools { true_ = b; false_ = not b })
  | Int n -> Some (Ints { least = Int32.to_int n; most = Int32.to_int n })
  | Float x -> Some (float x)
  | Signal _ -> None

let zero = float 0.
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
        {
          least = Float.min a.least b.least;
          most = Float.max a.most b.most;
          nan = a.nan || b.nan;
        }
  | Constructors a, Constructors b -> Constructors (union join a b)
  | (Bools _ | Ints _ | Floats _ | Constructors _), _ -> bug "values of different types"

let rec widen a b =
  match (a, b) with
  | Constructors a, Constructors b -> Constructors (union widen a b)
  | _ -> widened a (join a b)

and widened a joined =
  match (a, joined) with
  | Ints a, Ints j ->
      Ints
        {
          least = (if j.least < a.least then least_int else a.least);
          most = (if j.most > a.most then most_int else a.most);
        }
  | Floats a, Floats j ->
      Floats
        {
          least = (if j.least < a.least then neg_infinity else a.least);
          most = (if j.most > a.most then infinity else a.most);
          nan = j.nan;
        }
  | _, joined -> joined

let may_be_true = function Bools b -> b.true_ | _ -> bug "a condition that is no Bool"
let may_be_false = function Bools b -> b.false_ | _ -> bug "a condition that is no Bool"

let has_constructor t k =
  match t with
  | Constructors ks ->
      Bools { true_ = List.mem_assoc k ks; false_ = List.exists (fun (other, _) -> other <> k) ks }
  | Bools _ | Ints _ | Floats _ -> bug "a constructor of what is no sum"

let payload t k leaf =
  match t with
  | Constructors [ (only, Some leaves) ] when only = k -> List.nth_opt leaves leaf
  | Constructors _ -> None
  | Bools _ | Ints _ | Floats _ -> bug "the payload of what is no sum"

(* The number that a range is alone. Zeros have a sign, which a range forgets. *)
let constant : t -> Ir.atom option = function
  | Bools { true_ = true; false_ = false } -> Some (Bool true)
  | Bools { true_ = false; false_ = true } -> Some (Bool false)
  | Ints { least; most } when least = most -> Some (Int (Int32.of_int least))
  | Floats { least; most; nan = false } when least = most && least <> 0. -> Some (Float least)
  | Bools _ | Ints _ | Floats _ | Constructors _ -> None

let ints least most =
  if least < least_int || most > most_int then any_int else Ints { least; most }

(* A bound that came out as NaN bounds nothing. *)
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

(* Rounding keeps the order of numbers, so bounds of results are results of bounds. Of
   numbers, NaN comes by inf - inf, 0 * inf and inf / inf (0 / 0 is left out here),
   wherever in the ranges they are. *)
let on_floats real (operator : Ir.operator) (al, ah, a_nan) (bl, bh, b_nan) : t option =
  let nan = a_nan || b_nan in
  let sum (bl, bh) =
    let opposed = (ah = infinity && bl = neg_infinity) || (al = neg_infinity && bh = infinity) in
    let bounds = [ al +. bl; ah +. bh ] in
    if List.exists Float.is_nan bounds then any_float
    else floats real ~nan:(nan || opposed) bounds
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
        (* 0 * inf at a corner is next to 0 * x, which is 0. *)
        let times x y = if x = 0. || y = 0. then 0. else x *. y in
        Some (floats real ~nan:(nan || vanishing) (corners times (al, ah) (bl, bh)))
    | Divide when bl > 0. || bh < 0. ->
        let nan = nan || (has_infinity al ah && has_infinity bl bh) in
        (* x / inf is 0 for all x but the corners. *)
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

let on_ranges real (operator : Ir.operator) arguments =
  match (operator, arguments) with
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
      let least =
        if a.least > 0. then a.least else if a.most < 0. then -.a.most else 0.
      in
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
