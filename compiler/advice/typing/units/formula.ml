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
  | Apply { style = Juxtaposed; _ } -> (
      match applied words e with
      | Some u when Units.rigid_powers u = [] -> Some u
      | Some _ | None -> None)
  | _ -> None

and applied words (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply { head; style = Juxtaposed; _ } -> applied words head
  | Global g -> Option.bind (Wording.declared_type words g) result
  | Local x -> Option.bind (Wording.local words x) result
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

let with_part words (e : Resolve.Ir.expr) ~(part : Span.t) replacement =
  let column (p : Span.position) = Span.column p in
  match text words e with
  | Some whole when Span.line part.start = Span.line e.span.start ->
      let from = column part.start - column e.span.start in
      let until = column part.stop - column e.span.start in
      if from < 0 || until > String.length whole || until < from then None
      else
        Some
          (String.sub whole 0 from ^ replacement
          ^ String.sub whole until (String.length whole - until))
  | Some _ | None -> None
