open Basis
module Ir = Flow.Ir

let bug format = Diagnostic.bug ~stage:"Specialize.Leaves" format

(* The leaves of a value of this type. *)
let rec atoms table node ~span ty value = List.rev (add_atoms table node ~span ty value [])

(* Prepends the leaves to [rest], in reverse order. *)
and add_atoms table node ~span ty (value : Value.t) rest =
  let layout = Types.layout table ty in
  match (value, layout.kind) with
  | Atom atom, (Scalar | Sum _) -> atom :: rest
  | Product values, Product parts ->
      List.fold_left2
        (fun rest (part : Types.part) value -> add_atoms table node ~span part.ty value rest)
        rest parts (Array.to_list values)
  | Constructed { constructor; arguments }, Sum fields ->
      let payload =
        List.fold_left2
          (fun rest (part : Types.part) value -> add_atoms table node ~span part.ty value rest)
          [] fields.(constructor) arguments
      in
      construct_leaf node ~span layout constructor (List.rev payload) :: rest
  | Array atoms, Array _ -> List.rev_append atoms rest
  | Elements values, Array (_, element) ->
      let rows = List.rev_map (atoms table node ~span element) values in
      List.rev_append (columns node ~span layout.leaves rows) rest
  | Unspecified, (Scalar | Product _ | Sum _ | Array _) ->
      List.rev_append (zeros table node ~span ty) rest
  | ( ( Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Function _
      | Signal_function _ | Primitive _ | Choice _ | Program _ | Unspecified ),
      (Scalar | Product _ | Sum _ | Array _ | Opaque) ) ->
      bug "a value of type %s has no leaves" (Types.to_string ty)

(* One array for each leaf. Each row consists of the leaves of one element; the rows are in reverse
   order. *)
and columns node ~span (leaves : Types.leaf list) rows =
  match leaves with
  | [] -> []
  | leaf :: others ->
      let column = List.rev_map List.hd rows in
      let array = Node.define node Unnamed ~span leaf.leaf (Elements column) in
      array :: columns node ~span others (List.map List.tl rows)

and construct_leaf node ~span (layout : Types.layout) constructor payload =
  match layout.leaves with
  | [ { leaf; _ } ] -> Node.define node Unnamed ~span leaf (Construct { constructor; payload })
  | [] | _ :: _ :: _ -> bug "a sum does not have exactly one leaf"

(* The leaves of an arbitrary value of the type, in place of a value that is never used. *)
and zeros table node ~span ty : Ir.atom list =
  let layout = Types.layout table ty in
  match (layout.kind, layout.leaves) with
  | Scalar, [ { leaf = Bool; _ } ] -> [ Bool false ]
  | Scalar, [ { leaf = Int; _ } ] -> [ Int 0l ]
  | Scalar, [ { leaf = Float; _ } ] -> [ Float 0. ]
  | Scalar, [ { leaf = Foreign _ as leaf; _ } ] -> [ Node.define node Unnamed ~span leaf Absent ]
  | Scalar, [ { leaf = Sum _ as leaf; _ } ] ->
      [ Node.define node Unnamed ~span leaf (Construct { constructor = 0; payload = [] }) ]
  | Product parts, _ -> zeros_of_parts table node ~span parts
  | Sum fields, _ ->
      [ construct_leaf node ~span layout 0 (zeros_of_parts table node ~span fields.(0)) ]
  | Array (_, element), leaves ->
      List.map2
        (fun (leaf : Types.leaf) zero -> Node.define node Unnamed ~span leaf.leaf (Fill zero))
        leaves (zeros table node ~span element)
  | (Scalar | Opaque), _ -> bug "the type %s has no zero" (Types.to_string ty)

and zeros_of_parts table node ~span parts =
  List.concat_map (fun (part : Types.part) -> zeros table node ~span part.ty) parts

