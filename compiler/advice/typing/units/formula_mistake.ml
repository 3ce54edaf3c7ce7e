open Basis
open Typing
open Diagnostic

let closed (wanted, given) = not (Units.is_open wanted || Units.is_open given)

let is_of_square words ~subject (wanted, given) =
  closed (wanted, given)
  && Units.equal (Units.multiply wanted wanted) given
  && (not (Units.equal given Units.one))
  && Option.fold subject ~none:false ~some:(Formula.is_square words)

(* Adds the fix that replaces the expression [e] with [text] in parentheses. *)
let replace (e : Resolve.Ir.expr) text =
  fix (Printf.sprintf "write `%s`" text) [ (e.span, "(" ^ text ^ ")") ]

let sqrt_of words (e : Resolve.Ir.expr) d =
  match Formula.grouped words e with
  | Some text ->
      let fixed = "sqrt " ^ text in
      hint "for the square root, write `%s`" fixed d |> replace e fixed
  | None -> hint "for the square root, write `sqrt (…)` around the expression" d

(* The exponent, from 2 to 4, that turns the second unit into the first one. *)
let exponent u v =
  let is_it k =
    match Units.power v (Rational.of_int k) with
    | power -> Units.equal u power
    | exception Rational.Out_of_range -> false
  in
  List.find_opt is_it [ 2; 3; 4 ]

let compared words ~operator ~(higher : Resolve.Ir.expr) ~(lower : Resolve.Ir.expr) k d =
  let raised =
    match Formula.grouped words lower with
    | Some text ->
        let fixed = Printf.sprintf "%s ^ %d" text k in
        fun d ->
          hint "to use the %s, write `%s`"
            (match k with 2 -> "square" | 3 -> "cube" | _ -> "fourth power")
            fixed d
          |> replace lower fixed
    | None -> Fun.id
  in
  (* in a sum of squares, the missing root is usually that of the whole sum *)
  let is_sum = List.mem operator [ "+"; "-" ] in
  (if k = 2 && not is_sum then sqrt_of words higher d else d) |> raised

(* Is this a power with this exponent, a product of that many equal factors, or a sum of such
   powers? *)
let rec is_power words k (e : Resolve.Ir.expr) =
  let e = Bare_number.value words e in
  match (e.desc, Formula.binary e) with
  | Power { exponent; _ }, _ -> exponent = k
  | _, Some (("+" | "-"), a, b) -> is_power words k a && is_power words k b
  | _, Some ("*", _, _) -> (
      match List.map (fun (e, power) -> (Formula.text words e, power)) (Formula.factors e) with
      | ((Some _, 1) as first) :: rest ->
          List.compare_length_with rest (k - 1) = 0 && List.for_all (( = ) first) rest
      | _ -> false)
  | _ -> false

let root words ~subject ~(expected : Expected.t) (wanted, given) =
  let is_one u = Units.equal u Units.one in
  if (not (closed (wanted, given))) || is_one wanted || is_one given then None
  else
    let fits k e = if k = 2 then Formula.is_square words e else is_power words k e in
    match (expected.because, subject) with
    | ( Operand
          { other; operator = ("+" | "-" | "<" | "<=" | ">" | ">=" | "==" | "/=") as operator; _ },
        Some e ) -> (
        match (exponent wanted given, exponent given wanted) with
        | Some k, _ when fits k other -> Some (compared words ~operator ~higher:other ~lower:e k)
        | _, Some k when fits k e -> Some (compared words ~operator ~higher:e ~lower:other k)
        | _ -> None)
    | Operand _, _ -> None
    | _, Some e when is_of_square words ~subject (wanted, given) -> Some (sqrt_of words e)
    | _ -> None

(* {1 A missing factor} *)

let is_rate words u = List.mem (Wording.measure words u) [ "s"; "1/s"; "Hz" ]

(* Does the expected unit of the field come from another field, which may itself be wrong? The
   fields of a vector have the same unit. *)
