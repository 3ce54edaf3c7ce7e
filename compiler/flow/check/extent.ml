open Basis
open Ir

(* The number of instances is limited because tools traverse all of them, and the number of state
   values because computers that drive robots do not have more memory. *)
let most_instances = 4e6
let most_values = 134_217_728.

(* Counts are floats, because integers could overflow. *)
type size = { instances : float; values : float }

let nothing = { instances = 0.; values = 0. }
let add a b = { instances = a.instances +. b.instances; values = a.values +. b.values }
let times n a = { instances = n *. a.instances; values = n *. a.values }

let rec values_of : ty -> float = function
  | Array (n, element) -> float_of_int n *. values_of element
  | Bool | Int | Float | Sum _ | Foreign _ -> 1.

let kept (e : equation) =
  match e.rhs with
  | Delay _ -> values_of e.defines.ty
  | Time _ | Ticks _ | Integral _ | Derivative _ -> 1.
  | _ -> 0.

(* The child nodes of a node, each with its count and source location. *)
let parts (n : node) =
  let instance (i : instance) =
    (i.node, Option.fold i.loop ~none:1. ~some:(fun l -> float_of_int l.count), i.span)
  in
  let mode span k = (k, 1., span) in
  List.map instance n.instances
  @ Option.fold n.machine ~none:[] ~some:(fun (m : machine) -> List.map (mode m.span) m.modes)

(* Modes share memory, so the largest mode determines the number of values; each mode counts as an
   instance. *)
let sizes (p : program) =
  let sizes = Array.make (Array.length p.nodes) nothing in
  Array.iteri
    (fun k n ->
      let part total (j, count, _) = add total (times count sizes.(j)) in
      let own = List.fold_left (fun sum e -> sum +. kept e) 0. n.equations in
      let inside = List.fold_left part { nothing with values = own } (parts n) in
      let modes (m : machine) =
        List.fold_left (fun most j -> Float.max most sizes.(j).values) 0. m.modes
        -. List.fold_left (fun sum j -> sum +. sizes.(j).values) 0. m.modes
      in
      let values = inside.values +. Option.fold n.machine ~none:0. ~some:modes in
      let holds = inside.instances > 0. || values > 0. in
      sizes.(k) <- { instances = (inside.instances +. if holds then 1. else 0.); values })
    p.nodes;
  sizes

(* Follows the largest part from node to node. *)
let rec largest (p : program) measure k steps =
  let size (j, count, _) = count *. measure j in
  let larger best part =
    match best with Some other when size other >= size part -> best | Some _ | None -> Some part
  in
  match List.fold_left larger None (parts p.nodes.(k)) with
  | Some ((j, _, span) as part) when steps > 0 && size part > 0. ->
      let same (other, _, _) = other = j in
      let all = List.filter same (parts p.nodes.(k)) in
      let count = List.fold_left (fun n (_, count, _) -> n +. count) 0. all in
      (k, j, count, span) :: largest p measure j (steps - 1)
  | Some _ | None -> []

let shown = 5

let report sink ~entry (p : program) measure text =
  let root = Array.length p.nodes - 1 in
  let name k = p.nodes.(k).origin in
  let hops =
    List.filter
      (fun (k, j, count, _) -> count > 1. || not (String.equal (name k) (name j)))
      (largest p measure root 50)
  in
  let label (d, places) (k, j, count, span) =
    if List.length places >= shown || List.mem span places then (d, places)
    else
      let what =
        if count > 1. then Printf.sprintf "%.0f of `%s`" count (name j)
        else Printf.sprintf "`%s`" (name j)
      in
      (Diagnostic.label ~at:span (Printf.sprintf "`%s` contains %s" (name k) what) d, span :: places)
  in
  let error = Diagnostic.error ~code:"E0413" ~at:entry "%s" text in
  fst (List.fold_left label (error, []) hops)
  |> Diagnostic.note
       "each use of a signal function has its own copy of the state, including the state of all \
        signal functions inside it"
  |> Diagnostic.hint
       "name the output of a signal function in an equation, so that you can use it twice and run \
        the signal function only once"
  |> Diagnostic.emit sink

let check sink ~entry (p : program) =
  let sizes = sizes p in
  let { instances; values } = sizes.(Array.length p.nodes - 1) in
  if values > most_values then
    report sink ~entry p
      (fun k -> sizes.(k).values)
      (Printf.sprintf
         "the program would store %.3g values from one instant to the next; the maximum is %.0f"
         values most_values)
  else if instances > most_instances then
    report sink ~entry p
      (fun k -> sizes.(k).instances)
      (Printf.sprintf
         "the program would run %.3g signal functions at the same time; the maximum is %.0f"
         instances most_instances)
