open Basis

type t = {
  digits : string;
  negative : bool;
  unit_ : Resolve.Ir.unit_ option;
  at : Span.t;
  name : string option;
  signature : Span.t option;
  of_record : bool;
}

(* The definition of a name without parameters, and its signature. Constants from other files are
   excluded, because a fix can edit only one file. *)
let definition words (e : Resolve.Ir.expr) =
  match e.desc with
  | Local x -> Option.map (fun e -> (x.name, e, None)) (Wording.definition words x)
  | Global g -> (
      match Wording.binding words g with
      | Some
          {
            parameters = [];
            signature;
            body = { guards = [ { condition = None; value } ]; where = { groups = []; _ } };
            _;
          }
        when String.equal value.span.file e.span.file ->
          Some (g.name, value, Option.map (fun (s : Resolve.Ir.scheme) -> s.span) signature)
      | Some _ | None -> None)
  | _ -> None

let own_function words (f : Resolve.Ir.expr) =
  let is_own (b : Resolve.Ir.binding) =
    b.signature = None && b.parameters <> [] && String.equal b.span.file f.span.file
  in
  match
    match f.desc with
    | Global g -> Wording.binding words g
    | Local x -> Wording.local_function words x
    | _ -> None
  with
  | Some b when is_own b -> Some b
  | Some _ | None -> None

let rec number (e : Resolve.Ir.expr) =
  match e.desc with
  | Number { digits; _ } when float_of_string_opt digits = Some 0. -> None
  | Number { digits; unit_; _ } -> Some (digits, false, unit_, e.span)
  | Negate e ->
      Option.map (fun (digits, negative, unit_, at) -> (digits, not negative, unit_, at)) (number e)
  | _ -> None

let literal words (e : Resolve.Ir.expr) =
  match number e with
  | Some (digits, negative, unit_, at) ->
      Some { digits; negative; unit_; at; name = None; signature = None; of_record = false }
  | None -> (
      match definition words e with
      | Some (name, value, signature) ->
          Option.map
            (fun (digits, negative, unit_, at) ->
              { digits; negative; unit_; at; name = Some name; signature; of_record = false })
            (number value)
      | None -> None)

(* The literal in a field of a constant record, as in `gains.kp`. *)
let field words (e : Resolve.Ir.expr) =
  match e.desc with
  | Field { record; field; _ } -> (
      match definition words record with
      | Some (_, { desc = Record { fields; _ }; _ }, _) ->
          let is_it ((name : Syntax.Ir.name), _) = String.equal name.text field.text in
          Option.bind (List.find_opt is_it fields) (fun (_, value) -> number value)
          |> Option.map (fun (digits, negative, unit_, at) ->
                 {
                   digits;
                   negative;
                   unit_;
                   at;
                   name = Some field.text;
                   signature = None;
                   of_record = true;
                 })
      | Some _ | None -> None)
  | _ -> None

(* Maximum length of a chain of names to follow. *)
let deepest = 6

(* Is this a function or signal function whose last argument alone determines the unit of its
   result? *)
let keeps_the_unit (head : Resolve.Ir.expr) =
  match head.desc with
  | Global { name = "abs" | "previous"; _ } -> true
  | Apply
      {
        head =
          { desc = Global { name = "lowPass" | "highPass" | "delayBy" | "movingAverage"; _ }; _ };
        style = Juxtaposed;
        _;
      } ->
      true
  | _ -> false

(* For the application of a function without a signature: its result, if only one expression can be
   the result. *)
