open Basis
module Ir = Core.Ir
module Global_table = Resolve.Global_table

type layout = { id : int; kind : kind; first_order : bool; leaves : leaf list; nesting : int }
and kind = Scalar | Product of part list | Sum of part list array | Array of int * Ir.ty | Opaque
and part = { part : string; ty : Ir.ty }
and leaf = { path : string list; leaf : Flow.Ir.ty }

(* Polymorphic comparison and hashing would traverse the whole type, including the characters of
   names. *)
module Types = Hashtbl.Make (struct
  type t = Ir.ty

  let rec equal (a : t) (b : t) =
    a == b
    ||
    match (a, b) with
    | Variable a, Variable b -> a.id = b.id
    | Bool, Bool | Int, Int | Float, Float | String, String -> true
    | Tuple a, Tuple b -> equal_all a b
    | Function (a, b), Function (c, d) | Signal_function (a, b), Signal_function (c, d) ->
        equal a c && equal b d
    | Data (a, arguments), Data (b, others) ->
        String.equal a.name b.name && String.equal a.module_ b.module_ && equal_all arguments others
    | Array (size, element), Array (other_size, other) ->
        equal size other_size && equal element other
    | Size m, Size n -> Int.equal m n
    | ( ( Variable _ | Bool | Int | Float | String | Tuple _ | Function _ | Signal_function _
        | Data _ | Array _ | Size _ ),
        _ ) ->
        false

  and equal_all a b = List.compare_lengths a b = 0 && List.for_all2 equal a b

  (* A type may contain the same part many times. Hashing visits each occurrence, so it counts as
     work. *)
  let rec hash (ty : t) =
    Work.step ();
    match ty with
    | Bool -> 1
    | Int -> 2
    | Float -> 3
    | String -> 4
    | Variable v -> 5 + v.id
    | Tuple tys -> hash_all 7 tys
    | Function (a, b) -> hash_all 11 [ a; b ]
    | Signal_function (a, b) -> hash_all 13 [ a; b ]
    | Data (tycon, arguments) -> hash_all (String_table.hash tycon.name) arguments
    | Array (size, element) -> hash_all 17 [ size; element ]
    | Size n -> 19 + n

  and hash_all start tys =
    List.fold_left (fun h ty -> ((h * 65_599) + hash ty) land max_int) start tys
end)

type table = {
  foreign : Flow.Ir.foreign_type Global_table.t;
  data : Ir.data Global_table.t;
  layouts : layout Types.t;
  marks : int option;
  texts : Texts.t;
  mutable sums : Flow.Ir.sum list; (* newest first *)
  mutable sum_count : int;
}

let table ~marks (program : Ir.program) =
  let by_name = Global_table.create 64 and foreign = Global_table.create 8 in
  List.iter (fun (d : Ir.data) -> Global_table.replace by_name d.tycon d) program.data;
  (* If two foreign types share a name, each is prefixed with its module. *)
  let shared name =
    let has_name (t : Ir.foreign_type) = String.equal t.foreign_type.name name in
    List.length (List.filter has_name program.foreign.types) > 1
  in
  List.iter
    (fun (t : Ir.foreign_type) ->
      let { Ir.foreign_type = tycon; c_type; copyable } = t in
      let name = if shared tycon.name then tycon.module_ ^ "." ^ tycon.name else tycon.name in
      Global_table.replace foreign tycon { Flow.Ir.foreign_name = name; c_type; copyable })
    program.foreign.types;
  {
    foreign;
    data = by_name;
    layouts = Types.create 64;
    marks;
    texts = Texts.create ();
    sums = [];
    sum_count = 0;
  }

let rec close substitution (ty : Ir.ty) : Ir.ty =
  if Variables.is_empty substitution then ty
  else
    match ty with
    | Variable v -> (
        match Variables.find_opt v.id substitution with Some closed -> closed | None -> ty)
    | Bool | Int | Float | String | Size _ | Tuple [] | Data (_, []) -> ty
    | Tuple parts -> Tuple (List.map (close substitution) parts)
    | Function (a, b) -> Function (close substitution a, close substitution b)
    | Signal_function (a, b) -> Signal_function (close substitution a, close substitution b)
    | Data (tycon, arguments) -> Data (tycon, List.map (close substitution) arguments)
    | Array (size, element) -> Array (close substitution size, close substitution element)

let to_string = Core.Print.type_name

let join name path =
  match (name, path) with "", other | other, "" -> other | _, _ -> name ^ "." ^ path

let path_name (leaf : leaf) = String.concat "." leaf.path

