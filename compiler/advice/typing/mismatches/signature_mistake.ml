open Basis
open Typing
open Diagnostic

let construct : Surroundings.construct -> string = function
  | Signature name -> Printf.sprintf "the signature of `%s`" name
  | Class name -> Printf.sprintf "the class `%s`" name
  | Instance name -> Printf.sprintf "the instance of `%s`" name

(* The places in a signature where this name occurs. *)
let mentions words (place : Span.t) name =
  let is_part = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | _ -> false in
  match Wording.quote words place with
  | Some text when Span.line place.start = Span.line place.stop ->
      let n = String.length name and length = String.length text in
      let stands i =
        i + n <= length
        && String.equal (String.sub text i n) name
        && (i = 0 || not (is_part text.[i - 1]))
        && (i + n = length || not (is_part text.[i + n]))
      in
      let span i =
        let start = Span.forward i place.start in
        Span.make ~file:place.file ~start ~stop:(Span.forward n start)
      in
      List.filter stands (List.init length Fun.id) |> List.map span
  | Some _ | None -> []

let variable_like_a_type words ~at (variable : Ir.variable) type_ =
  warning ~code:"W0302" ~at "`%s` is a type variable here, so it means any type" variable.name
  |> hint "if you meant the type, write `%s`" type_
  |>
  match mentions words at variable.name with
  | [] -> Fun.id
  | places -> fix (Printf.sprintf "write `%s`" type_) (List.map (fun at -> (at, type_)) places)

(* Suggests the signature with the variable replaced by the required type. The head of an instance
   is not a signature. *)
let less_general words ({ by; place } : Surroundings.owned) (variable : Ir.variable) needed d =
  (* a context can only constrain variables, so a variable in it cannot become a type *)
  let is_constrained text =
    match String.index_opt text '=' with
    | Some i when i + 1 < String.length text && text.[i + 1] = '>' ->
        let context = { place with stop = Span.forward i place.start } in
        mentions words context variable.name <> []
    | Some _ | None -> false
  in
  match (by, Wording.quote words place, mentions words place variable.name) with
  | Signature _, Some text, (_ :: _ as places) when not (is_constrained text) ->
      let piece (at : Span.t) = Span.column at.start - Span.column place.start in
      let replaced =
        List.fold_left
          (fun text at ->
            let i = piece at and n = String.length variable.name in
            String.sub text 0 i ^ needed ^ String.sub text (i + n) (String.length text - i - n))
          text (List.rev places)
      in
      let replaced = Source.with_opening replaced in
      hint "if the definition is right, write the signature as `%s`" replaced d
      |> fix (Printf.sprintf "write `%s`" replaced) (List.map (fun at -> (at, needed)) places)
  | _ -> d

let too_general words ~at ~kind ~instead (variable : Ir.variable) needed =
  let diagnostic =
    error ~code:"E0306" ~at "the signature allows any %s `%s`, but the definition needs %s" kind
      variable.name needed
  in
  (match Wording.owner words variable with
  | Some { by; place } ->
      label ~at:place "`%s` is any %s in %s" variable.name kind (construct by) diagnostic
  | None -> diagnostic)
  |>
  match Variable_name.type_meant variable.name with
  | Some type_ ->
      let meant =
        Option.bind (Wording.owner words variable) (fun ({ place; _ } : Surroundings.owned) ->
            Option.bind (Wording.quote words place) Other_type.of_text)
      in
      hint "if you meant the type, write `%s`; a lower-case name means any %s"
        (Option.value meant ~default:type_)
        kind
  | None -> (
      match (Wording.owner words variable, instead) with
      | Some owner, Some needed -> less_general words owner variable needed
      | _ -> Fun.id)

let general_type words ~at (r : Type.rigid) t =
  let kind = match r.kind with Of_types -> "type" | Of_sizes -> "size" in
  let instead =
    match Type.expand t with
    | Bool | String | Size _ | Data { arguments = []; _ } -> Some (Wording.type_ words t)
    | Number (Float, u) when not (Units.is_open u) -> Some (Wording.type_ words t)
    | _ -> None
  in
  too_general words ~at ~kind ~instead r.variable
    (Printf.sprintf "it to be %s" (Wording.described words t))

(* The power (`s^2`) that the user probably meant by a name such as `s2` in a unit. The parser reads
   `s2` as a variable. *)
let power_meant (variable : Ir.variable) =
  match variable.name with
  | "m2" | "m3" | "s2" | "s3" | "g2" ->
      Some (Printf.sprintf "%c^%c" variable.name.[0] variable.name.[1])
  | _ -> None

let general_unit words ~at (r : Units.rigid) u =
  let instead = if Units.is_open u then None else Some (Wording.measure words u) in
  let instead = if power_meant r.variable = None then instead else None in
  too_general words ~at ~kind:"unit" ~instead r.variable
    (Printf.sprintf "it to be `%s`" (Wording.measure words u))
  |> Option.fold (power_meant r.variable) ~none:Fun.id ~some:(fun power ->
         hint "`%s` is a variable here: for a power, write `%s`" r.variable.name power)

let general_representation words ~at (r : Units.rigid) n =
  let instead =
    match n with
    | Type.Float | Int -> Some (Wording.representation words n)
    | Flexible_representation _ | Rigid_representation _ -> None
  in
  too_general words ~at ~kind:"representation" ~instead r.variable
    (Printf.sprintf "it to be `%s`" (Wording.representation words n))

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

let idle_constraint ~at (variable : Ir.variable) ~ty =
  error ~code:"E0364" ~at "the context contains `%s`, but the type does not" variable.name
  |> label ~at:ty "nothing here determines the type `%s`" variable.name

let constraint_on_type words ~at ty =
  error ~code:"E0365" ~at "a context can only constrain a variable, not %s"
    (Wording.quoted words ty)

let unknown_size ~at ~of_ ~variable =
  error ~code:"E0331" ~at "nothing determines the size of an array where `%s` is used" of_
  |> (match variable with
     | Some variable ->
         note
           "`%s` in the signature of `%s` is a variable for any size: write a number instead, or \
            name the size, as in `type Size = 4`"
           variable of_
     | None -> Fun.id)
  |> hint "add a type annotation, as in `(e :: Array 4 Float)`, or give the definition a signature"

let polymorphic_value words ~name ~at ~signature ty =
  let name = match name with Some name -> "`" ^ name ^ "`" | None -> "this" in
  error ~code:"E0314" ~at "only a local function can be polymorphic, but %s is %s" name
    (Wording.quoted words ty)
  |> label ~at:signature "this signature has type variables of its own"
