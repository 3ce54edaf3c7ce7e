open Basis
module Ir = Flow.Ir

let bug format = Diagnostic.bug ~stage:"Specialize.Mode_output" format

type given = { node : Node.t; place : Span.t; value : Value.t }

type leaves = {
  key : int option;
  (* [None] if any value will do *) holes : Specialization_key.hole list;
}

type variant = { key : int; shape : Value.t; holes : Specialization_key.hole list }

let leaves (c : Context.t) ty { node; place; value } =
  let first_order = (Types.layout c.types ty).first_order in
  match value with
  | Unspecified when not first_order -> { key = None; holes = [] }
  | value ->
      let walk = Specialization_key.walk c.keys node Holes in
      Specialization_key.add walk { id = 0; name = ""; span = place } ty value;
      let holes = Specialization_key.take_holes walk in
      { key = Some (Specialization_key.key walk); holes }

let variants givens leaves =
  let add variants (given : given) (l : leaves) =
    match l.key with
    | Some key when not (List.exists (fun (other : variant) -> other.key = key) variants) ->
        { key; shape = given.value; holes = l.holes } :: variants
    | Some _ | None -> variants
  in
  List.rev (List.fold_left2 add [] givens leaves)

let rec zero (c : Context.t) node ~span (ty : Ir.ty) : Ir.atom =
  match ty with
  | Bool -> Bool false
  | Int -> Int 0l
  | Float -> Float 0.
  | Sum k -> (
      match (Types.sums c.types).(k).constructors with
      | [] -> bug "a sum without constructors"
      | first :: _ ->
          let payload = List.map (zero c node ~span) (Flow.Shape.payload first) in
          Node.define node Unnamed ~span ty (Construct { constructor = 0; payload }))
  | Array (_, element) -> Node.define node Unnamed ~span ty (Fill (zero c node ~span element))
  | Foreign _ -> Node.define node Unnamed ~span ty Absent

let named (hole : Specialization_key.hole) = (hole.path, hole.atom)
let types holes = List.map (fun (h : Specialization_key.hole) -> Flow.Operands.ty h.atom) holes

let of_mode c variants (given : given) (l : leaves) =
  match variants with
  | [ _ ] when Option.is_some l.key -> List.map named l.holes
  | _ ->
      let own (variant : variant) = l.key = Some variant.key in
      let leaves variant =
        if own variant then List.map named l.holes
        else List.map (fun ty -> ("", zero c given.node ~span:given.place ty)) (types variant.holes)
      in
      let rec number k = function
        | variant :: others -> if own variant then k else number (k + 1) others
        | [] -> 0
      in
      let all = List.concat_map leaves variants in
      if List.length variants = 1 then all
      else ("variant", Ir.Int (Int32.of_int (number 0 variants))) :: all

let of_machine (c : Context.t) node ~span ty variants : Value.t * Ir.signal list =
  let signal ~name ty = Node.signal node ~name ~span ty in
  let value (variant : variant) =
    let names = List.map (fun (h : Specialization_key.hole) -> h.path) variant.holes in
    let signals = List.map2 (fun name ty -> signal ~name ty) names (types variant.holes) in
    let atoms = List.map (fun s -> Ir.Signal s) signals in
    (Specialization_key.value (Specialization_key.copy c.keys Holes atoms) ty variant.shape, signals)
  in
  match List.map value variants with
  | [] -> (Unspecified, [])
  | [ only ] -> only
  | several ->
      let variant = signal ~name:"variant" Int in
      let is number : Ir.atom =
        Node.define node Unnamed ~span Bool
          (Op (Equal, [ Signal variant; Int (Int32.of_int number) ]))
      in
      let rec choose number = function
        | [] -> bug "an output without variants"
        | [ (last, _) ] -> last
        | (value, _) :: others ->
            let rest = choose (number + 1) others in
            Leaves.select c.types node Unnamed ~span ty (is number) value rest
      in
      (choose 0 several, variant :: List.concat_map snd several)
