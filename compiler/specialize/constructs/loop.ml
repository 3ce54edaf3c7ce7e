open Basis
module Ir = Flow.Ir

type argument = { form : Ir.argument; ty : Core.Ir.ty; value : Value.t; local : Core.Ir.Local.t }

type request = {
  name : string;
  kind : Ir.kind;
  count : int;
  key : string;
  captured : Value.argument list;
  arguments : argument list;
  final : Core.Ir.ty list;
  elements : Core.Ir.ty list;
}

(* Keys contain this number in place of the code number of a definition or function. *)
let code = max_int
let array count ty : Core.Ir.ty = Array (Size count, ty)

let number_of_form : Ir.argument -> int = function
  | Accumulator -> 0
  | Element -> 1
  | Same -> 2
  | Counter -> 3

(* Replaces the leaves of an argument with holes, which have the types of the node's inputs. *)
let holes (c : Context.t) node ~span request argument : Specialization_key.hole list =
  let given =
    match argument.form with
    | Element -> array request.count argument.ty
    | Accumulator | Same | Counter -> argument.ty
  in
  List.map2
    (fun (leaf : Types.leaf) atom : Specialization_key.hole ->
      { atom; local = argument.local; path = Types.path_name leaf; ty = leaf.leaf })
    (Types.layout c.types argument.ty).leaves
    (Leaves.atoms c.types node ~span given argument.value)

let unnamed span : Core.Ir.Local.t = { id = 0; name = ""; span }

(* Splits the atoms into values of these types. *)
let split (c : Context.t) tys atoms =
  let take (values, atoms) ty =
    let count = List.length (Types.layout c.types ty).leaves in
    let own, others = Basis.Long_list.split_at count atoms in
    (Leaves.value c.types ty own :: values, others)
  in
  let values, _ = List.fold_left take ([], atoms) tys in
  List.rev values

(* An iteration without equations needs no node if each of its outputs is either the same in all
   iterations or an element of an existing array. *)
let without_node caller ~span ~count parameters outputs tys =
  let given (atom : Ir.atom) =
    match atom with
    | Bool _ | Int _ | Float _ -> Some (Ir.Same, atom)
    | Signal s ->
        List.find_map
          (fun ((p : Ir.signal), form, atom) -> if p.id = s.id then Some (form, atom) else None)
          parameters
  in
  let output atom ty =
    match given atom with
    | Some (Ir.Element, array) -> Some array
    | Some (Same, atom) ->
        Some (Node.define caller Unnamed ~span (Ir.Array (count, ty)) (Fill atom))
    | Some ((Accumulator | Counter), _) | None -> None
  in
  let found = List.map2 output outputs tys in
  if List.mem None found then None else Some (List.filter_map Fun.id found)

(* Adds a copy equation for each output of an iteration that has no equations. *)
let define_outputs (c : Context.t) node ~span tys values =
  List.map2
    (fun ty value ->
      let copy (leaf : Types.leaf) atom = Node.define node Unnamed ~span leaf.leaf (Ir.Copy atom) in
      let leaves = (Types.layout c.types ty).leaves in
      Leaves.value c.types ty (List.map2 copy leaves (Leaves.atoms c.types node ~span ty value)))
    tys values

(* The key of the node, and the holes of the captured values. *)
let key_of (c : Context.t) node ~span request =
  let walk = Specialization_key.walk c.keys node Holes in
  let layout ty = Specialization_key.add_number walk (Types.layout c.types ty).id in
  Specialization_key.add_number walk code;
  Specialization_key.add_text walk request.key;
  List.iter
    (fun argument ->
      Specialization_key.add_number walk (number_of_form argument.form);
      layout argument.ty)
    request.arguments;
  List.iter layout request.final;
  List.iter layout request.elements;
  List.iter
    (fun (a : Value.argument) -> Specialization_key.add walk (unnamed span) a.ty a.value)
    request.captured;
  let captured = Specialization_key.take_holes walk in
  (Specialization_key.key walk, captured)

(* The holes that become inputs of the node. The order is: accumulators, captured values that are
   the same in all iterations, other arguments. In a signal function, captured values are static
   instead. *)
type inputs = {
  accumulated : Specialization_key.hole list;
  same : Specialization_key.hole list;
  given : Specialization_key.hole list;
  statics : Specialization_key.hole list;
  forms : Ir.argument list;  (** the form of each input *)
}

let is_accumulator a = a.form = Ir.Accumulator

let inputs_of (c : Context.t) caller ~span request captured =
  let accumulators, others = List.partition is_accumulator request.arguments in
  let statics, same =
    match request.kind with Signal_function -> (captured, []) | Function -> ([], captured)
  in
  let holes_of = List.concat_map (holes c caller ~span request) in
  let accumulated = holes_of accumulators in
  let given = holes_of others in
  let forms_of =
    List.concat_map (fun a -> List.map (fun _ -> a.form) (Types.layout c.types a.ty).leaves)
  in
  {
    accumulated;
    same;
    given;
    statics;
    forms = forms_of accumulators @ List.map (fun _ -> Ir.Same) same @ forms_of others;
  }

let holes_of_inputs inputs = inputs.accumulated @ inputs.same @ inputs.given

(* Splits the node's atoms into the captured ones and the arguments. In a signal function, the
   captured values are static, so they come first; in a function, they follow the accumulators. *)
let split_captured request inputs atoms =
  let before =
    match request.kind with Signal_function -> 0 | Function -> List.length inputs.accumulated
  in
  let count = List.length inputs.same + List.length inputs.statics in
  let is_captured i = i >= before && i < before + count in
  ( List.filteri (fun i _ -> is_captured i) atoms,
    List.filteri (fun i _ -> not (is_captured i)) atoms )

(* Whether an iteration that has no equations must copy a value to its outputs. In a loop with
   accumulators, it must copy every value; in any other loop, only the index. *)
let only_hands_on (c : Context.t) node ~span request arguments results values =
  let atoms ty value = Leaves.atoms c.types node ~span ty value in
  let changing_atoms a value =
    match a.form with Ir.Accumulator | Counter -> atoms a.ty value | Element | Same -> []
  in
  let changing = List.concat (List.map2 changing_atoms request.arguments arguments) in
  let outputs = List.concat (List.map2 atoms results values) in
  Node.size node = 0
  && (List.exists is_accumulator request.arguments
     || List.exists (fun a -> List.mem a changing) outputs)

(* The body of the node: one iteration. *)
let body (p : Evaluator.position) request inputs round trail node atoms =
  let { Evaluator.context = c; span; _ } = p in
  let own, rest = split_captured request inputs atoms in
  let copy = Specialization_key.copy c.keys Holes own in
  let captured =
    List.map
      (fun (a : Value.argument) -> Specialization_key.value copy a.ty a.value)
      request.captured
  in
  let arguments = split c (List.map (fun a -> a.ty) request.arguments) rest in
  let values = round { p with trail; node } captured arguments in
  let results = request.final @ request.elements in
  let must_copy =
    Node.size node = 0 && only_hands_on c node ~span request arguments results values
  in
  let outputs = if must_copy then define_outputs c node ~span results values else values in
  Value.Product (Array.of_list outputs)

let leaf_types (c : Context.t) tys =
  List.concat_map
    (fun ty -> List.map (fun (l : Types.leaf) -> l.leaf) (Types.layout c.types ty).leaves)
    tys

let result_types request = request.final @ List.map (array request.count) request.elements
let actual (hole : Specialization_key.hole) = hole.atom

(* The instance that runs the node for each element. *)
let call (p : Evaluator.position) targets request inputs node =
  let { Evaluator.context = c; node = caller; span; _ } = p in
  let arrays =
    List.map (fun ty : Ir.ty -> Array (request.count, ty)) (leaf_types c request.elements)
  in
  let targets =
    List.concat
      (List.map2
         (fun target ty -> Node.leaves target (Types.layout c.types ty).leaves)
         targets (result_types request))
  in
  Node.call caller targets ~callee:request.name ~node ~span
    ~loop:{ count = request.count; arguments = inputs.forms }
    ~statics:(List.map actual inputs.statics)
    ~inputs:(List.map actual (holes_of_inputs inputs))
    (leaf_types c request.final @ arrays)

(* The results of a loop whose iterations have no equations and therefore need no node. *)
let without_call (p : Evaluator.position) request inputs parameters outputs =
  let { Evaluator.context = c; node = caller; span; _ } = p in
  let given =
    List.map (fun hole -> (Ir.Same, actual hole)) inputs.statics
    @ List.combine inputs.forms (List.map actual (holes_of_inputs inputs))
  in
  let formed = List.map2 (fun p (form, atom) -> (p, form, atom)) parameters given in
  let elements = leaf_types c request.elements in
  match without_node caller ~span ~count:request.count formed outputs elements with
  | Some atoms -> atoms
  | None -> Diagnostic.bug ~stage:"Specialize.Loop" "an iteration without equations needs a node"

let run (p : Evaluator.position) targets request round =
  let { Evaluator.context = c; trail; node = caller; span; _ } = p in
  let key, captured = key_of c caller ~span request in
  let inputs = inputs_of c caller ~span request captured in
  let specialization =
    Specialization.find c trail
      {
        kind = request.kind;
        name = request.name;
        span;
        call = span;
        result = Tuple (request.final @ request.elements);
        names = Destructuring.none;
        statics = inputs.statics;
        inputs = holes_of_inputs inputs;
        key;
      }
      (body p request inputs round)
  in
  let atoms =
    match specialization.callee with
    | Node node -> call p targets request inputs node
    | Nothing parameters -> without_call p request inputs parameters specialization.outputs
  in
  split c (result_types request) atoms
