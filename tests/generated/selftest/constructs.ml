(* Checks that the programs of `frobc selftest` together contain every construct of the C that
   frobc can generate: each constructor of compiler/cgen/ir.mli, each helper, each array
   operation and each elementary function.

   usage: constructs LIBRARY PROGRAMS IR.mli ELEMENTARY.h *)

open Cgen.Ir

let found : (string, unit) Hashtbl.t = Hashtbl.create 100
let note name = Hashtbl.replace found name ()

let rec ty (t : ty) =
  match t with
  | Void -> note "Void"
  | Bool -> note "Bool"
  | Uint8 -> note "Uint8"
  | Uint32 -> note "Uint32"
  | Int32 -> note "Int32"
  | Int64 -> note "Int64"
  | Real _ -> note "Real"
  | Struct _ -> note "Struct"
  | Named _ -> note "Named"
  | Members members ->
      note "Members";
      List.iter member members
  | Union members ->
      note "Union";
      List.iter member members
  | Array (t, _) ->
      note "Array";
      ty t
  | Pointer t ->
      note "Pointer";
      ty t
  | Pointer_to_const t ->
      note "Pointer_to_const";
      ty t

and member m = ty m.ty

let unary : unary -> string = function
  | Negate -> "Negate"
  | Not -> "Not"
  | Address -> "Address"
  | Dereference -> "Dereference"

let binary : binary -> string = function
  | Times -> "Times"
  | Over -> "Over"
  | Plus -> "Plus"
  | Minus -> "Minus"
  | Less -> "Less"
  | Less_equal -> "Less_equal"
  | Greater -> "Greater"
  | Equal -> "Equal"
  | Not_equal -> "Not_equal"
  | And -> "And"
  | Or -> "Or"
  | Remainder -> "Remainder"

let rec expr : expr -> unit = function
  | Name _ -> note "Name"
  | Boolean _ -> note "Boolean"
  | Integer _ -> note "Integer"
  | Long _ -> note "Long"
  | Float _ -> note "Float"
  | Unary (operator, e) ->
      note "Unary";
      note (unary operator);
      expr e
  | Binary (operator, a, b) ->
      note "Binary";
      note (binary operator);
      expr a;
      expr b
  | Conditional (a, b, c) ->
      note "Conditional";
      List.iter expr [ a; b; c ]
  | Call (name, arguments) ->
      note "Call";
      note name;
      List.iter expr arguments
  | Member (e, _) ->
      note "Member";
      expr e
  | Arrow (e, _) ->
      note "Arrow";
      expr e
  | Subscript (a, b) ->
      note "Subscript";
      expr a;
      expr b
  | Aggregate es ->
      note "Aggregate";
      List.iter expr es
  | Cast (t, e) ->
      note "Cast";
      ty t;
      expr e

let rec statement (s : statement) =
  match s.desc with
  | Constant { ty = t; value; _ } ->
      note "Constant";
      ty t;
      expr value
  | Table { ty = t; value; _ } ->
      note "Table";
      ty t;
      expr value
  | Variables { ty = t; _ } ->
      note "Variables";
      ty t
  | Variable { ty = t; value; _ } ->
      note "Variable";
      ty t;
      expr value
  | Initialize { ty = t; values; _ } ->
      note "Initialize";
      ty t;
      List.iter expr values
  | Assign (a, b) ->
      note "Assign";
      expr a;
      expr b
  | Add_to (a, b) ->
      note "Add_to";
      expr a;
      expr b
  | Do e ->
      note "Do";
      expr e
  | If { condition; then_; else_ } ->
      note "If";
      expr condition;
      List.iter statement (then_ @ else_)
  | Switch { value; cases } ->
      note "Switch";
      expr value;
      List.iter (fun (_, body) -> List.iter statement body) cases
  | For { body; _ } ->
      note "For";
      List.iter statement body
  | Repeat { body; _ } ->
      note "Repeat";
      List.iter statement body
  | Continue -> note "Continue"
  | Break -> note "Break"
  | Return e ->
      note "Return";
      expr e

let function_ (f : function_) =
  (match f.linkage with
  | External -> note "External"
  | Static -> note "Static"
  | Static_inline -> note "Static_inline");
  ty f.result;
  List.iter (fun (t, _) -> ty t) f.parameters;
  List.iter statement f.body;
  let operation o =
    let suffix = Cgen.Array_type.suffix o in
    if String.ends_with ~suffix:("_" ^ suffix) f.name then note ("array " ^ suffix)
  in
  List.iter operation Cgen.Array_type.operations

let declaration : declaration -> unit = function
  | Struct_definition { members; _ } ->
      note "Struct_definition";
      List.iter member members
  | Constants _ -> note "Constants"
  | Prototype f ->
      note "Prototype";
      function_ { f with body = [] }
  | Function f ->
      note "Function";
      function_ f
  | Text _ -> note "Text"

let program ~library ~real folder (file, entry) =
  let options = { Build.Common_options.default with real; lint = true } in
  let request = Build.Request.make ~options ~entry ~library (Filename.concat folder file) in
  let sink = Basis.Diagnostic.sink () and sources = Basis.Source.create () in
  match Build.Queries.step sink sources request with
  | None -> failwith (file ^ " is rejected")
  | Some step ->
      let files = Cgen.Of_step.program step in
      List.iter declaration (files.header @ files.source)

let lines path =
  let channel = open_in path in
  let rec go lines =
    match input_line channel with
    | line -> go (line :: lines)
    | exception End_of_file -> List.rev lines
  in
  Fun.protect ~finally:(fun () -> close_in channel) (fun () -> go [])

(* The results of [scan] on each line of a file; lines on which it fails are skipped. *)
let found_in path scan =
  List.filter_map
    (fun line ->
      match scan line with
      | name -> Some name
      | exception (Scanf.Scan_failure _ | End_of_file) -> None)
    (lines path)

(* Assumes that each constructor of a type is on a line of its own. *)
let constructors path =
  found_in path (fun line -> Scanf.sscanf line "  | %1[A-Z]%[A-Za-z0-9_]" ( ^ ))

let elementary path = found_in path (fun line -> Scanf.sscanf line "double %[a-z0-9_](" Fun.id)

(* Helpers that programs do not call directly: one is called or used only by other helpers, and
   one is a guard that only the header uses. *)
let called_by_nobody = [ "frob_wrap"; "FROB_STEP_H" ]

let () =
  let library = Sys.argv.(1) and folder = Sys.argv.(2) in
  List.iter
    (fun real -> List.iter (program ~library ~real folder) Tools.Selftest.programs)
    [ Basis.Real.Double; Single ];
  let wanted =
    [
      ("constructors", constructors Sys.argv.(3));
      ( "helpers",
        List.filter (fun name -> not (List.mem name called_by_nobody)) (Cgen.Helpers.names ()) );
      ("elementary functions", elementary Sys.argv.(4));
      ( "operations on arrays",
        List.map (fun o -> "array " ^ Cgen.Array_type.suffix o) Cgen.Array_type.operations );
    ]
  in
  let missing (what, names) =
    let missing = List.filter (fun name -> not (Hashtbl.mem found name)) names in
    Printf.printf "%s: %d, not in any program: %s\n" what (List.length names)
      (if missing = [] then "none" else String.concat " " missing);
    missing <> []
  in
  if List.exists Fun.id (List.map missing wanted) then exit 1
