module F = Flow.Ir

type key = string * string * F.shape list

type types = {
  real : Basis.Real.t;
  scope : Name.scope;
  prefix : string;
  sum : int -> string;
  foreign : F.foreign_type -> Ir.ty;
  of_record : F.product -> Units.value;
  known : (key, string * Ir.member list) Hashtbl.t;
  mutable definitions : Ir.declaration list;  (** newest first *)
}

type t = { struct_name : string; leaves : step list list; unused : step list list }
and step = Member of string | Element of int

let is_element = function Element _ -> true | Member _ -> false
let is_in_array = List.exists is_element
let dimensions steps = List.length (List.filter is_element steps)

let types scope ~real ~prefix ~sum ~foreign ~(units : Units.t) =
  let of_record = units.record and known = Hashtbl.create 8 in
  { real; scope; prefix; sum; foreign; of_record; known; definitions = [] }

let key (product : F.product) =
  (product.product_module, product.product_name, List.map snd product.parts)

let definitions types = List.rev types.definitions

let direct (shape : F.shape) =
  match shape with
  | Product { product_name; _ } -> not (String.equal product_name "")
  | Leaf _ | Repeated _ -> false

let no_value : Ir.member = { name = "unused"; ty = Uint8; comment = "" }

let rec leaf_type types (ty : F.ty) : Ir.ty =
  match ty with
  | Bool -> Bool
  | Int -> Int32
  | Float -> Real types.real
  | Sum k -> Struct (types.sum k)
  | Array (n, element) -> Array (leaf_type types element, n)
  | Foreign foreign -> types.foreign foreign

let rec members types (units : Units.value) (product : F.product) : Ir.member list =
  match product.parts with
  | [] -> [ no_value ]
  | parts ->
      let scope = Name.scope Members in
      List.mapi
        (fun k (field, shape) ->
          let units = units.part (if String.equal field "" then string_of_int (k + 1) else field) in
          let field = if String.equal field "" then Printf.sprintf "f%d" (k + 1) else field in
          let name = Name.fresh scope field in
          { Ir.name; ty = part_type types units shape; comment = units.unit_ })
        parts

and part_type types units (shape : F.shape) : Ir.ty =
  match shape with
  | Leaf ty -> leaf_type types ty
  | Product ({ product_name = ""; _ } as product) -> Members (members types units product)
  | Product product -> Struct (record types product)
  | Repeated (n, element) -> Array (part_type types units element, n)

and record types (product : F.product) =
  match Hashtbl.find_opt types.known (key product) with
  | Some (name, _) -> name
  | None ->
      let members = members types (types.of_record product) product in
      let own = Name.short (Name.snake product.product_name) in
      let name = Name.fresh types.scope (types.prefix ^ "_" ^ own) in
      Hashtbl.replace types.known (key product) (name, members);
      define types name members;
      name

and define types name members =
  let definition = Ir.Struct_definition { overlaid = false; name; members; comment = "" } in
  types.definitions <- definition :: types.definitions

(* The paths through the members of a shape to leaves and to unused bytes. *)
let paths (shape : F.shape) (members : Ir.member list) member_list_of =
  let leaves = ref [] and unused = ref [] in
  let rec part path (shape : F.shape) (member : Ir.member) =
    at (Member member.name :: path) shape member.ty
  and at path (shape : F.shape) (ty : Ir.ty) =
    match (shape, ty) with
    | Leaf _, _ -> leaves := List.rev path :: !leaves
    | Product product, _ -> inside path product (member_list_of product ty)
    | Repeated (n, element), Array (ty, _) -> at (Element n :: path) element ty
    | Repeated _, _ -> Basis.Diagnostic.bug ~stage:"Cgen.Interface" "expected an array type in C"
  and inside path (product : F.product) (members : Ir.member list) =
    match (product.parts, members) with
    | [], member :: _ -> unused := List.rev (Member member.name :: path) :: !unused
    | parts, members -> List.iter2 (fun (_, shape) member -> part path shape member) parts members
  in
  (match shape with
  | Product product -> inside [] product members
  | Leaf _ | Repeated _ -> List.iter (part [] shape) members);
  (List.rev !leaves, List.rev !unused)

let with_paths types ~name members (shape : F.shape) =
  let member_list_of (product : F.product) (ty : Ir.ty) =
    match ty with
    | Members members -> members
    | Void | Bool | Uint8 | Uint32 | Int32 | Int64 | Real _ | Struct _ | Named _ | Union _ | Array _
    | Pointer _ | Pointer_to_const _ -> (
        match Hashtbl.find_opt types.known (key product) with
        | Some (_, members) -> members
        | None -> Basis.Diagnostic.bug ~stage:"Cgen.Interface" "the record has no struct")
  in
  let leaves, unused = paths shape members member_list_of in
  { struct_name = name; leaves; unused }

let record_of parts =
  F.Product
    { product_name = "Probes"; product_module = ""; constructor = "Probes"; record = true; parts }

let apart (shape : F.shape) =
  match shape with
  | Product product -> (
      match List.rev product.parts with
      | (_, result) :: parts when product.record ->
          (F.Product { product with parts = List.rev parts }, Some result)
      | [ (_, result); (_, command) ] -> (command, Some result)
      | _ -> (shape, None))
  | Leaf _ | Repeated _ -> (shape, None)

let with_others types ~name ~first:first_name command (others : (string * F.shape) list) =
  let product : F.product =
    { product_name = ""; product_module = ""; constructor = ""; record = false; parts = others }
  in
  let first : Ir.member = { name = first_name; ty = Struct command.struct_name; comment = "" } in
  let others = members types Units.unknown product in
  define types name (first :: others);
  let beside = with_paths types ~name others (Product product) in
  let inside path = Member first_name :: path in
  {
    beside with
    leaves = List.map inside command.leaves @ beside.leaves;
    unused = List.map inside command.unused @ beside.unused;
  }

let with_leaves ~at count t =
  let others, moved = Basis.Long_list.split_at (List.length t.leaves - count) t.leaves in
  let before, after = Basis.Long_list.split_at at others in
  { t with leaves = before @ moved @ after }

let of_shape types ~(units : Units.value) ~name (shape : F.shape) =
  let members =
    match shape with
    | Leaf _ | Repeated _ ->
        [ { Ir.name = "value"; ty = part_type types units shape; comment = units.unit_ } ]
    | Product product -> members types units product
  in
  define types name members;
  with_paths types ~name members shape

let of_record types ~name (product : F.product) =
  let units = types.of_record product in
  let interface = of_shape types ~units ~name (Product product) in
  Hashtbl.replace types.known (key product) (name, members types units product);
  interface

let of_type types ~name (shape : F.shape) =
  match shape with
  | Product ({ product_name; _ } as product) when not (String.equal product_name "") -> (
      let name = record types product in
      match Hashtbl.find_opt types.known (key product) with
      | Some (_, members) -> with_paths types ~name members shape
      | None -> Basis.Diagnostic.bug ~stage:"Cgen.Interface" "the record has no struct")
  | Product _ | Leaf _ | Repeated _ -> of_shape types ~units:Units.unknown ~name:(name ()) shape