(* The constructors of a data type with these type arguments. Empty for a built-in type such as
   [Program]. *)
let constructors table tycon arguments =
  match Global_table.find_opt table.data tycon with
  | None -> []
  | Some data ->
      let bind substitution (v : Ir.variable) ty = Variables.add v.id ty substitution in
      let substitution = List.fold_left2 bind Variables.empty data.parameters arguments in
      List.map
        (fun (c : Ir.constructor) ->
          { c with fields = List.map (fun (name, ty) -> (name, close substitution ty)) c.fields })
        data.constructors

let positional tys = List.mapi (fun i ty -> { part = string_of_int (i + 1); ty }) tys

let parts_of_fields fields =
  List.mapi
    (fun i (name, ty) ->
      { part = (if String.equal name "" then string_of_int (i + 1) else name); ty })
    fields

let scalar leaf = (Scalar, true, [ { path = []; leaf } ])
let is_drawing (ty : Ir.ty) = ty = Core.Signature.drawing
let is_text (ty : Ir.ty) = ty = Core.Signature.text

(* Names that a program cannot use for fields. *)
let count_path = "count#"
let marks_path = "marks#"
let paths_of_drawing = [ count_path; marks_path ]
let slot = Core.Signature.(event mark)

let parts_of_drawing most =
  [ { part = count_path; ty = Ir.Int }; { part = marks_path; ty = Array (Size most, slot) } ]

let text_sum (constructors : Flow.Ir.sum_constructor list) : Flow.Ir.sum =
  { name = "Text"; module_ = "Display"; constructors }

exception Too_large of Ir.ty
exception Too_deep of Ir.ty

let most_leaves = 20_000
let deepest = 500

let rec layout table (ty : Ir.ty) =
  match Types.find_opt table.layouts ty with
  | Some known -> known
  | None ->
      let kind, first_order, leaves = analyse table ty in
      let nesting = nesting table kind in
      if nesting > deepest then raise_notrace (Too_deep ty);
      let layout = { id = Types.length table.layouts; kind; first_order; leaves; nesting } in
      Types.add table.layouts ty layout;
      layout

and analyse table (ty : Ir.ty) =
  match ty with
  | Bool -> scalar Bool
  | Int -> scalar Int
  | Float -> scalar Float
  | String | Function _ | Signal_function _ -> (Opaque, false, [])
  | Variable v ->
      Diagnostic.bug ~stage:"Specialize.Types" "the type variable `%s` has no type" v.name
  | Tuple tys -> product table ty (positional tys)
  | Array (Size n, element) ->
      let { first_order; leaves; _ } = layout table element in
      let array { path; leaf } = { path; leaf = Flow.Ir.Array (n, leaf) } in
      (Array (n, element), first_order, List.map array leaves)
  | Size _ -> (Opaque, false, [])
  | Array _ -> Diagnostic.bug ~stage:"Specialize.Types" "an array without a size"
  | Data _ when is_drawing ty ->
      product table ty (Option.fold ~none:[] ~some:parts_of_drawing table.marks)
  | Data _ when is_text ty -> (
      match table.marks with
      | None -> product table ty []
      | Some _ -> scalar (add_sum table (text_sum [])))
  | Data (tycon, []) when Global_table.mem table.foreign tycon ->
      scalar (Foreign (Global_table.find table.foreign tycon))
  | Data (tycon, arguments) -> (
      match constructors table tycon arguments with
      | [] -> (Opaque, false, [])
      | [ only ] -> product table ty (parts_of_fields only.fields)
      | several ->
          let fields = List.map (fun (c : Ir.constructor) -> parts_of_fields c.fields) several in
          let first_order = List.for_all (List.for_all (is_first_order table)) fields in
          let leaves =
            if first_order then [ { path = []; leaf = intern_sum table ty tycon several } ] else []
          in
          (Sum (Array.of_list fields), first_order, leaves))

and nesting table kind =
  let of_parts = List.fold_left (fun n part -> max n (layout table part.ty).nesting) 0 in
  match kind with
  | Product parts -> 1 + of_parts parts
  | Sum constructors -> 1 + Array.fold_left (fun n parts -> max n (of_parts parts)) 0 constructors
  | Array (_, element) -> 1 + (layout table element).nesting
  | Scalar | Opaque -> 0

and is_first_order table part = (layout table part.ty).first_order

