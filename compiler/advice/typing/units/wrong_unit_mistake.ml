open Basis
open Typing
open Diagnostic

let is_one u = Units.equal u Units.one
let is_open (wanted, given) = Units.is_open wanted || Units.is_open given

(* {1 Superfluous factors} *)

let superfluous_factor words ~subject ~(expected : Expected.t) (wanted, given) =
  let is_conversion excess power (e : Resolve.Ir.expr) =
    match e.desc with
    | Number { digits; unit_ = Some u; _ } when float_of_string_opt digits = Some 1. -> (
        match (Wording.unit_written words u, Wording.quote words e.span) with
        | Some unit_, Some text ->
            (* `1[km]` does not count, because removing it would also change the number *)
            String.ends_with ~suffix:(Printf.sprintf "[%s]" (Wording.measure words unit_)) text
            && Units.equal (Units.power unit_ (Rational.of_int power)) excess
        | _ -> false)
    | _ -> false
  in
  (* the product with the factor, the factor, its operator and the rest of the product *)
  let rec find excess (e : Resolve.Ir.expr) =
    match Formula.binary e with
    | Some ("*", a, b) when is_conversion excess 1 b -> Some (e, "* ", b, a)
    | Some ("*", a, b) when is_conversion excess 1 a -> Some (e, "", a, b)
    | Some ("/", a, b) when is_conversion excess (-1) b -> Some (e, "/ ", b, a)
    | Some (("*" | "/"), a, _) -> find excess a
    | _ -> None
  in
  let of_side (e, (wanted, given)) =
    let is_signature =
      match expected.because with Signature _ | Output (Signature _) -> true | _ -> false
    in
    if is_one wanted && is_signature then None
    else
      match find (Units.divide given wanted) (Bare_number.value words e) with
      | Some (whole, operator, factor, rest) -> (
          match (Wording.quote words factor.span, Formula.text words rest) with
          | Some factor, Some text ->
              let is_multiplied = String.equal operator "" in
              Some
                (fun d ->
                  hint "remove `%s%s%s`: `%s` is already %s" operator factor
                    (if is_multiplied then " *" else "")
                    text
                    (if is_one wanted then "a plain number"
                     else Printf.sprintf "in `%s`" (Wording.measure words wanted))
                    d
                  |> fix (Printf.sprintf "write `%s`" text) [ (whole.span, text) ])
          | _ -> None)
      | None -> None
  in
  if is_open (wanted, given) then None
  else List.find_map of_side (Lacking_unit_mistake.sides words ~subject ~expected (wanted, given))

let superfluous_function words ~subject ~(expected : Expected.t) (wanted, given) =
  let of_side (e, (wanted, _)) =
    let e : Resolve.Ir.expr = Bare_number.value words e in
    match e.desc with
    | Apply
        {
          head = { desc = Global { name = ("integral" | "derivative") as name; _ }; _ };
          argument;
          style = Juxtaposed;
        } -> (
        match (Formula.unit_of words argument, Formula.text words argument) with
        | Some u, Some text when Units.equal u wanted ->
            Some
              (fun d ->
                hint "remove `%s`: `%s` is already in `%s`" name text (Wording.measure words wanted)
                  d
                |> fix (Printf.sprintf "write `%s`" text) [ (e.span, Source.grouped text) ])
        | _ -> None)
    | _ -> None
  in
  if is_open (wanted, given) || is_one wanted then None
  else List.find_map of_side (Lacking_unit_mistake.sides words ~subject ~expected (wanted, given))

(* {1 Gains and constants} *)

(* The text of the unit in a literal. If a gain was written with [rad], the text also contains
   [rad]. *)
let unit_like words (number : Bare_number.t) u =
  let measure = Wording.measure words u in
  let is_angle ((f : Resolve.Ir.unit_factor), _) =
    match f with Declared { name = "rad"; _ } -> true | Declared _ | Unit_variable _ -> false
  in
  let has_angle =
    match number.unit_ with Some { factors; _ } -> List.exists is_angle factors | None -> false
  in
  let n = String.length measure in
  if has_angle && String.starts_with ~prefix:"1/" measure then "rad" ^ String.sub measure 1 (n - 1)
  else measure

