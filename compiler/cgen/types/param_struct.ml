module F = Flow.Ir
open Printf

type t = { struct_name : string; defaults : string; members : string array }

let struct_name t = t.struct_name
let defaults t = t.defaults
let member t k = t.members.(k)

let of_program scope ~name (program : Step.Ir.program) =
  match program.params with
  | [] -> None
  | params ->
      let members = Name.scope Members in
      let struct_name = Name.fresh scope (name ^ "_params") in
      let defaults = Name.fresh scope (name ^ "_default_params") in
      let member (p : F.param) =
        Name.fresh members (String.map (fun c -> if c = '.' then '_' else c) p.label)
      in
      Some { struct_name; defaults; members = Array.of_list (List.map member params) }

let ty real : F.ty -> string = function
  | Bool -> "bool"
  | Int -> "int32_t"
  | _ -> Print.real_name real

let comment (p : F.param) =
  let unit_ = if List.mem p.unit_ [ ""; "1" ] then [] else [ "[" ^ p.unit_ ^ "]" ] in
  let doc = List.concat_map (String.split_on_char '\n') (Option.to_list p.doc) in
  match (doc, unit_) with
  | [], [] -> ""
  | lines, unit_ ->
      let lines = List.map (fun line -> Basis.C_string.comment (String.trim line)) lines in
      let rec with_unit = function
        | [] -> unit_
        | [ last ] -> [ String.concat " " (last :: unit_) ]
        | line :: rest -> line :: with_unit rest
      in
      sprintf "    /* %s */\n" (String.concat "\n     * " (with_unit lines))

let definition t (program : Step.Ir.program) =
  let member k (p : F.param) =
    sprintf "%s    %s %s;\n" (comment p) (ty program.real p.param_ty) t.members.(k)
  in
  sprintf
    "/* Parameters. Do not change them between a reset and the last step after it. */\n\
     struct %s {\n\
     %s};\n\n\
     extern const struct %s %s;\n"
    t.struct_name
    (String.concat "" (List.mapi member program.params))
    t.struct_name t.defaults

let literal real : F.atom -> string = function
  | Bool b -> string_of_bool b
  | Int n -> if Int32.equal n Int32.min_int then "INT32_MIN" else Int32.to_string n
  | Float x -> Print.float_literal real x
  | Signal _ ->
      Basis.Diagnostic.bug ~stage:"Cgen.Param_struct" "the default of a parameter is not a constant"

let values t (program : Step.Ir.program) =
  let value k (p : F.param) =
    sprintf "    %s, /* %s */\n" (literal program.real p.default) t.members.(k)
  in
  sprintf "const struct %s %s = {\n%s};\n" t.struct_name t.defaults
    (String.concat "" (List.mapi value program.params))