let rec known table ty (value : Value.t) : Ir.atom option list =
  let layout = Types.layout table ty in
  match (value, layout.kind) with
  | Atom atom, _ -> [ Some atom ]
  | Array atoms, _ -> List.map Option.some atoms
  | Product values, Product parts ->
      List.concat
        (List.map2
           (fun (part : Types.part) value -> known table part.ty value)
           parts (Array.to_list values))
  | ( ( Text _ | Product _ | Constructed _ | Elements _ | Function _ | Signal_function _
      | Primitive _ | Choice _ | Program _ | Unspecified ),
      (Scalar | Product _ | Sum _ | Array _ | Opaque) ) ->
      List.map (fun _ -> None) layout.leaves

let atom table node ~span ty value =
  match atoms table node ~span ty value with
  | [ atom ] -> atom
  | [] | _ :: _ :: _ -> bug "a value of type %s does not have exactly one leaf" (Types.to_string ty)

let value table ty atoms =
  let rec take ty atoms : Value.t * Ir.atom list =
    match ((Types.layout table ty).kind, atoms) with
    | (Scalar | Sum _), atom :: others -> (Atom atom, others)
    | Product parts, _ ->
        let values, others =
          List.fold_left
            (fun (values, atoms) (part : Types.part) ->
              let value, others = take part.ty atoms in
              (value :: values, others))
            ([], atoms) parts
        in
        (Product (Array.of_list (List.rev values)), others)
    | Array _, _ ->
        let rec split own count atoms =
          match atoms with
          | atom :: others when count > 0 -> split (atom :: own) (count - 1) others
          | [] | _ :: _ -> (Value.Array (List.rev own), atoms)
        in
        split [] (List.length (Types.layout table ty).leaves) atoms
    | (Scalar | Sum _), [] | Opaque, _ ->
        bug "a value of type %s cannot be built from leaves" (Types.to_string ty)
  in
  fst (take ty atoms)

let of_leaves = value

let rec component (value : Value.t) index : Value.t =
  match value with
  | Product values -> values.(index)
  | Choice { condition; then_; else_ } ->
      Choice { condition; then_ = component then_ index; else_ = component else_ index }
  | Unspecified -> Unspecified
  | Atom _ | Text _ | Constructed _ | Array _ | Elements _ | Function _ | Signal_function _
  | Primitive _ | Program _ ->
      bug "component %d of a value that is not a product" index

let rec is_constructor table node target ~span ty (value : Value.t) index : Ir.atom =
  match value with
  | Product _ -> Bool true
  | Constructed { constructor; _ } -> Bool (constructor = index)
  | Atom atom -> Node.define node target ~span Bool (Is_constructor (atom, index))
  | Choice { condition; then_; else_ } -> (
      let test value = is_constructor table node Node.Unnamed ~span ty value index in
      let test_then = test then_ in
      match (test_then, test else_) with
      | Bool a, Bool b when a = b -> Bool a
      | then_, else_ -> Node.define node target ~span Bool (If { condition; then_; else_ }))
  | Unspecified -> Bool false
  | Text _ | Array _ | Elements _ | Function _ | Signal_function _ | Primitive _ | Program _ ->
      bug "a value of type %s has no constructor" (Types.to_string ty)

(* Keeps the condition even if both leaves are equal, because the causality check must see that the
   result depends on the condition. {!Flow.Simplify} removes unnecessary choices later. *)
let rec select table node target ~span ty condition (a : Value.t) (b : Value.t) : Value.t =
  let layout = Types.layout table ty in
  if layout.first_order then
    let choose target (leaf : Types.leaf) (a, b) : Ir.atom =
      Node.define node target ~span leaf.leaf (If { condition; then_ = a; else_ = b })
    in
    let of_a = atoms table node ~span ty a in
    let pairs = List.combine of_a (atoms table node ~span ty b) in
    let chosen =
      List.map2
        (fun (target, leaf) pair -> choose target leaf pair)
        (List.combine (Node.leaves target layout.leaves) layout.leaves)
        pairs
    in
    value table ty chosen
  else if a == b then a
  else
    match (layout.kind, a, b) with
    | _, Unspecified, other | _, other, Unspecified -> other
    | Product parts, _, _ ->
        let targets = Node.parts target table parts in
        let choose i (part : Types.part) target =
          select table node target ~span part.ty condition (component a i) (component b i)
        in
        let choose_target i (part, target) = choose i part target in
        Product (Array.of_list (List.mapi choose_target (List.combine parts targets)))
    | Array (_, element), Elements of_a, Elements of_b ->
        Elements (List.map2 (select table node Node.Unnamed ~span element condition) of_a of_b)
    | (Scalar | Sum _ | Array _ | Opaque), _, _ -> Choice { condition; then_ = a; else_ = b }

