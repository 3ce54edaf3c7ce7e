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

(* In the place of the number of a definition's or a function's code. *)
let code = max_int
let array count ty : Core.Ir.ty = Array (Size count, ty)

let number_of_form : Ir.argument -> int = function
  | Accumulator -> 0
  | Element -> 1
  | Same -> 2
  | Counter -> 3

(* What the loop gets for an argument, leaf by leaf: each as a hole, so with
   the type that the node's input has. *)
let holes (c : Context.t) node ~span request argument : Skeleton.hole list =
  let given =
    match argument.form with
    | Element -> array request.count argument.ty
    | Accumulator | Same | Counter -> argument.ty
  in
  List.map2
    (fun (leaf : Types.leaf) atom : Skeleton.hole ->
      { atom; local = argument.local; path = leaf.path; ty = leaf.leaf })
    (Types.layout c.types argument.ty).leaves
    (Leaves.atoms c.types node ~span given argument.value)

let unnamed span : Core.Ir.Local.t = { id = 0; name = ""; span }

(* Takes as many atoms for each type as it has leaves. *)
let split (c : Context.t) tys atoms =
  let take (values, atoms) ty =
    let count = List.length (Types.layout c.types ty).leaves in
    let own, others = Basis.Long_list.split_at count atoms in
    (Leaves.value c.types ty own :: values, others)
  in
  let values, _ = List.fold_left take ([], atoms) tys in
  List.rev values

(* A round that computes nothing needs no node if all that it gives is the
   same in all rounds, or an element of an array that is there. *)
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

(* The outputs of such a node get equations after all. *)
let define_outputs (c : Context.t) node ~span tys values =
  List.map2
    (fun ty value ->
      let copy (leaf : Types.leaf) atom = Node.define node Unnamed ~span leaf.leaf (Ir.Copy atom) in
      let leaves = (Types.layout c.types ty).leaves in
      Leaves.value c.types ty (List.map2 copy leaves (Leaves.atoms c.types node ~span ty value)))
    tys values

let run (p : Evaluator.position) targets request round =
  let { Evaluator.context = c; trail; node = caller; span; _ } = p in
  let walk = Skeleton.walk c.keys caller Holes in
  Skeleton.add_number walk code;
  Skeleton.add_text walk request.key;
  let form argument =
    Skeleton.add_number walk (number_of_form argument.form);
    Skeleton.add_number walk (Types.layout c.types argument.ty).id
  in
  List.iter form request.arguments;
  let result ty = Skeleton.add_number walk (Types.layout c.types ty).id in
  List.iter result request.final;
  List.iter result request.elements;
  List.iter
    (fun (a : Value.argument) -> Skeleton.add walk (unnamed span) a.ty a.value)
    request.captured;
  let captured = Skeleton.take_holes walk in
  let is_accumulator a = a.form = Ir.Accumulator in
  let accumulators, others = List.partition is_accumulator request.arguments in
  let holes_of = List.concat_map (holes c caller ~span request) in
  let accumulated = holes_of accumulators and given = holes_of others in
  let statics, same =
    match request.kind with Signal_function -> (captured, []) | Function -> ([], captured)
  in
  let inputs = accumulated @ same @ given in
  let results = request.final @ request.elements in
  let body trail node atoms =
    (* Statics come before inputs: what is captured is first or second. *)
    let before =
      match request.kind with Signal_function -> 0 | Function -> List.length accumulated
    in
    let is_captured i = i >= before && i < before + List.length captured in
    let own = List.filteri (fun i _ -> is_captured i) atoms in
    let rest = List.filteri (fun i _ -> not (is_captured i)) atoms in
    let copy = Skeleton.copy c.keys Holes own in
    let captured =
      List.map (fun (a : Value.argument) -> Skeleton.value copy a.ty a.value) request.captured
    in
    let arguments = split c (List.map (fun a -> a.ty) request.arguments) rest in
    let values = round { p with trail; node } captured arguments in
    let only_hands_on () =
      let changing =
        List.concat
          (List.map2
             (fun a value ->
               match a.form with
               | Accumulator | Counter -> Leaves.atoms c.types node ~span a.ty value
               | Element | Same -> [])
             request.arguments arguments)
      in
      let atoms ty value = Leaves.atoms c.types node ~span ty value in
      let outputs = List.concat (List.map2 atoms results values) in
      Node.size node = 0
      && (accumulators <> [] || List.exists (fun a -> List.mem a changing) outputs)
    in
    Value.Product
      (if Node.size node = 0 && only_hands_on () then define_outputs c node ~span results values
       else values)
  in
  let specialization =
    Specialization.find c trail
      {
        kind = request.kind;
        name = request.name;
        span;
        call = span;
        result = Tuple results;
        names = Destructuring.none;
        statics;
        inputs;
        key = Skeleton.key walk;
      }
      body
  in
  let leaf_types tys =
    List.concat_map
      (fun ty -> List.map (fun (l : Types.leaf) -> l.leaf) (Types.layout c.types ty).leaves)
      tys
  in
  let element_types = leaf_types request.elements in
  let actual (hole : Skeleton.hole) = hole.atom in
  let forms =
    List.concat_map (fun a -> List.map (fun _ -> a.form) (Types.layout c.types a.ty).leaves)
  in
  let arguments = forms accumulators @ List.map (fun _ -> Ir.Same) same @ forms others in
  let tys = request.final @ List.map (array request.count) request.elements in
  let loop node =
    let arrays = List.map (fun ty : Ir.ty -> Array (request.count, ty)) element_types in
    let targets =
      List.concat
        (List.map2
           (fun target ty -> Node.leaves target (Types.layout c.types ty).leaves)
           targets tys)
    in
    Node.call caller targets ~callee:request.name ~node ~span
      ~loop:{ count = request.count; arguments }
      ~statics:(List.map actual statics) ~inputs:(List.map actual inputs)
      (leaf_types request.final @ arrays)
  in
  let atoms =
    match specialization.callee with
    | Node node -> loop node
    | Nothing parameters -> (
        let formed =
          List.map2
            (fun p (form, atom) -> (p, form, atom))
            parameters
            (List.map (fun hole -> (Ir.Same, actual hole)) statics
            @ List.combine arguments (List.map actual inputs))
        in
        match
          without_node caller ~span ~count:request.count formed specialization.outputs element_types
        with
        | Some atoms -> atoms
        | None -> Diagnostic.bug ~stage:"Specialize.Loop" "a round without equations")
  in
  split c tys atoms
