(* What a function takes last, if it may well give that back. *)
let rec changed t =
  match Type.expand t with
  | Function (a, b) -> (
      match (Type.expand a, Type.expand b) with
      | Flexible a', Flexible b' when a' == b' -> Some a
      | Rigid a', Rigid b' when a' == b' -> Some a
      | Data { tycon = a'; _ }, Data { tycon = b'; _ } when a' = b' -> Some a
      | _ -> changed b)
  | _ -> None

(* As robots' records are named. *)
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

let cure = "`roMake` makes a robot's output of such a function, as in `roMake (setVelTR v omega)`"

let hint ~subject ~expected ~found =
  let ends =
    match (program_output expected, program_output found) with
    | Some expected, Some found -> Some (expected, found)
    | _ -> None
  in
  match (changed found, ends) with
  | _, Some (wanted, given) when changed given <> None && changed wanted = None -> Some cure
  | Some _, _ when is_output expected || Option.fold subject ~none:false ~some:is_of_a_capability ->
      Some cure
  | _ -> None

let hint_without_instance t = Option.map (fun _ -> cure) (changed t)