let rec payload table node target ~span ty (value : Value.t) ~constructor ~field : Value.t =
  let layout = Types.layout table ty in
  match (value, layout.kind) with
  | Product values, _ -> values.(field)
  | Constructed known, _ ->
      if known.constructor = constructor then List.nth known.arguments field else Unspecified
  | Atom atom, Sum fields ->
      payload_of_leaf table node target ~span fields.(constructor) atom ~constructor ~field
  | Choice { condition; then_; else_ }, Sum fields ->
      let part = List.nth fields.(constructor) field in
      let of_branch value = payload table node Node.Unnamed ~span ty value ~constructor ~field in
      let then_ = of_branch then_ in
      select table node target ~span part.ty condition then_ (of_branch else_)
  | Unspecified, _ -> Unspecified
  | ( ( Atom _ | Text _ | Array _ | Elements _ | Function _ | Signal_function _ | Primitive _
      | Choice _ | Program _ ),
      (Scalar | Product _ | Sum _ | Array _ | Opaque) ) ->
      bug "a value of type %s has no payload" (Types.to_string ty)

and payload_of_leaf table node target ~span fields atom ~constructor ~field =
  let count (part : Types.part) = List.length (Types.layout table part.ty).leaves in
  let rec find first index fields =
    match fields with
    | [] -> bug "constructor %d has no field %d" constructor field
    | (part : Types.part) :: _ when index = 0 -> (first, part)
    | part :: others -> find (first + count part) (index - 1) others
  in
  let first, part = find 0 field fields in
  let leaves = (Types.layout table part.ty).leaves in
  let extract i (target, (leaf : Types.leaf)) =
    Node.define node target ~span leaf.leaf
      (Payload { value = atom; constructor; leaf = first + i })
  in
  value table part.ty (List.mapi extract (List.combine (Node.leaves target leaves) leaves))

let rec element table node target ~span ty (value : Value.t) k : Value.t =
  match (value, (Types.layout table ty).kind) with
  | Elements values, _ -> List.nth values k
  | Array atoms, Array (_, element) ->
      let leaves = (Types.layout table element).leaves in
      let take (target, (leaf : Types.leaf)) array =
        Node.define node target ~span leaf.leaf (Index (array, k))
      in
      let targets = List.combine (Node.leaves target leaves) leaves in
      of_leaves table element (List.map2 take targets atoms)
  | Choice { condition; then_; else_ }, Array (_, ty_of_element) ->
      let of_branch value = element table node Node.Unnamed ~span ty value k in
      let then_ = of_branch then_ in
      select table node target ~span ty_of_element condition then_ (of_branch else_)
  | Unspecified, _ -> Unspecified
  | ( ( Atom _ | Text _ | Product _ | Constructed _ | Array _ | Function _ | Signal_function _
      | Primitive _ | Choice _ | Program _ ),
      (Scalar | Product _ | Sum _ | Array _ | Opaque) ) ->
      bug "a value of type %s is not an array" (Types.to_string ty)

let elements table node ~span ty (value : Value.t) =
  match (value, (Types.layout table ty).kind) with
  | Elements values, _ -> values
  | _, Array (n, _) -> List.init n (element table node Node.Unnamed ~span ty value)
  | _, (Scalar | Product _ | Sum _ | Opaque) ->
      bug "a value of type %s has no elements" (Types.to_string ty)