let depends_on_another_field (expected : Expected.t) =
  match expected.because with
  | Field { constructor = Some _; _ } | Field { name = "x" | "y" | "z"; _ } -> true
  | _ -> false

let power words ~subject ~expected units =
  let of_side ((e : Resolve.Ir.expr), (wanted, given)) =
    let formula = Bare_number.value words e in
    let missing = Units.divide wanted given in
    let inverse = Units.divide given wanted in
    let named = function
      | ( (({ desc = Local _ | Global _ | Apply { style = Juxtaposed; _ }; _ } : Resolve.Ir.expr) as
           e),
          n )
        when Bare_number.literal words e = None ->
          Some (e, n)
      | _ -> None
    in
    let variables = List.filter_map named (Formula.factors formula) in
    let lacks (e, n) =
      match Formula.unit_of words e with
      | Some u -> Units.equal u (if n > 0 then missing else inverse)
      | None -> false
    in
    let is_alone = match variables with [ _ ] -> true | _ -> false in
    let is_formula =
      match formula.desc with Apply { style = Operator _; _ } -> true | _ -> false
    in
    let is_one u = Units.equal u Units.one in
    if
      is_one missing || is_one wanted || is_one given || (not is_formula)
      || (is_alone && is_rate words missing)
    then None
    else
      match List.filter lacks variables with
      | (x, _) :: _ -> (
          match (Formula.text words x, Formula.grouped words x) with
          | Some name, Some grouped ->
              Option.map
                (fun text d ->
                  hint
                    "the missing factor `%s` is the unit of `%s`: write `%s` if you meant its \
                     square"
                    (Wording.measure words missing) name text d
                  |> write x.span (grouped ^ " ^ 2"))
                (Formula.with_part words formula ~part:x.span (grouped ^ " ^ 2"))
          | _ -> None)
      | [] -> None
  in
  if depends_on_another_field expected || not (closed units) then None
  else List.find_map of_side (Lacking_unit_mistake.sides words ~subject ~expected units)

(* `Vec2 { x = d ^ 2 * cos a, y = d * sin a }`, where one field has an extra power *)
let of_fields words ~subject (wanted, given) =
  let lower ((name : Syntax.Ir.name), (e : Resolve.Ir.expr)) =
    let is_square ((e : Resolve.Ir.expr), power) =
      match e.desc with Power { base; exponent = 2 } when power = 1 -> Some (e, base) | _ -> None
    in
    match (Formula.unit_of words e, List.find_map is_square (Formula.factors e)) with
    | Some u, Some (square, base) when Units.equal u given ->
        Option.bind (Formula.grouped words base) (fun base ->
            Option.map
              (fun text d ->
                label ~at:e.span "the field `%s` is in `%s`" name.text (Wording.measure words given)
                  d
                |> hint "for a field in `%s`, write `%s`" (Wording.measure words wanted) text
                |> write square.span base)
              (Formula.with_part words e ~part:square.span base))
    | _ -> None
  in
  match Option.map (Bare_number.value words) subject with
  | Some { desc = Record { fields; _ }; _ }
    when closed (wanted, given) && Units.equal (Units.multiply wanted wanted) given ->
      List.find_map lower fields
  | _ -> None

(* The text of the expression as a factor of a product. A product needs no parentheses. *)
let as_a_factor words (e : Resolve.Ir.expr) =
  match Formula.binary e with
  | Some ("*", _, _) -> Formula.text words e
  | _ -> Formula.as_factor words e