(* The number with this unit, and the edits that write it. *)
let with_unit words (number : Bare_number.t) u =
  let unit_ = unit_like words number u in
  let literal = if is_one u then number.digits else Printf.sprintf "%s[%s]" number.digits unit_ in
  let text = if number.negative then "-" ^ literal else literal in
  let type_ = if is_one u then "Float" else Printf.sprintf "Float[%s]" unit_ in
  let of_signature =
    match number.signature with
    | Some place when Wording.quote words place <> None -> [ (place, type_) ]
    | Some _ | None -> []
  in
  let shown =
    match number.name with
    | None -> Printf.sprintf "`%s`" text
    | Some name when of_signature = [] -> Printf.sprintf "`%s = %s`" name text
    | Some name -> Printf.sprintf "`%s :: %s` and `%s = %s`" name type_ name text
  in
  (shown, of_signature @ [ (number.at, literal) ])

let label_number (number : Bare_number.t) d =
  match number.name with
  | Some name -> label ~at:number.at "`%s` is defined as this number" name d
  | None -> d

let rec mentions names (e : Resolve.Ir.expr) =
  match e.desc with
  | Global { name; _ } -> List.mem name names
  | Apply { head; argument; _ } -> mentions names head || mentions names argument
  | Negate e -> mentions names e
  | _ -> false

let gain words ~subject ~(expected : Expected.t) (wanted, given) =
  let of_side (e, (wanted, given)) =
    match Bare_number.gain words e with
    | [ ((number : Bare_number.t), power) ] when Bare_number.literal words e = None -> (
        match Option.bind number.unit_ (Wording.unit_written words) with
        | Some own ->
            let needed = Lacking_unit_mistake.needed (wanted, given) power in
            let unit_ = Units.multiply own needed in
            let what =
              match (number.name, Wording.quote words number.at) with
              | Some name, _ | None, Some name -> name
              | None, None -> number.digits
            in
            let shown, edits = with_unit words number unit_ in
            let of_a_rate = mentions [ "derivative"; "integral" ] (Bare_number.value words e) in
            if not (Lacking_unit_mistake.is_unit_of_a_gain unit_ || (of_a_rate && is_one unit_))
            then None
            else
              Some
                ( Bare_number.value words e,
                  fun d ->
                    label_number number d
                    |> hint "if the gain `%s` should have %s unit, write %s" what
                         (if is_one unit_ then "no" else "a different")
                         shown
                    |> fix (Printf.sprintf "write %s" shown) edits )
        | None -> None)
    | _ -> None
  in
  let sides =
    match expected.because with
    | Operand { operator = "+" | "-"; _ } ->
        Lacking_unit_mistake.sides words ~subject ~expected (wanted, given)
    | Operand _ -> []
    | _ -> Option.to_list (Option.map (fun e -> (e, (wanted, given))) subject)
  in
  if is_open (wanted, given) || is_one wanted || is_one given then None
  else
    let found = List.filter_map of_side sides in
    let is_of_a_rate (e, _) = mentions [ "derivative"; "integral" ] e in
    match (List.find_opt is_of_a_rate found, found) with
    | Some (_, complete), _ | None, (_, complete) :: _ -> Some complete
    | None, [] -> None

let is_angular_velocity (t : Type.t) =
  match Type.repr t with Alias { alias = { name = "AngularVelocity"; _ }; _ } -> true | _ -> false

let constant words ~subject ~(expected : Expected.t) (wanted, given) =
  let is_operand = Unit_conversion.is_operand expected in
  let of_side ((e : Resolve.Ir.expr), (wanted, given)) =
    match (e.desc, Bare_number.literal words e) with
    | (Local _ | Global _), Some ({ unit_ = Some _; name = Some _; signature = None; _ } as number)
      ->
        let _, edits = with_unit words number wanted in
        let text =
          if is_one wanted then number.digits
          else if is_angular_velocity expected.ty then number.digits ^ "[rad/s]"
          else Printf.sprintf "%s[%s]" number.digits (Wording.measure words wanted)
        in
        let edits = List.map (fun (at, _) -> (at, text)) edits in
        let shown = if number.negative then "-" ^ text else text in
        Some
          (fun d ->
            let others =
              if is_operand then []
              else (Unit_conversion.suggest words ~subject ~expected (wanted, given) d).hints
            in
            let d =
              label_number number d
              |> hint "%s"
                   (if is_one wanted then
                      Printf.sprintf "write `%s`, without a unit, if it is a plain number" shown
                    else Printf.sprintf "write `%s` if that is the right unit" shown)
              |> fix (Printf.sprintf "write `%s`" shown) edits
            in
            { d with hints = d.hints @ others })
    | _ -> None
  in
  let between_rate_and_time =
    List.for_all
      (fun u -> List.mem (Wording.measure words u) [ "s"; "1/s"; "Hz" ])
      [ wanted; given ]
  in
  if is_open (wanted, given) || is_one given || between_rate_and_time then None
  else List.find_map of_side (Lacking_unit_mistake.sides words ~subject ~expected (wanted, given))

