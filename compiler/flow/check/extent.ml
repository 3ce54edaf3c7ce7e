open Basis
open Ir

(* The number of instances is limited because tools traverse all of them, and the number of state
   values because the memory of a robot's computer is limited. *)
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

(* The child nodes of a node, each with the number of its instances and a place in the source. *)
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

(* Starting at node [k], descends into the largest part of each node, for at most [steps] levels. *)
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

let report facts ~entry (p : program) (measure : Fact.measure) size ~amount ~limit =
  let root = Array.length p.nodes - 1 in
  let name k = p.nodes.(k).origin in
  let part (k, j, count, at) : Fact.part option =
    if count > 1. || not (String.equal (name k) (name j)) then
      Some { whole = name k; part = name j; count; at }
    else None
  in
  let largest = List.filter_map part (largest p size root 50) in
  Facts.report facts (Fact.Too_large { entry; measure; amount; limit; largest })

let check facts ~entry (p : program) =
  let sizes = sizes p in
  let { instances; values } = sizes.(Array.length p.nodes - 1) in
  if values > most_values then
    report facts ~entry p Values (fun k -> sizes.(k).values) ~amount:values ~limit:most_values
  else if instances > most_instances then
    report facts ~entry p Instances
      (fun k -> sizes.(k).instances)
      ~amount:instances ~limit:most_instances
