open Basis

type set = { param : Core.Ir.Global.t; setting : string; value : Interp.Value.t }

let unknown (p : Core.Ir.param) ~at ?hint reason =
  Diagnostic.error ~code:"E0391" ~at "the value of the parameter `%s` must be known before the run"
    p.label
  |> Diagnostic.note "%s" reason
  |> Option.fold ~none:Fun.id ~some:(Diagnostic.hint "%s") hint

let places (core : Core.Ir.program) =
  let places = Hashtbl.create 256 in
  List.iter
    (fun (d : Core.Ir.definition) -> Hashtbl.replace places d.name d.body.span)
    core.definitions;
  fun (name : Core.Ir.Global.t) ->
    match Hashtbl.find_opt places name with
    | Some span -> span
    | None -> Diagnostic.bug ~stage:"Build.Params" "`%s` has no value" name.name

(* The value of the definition [name], which is the parameter's default or its setting. *)
let value sink (places, constants) (p : Core.Ir.param) name : Interp.Value.t option =
  let at = places name in
  let refuse diagnostic =
    Diagnostic.emit sink diagnostic;
    None
  in
  match Interp.Constant.value constants name with
  | Ok (Float x) when Float.is_nan x ->
      Diagnostic.error ~code:"E0391" ~at "the value of the parameter `%s` is not a number" p.label
      |> Diagnostic.note "it is NaN, like `0 / 0`"
      |> refuse
  | Ok ((Float _ | Int _ | Bool _) as value) -> Some value
  | Ok _ -> Diagnostic.bug ~stage:"Build.Params" "`%s` is not a number" p.label
  | Error (Param other) ->
      unknown p ~at
        (Printf.sprintf "it depends on the parameter `%s`, which can be set for each run"
           other.label)
        ~hint:
          (if name = p.param then Printf.sprintf "define it without `param`: `%s = …`" p.label
           else
             "a value that depends on a parameter cannot be a parameter itself: define it without \
              `param`")
      |> refuse
  | Error Too_much ->
      Diagnostic.error ~code:"E0413" ~at "the value of the parameter `%s` takes too long to compute"
        p.label
      |> Diagnostic.note "frobc computes it at compile time"
      |> Diagnostic.hint
           "write the value as a literal, or compute it in the program from simpler parameters"
      |> refuse
  | Error (Foreign f) ->
      unknown p ~at (Printf.sprintf "it depends on `%s`, which is written in C" f) |> refuse

let all_some list = if List.mem None list then None else Some (List.filter_map Fun.id list)

let atom : Interp.Value.t -> Flow.Ir.atom = function
  | Bool b -> Bool b
  | Int n -> Int n
  | Float x -> Float x
  | _ -> Diagnostic.bug ~stage:"Build.Params" "a parameter that is not a number"

let evaluated core = (places core, Interp.Constant.program core)

(* Evaluates the values only if no definition is recursive. Otherwise, the evaluation might not
   terminate. *)
let when_finite values sink (core : Core.Ir.program) =
  if core.params = [] then values sink core
  else
    match Core.Recursion.facts core with
    | [] -> values sink core
    | facts ->
        List.iter (Facts.report (Advice.Of_core.into sink)) facts;
        None

let all_defaults sink (core : Core.Ir.program) =
  let evaluated = evaluated core in
  let default (p : Core.Ir.param) =
    Option.map (fun value -> (p.label, atom value)) (value sink evaluated p p.param)
  in
  Option.map
    (fun all ->
      let table = Hashtbl.of_seq (List.to_seq all) in
      fun (p : Core.Ir.param) -> Hashtbl.find table p.label)
    (all_some (Long_list.map default core.params))

let defaults sink = when_finite all_defaults sink

let text real : Interp.Value.t -> string = function
  | Bool b -> string_of_bool b
  | Int n -> Int32.to_string n
  | Float x when x = infinity -> "inf"
  | Float x when x = neg_infinity -> "-inf"
  | Float x -> Real.shortest real x
  | _ -> ""

let all_given sink (core : Core.Ir.program) =
  let evaluated = evaluated core in
  let set (p : Core.Ir.param) =
    Option.map
      (fun given ->
        Option.map
          (fun value -> { param = p.param; setting = p.label ^ "=" ^ text core.real value; value })
          (value sink evaluated p given))
      p.given
  in
  all_some (List.filter_map set core.params)

let given sink = when_finite all_given sink
let host_options set = List.concat_map (fun s -> [ "--param"; s.setting ]) set
