open Ir

let given codes (code : code) =
  let argument (p : variable) =
    let rec find = function
      | [] -> Basis.Diagnostic.bug ~stage:"Step.Entry" "a start reads what it is not given"
      | (({ parameters; _ } : code), arguments) :: others -> (
          match List.find_opt (fun ((q : variable), _) -> q.id = p.id) (List.combine parameters arguments) with
          | Some (_, argument) -> argument
          | None -> find others)
    in
    find codes
  in
  List.map argument code.parameters

let started ~callee modes (run : run) (entry : entry) =
  let mode : mode = List.nth modes entry.mode in
  let node : node = callee mode.node in
  match (node.start, entry.first) with
  | Some start, Reset_by reset ->
      let step = (List.nth run.cases entry.mode).arguments in
      { entry with first = Started_by (given [ (node.reset, reset); (node.step, step) ] start) }
  | _, _ -> entry
