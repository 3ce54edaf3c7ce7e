open Basis
open Typing

let scale_out_of_range (unit_ : Resolve.Ir.unit_declaration) =
  Diagnostic.(
    error ~code:"E0324" ~at:unit_.span "the scale of the unit `%s` is out of range"
      unit_.unit_name.name
    |> note "a scale must be a positive number between 1e-150 and 1e150")

let param ~at name (scheme : Ir.scheme) =
  let refuse ?hint text =
    Diagnostic.error ~code:"E0390" ~at "%s" text
    |> Diagnostic.note
         "a parameter must be a number or a `Bool`, so that the command line can set it"
    |> Option.fold ~none:Fun.id ~some:(Diagnostic.hint "%s") hint
  in
  let cannot_be = Printf.sprintf "the parameter `%s` cannot have the %s `%s`" name in
  let ty = Show.scheme scheme in
  match (scheme, scheme.ty) with
  | { units = _ :: _; _ }, Number _ | { representations = _ :: _; _ }, Number _ ->
      refuse (cannot_be "polymorphic type" ty) ~hint:"name its unit, as in `Float[1/m]`"
  | _, (Function _ | Signal_function _) ->
      refuse (cannot_be "type" ty) ~hint:"make the parameter a number, and use it in the function"
  | _, Data { tycon = { name = ("Vec2" | "Vec3") as vector; _ }; units = [ unit_ ]; _ } ->
      let fields = if String.equal vector "Vec2" then [ "x"; "y" ] else [ "x"; "y"; "z" ] in
      let part field = name ^ String.capitalize_ascii field in
      let number = Show.ty (Number (Float, unit_)) in
      let zero = String.sub number 5 (String.length number - 5) in
      let param field = Printf.sprintf "`param %s :: %s = 0%s`" (part field) number zero in
      let setting field = Printf.sprintf "%s = %s" field (part field) in
      refuse (cannot_be "type" ty)
        ~hint:
          (Printf.sprintf "declare a parameter for each number, %s, and write `%s = %s { %s }`"
             (String.concat ", " (List.map param fields))
             name vector
             (String.concat ", " (List.map setting fields)))
  | _, (Tuple _ | Data _) ->
      refuse (cannot_be "type" ty)
        ~hint:
          "declare a separate parameter for each number in this value; for a choice, use a `Bool` \
           or an `Int`"
  | _, (Variable _ | Number _ | Bool | String | Size _) -> refuse (cannot_be "type" ty)

let diagnostic words (fact : Declaration_fact.t) =
  match fact with
  | Scale_out_of_range unit_ -> scale_out_of_range unit_
  | Param { at; name; scheme } -> param ~at name scheme
  | Foreign { declared; refusal } -> Foreign_type_mistake.refused declared refusal
  | Imported_twice { symbol; this; first } ->
      Foreign_type_mistake.imported_twice symbol ~this ~first
  | Method_without_variable { method_; variable } ->
      Class_mistake.method_without_variable method_ variable
  | Constrained_variable { constraint_; variable } ->
      Class_mistake.constrained_variable constraint_ variable
  | Built_in_class instance -> Built_in_class.instance ~at:instance.span instance.class_.name
  | Instance_head { instance; head } -> Class_mistake.instance_head words instance head
  | Second_instance { instance; head; first } ->
      Class_mistake.second_instance words instance head ~first
  | Missing_methods { instance; head; missing } ->
      Class_mistake.missing_methods words instance head missing
