(* Checks that the range of an operation's result contains the result for any arguments within
   their ranges. *)

open Flow

let floats =
  [|
    Float.nan;
    infinity;
    neg_infinity;
    0.;
    -0.;
    1.;
    -1.;
    0.5;
    1e308;
    -1e308;
    3e38;
    -3e38;
    5e-324;
    1e-45;
    -1e-30;
    7.;
    1e16;
  |]

let ints = [| 0l; 1l; -1l; 2l; 31l; 65536l; Int32.max_int; Int32.min_int; -7l |]

let member rng real : Ir.ty -> Ir.atom = function
  | Bool -> Bool (Random.State.bool rng)
  | Int -> Int ints.(Random.State.int rng (Array.length ints))
  | _ ->
      let x = floats.(Random.State.int rng (Array.length floats)) in
      Float (Basis.Real.round real x)

let range = function
  | [] -> Alcotest.fail "no members"
  | first :: others ->
      let of_atom atom = Option.get (Range.of_constant atom) in
      List.fold_left (fun r atom -> Range.join r (of_atom atom)) (of_atom first) others

(* Chooses the bounds, or numbers between them; NaN only if the range contains it. *)
let inside rng (r : Range.t) members : Ir.atom =
  let between a b = a +. ((b -. a) *. Random.State.float rng 1.) in
  match r with
  | Floats { least; most; nan = _ } when Random.State.bool rng && least <= most ->
      let x = between least most in
      let x = if Float.is_nan x then 0. else x in
      Float (Float.min most (Float.max least x))
  | Ints { least; most } when Random.State.bool rng ->
      Int (Int32.of_int (least + Random.State.full_int rng (most - least + 1)))
  | _ -> List.nth members (Random.State.int rng (List.length members))

let holds (r : Range.t) (atom : Ir.atom) =
  match (r, atom) with
  | Bools { true_; false_ }, Bool b -> if b then true_ else false_
  | Ints { least; most }, Int n -> least <= Int32.to_int n && Int32.to_int n <= most
  | Floats { nan; _ }, Float x when Float.is_nan x -> nan
  | Floats { least; most; _ }, Float x -> least <= x && x <= most
  | _ -> false

let shown : Ir.atom -> string = function
  | Bool b -> string_of_bool b
  | Int n -> Int32.to_string n
  | Float x -> Printf.sprintf "%h" x
  | Signal _ -> "signal"

let two (ty : Ir.ty) : Ir.ty list = [ ty; ty ]

let operators : (string * Ir.operator * Ir.ty list * Ir.ty) list =
  let of_numbers (ty : Ir.ty) : (string * Ir.operator * Ir.ty list * Ir.ty) list =
    [
      ("+", Add, two ty, ty);
      ("-", Subtract, two ty, ty);
      ("*", Multiply, two ty, ty);
      ("min", Minimum, two ty, ty);
      ("max", Maximum, two ty, ty);
      ("<", Less, two ty, Bool);
      ("<=", Less_equal, two ty, Bool);
      ("==", Equal, two ty, Bool);
      ("abs", Absolute, [ ty ], ty);
      ("negate", Negate, [ ty ], ty);
      ("signum", Signum, [ ty ], ty);
    ]
  in
  of_numbers Float @ of_numbers Int
  @ [
      ("/", Divide, two Float, Float);
      ("div", Div, two Int, Int);
      ("mod", Mod, two Int, Int);
      ("fromInt", To_float, [ Int ], Float);
      ("round", Round, [ Float ], Int);
      ("floor", Floor, [ Float ], Int);
      ("floorFloat", Elementary Floor_float, [ Float ], Float);
      ("ceilingFloat", Elementary Ceiling_float, [ Float ], Float);
      ("nanoseconds", Elementary Nanoseconds, [ Float ], Float);
      ("sqrt", Elementary Sqrt, [ Float ], Float);
      ("hypot", Elementary Hypot, two Float, Float);
      ("**", Pow, two Float, Float);
      ("&&", And, two Bool, Bool);
      ("||", Or, two Bool, Bool);
      ("not", Not, [ Bool ], Bool);
      ("==", Equal, two Bool, Bool);
    ]

let sound real rng (name, operator, arguments, result) () =
  for _ = 1 to 20_000 do
    let members =
      List.map
        (fun ty -> List.init (1 + Random.State.int rng 3) (fun _ -> member rng real ty))
        arguments
    in
    let ranges = List.map range members in
    let given = Range.operation real operator ranges result in
    let arguments =
      List.map2
        (fun r m ->
          match inside rng r m with
          | Float x when Float.is_finite x -> Ir.Float (Basis.Real.round real x)
          | atom -> atom)
        ranges members
    in
    match Fold.operation real operator arguments with
    | Some atom when not (holds given atom) ->
        Alcotest.failf "%s of %s gives %s" name
          (String.concat ", " (List.map shown arguments))
          (shown atom)
    | Some _ | None -> ()
  done

let cases real =
  let rng = Random.State.make [| 7 |] in
  List.map
    (fun ((name, _, arguments, _) as operator) ->
      let types =
        List.map (function (Ir.Float : Ir.ty) -> "Float" | Int -> "Int" | _ -> "Bool") arguments
      in
      Alcotest.test_case (String.concat " " (name :: types)) `Quick (sound real rng operator))
    operators

let () =
  Alcotest.run "ranges" [ ("double", cases Basis.Real.Double); ("single", cases Basis.Real.Single) ]
