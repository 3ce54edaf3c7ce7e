open Basis

(* What an element is, but for the signals it reads: these are its arguments. *)
type label =
  | Parameter of int  (** its signal's id: each is different; outputs of a machine and results of C too *)
  | Equation of Ir.ty * Ir.rhs * constant list  (** the operands in [rhs] are blank *)
  | Instance of int * Ir.loop option * constant list
  | Output of int  (** of the instance that is the only argument *)

(* An operand's place in a label; floats by their bits. *)
and constant =
  | Argument
  | Bool of bool
  | Int of int32
  | Float of int64

let constant : Ir.atom -> constant = function
  | Signal _ -> Argument
  | Bool b -> Bool b
  | Int n -> Int n
  | Float x -> Float (Int64.bits_of_float x)

let blank : Ir.atom = Bool false

(* Bit for bit the same with its arguments exchanged. Not so [Minimum] and
   [Maximum], which tell 0 from -0. *)
let is_commutative : Ir.operator -> bool = function
  | Add | Multiply | Equal | And | Or | Elementary Hypot -> true
  | Subtract | Negate | Absolute | Signum | Less | Less_equal | Minimum | Maximum | Divide | Pow
  | Elementary (Sqrt | Exp | Log | Sin | Cos | Tan | Asin | Acos | Atan | Atan2)
  | Div | Mod | To_float | Round | Floor | Ceiling | Truncate | Not ->
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
  | Replace _ | Delay _ | Time _ | Ticks _
  | Integral _ | Derivative _ ->
      rhs

(* The elements of a node in order, each with its label and the signals it
   reads; an output reads its instance instead. *)
type argument = Signal of Ir.signal | Element of int

type elements = {
  mutable labels : label list;
  mutable arguments : argument list list;  (** both: last first *)
  mutable count : int;
  of_signal : int Int_table.t;
}

let add elements label arguments =
  elements.labels <- label :: elements.labels;
  elements.arguments <- arguments :: elements.arguments;
  elements.count <- elements.count + 1;
  elements.count - 1

let signals atoms = Long_list.map (fun s -> Signal s) (Operands.signals atoms)

let elements_of (node : Ir.node) =
  let elements = { labels = []; arguments = []; count = 0; of_signal = Int_table.create 64 } in
  let define (s : Ir.signal) element = Int_table.replace elements.of_signal s.id element in
  let parameter (s : Ir.signal) = define s (add elements (Parameter s.id) []) in
  List.iter parameter node.statics;
  List.iter parameter node.inputs;
  List.iter
    (fun (e : Ir.equation) ->
      let rhs = normal e.rhs in
      let operands = Operands.all rhs in
      let label =
        Equation (e.defines.ty, Operands.map (fun _ -> blank) rhs, Long_list.map constant operands)
      in
      define e.defines (add elements label (signals operands)))
    node.equations;
  let instance (i : Ir.instance) =
    let atoms = List.rev_append (List.rev i.statics) i.inputs in
    let element = add elements (Instance (i.node, i.loop, Long_list.map constant atoms)) (signals atoms) in
    List.iteri (fun k s -> define s (add elements (Output k) [ Element element ])) i.outputs;
    element
  in
  let instances = Long_list.map instance node.instances in
  Option.iter (fun (m : Ir.machine) -> List.iter parameter m.outputs) node.machine;
  Option.iter (fun (f : Ir.foreign) -> List.iter parameter f.results) node.foreign;
  (elements, instances)

(* Equal ones get the same number. A parameter is like nothing else, so it need
   not be looked up. *)
let numbered labels =
  let numbers = Hashtbl.create 64 and count = ref 0 in
  let fresh () =
    incr count;
    !count
  in
  let number label =
    match label with
    | Parameter _ -> fresh ()
    | Equation _ | Instance _ | Output _ -> (
        match Hashtbl.find_opt numbers label with
        | Some n -> n
        | None ->
            let n = fresh () in
            Hashtbl.add numbers label n;
            n)
  in
  Array.of_list (Long_list.map number labels)

(* For each signal that equals an earlier one that one, and the instances that stay. *)
let shared (node : Ir.node) =
  let elements, instances = elements_of node in
  let element = function
    | Element e -> e
    | Signal s -> Int_table.find elements.of_signal s.id
  in
  let arguments =
    Array.of_list
      (List.rev_map
         (fun arguments -> Array.of_list (Long_list.map element arguments))
         elements.arguments)
  in
  let class_of = Partition.congruence ~labels:(numbered (List.rev elements.labels)) ~arguments in
  let substitution = Substitution.create () in
  let first = Array.make elements.count None in
  let visit (s : Ir.signal) =
    let c = class_of.(element (Signal s)) in
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

let equal (node : Ir.node) = Substitution.atom (fst (shared node))

let node (node : Ir.node) =
  let substitution, instances = shared node in
  Substitution.node substitution { node with instances }

let program (program : Ir.program) = { program with nodes = Array.map node program.nodes }