let rec result words (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply { head = { desc = Apply _; _ } as head; style = Juxtaposed; _ } -> result words head
  | Apply { head; style = Juxtaposed; _ } -> (
      match own_function words head with
      | Some { body = { guards = [ { condition = None; value } ]; _ }; _ } -> Some value
      | Some _ | None -> None)
  | _ -> None

(* The factors that [select] accepts, each with its exponent: only the first one in a product, and
   one for each operand in a sum. *)
let factors words ~select e =
  let rec of_expr depth power (e : Resolve.Ir.expr) =
    match (select words e, e.desc) with
    | Some found, _ -> [ (found, power) ]
    | ( None,
        Apply
          {
            head = { desc = Apply { head = { desc = Global { name; _ }; _ }; argument = a; _ }; _ };
            argument = b;
            style = Operator _;
          } ) -> (
        match name with
        | "*" | "/" -> (
            match of_expr depth power a with
            | [] -> of_expr depth (if String.equal name "/" then -power else power) b
            | found -> found)
        | "+" | "-" -> (
            match (of_expr depth power a, of_expr depth power b) with
            | [], _ | _, [] -> []
            | left, right -> left @ right)
        | _ -> [])
    | None, Negate e -> of_expr depth power e
    | None, Apply { head; argument; style = Juxtaposed } when keeps_the_unit head ->
        of_expr depth power argument
    | None, (Local _ | Global _) when depth < deepest -> (
        match definition words e with
        | Some (_, value, None) -> of_expr (depth + 1) power value
        | Some (_, _, Some _) | None -> [])
    | None, Apply { style = Juxtaposed; _ } when depth < deepest ->
        Option.fold (result words e) ~none:[] ~some:(of_expr (depth + 1) power)
    | None, _ -> []
  in
  of_expr 0 1 e

let factor words e =
  let select words e =
    match (literal words e, field words e) with
    | Some ({ unit_ = None; name = Some _; _ } as found), _
    | None, Some ({ unit_ = None; _ } as found) ->
        Some found
    | _ -> None
  in
  factors words ~select e

let written_factor words e =
  let select words (e : Resolve.Ir.expr) =
    match literal words e with
    | Some ({ name = None; _ } as found) -> Some found
    | Some _ | None -> None
  in
  factors words ~select e

let is_per_millisecond words e =
  match literal words e with
  | Some { unit_ = Some _; at; _ } ->
      Option.fold (Wording.quote words at) ~none:false ~some:(String.ends_with ~suffix:"[ms^-1]")
  | Some _ | None -> false

let gain words e =
  let is_of_a_gain (u : Resolve.Ir.unit_) =
    let is_negative ((f : Resolve.Ir.unit_factor), (power : Syntax.Ir.rational)) =
      match f with
      | Declared { name = "rad" | "deg"; _ } -> true
      | Declared _ | Unit_variable _ -> power.numerator < 0
    in
    List.exists (fun (_, (power : Syntax.Ir.rational)) -> power.numerator < 0) u.factors
    && List.for_all is_negative u.factors
  in
  let select words e =
    match literal words e with
    | Some ({ unit_ = Some u; _ } as found) when is_of_a_gain u -> Some found
    | Some _ | None -> None
  in
  factors words ~select e

let value words e =
  match (definition words e, result words e) with
  | Some (_, value, None), _ | None, Some value -> value
  | Some (_, _, Some _), _ | None, None -> e

let with_unit { digits; negative; _ } unit_ =
  let literal = Printf.sprintf "%s[%s]" digits unit_ in
  (literal, if negative then "-" ^ literal else literal)

let give_literals numbers d =
  let quoted (number, unit_) = "`" ^ snd (with_unit number unit_) ^ "`" in
  let edit (number, unit_) = (number.at, fst (with_unit number unit_)) in
  let texts = String.concat " and " (List.map quoted numbers) in
  Diagnostic.hint "write %s if these are the right units" texts d
  |> Diagnostic.fix (Printf.sprintf "write %s" texts) (List.map edit numbers)

let give words ({ at; name; signature; of_record; _ } as number) unit_ d =
  let literal, text = with_unit number unit_ in
  let float = Printf.sprintf "Float[%s]" unit_ in
  match name with
  | None ->
      Diagnostic.hint "write `%s` if that is the right unit" text d |> Diagnostic.write at literal
  | Some name when of_record ->
      Diagnostic.label ~at "`%s` is defined as this number, which has no unit" name d
      |> Diagnostic.hint
           "give the field `%s` its unit: `%s = %s`, and `%s :: %s` in the declaration of the \
            record"
           name name text name float
  | Some name ->
      (* a `param` has its signature and its value on one line *)
      let fixed, edits =
        match signature with
        | Some place when Wording.quote words place <> None ->
            ( (if Span.line place.start = Span.line at.start then
                 Printf.sprintf "`param %s :: %s = %s`" name float text
               else Printf.sprintf "`%s :: %s` and `%s = %s`" name float name text),
              [ (place, float) ] )
        | Some _ | None -> (Printf.sprintf "`%s = %s`" name text, [])
      in
      Diagnostic.label ~at "`%s` is defined as this number, which has no unit" name d
      |> Diagnostic.hint "give `%s` its unit: %s" name fixed
      |> Diagnostic.fix (Printf.sprintf "write `%s`" text) (edits @ [ (at, literal) ])
