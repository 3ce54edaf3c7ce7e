open Basis

(* Bit for bit the same with its arguments exchanged. Not so [Minimum] and
   [Maximum], which tell 0 from -0. *)
let is_commutative : Ir.operator -> bool = function
  | Add | Multiply | Equal | And | Or | Elementary Hypot | Bitwise (Bit_and | Bit_or | Bit_xor) ->
      true
  | Subtract | Negate | Absolute | Signum | Less | Less_equal | Minimum | Maximum | Divide | Pow
  | Elementary (Sqrt | Floor_float | Ceiling_float | Exp | Log | Sin | Cos | Tan | Asin | Acos | Atan | Atan2)
  | Div | Mod | Bitwise (Shift_left | Shift_right) | To_float | Round | Floor | Ceiling | Truncate | Not ->
      false

let compare_atoms (a : Ir.atom) (b : Ir.atom) =
  match (a, b) with
  | Signal a, Signal b -> Int.compare a.id b.id
  | Signal _, (Bool _ | Int _ | Float _) -> -1
  | (Bool _ | Int _ | Float _), Signal _ -> 1
  | (Bool _ | Int _ | Float _), (Bool _ | Int _ | Float _) -> 0

let normal (rhs : Ir.rhs) : Ir.rhs =
  match rhs with
  | Op (operator, arguments) when is_commutative operator ->
      Op (operator, List.stable_sort compare_atoms arguments)
  | Op _ | Copy _ | If _ | Construct _ | Is_constructor _ | Payload _ | Elements _ | Absent | Fill _ | Index _ | At _
  | Replace _ | Delay _ | Time _ | Step_time | Ticks _
  | Integral _ | Derivative _ ->
      rhs

(* The elements of a node in order, each with what it reads: signals or, an output,
   its instance. *)
type reads = Operands of Ir.atom list | Element of int

type elements = {
  mutable labels : Label.t option list;  (** [None]: like nothing else *)
  mutable reads : reads list;  (** both: last first *)
  mutable count : int;
  of_signal : int Int_table.t;
}

let add elements label reads =
  elements.labels <- label :: elements.labels;
  elements.reads <- reads :: elements.reads;
  elements.count <- elements.count + 1;
  elements.count - 1

let elements_of (node : Ir.node) =
  let elements = { labels = []; reads = []; count = 0; of_signal = Int_table.create 64 } in
  let define (s : Ir.signal) element = Int_table.replace elements.of_signal s.id element in
  let add_label label reads = add elements (Some label) reads in
  (* Outputs of a machine and results of C are like nothing else too. *)
  let parameter s = define s (add elements None (Operands [])) in
  List.iter parameter node.statics;
  List.iter parameter node.inputs;
  List.iter
    (fun (e : Ir.equation) ->
      let label = Label.Equation (e.defines.ty, normal e.rhs) in
      define e.defines (add_label label (Operands (Label.operands label))))
    node.equations;
  let instance (i : Ir.instance) =
    let label = Label.Instance i in
    let element = add_label label (Operands (Label.operands label)) in
    List.iteri (fun k s -> define s (add_label (Output k) (Element element))) i.outputs;
    element
  in
  let instances = Long_list.map instance node.instances in
  Option.iter (fun (m : Ir.machine) -> List.iter parameter m.outputs) node.machine;
  Option.iter (fun (f : Ir.foreign) -> List.iter parameter f.results) node.foreign;
  (elements, instances)

let arguments elements =
  let element (s : Ir.signal) = Int_table.find elements.of_signal s.id in
  let of_reads = function
    | Element e -> [| e |]
    | Operands atoms -> (
        match Operands.signals atoms with
        | [] -> [||]
        | [ s ] -> [| element s |]
        | [ s; s' ] -> [| element s; element s' |]
        | signals -> Array.of_list (Long_list.map element signals))
  in
  Array.of_list (List.rev_map of_reads elements.reads)

(* Numbers from 0, equal for equal labels, and how many there are. *)
let number labels =
  let numbers = Label.Table.create 64 and distinct = ref 0 in
  let fresh () =
    incr distinct;
    !distinct - 1
  in
  let number label =
    match Label.Table.find_opt numbers label with
    | Some n -> n
    | None ->
        let n = fresh () in
        Label.Table.add numbers label n;
        n
  in
  let numbered = Array.map (function Some label -> number label | None -> fresh ()) labels in
  (numbered, !distinct)

(* Of the node's elements: for each signal that equals an earlier one that one, and the
   instances that stay. *)
let classes (node : Ir.node) elements ~labels ~arguments instances =
  let labels, distinct = number labels in
  let class_of = Partition.congruence ~distinct ~labels ~arguments in
  let substitution = Substitution.create () in
  let first = Array.make elements.count None in
  let visit (s : Ir.signal) =
    let c = class_of.(Int_table.find elements.of_signal s.id) in
    match first.(c) with
    | None -> first.(c) <- Some s
    | Some representative -> Substitution.replace substitution s (Ir.Signal representative)
  in
  List.iter (fun (e : Ir.equation) -> visit e.defines) node.equations;
  List.iter (fun (i : Ir.instance) -> List.iter visit i.outputs) node.instances;
  let kept =
    List.fold_left2
      (fun kept (i : Ir.instance) element -> if class_of.(element) = element then i :: kept else kept)
      [] node.instances instances
  in
  (substitution, List.rev kept)

let shared (node : Ir.node) =
  let elements, instances = elements_of node in
  let labels = Array.of_list (List.rev elements.labels) and arguments = arguments elements in
  classes node elements ~labels ~arguments instances

let node (node : Ir.node) =
  let substitution, instances = shared node in
  if Substitution.is_empty substitution && List.compare_lengths instances node.instances = 0 then node
  else Substitution.node substitution { node with instances }

let program program = Each_node.program (fun ~fresh:_ -> node) program