(* {1 Parameters} *)

let rec nth_parameter n (t : Resolve.Ir.ty) =
  match t.desc with
  | Function (parameter, _) when n = 0 -> Some parameter
  | Function (_, result) -> nth_parameter (n - 1) result
  | _ -> None

type declared = { type_ : Resolve.Ir.ty; with_type : string -> string }

(* The declared type of a parameter of a top-level function, and a function that replaces this type
   in the signature. *)
let declared_parameter words (x : Resolve.Ir.Local.t) =
  match Wording.parameter words x with
  | Some ({ signature = Some signature; name; _ }, index) -> (
      match (nth_parameter index signature.ty, Wording.quote words signature.span) with
      | Some ({ desc = Named _; span } as type_), Some whole
        when Span.line span.start = Span.line signature.span.start ->
          let from = Span.column span.start - Span.column signature.span.start in
          let until = Span.column span.stop - Span.column signature.span.start in
          let name =
            match name with
            | Top (g, _) -> g.name ^ " :: "
            | Inner f -> f.name ^ " :: "
            | Destructure _ -> ""
          in
          let with_type text =
            let rest = String.sub whole until (String.length whole - until) in
            name ^ Source.with_opening (String.sub whole 0 from ^ text ^ rest)
          in
          Some { type_; with_type }
      | _ -> None)
  | Some _ | None -> None

(* `k * e`, where the signature declares `k` without a unit *)
let bare_parameter words ~subject ~(expected : Expected.t) (wanted, given) =
  let of_factor ((e : Resolve.Ir.expr), power) =
    match e.desc with
    | Local x when abs power = 1 -> (
        match declared_parameter words x with
        | Some
            ({ type_ = { desc = Named { tycon = { name = "Float"; _ }; units = []; _ }; _ }; _ } as
             d) ->
            Some (x, d, power)
        | Some _ | None -> None)
    | _ -> None
  in
  let of_side ((e : Resolve.Ir.expr), units) =
    let factors = Formula.factors e in
    match List.filter_map of_factor factors with
    | (x, { type_; with_type }, power) :: _ when List.length factors > 1 ->
        let unit_ = Wording.measure words (Lacking_unit_mistake.needed units power) in
        let text = Printf.sprintf "Float[%s]" unit_ in
        Some
          (fun d ->
            label ~at:type_.span "the signature gives `%s` no unit" x.name d
            |> hint "if `%s` has a unit, write the signature as `%s`" x.name (with_type text)
            |> write type_.span text)
    | _ -> None
  in
  if is_open (wanted, given) || is_one wanted then None
  else List.find_map of_side (Lacking_unit_mistake.sides words ~subject ~expected (wanted, given))

let parameter words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t) units =
  match (subject, expected.because) with
  | Some { desc = Local x; _ }, Parameter { callee = Some _; decided_by = []; _ }
    when not (is_open units) -> (
      match declared_parameter words x with
      | Some { type_ = { span; _ }; with_type } ->
          let type_ = Wording.type_ words expected.ty in
          Some
            (fun d ->
              let others = (Unit_conversion.suggest words ~subject ~expected units d).hints in
              let d =
                label ~at:span "the signature gives `%s` this type" x.name d
                |> hint "if `%s` is of type `%s`, write the signature as `%s`" x.name type_
                     (with_type type_)
                |> write span type_
              in
              { d with hints = d.hints @ others })
      | None -> None)
  | _ -> None