and product table ty parts =
  let first_order = List.for_all (is_first_order table) parts in
  let count = List.fold_left (fun n part -> n + List.length (layout table part.ty).leaves) 0 in
  if first_order && count parts > most_leaves then raise_notrace (Too_large ty);
  let leaves_of part =
    List.rev_map
      (fun leaf -> { leaf with path = part.part :: leaf.path })
      (layout table part.ty).leaves
  in
  let leaves =
    if first_order then
      List.rev (List.fold_left (fun leaves part -> leaves_of part @ leaves) [] parts)
    else []
  in
  (Product parts, first_order, leaves)

and intern_sum table ty (tycon : Ir.Global.t) constructors : Flow.Ir.ty =
  let sum_constructor (c : Ir.constructor) : Flow.Ir.sum_constructor =
    {
      constructor = c.name.name;
      fields = List.map (fun (name, ty) -> (name, shape table ty)) (seen table c.fields);
    }
  in
  let sum : Flow.Ir.sum =
    {
      name = to_string ty;
      module_ = tycon.module_;
      constructors = List.map sum_constructor constructors;
    }
  in
  add_sum table sum

(* Removes drawings if they have no leaves. *)
and seen table fields =
  if Option.is_some table.marks then fields
  else List.filter (fun (_, ty) -> not (is_drawing ty)) fields

and add_sum table sum : Flow.Ir.ty =
  let index = table.sum_count in
  table.sums <- sum :: table.sums;
  table.sum_count <- index + 1;
  Sum index

and shape table (ty : Ir.ty) : Flow.Ir.shape =
  match ty with
  | Tuple parts ->
      Product
        {
          product_name = "";
          product_module = "";
          constructor = "";
          record = false;
          parts = List.map (fun ty -> ("", shape table ty)) parts;
        }
  | Data _ when is_drawing ty || (is_text ty && Option.is_none table.marks) ->
      let parts =
        match (layout table ty).kind with
        | Product parts -> List.map (fun { part; ty } -> (part, shape table ty)) parts
        | Scalar | Sum _ | Array _ | Opaque -> []
      in
      Product
        {
          product_name = to_string ty;
          product_module = "Display";
          constructor = to_string ty;
          record = parts <> [];
          parts;
        }
  | Data _ when is_text ty -> single_leaf table ty
  | Data (tycon, arguments) -> (
      match constructors table tycon arguments with
      | [ only ] ->
          Product
            {
              product_name = tycon.name;
              product_module = tycon.module_;
              constructor = only.name.name;
              record = only.record;
              parts =
                List.filter_map
                  (fun (name, ty) ->
                    if is_bare_console table ty then None else Some (name, shape table ty))
                  (seen table only.fields);
            }
      | [] | _ :: _ :: _ -> single_leaf table ty)
  | Array (Size n, element) -> Repeated (n, shape table element)
  | Variable _ | Bool | Int | Float | String | Function _ | Signal_function _ | Array _ | Size _ ->
      single_leaf table ty

(* A console without controls is invisible outside the program. *)
and is_bare_console table (ty : Ir.ty) =
  match ty with
  | Data (tycon, []) when Core.Console.is_console tycon -> (layout table ty).leaves = []
  | _ -> false

and single_leaf table ty : Flow.Ir.shape =
  match (layout table ty).leaves with
  | [ { leaf; _ } ] -> Leaf leaf
  | [] | _ :: _ :: _ ->
      Diagnostic.bug ~stage:"Specialize.Types" "%s does not have exactly one leaf" (to_string ty)

let shape_of_output table ty =
  let rec without_drawings (shape : Flow.Ir.shape) : Flow.Ir.shape =
    match shape with
    | Product product ->
        let is_drawing (_, (part : Flow.Ir.shape)) =
          match part with
          | Product { product_module = "Display"; product_name = "Drawing"; _ } -> true
          | Product _ | Leaf _ | Repeated _ -> false
        in
        let seen = List.filter (fun part -> not (is_drawing part)) product.parts in
        Product
          { product with parts = List.map (fun (name, part) -> (name, without_drawings part)) seen }
    | Repeated (n, element) -> Repeated (n, without_drawings element)
    | Leaf _ -> shape
  in
  without_drawings (shape table ty)

let shape_of_marks table = shape table (Array (Size (Option.value table.marks ~default:1), slot))

let sums table =
  let with_texts (sum : Flow.Ir.sum) =
    if sum <> text_sum [] then sum
    else
      let says text : Flow.Ir.sum_constructor = { constructor = text; fields = [] } in
      text_sum (List.map says (Texts.all table.texts))
  in
  Array.of_list (List.rev_map with_texts table.sums)

let of_the_instant table ty =
  if Global_table.length table.foreign = 0 then None else Flow.Shape.of_the_instant (sums table) ty

let marks table = table.marks
let text table says = Texts.number table.texts says
