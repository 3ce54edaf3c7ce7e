open Basis
open Diagnostic

type owned = { by : string; place : Span.t }
type owner = Ir.variable -> owned option

let type_meant (variable : Ir.variable) =
  match String.capitalize_ascii variable.name with
  | ( "Float" | "Double" | "Int" | "Integer" | "Bool" | "String" | "Time" | "Distance" | "Velocity"
    | "Acceleration" | "Angle" ) as type_ ->
      Some type_
  | _ -> None

let variable_like_a_type ~at (variable : Ir.variable) =
  Option.map
    (fun type_ ->
      warning ~code:"W0302" ~at "`%s` is a variable here, and stands for every type" variable.name
      |> hint (Printf.sprintf "the type is `%s`" type_))
    (type_meant variable)

let too_general owner ~at ~kind (variable : Ir.variable) needed =
  let diagnostic =
    error ~code:"E0306" ~at "the signature promises every %s `%s`, but the definition needs %s" kind
      variable.name needed
  in
  (match owner variable with
  | Some { by; place } ->
      label ~at:place (Printf.sprintf "`%s` is any %s in %s" variable.name kind by)
        diagnostic
  | None -> diagnostic)
  |>
  match type_meant variable with
  | Some type_ ->
      hint (Printf.sprintf "the type is `%s`; a name in lower case stands for every %s" type_ kind)
  | None -> Fun.id

let general_type words owner ~at (r : Type.rigid) t =
  let kind = match r.kind with Of_types -> "type" | Of_sizes -> "size" in
  too_general owner ~at ~kind r.variable (Printf.sprintf "it to be %s" (Show.described words t))

(* `s2` in brackets, which is a variable. *)
let power_meant (variable : Ir.variable) =
  match variable.name with
  | "m2" | "m3" | "s2" | "s3" | "g2" ->
      Some (Printf.sprintf "%c^%c" variable.name.[0] variable.name.[1])
  | _ -> None

let general_unit words owner ~at (r : Units.rigid) u =
  too_general owner ~at ~kind:"unit" r.variable
    (Printf.sprintf "it to be `%s`" (Show.measure words u))
  |> Option.fold (power_meant r.variable) ~none:Fun.id ~some:(fun power ->
         hint (Printf.sprintf "`%s` is a variable here; a power is written `%s`" r.variable.name
                 power))

let general_representation words owner ~at (r : Units.rigid) n =
  too_general owner ~at ~kind:"representation" r.variable
    (Printf.sprintf "it to be `%s`" (Show.representation words n))

let promised_unit (a, b) =
  let alone u =
    match (Units.base_powers u, Units.rigid_powers u, Units.flexible_powers u) with
    | [], [ (r, p) ], [] when Rational.equal p Rational.one -> Some r
    | _ -> None
  in
  match (alone a, alone b) with
  | Some r, _ when Units.rigid_powers b = [] -> Some (r, b)
  | _, Some r when Units.rigid_powers a = [] -> Some (r, a)
  | _ -> None