(* `sqrt x`, where `x` lacks a factor with a unit *)
let within_root words ~subject (wanted, given) =
  match subject with
  | Some
      ({
         desc =
           Apply { head = { desc = Global { name = "sqrt"; _ }; _ }; argument; style = Juxtaposed };
         _;
       } :
        Resolve.Ir.expr)
    when closed (wanted, given) ->
      let missing = Units.power (Units.divide wanted given) (Rational.of_int 2) in
      let is_whole (_, power) = Rational.is_integer power in
      (* [sqrt d] for a distance, where a sum of squares was probably meant *)
      let is_same = Units.equal missing wanted in
      let is_decimal ((e : Resolve.Ir.expr), _) =
        match e.desc with
        | Number { digits; unit_ = None; _ } -> String.contains digits '.'
        | _ -> false
      in
      if is_same then
        match Formula.binary argument with
        | Some ("+", a, b) -> (
            let base (e : Resolve.Ir.expr) =
              match e.desc with Field _ -> Formula.text words e | _ -> Formula.grouped words e
            in
            match (base a, base b) with
            | Some a, Some b ->
                let text = Printf.sprintf "sqrt (%s ^ 2 + %s ^ 2)" a b in
                Some (hint "for the root of a sum of squares, write `%s`" text)
            | _ -> None)
        | _ -> None
      else if
        List.exists is_decimal (Formula.factors argument)
        || not (List.for_all is_whole (Units.base_powers missing))
      then None
      else
        let unit_ = Wording.measure words missing in
        Option.map
          (fun inside ->
            hint "multiply by a factor in `%s`%s inside the root, as in `sqrt (1[%s] * %s)`" unit_
              (if unit_ = "m/s^2" then ", an acceleration," else "")
              unit_ inside)
          (as_a_factor words argument)
  | _ -> None

(* `round x`, which keeps the unit of `x` *)
let rounded words ~subject (wanted, given) =
  match subject with
  | Some
      ({
         desc =
           Apply
             {
               head =
                 {
                   desc = Global { name = ("round" | "floor" | "ceiling" | "truncate") as name; _ };
                   _;
                 };
               argument;
               style = Juxtaposed;
             };
         span;
       } :
        Resolve.Ir.expr)
    when closed (wanted, given) && Units.equal wanted Units.one ->
      Option.map
        (fun inside d ->
          let text = Printf.sprintf "%s (%s / 1[%s])" name inside (Wording.measure words given) in
          hint "divide by the unit before rounding: `%s`" text d |> write span ("(" ^ text ^ ")"))
        (as_a_factor words argument)
  | _ -> None

(* `0.5[rad/s]` where an angle is expected *)
let rate_for_angle words ~subject (wanted, given) =
  let is_angle ((f : Resolve.Ir.unit_factor), _) =
    match f with
    | Declared { name = "rad" | "deg"; _ } -> true
    | Declared _ | Unit_variable _ -> false
  in
  match subject with
  | Some ({ desc = Number { digits; unit_ = Some { factors; _ }; _ }; span } : Resolve.Ir.expr)
    when Units.equal wanted Units.one && String.equal (Wording.measure words given) "1/s" -> (
      match List.find_opt is_angle factors with
      | Some (Declared { name; _ }, _) ->
          let text = Printf.sprintf "%s[%s]" digits name in
          Some
            (fun d ->
              hint "this is a turn rate: for an angle, write `%s`" text d |> write span text)
      | Some (Unit_variable _, _) | None -> None)
  | _ -> None

(* The gain `kd` in `kp * e + kd * derivative e`, which is declared with the unit of another gain *)
let gain_of_rate words ~subject ~(expected : Expected.t) (wanted, given) =
  let has_derivative factors =
    let is_it ((e : Resolve.Ir.expr), _) =
      match e.desc with
      | Apply { head = { desc = Global { name = "derivative"; _ }; _ }; _ } -> true
      | _ -> false
    in
    List.exists is_it factors
  in
  let of_side e (wanted, given) =
    let factors = Formula.factors e in
    let gain ((e : Resolve.Ir.expr), power) =
      match (e.desc, Formula.unit_of words e) with
      | Local x, Some u when power = 1 && not (Units.equal u Units.one) ->
          Some (x.name, Units.multiply u (Units.divide wanted given))
      | _ -> None
    in
    if not (has_derivative factors) then None
    else
      Option.map
        (fun (name, u) ->
          hint
            "the gain of a rate of change needs a different unit: in the signature, write \
             `Float[%s]` as the type of `%s`"
            (Wording.measure words u) name)
        (List.find_map gain factors)
  in
  match (expected.because, subject) with
  | Operand { operator = "+" | "-"; other; _ }, Some e when closed (wanted, given) -> (
      match of_side e (wanted, given) with
      | Some advice -> Some advice
      | None -> of_side other (given, wanted))
  | _ -> None

