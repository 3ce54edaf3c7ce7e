let same = Operands.same

(* Choices within choices are looked into so deep. *)
let depth = 4

let equal_if_equal definitions (first : Ir.signal) (second : Ir.signal) =
  let one (atom : Ir.atom) : Ir.atom =
    match atom with
    | Signal s when s.id = second.id -> Signal first
    | Signal _ | Bool _ | Int _ | Float _ -> atom
  in
  let definition (atom : Ir.atom) =
    match atom with
    | Signal s -> Hashtbl.find_opt definitions s.id
    | Bool _ | Int _ | Float _ -> None
  in
  let rec equal depth a b =
    same (one a) (one b)
    || depth > 0
       &&
       match (definition a, definition b) with
       | Some (Ir.If a), Some (Ir.If b) ->
           same (one a.condition) (one b.condition)
           && equal (depth - 1) a.then_ b.then_
           && equal (depth - 1) a.else_ b.else_
       | _, _ -> false
  in
  equal depth

(* The accumulators: initial value, parameter, what a round gives, and the end. *)
let accumulators (i : Ir.instance) (l : Ir.loop) (callee : Ir.node) =
  let rec collect arguments initial parameters outputs ends =
    match (arguments, initial, parameters, outputs, ends) with
    | Ir.Accumulator :: arguments, a :: initial, p :: parameters, (_, o) :: outputs, e :: ends ->
        (a, p, o, e) :: collect arguments initial parameters outputs ends
    | _, _, _, _, _ -> []
  in
  collect l.arguments i.inputs callee.inputs callee.outputs i.outputs

(* The first two that are twins: the parameters and the ends. *)
let find (i : Ir.instance) (l : Ir.loop) (callee : Ir.node) =
  match accumulators i l callee with
  | [] | [ _ ] -> None
  | accumulators ->
      let definitions = Hashtbl.create 16 in
      List.iter
        (fun (e : Ir.equation) -> Hashtbl.replace definitions e.defines.id e.rhs)
        callee.equations;
      let rec search = function
        | [] -> None
        | (initial, parameter, output, at_end) :: others -> (
            let is_twin (initial', (parameter' : Ir.signal), output', _) =
              same initial initial'
              && parameter.Ir.ty = parameter'.ty
              && equal_if_equal definitions parameter parameter' output output'
            in
            match List.find_opt is_twin others with
            | Some (_, parameter', _, at_end') -> Some ((parameter, parameter'), (at_end, at_end'))
            | None -> search others)
      in
      search accumulators

let program (program : Ir.program) =
  let uses = lazy (Uses.of_nodes program) in
  let nodes = Array.copy program.nodes in
  let changed = ref false in
  Array.iteri
    (fun index (node : Ir.node) ->
      let merged = Substitution.create () and any = ref false in
      List.iter
        (fun (i : Ir.instance) ->
          match i.loop with
          | Some l when (Lazy.force uses).(i.node) = 1 -> (
              match find i l nodes.(i.node) with
              | None -> ()
              | Some ((parameter, twin), (at_end, at_end')) ->
                  let inside = Substitution.create () in
                  Substitution.replace inside twin (Signal parameter);
                  nodes.(i.node) <- Substitution.node inside nodes.(i.node);
                  Substitution.replace merged at_end' (Signal at_end);
                  any := true)
          | Some _ | None -> ())
        node.instances;
      if !any then begin
        changed := true;
        nodes.(index) <- Substitution.node merged nodes.(index)
      end)
    program.nodes;
  if !changed then { program with nodes } else program
