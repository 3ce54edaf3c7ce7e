open Basis

let limit = 1_000
let beyond = limit + 1

type t = {
  program : Ir.program;
  carries : bool array;  (** for each sum, whether its values can contain marks *)
  known : (int * int list, int list * int list list) Hashtbl.t;
      (** cached bounds for a node's outputs and the arguments of its transitions, keyed by the node
          and the bounds for its static parameters and inputs *)
}

(* Whether the sum is the type of a slot for a mark. Checks the module, because programs may define
   their own [Mark]. *)
let slot (program : Ir.program) (sum : Ir.sum) =
  String.equal sum.name "Event Mark"
  &&
  match sum.constructors with
  | [ _; { fields = [ (_, Leaf (Sum mark)) ]; _ } ] ->
      String.equal program.sums.(mark).module_ "Display"
  | _ -> false

let is_drawing (program : Ir.program) : Ir.ty -> bool = function
  | Array (_, Sum k) -> slot program program.sums.(k)
  | Bool | Int | Float | Sum _ | Array _ | Foreign _ -> false

(* For each sum, whether its values can contain marks, directly or inside other sums. *)
let carrying (program : Ir.program) =
  let carries = Array.map (slot program) program.sums in
  let rec ty : Ir.ty -> bool = function
    | Sum k -> carries.(k)
    | Array (_, element) -> ty element
    | Bool | Int | Float | Foreign _ -> false
  in
  let rec shape : Ir.shape -> bool = function
    | Leaf leaf -> ty leaf
    | Product { parts; _ } -> List.exists (fun (_, part) -> shape part) parts
    | Repeated (_, element) -> shape element
  in
  let constructor (c : Ir.sum_constructor) = List.exists (fun (_, field) -> shape field) c.fields in
  let rec settle () =
    let grown = ref false in
    Array.iteri
      (fun k (sum : Ir.sum) ->
        if (not carries.(k)) && List.exists constructor sum.constructors then (
          carries.(k) <- true;
          grown := true))
      program.sums;
    if !grown then settle ()
  in
  settle ();
  carries

let rec can_carry t : Ir.ty -> bool = function
  | Sum k -> t.carries.(k)
  | Array (_, element) -> can_carry t element
  | Bool | Int | Float | Foreign _ -> false

let join a b = List.map2 max a b

(* The bounds for a node, computed as a fixpoint, starting from no marks. *)
let rec node t index bounds =
  let key = (index, bounds) in
  match Hashtbl.find_opt t.known key with
  | Some known -> known
  | None ->
      let found = settle t t.program.nodes.(index) bounds in
      Hashtbl.replace t.known key found;
      found

and settle t (n : Ir.node) bounds =
  let table = Int_table.create 16 in
  let grown = ref true in
  let atom : Ir.atom -> int = function
    | Signal s -> Option.value (Int_table.find_opt table s.id) ~default:0
    | Bool _ | Int _ | Float _ -> 0
  in
  let atoms = List.map atom in
  let set (s : Ir.signal) bound =
    let bound = min beyond bound in
    if can_carry t s.ty && bound > atom (Signal s) then (
      Int_table.replace table s.id bound;
      grown := true)
  in
  let highest rhs = List.fold_left (fun most a -> max most (atom a)) 0 (Operands.all rhs) in
  let equation (e : Ir.equation) =
    match e.rhs with
    | Replace { array; value; index = _ } when is_drawing t.program e.defines.ty ->
        set e.defines (atom array + max 1 (atom value))
    | rhs -> set e.defines (highest rhs)
  in
  let instance (i : Ir.instance) =
    let statics = atoms i.statics and inputs = atoms i.inputs in
    let run inputs = fst (node t i.node (statics @ inputs)) in
    let outputs = match i.loop with None -> run inputs | Some loop -> rounds ~run loop inputs in
    List.iter2 set i.outputs outputs
  in
  let machine (m : Ir.machine) = List.iter2 set m.outputs (running t m ~atoms) in
  List.iter2 set (n.statics @ n.inputs) bounds;
  while !grown do
    grown := false;
    List.iter (fun (e : Ir.equation) -> if can_carry t e.defines.ty then equation e) n.equations;
    List.iter instance n.instances;
    Option.iter machine n.machine
  done;
  let handed_on (transition : Ir.transition) = atoms transition.arguments in
  (List.map (fun (_, a) -> atom a) n.outputs, List.map handed_on n.transitions)

(* The outputs of a loop: the final values of accumulators and, for other outputs, the maximum over
   all iterations. *)
and rounds ~run (loop : Ir.loop) inputs =
  let accumulators = List.length (List.filter (fun a -> a = Ir.Accumulator) loop.arguments) in
  let rec go k inputs before =
    let outputs = run inputs in
    let next = List.mapi (fun i b -> if i < accumulators then List.nth outputs i else b) inputs in
    let all = match before with None -> outputs | Some before -> join before outputs in
    if k + 1 >= loop.count || next = inputs then
      List.mapi (fun i b -> if i < accumulators then List.nth outputs i else b) all
    else go (k + 1) next (Some all)
  in
  go 0 inputs None

and running t (m : Ir.machine) ~atoms =
  let modes = Array.of_list m.modes in
  let given = Array.map (fun mode -> List.map (fun _ -> 0) t.program.nodes.(mode).statics) modes in
  let grown = ref true in
  let hand target arguments =
    let joined = join given.(target) arguments in
    if joined <> given.(target) then (
      given.(target) <- joined;
      grown := true)
  in
  List.iter
    (fun (transition : Ir.transition) -> hand transition.target (atoms transition.arguments))
    (m.start @ m.controls);
  let inputs = atoms m.inputs in
  let outputs = ref (List.map (fun _ -> 0) m.outputs) in
  while !grown do
    grown := false;
    Array.iteri
      (fun k mode ->
        let found, handed_on = node t mode (given.(k) @ inputs) in
        outputs := join !outputs found;
        List.iter2
          (fun (transition : Ir.transition) arguments -> hand transition.target arguments)
          t.program.nodes.(mode).transitions handed_on)
      modes
  done;
  !outputs

let most (program : Ir.program) =
  let t = { program; carries = carrying program; known = Hashtbl.create 64 } in
  let root = Array.length program.nodes - 1 in
  let inputs = List.map (fun _ -> 0) program.nodes.(root).inputs in
  let outputs, _ = node t root inputs in
  let most = List.fold_left max 0 outputs in
  if most > limit then None else Some most