(* `radius / speed` where the unit of `speed / radius` is expected *)
let upside_down words ~subject (wanted, given) =
  let is_inverse u v = Units.equal (Units.multiply u v) Units.one in
  match Option.bind subject Formula.binary with
  | Some ("/", a, b)
    when closed (wanted, given)
         && is_inverse wanted given
         && (not (Units.equal wanted Units.one))
         && Bare_number.literal words a = None -> (
      match (Formula.as_factor words a, Formula.as_factor words b) with
      | Some a, Some b ->
          let quotient = Printf.sprintf "%s / %s" b a in
          let whole = (Option.get subject).span in
          Some
            (fun d ->
              hint "swap the operands to get the unit `%s`: write `%s`"
                (Wording.measure words wanted) quotient d
              |> write whole quotient)
      | _ -> None)
  | _ -> None

(* {1 A quantity and its rate} *)

let rate words ~subject ~(expected : Expected.t) (wanted, given) =
  let per_second u v = List.mem (Wording.measure words (Units.divide u v)) [ "s" ] in
  let is_bare (e : Resolve.Ir.expr) =
    Bare_number.literal words e <> None || Bare_number.written_factor words e <> []
  in
  (* `kd * derivative e` is intentionally a rate. *)
  let is_differentiated e =
    let is_it ((e : Resolve.Ir.expr), _) =
      match e.desc with
      | Apply { head = { desc = Global { name = "derivative"; _ }; _ }; _ } -> true
      | _ -> false
    in
    List.exists is_it (Formula.factors e)
  in
  match (expected.because, subject) with
  | Operand { operator = ("+" | "-") as operator; other; _ }, Some e
    when closed (wanted, given)
         && not (is_bare other || is_bare e || is_differentiated e || is_differentiated other) -> (
      let rate_is_second = per_second wanted given in
      let quantity, rate = if rate_is_second then (wanted, e) else (given, other) in
      let is_it = rate_is_second || per_second given wanted in
      let duration = String.equal (Wording.measure words quantity) "s" in
      let time =
        let is_time (_, t) =
          match Type.expand t with
          | Type.Number (_, u) -> String.equal (Wording.measure words u) "s"
          | _ -> false
        in
        match List.find_opt is_time (Wording.inputs words) with
        | Some (name, _) -> name
        | None -> "0.5[s]"
      in
      match (Formula.as_factor words rate, Formula.grouped words rate) with
      | Some factor, Some argument when is_it && not duration ->
          let sum change =
            match (Formula.text words other, Formula.text words e) with
            | Some a, Some _ when rate_is_second -> Printf.sprintf "%s %s %s" a operator change
            | _, Some b -> Printf.sprintf "%s %s %s" change operator b
            | _ -> change
          in
          let times = Printf.sprintf "%s * %s" factor time in
          let integral = "integral " ^ argument in
          let in_a_proc = Wording.inputs words <> [] in
          Some
            (fun d ->
              hint "`%s` is a rate of change: multiply it by a time, as in `%s`%s"
                (Option.value (Formula.text words rate) ~default:"it")
                (sum times)
                (if in_a_proc then
                   Printf.sprintf ", or, for its sum over time, write `%s`" (sum integral)
                 else "")
                d
              |> fix (Printf.sprintf "write `%s`" times) [ (rate.span, times) ]
              |>
              if in_a_proc then fix (Printf.sprintf "write `%s`" integral) [ (rate.span, integral) ]
              else Fun.id)
      | _ -> None)
  | _ -> None
