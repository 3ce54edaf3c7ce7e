open Ir

let rec ty names : ty -> string list = function
  | Struct name -> name :: names
  | Members all | Union all -> members names all
  | Array (t, _) | Pointer t | Pointer_to_const t -> ty names t
  | Void | Bool | Uint8 | Uint32 | Int32 | Int64 | Real _ | Named _ -> names

and members names all = List.fold_left (fun names (m : member) -> ty names m.ty) names all

let rec statement names s =
  match s.desc with
  | Constant { ty = t; _ }
  | Table { ty = t; _ }
  | Variables { ty = t; _ }
  | Variable { ty = t; _ }
  | Initialize { ty = t; _ } ->
      ty names t
  | If { then_; else_; condition = _ } -> statements (statements names then_) else_
  | Switch { cases; value = _ } ->
      List.fold_left (fun names (_, body) -> statements names body) names cases
  | For { body; _ } | Repeat { body; _ } -> statements names body
  | Assign _ | Add_to _ | Do _ | Continue | Break | Return _ -> names

and statements names body = List.fold_left statement names body

let signature names f =
  List.fold_left (fun names (t, _) -> ty names t) (ty names f.result) f.parameters

let declaration names = function
  | Struct_definition { members = all; _ } -> members names all
  | Prototype f -> signature names f
  | Function f -> statements (signature names f) f.body
  | Constants _ | Text _ -> names

let structs declarations = List.fold_left declaration [] declarations
