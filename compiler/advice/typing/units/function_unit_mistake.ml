open Basis
open Typing
open Diagnostic

let text words (e : Resolve.Ir.expr) = Wording.quote words e.span
let grouped words e = Option.map Source.grouped (text words e)

(* Is the value the same at every instant? Equations may be recursive, so the function keeps track
   of the names that it has already visited. *)
let is_fixed words e =
  let rec go followed (e : Resolve.Ir.expr) =
    match e.desc with
    | Number _ | Global _ -> true
    | Local x when List.mem x.id followed -> false
    | Local x -> Option.fold (Wording.definition words x) ~none:false ~some:(go (x.id :: followed))
    | Negate e -> go followed e
    | Power { base; _ } -> go followed base
    | Apply { head; argument; style = Operator _ } -> go followed head && go followed argument
    | _ -> false
  in
  go [] e

(* The source text as a factor of a product. *)
let as_factor words (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply
      {
        head = { desc = Apply { head = { desc = Global { name = "*" | "/"; _ }; _ }; _ }; _ };
        style = Operator _;
        _;
      } ->
      text words e
  | _ -> grouped words e

(* A rate used as an angle: [sin (2 * pi * freq)]. *)
let angle_of_a_rate words ~subject ~(expected : Expected.t) (_, given) =
  match (expected.because, subject) with
  | Parameter { callee = Some (("sin" | "cos" | "tan") as f); _ }, Some (e : Resolve.Ir.expr)
    when List.mem (Wording.measure words given) [ "1/s"; "Hz" ] ->
      let angle =
        if is_fixed words e then Option.map (Printf.sprintf "%s * time ()") (as_factor words e)
        else Option.map (Printf.sprintf "integral %s") (grouped words e)
      in
      let with_fix angle d =
        hint "an angle is a rate times a time: in a `proc`, write `%s (%s)`" f angle d
        |> fix (Printf.sprintf "write `%s (%s)`" f angle) [ (e.span, "(" ^ angle ^ ")") ]
      in
      Option.map with_fix angle
  | _ -> None

let power words ~(expected : Expected.t) ?unit_ () =
  match expected.because with
  | Parameter { callee = Some "**"; position = 1; given = [ base; exponent ]; at; _ } -> (
      let value =
        match exponent.desc with
        | Number { digits; unit_ = None; _ } -> float_of_string_opt digits
        | _ -> None
      in
      match (grouped words base, value) with
      | Some base, Some k when Float.is_integer k && Float.abs k < 100. ->
          let k = Printf.sprintf "%.0f" k in
          Some
            (fun d ->
              hint "for a power with an integer exponent, write `%s ^ %s`" base k d
              |> fix (Printf.sprintf "write `%s ^ %s`" base k) [ (at, "^"); (exponent.span, k) ])
      | Some b, Some 0.5 ->
          let fixed = "sqrt " ^ b in
          Some
            (fun d ->
              hint "for a square root, write `%s`" fixed d
              |> fix
                   (Printf.sprintf "write `%s`" fixed)
                   [ (Span.merge base.span exponent.span, "(" ^ fixed ^ ")") ])
      | Some base, _ ->
          let plain unit_ =
            hint
              "the base of `**` must be a plain number: divide by the unit, `(%s / 1[%s])`, or, \
               for an integer exponent, write `%s ^ 2`"
              base unit_ base
          in
          Option.map plain unit_
      | None, _ -> None)
  | _ -> None

let is_angle (t : Type.t) =
  match Type.repr t with Alias { alias = { name = "Angle"; _ }; _ } -> true | _ -> false

let rec has_an_angle (e : Resolve.Ir.expr) =
  match e.desc with
  | Global { name = "pi"; _ } -> true
  | Number { unit_ = Some { factors = [ (Declared { name = "deg" | "rad"; _ }, _) ]; _ }; _ } ->
      true
  | Apply { head; argument; _ } -> has_an_angle head || has_an_angle argument
  | Negate e -> has_an_angle e
  | _ -> false

let whole_numbers words ~(expected : Expected.t) ~found =
  match expected.because with
  | Parameter { callee = Some (("mod" | "div") as f); given = [ a; b ]; _ } -> (
      match (f, grouped words a, grouped words b) with
      | "div", Some x, Some y ->
          Some
            (hint "`div` is for whole numbers: write `%s / %s`, or `floor (%s / %s)` for an `Int`" x
               y x y)
      | "mod", Some x, Some y when is_angle found || has_an_angle b ->
          Some
            (hint
               "`mod` is for whole numbers: for an angle between -pi and pi, write `wrapAngle %s`, \
                with `import Geometry`; for an angle that is never negative, write `%s - %s * \
                floorFloat (%s / %s)`"
               x x y x y)
      | "mod", Some x, Some y ->
          Some
            (hint
               "`mod` is for whole numbers: for the remainder, write `%s - %s * floorFloat (%s / \
                %s)`"
               x y x y)
      | _ -> None)
  | _ -> None

let quotient words ~(expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some "/"; position = 1; given = [ a; b ]; _ } -> (
      let is_decimal =
        match b.desc with Number { decimal; unit_; _ } -> decimal || unit_ <> None | _ -> false
      in
      match (grouped words a, grouped words b) with
      | Some x, Some y when is_decimal ->
          let fixed = Printf.sprintf "toFloat %s" x in
          Some
            (fun d ->
              hint "write `%s / %s`" fixed y d
              |> fix (Printf.sprintf "write `%s`" fixed) [ (a.span, "(" ^ fixed ^ ")") ])
      | Some x, Some y ->
          let fixed = Printf.sprintf "div %s %s" x y in
          (* A literal can be a Float, but a divisor with a name is probably an Int, too. *)
          let divisor = match b.desc with Number _ -> y | _ -> Printf.sprintf "toFloat %s" y in
          Some
            (fun d ->
              hint
                "for a whole number, write `%s`, which rounds down; for a number with a fraction, \
                 write `toFloat %s / %s`"
                fixed x divisor d
              |> fix
                   (Printf.sprintf "write `%s`" fixed)
                   [ (Span.merge a.span b.span, "(" ^ fixed ^ ")") ])
      | _ -> None)
  | _ -> None

let complete words ~subject ~expected (wanted, given) =
  match angle_of_a_rate words ~subject ~expected (wanted, given) with
  | Some complete -> Some complete
  | None -> power words ~expected ~unit_:(Wording.measure words given) ()
