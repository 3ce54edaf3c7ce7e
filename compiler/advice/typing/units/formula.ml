open Basis
open Typing

let binary (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply
      {
        head = { desc = Apply { head = { desc = Global { name; _ }; _ }; argument = a; _ }; _ };
        argument = b;
        style = Operator _;
      } ->
      Some (name, a, b)
  | _ -> None

let text words (e : Resolve.Ir.expr) = Wording.quote words e.span
let grouped words e = Option.map Source.grouped (text words e)

let as_factor words (e : Resolve.Ir.expr) =
  match (e.desc, binary e) with
  | Apply { style = Juxtaposed; _ }, _ | _, Some (("*" | "/"), _, _) -> text words e
  | _ -> grouped words e

let number t =
  match Type.expand t with
  | Type.Number (_, u) when not (Units.is_open u) -> Some (Units.resolve u)
  | _ -> None

let rec result t =
  match Type.expand t with
  | Type.Function (_, t) -> result t
  | Signal_function (_, t) -> number t
  | _ -> number t

let is_zero (e : Resolve.Ir.expr) =
  match e.desc with Number { digits; _ } -> float_of_string_opt digits = Some 0. | _ -> false

(* Solves for the variable in the parameter's unit, given the argument's unit. *)
let solution ~parameter ~argument =
  match Units.rigid_powers parameter with
  | [ (r, power) ] when not (Rational.is_zero power) ->
      let constant = Units.divide parameter (Units.power (Units.of_rigid r) power) in
      Some (r, Units.power (Units.divide argument constant) (Rational.inverse power))
  | _ -> None

let rec find words (e : Resolve.Ir.expr) =
  match e.desc with
  | Number { unit_ = None; _ } -> Some Units.one
  | Number { unit_ = Some u; _ } -> Wording.unit_written words u
  | Negate e -> find words e
  | Power { base; exponent } when abs exponent < 10 ->
      Option.map (fun u -> Units.power u (Rational.of_int exponent)) (find words base)
  | Local x -> Option.bind (Wording.local words x) number
  | Global g -> Option.bind (Wording.declared_type words g) number
  | Apply { style = Operator _; _ } -> (
      match binary e with
      | Some ((("*" | "/") as operator), a, b) -> (
          match (find words a, find words b) with
          | Some u, Some v ->
              Some (if String.equal operator "*" then Units.multiply u v else Units.divide u v)
          | _ -> None)
      | Some (("+" | "-"), a, _) -> find words a
      | _ -> None)
  | Field { record; field; _ } ->
      Option.bind (type_of_record words record) (fun ty ->
          Option.bind (Wording.field_type words ty field.text) number)
  | Apply { style = Juxtaposed; _ } -> applied words e
  | _ -> None

and type_of_record words (e : Resolve.Ir.expr) =
  match e.desc with
  | Local x -> Wording.local words x
  | Global g -> Wording.declared_type words g
  | Field { record; field; _ } ->
      Option.bind (type_of_record words record) (fun ty -> Wording.field_type words ty field.text)
  | _ -> None

(* The unit of an application, where the arguments determine the variables in the declared unit. *)
and applied words (e : Resolve.Ir.expr) =
  let head, arguments = Resolve.Walk.application e in
  let ty =
    match head.desc with
    | Global g -> Wording.declared_type words g
    | Local x -> Wording.local words x
    | _ -> None
  in
  match (ty, Option.bind ty result) with
  | Some ty, Some u ->
      let pairs = List.filteri (fun i _ -> i < List.length arguments) (Wording.parameters ty) in
      if List.compare_lengths pairs (Wording.parameters ty) <> 0 then None
      else
        let given = List.filteri (fun i _ -> i < List.length pairs) arguments in
        let solve parameter argument =
          match (number parameter, is_zero argument) with
          | Some parameter, false when Units.rigid_powers parameter <> [] ->
              Option.bind (find words argument) (fun argument -> solution ~parameter ~argument)
          | _ -> None
        in
        let solutions = List.filter_map Fun.id (List.map2 solve pairs given) in
        let of_variable id =
          List.find_map
            (fun ((r : Units.rigid), u) -> if r.variable.id = id then Some u else None)
            solutions
        in
        let known ((r : Units.rigid), _) = of_variable r.variable.id <> None in
        if List.for_all known (Units.rigid_powers u) then Some (Units.substitute of_variable u)
        else None
  | _ -> None

let unit_of words e = try find words e with Rational.Out_of_range -> None

let factors e =
  let rec go power (e : Resolve.Ir.expr) =
    match (binary e, e.desc) with
    | Some ("*", a, b), _ -> go power a @ go power b
    | Some ("/", a, b), _ -> go power a @ go (-power) b
    | None, Negate e -> go power e
    | _ -> [ (e, power) ]
  in
  go 1 e

let is_number (e : Resolve.Ir.expr) = match e.desc with Number _ -> true | _ -> false

(* Maximum length of a chain of names to follow. *)
let deepest = 6

let is_square words e =
  let rec go depth (e : Resolve.Ir.expr) =
    depth < deepest
    &&
    let e = Bare_number.value words e in
    let go = go (depth + 1) in
    match (e.desc, binary e) with
    | Power { exponent = 2; _ }, _ -> true
    | _, Some ("*", a, b) ->
        (text words a <> None && text words a = text words b)
        || (is_number a && go b)
        || (is_number b && go a)
    | _, Some ("/", a, b) -> is_number b && go a
    | _, Some (("+" | "-"), a, b) -> go a && go b
    | _ -> false
  in
  go 0 e

let is_product words e =
  let is_variable (e : Resolve.Ir.expr) =
    let rec plain (e : Resolve.Ir.expr) =
      match e.desc with
      | Local _ | Global _ -> Bare_number.literal words e = None
      | Field { record; _ } -> plain record
      | Apply { head; argument; style = Juxtaposed } -> plain head && plain argument
      | _ -> false
    in
    plain e
  in
  match factors (Bare_number.value words e) with
  | _ :: _ :: _ as all -> List.for_all (fun (e, _) -> is_variable e) all
  | _ -> false

let with_parts words (e : Resolve.Ir.expr) replacements =
  let column (p : Span.position) = Span.column p in
  let replace whole ((part : Span.t), replacement) =
    Option.bind whole (fun whole ->
        let from = column part.start - column e.span.start in
        let until = column part.stop - column e.span.start in
        if
          Span.line part.start <> Span.line e.span.start
          || from < 0
          || until > String.length whole
          || until < from
        then None
        else
          Some
            (String.sub whole 0 from ^ replacement
            ^ String.sub whole until (String.length whole - until)))
  in
  (* the last part first, so that the parts before it keep their columns *)
  let later ((a : Span.t), _) ((b : Span.t), _) = Int.compare (column b.start) (column a.start) in
  List.fold_left replace (text words e) (List.sort later replacements)

let with_part words e ~part replacement = with_parts words e [ (part, replacement) ]
