open Basis

(* The type of the last argument, if the function may return a value of that type. *)
let rec changed t =
  match Type.expand t with
  | Function (a, b) -> (
      match (Type.expand a, Type.expand b) with
      | Flexible a', Flexible b' when a' == b' -> Some a
      | Rigid a', Rigid b' when a' == b' -> Some a
      | Data { tycon = a'; _ }, Data { tycon = b'; _ } when a' = b' -> Some a
      | _ -> changed b)
  | _ -> None

(* By convention, the names of robots' output records end in `Output`. *)
let is_output t =
  match Type.expand t with
  | Data { tycon; _ } -> String.ends_with ~suffix:"Output" tycon.name
  | _ -> false

let rec is_of_a_capability (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply { head; style = Juxtaposed; _ } -> is_of_a_capability head
  | Global { module_; _ } -> String.equal module_ "Capability"
  | _ -> false

let program_output t =
  match Type.expand t with
  | Data { tycon; arguments = [ _; output ]; _ } when tycon = Environment.built_in "Program" ->
      Some output
  | _ -> None

let cure =
  "use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`"

let hint (fact : Shape_fact.t) =
  let ends =
    match (program_output fact.expected.ty, program_output fact.found) with
    | Some expected, Some found -> Some (expected, found)
    | _ -> None
  in
  match (changed fact.found, ends) with
  | _, Some (wanted, given) when changed given <> None && changed wanted = None -> Some cure
  | Some _, _
    when is_output fact.expected.ty || Option.fold fact.subject ~none:false ~some:is_of_a_capability
    ->
      Some cure
  | _ -> None

let hint_without_instance t = Option.map (fun _ -> cure) (changed t)

let not_made (fact : Shape_fact.t) =
  match (fact.wanted, fact.given) with
  | (Data _ | Rigid _), (Function _ | Data _) -> Option.map (Shape_fact.hinted fact) (hint fact)
  | _ -> None

(* `(v, omega)` in place of a robot's output *)
let speeds (fact : Shape_fact.t) =
  let is_number t = match Type.expand t with Type.Number _ -> true | _ -> false in
  match (fact.given, Shape_fact.all (Shape_fact.elements fact)) with
  | Tuple [ v; omega ], Some [ v'; omega' ]
    when is_output fact.expected.ty && is_number v && is_number omega ->
      let text =
        Printf.sprintf "roMake (setVelTR %s %s)" (Source.grouped v') (Source.grouped omega')
      in
      Some
        (Shape_fact.hinted fact
           (Printf.sprintf "write `%s` for a robot's output: its speed and its turn rate" text)
        |> Diagnostic.write fact.at text)
  | _ -> None

let statement (fact : Shape_fact.t) =
  match fact.given with
  | Function _ when Shape_fact.is_statement fact && changed fact.found <> None ->
      let output = Printf.sprintf "(roMake %s)" (Shape_fact.grouped fact "(…)") in
      Diagnostic.error ~code:"E0370" ~at:fact.at
        "the statements of a `do` are tasks, but this is %s" (Shape_fact.found_text fact)
      |> Diagnostic.hint
           (Printf.sprintf
              "use `sleepT 1[s] %s` for a task of one second, or `constT %s` for one that never \
               ends"
              output output)
      |> Option.some
  | _ -> None
