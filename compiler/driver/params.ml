open Basis

type set = { param : Core.Ir.Global.t; setting : string; value : Interp.Value.t }

let unknown (p : Core.Ir.param) ~at ?hint reason =
  Diagnostic.error ~code:"E0391" ~at "the value of the parameter `%s` is not known before the run"
    p.label
  |> Diagnostic.note reason
  |> Option.fold ~none:Fun.id ~some:Diagnostic.hint hint

let place (core : Core.Ir.program) name =
  match List.find_opt (fun (d : Core.Ir.definition) -> d.name = name) core.definitions with
  | Some d -> d.body.span
  | None -> Diagnostic.bug ~stage:"Driver.Params" "`%s` has no value" name.name

(* Of the definition of a default, or of what is given. *)
let value sink core (p : Core.Ir.param) name : Interp.Value.t option =
  let at = place core name in
  let refuse diagnostic =
    Diagnostic.emit sink diagnostic;
    None
  in
  match Interp.Constant.value core name with
  | Ok (Float x) when Float.is_nan x ->
      Diagnostic.error ~code:"E0391" ~at "the value of the parameter `%s` is no number" p.label
      |> Diagnostic.note "it is NaN, as `0 / 0` is"
      |> refuse
  | Ok ((Float _ | Int _ | Bool _) as value) -> Some value
  | Ok _ -> Diagnostic.bug ~stage:"Driver.Params" "`%s` is no number" p.label
  | Error (Param other) ->
      unknown p ~at
        (Printf.sprintf "it depends on the parameter `%s`, which a run may set" other.label)
        ~hint:
          (if name = p.param then
             Printf.sprintf
               "what follows from a parameter is a definition: `%s = …`, without `param`" p.label
           else "what is to follow from a parameter is a definition")
      |> refuse
  | Error (Foreign f) ->
      unknown p ~at (Printf.sprintf "it depends on `%s`, which is in C" f) |> refuse

let all_some list = if List.mem None list then None else Some (List.filter_map Fun.id list)

let atom : Interp.Value.t -> Flow.Ir.atom = function
  | Bool b -> Bool b
  | Int n -> Int n
  | Float x -> Float x
  | _ -> Diagnostic.bug ~stage:"Driver.Params" "a parameter that is no number"

let defaults sink (core : Core.Ir.program) =
  let default (p : Core.Ir.param) =
    Option.map (fun value -> (p.label, atom value)) (value sink core p p.param)
  in
  Option.map
    (fun all (p : Core.Ir.param) -> List.assoc p.label all)
    (all_some (List.map default core.params))

let text real : Interp.Value.t -> string = function
  | Bool b -> string_of_bool b
  | Int n -> Int32.to_string n
  | Float x when x = infinity -> "inf"
  | Float x when x = neg_infinity -> "-inf"
  | Float x -> Real.shortest real x
  | _ -> ""

let given sink (core : Core.Ir.program) =
  let set (p : Core.Ir.param) =
    Option.map
      (fun given ->
        Option.map
          (fun value -> { param = p.param; setting = p.label ^ "=" ^ text core.real value; value })
          (value sink core p given))
      p.given
  in
  all_some (List.filter_map set core.params)
