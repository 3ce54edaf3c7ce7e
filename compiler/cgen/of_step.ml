module M = Step.Ir
module V = Vocabulary

type t = {
  name : string;
  header : Ir.file;
  source : Ir.file;
  input : Interface.t;
  output : Interface.t;
  params : Param_struct.t option;
  sums : Sum_type.t array;
  machines : Machine_table.t list;
  is_valid : string option;
}

let state_comment (v : Program_names.t) (field : M.field) =
  let what =
    match field.content with
    | Value Nanoseconds when Option.is_some field.bound -> "time left in ns"
    | Value _ | Running_mode | Modes _ | Component _ -> field.purpose
    | State_of k | States_of { node = k; _ } -> v.program.nodes.(k).origin
  in
  let line = string_of_int (Basis.Span.line field.span.start) in
  let file = Basis.C_string.comment (Filename.basename field.span.file) in
  let unit_ = match v.units.field field with "" -> "" | unit_ -> unit_ ^ ", " in
  String.concat "" [ unit_; what; " at "; file; ":"; line ]

let rec member (v : Program_names.t) (m : Program_names.member) : Ir.member =
  let { Step.State_struct.node = k; field; _ } = m.stores in
  let state node = Ir.Struct v.nodes.(node).state in
  let ty : Ir.ty =
    match field.content with
    | Value ty -> if Option.is_some field.bound then Uint32 else V.ty v ty
    | State_of k -> state k
    | States_of { node; count } -> Array (state node, count)
    | Component symbol -> Struct (symbol ^ "_state")
    | Running_mode -> if Array.length v.nodes.(k).modes <= 256 then Uint8 else Int32
    | Modes _ -> Union (List.map (mode v) m.modes)
  in
  { name = m.name; ty; comment = state_comment v field }

and mode v (name, members) : Ir.member =
  { name; ty = Members (Basis.Long_list.map (member v) members); comment = "" }

let mode_numbers (v : Program_names.t) k (node : M.node) =
  match node.modes with
  | [] | [ _ ] -> []
  | _ :: _ :: _ ->
      let names =
        List.map (fun (m : Program_names.mode) -> m.constant) (Array.to_list v.nodes.(k).modes)
      in
      [ Ir.Constants { names; comment = "the modes of " ^ node.origin } ]

(* Modes that exclude each other share memory in a union, and the step of each receives a pointer to
   its own struct. Unless the structs are marked [may_alias], gcc assumes that pointers to different
   structs do not alias, and may then read stale values left by the previous mode (seen with gcc 12
   -O2). *)
let overlaid =
  {|/* Modes that exclude each other share memory. */
#ifndef FROB_OVERLAID
#ifdef __GNUC__
#define FROB_OVERLAID __attribute__((__may_alias__))
#else
#define FROB_OVERLAID
#endif
#endif
|}

let state_struct (v : Program_names.t) ~overlaid k =
  let members =
    match v.nodes.(k).members with
    | [] -> [ { Ir.name = "unused"; ty = Uint8; comment = "" } ]
    | members -> Basis.Long_list.map (member v) members
  in
  Ir.Struct_definition { name = v.nodes.(k).state; overlaid; members; comment = "" }

let states (v : Program_names.t) =
  let overlaid = V.has_modes v in
  let of_node k (node : M.node) =
    let has_struct = V.home v k = k && (V.has_state v k || V.is_root v k) in
    if Option.is_some node.foreign then []
    else mode_numbers v k node @ if has_struct then [ state_struct v ~overlaid k ] else []
  in
  List.concat (List.mapi of_node (Array.to_list v.program.nodes))

(* Leaves out the types of a robot, which the robot's header defines. *)
let definitions (v : Program_names.t) =
  let ours : Value_types.owner -> bool = function
    | Program | Foreign_code -> true
    | Robot -> false
  in
  let of_foreign_code =
    match v.program.real with
    | Double -> []
    | Single -> Value_types.definitions v.foreign_types ~of_:ours
  in
  Value_types.definitions v.types ~of_:ours @ of_foreign_code

(* {1 The user's C code} *)

let foreign_headers (v : Program_names.t) =
  List.sort_uniq String.compare
    (List.map (fun (h : Flow.Ir.header) -> Printf.sprintf "\"%s\"" h.header) v.program.headers)

(* Structs that are only passed by address may be incomplete types. *)
let foreign_structs (v : Program_names.t) =
  let imported (f : Flow.Ir.import) = f.result :: f.arguments in
  let shapes = v.program.input :: v.program.output :: List.concat_map imported v.program.imports in
  let types = List.concat_map Flow.Shape.leaves shapes in
  let declared (f : Flow.Ir.foreign_type) =
    if f.copyable || not (String.contains f.c_type ' ') then None else Some (f.c_type ^ ";\n")
  in
  let foreign = List.concat_map (Flow.Shape.foreign v.program.sums) types in
  match List.sort_uniq compare (List.filter_map declared foreign) with
  | [] -> []
  | all -> [ Ir.Text (String.concat "" all) ]

(* A program may also be used as a component of another program. Its header then replaces the
   definitions that the importing program would generate. *)
let own_records (v : Program_names.t) =
  let mark (d : Ir.declaration) =
    match d with
    | Struct_definition { name; _ } when List.mem name [ v.input.struct_name; v.output.struct_name ]
      ->
        Some (Printf.sprintf "#define %s\n" (Value_types.defined name))
    | _ -> None
  in
  match List.filter_map mark v.records with
  | [] -> v.records
  | marks -> Ir.Text (String.concat "" marks) :: v.records

let foreign_records (v : Program_names.t) =
  List.concat_map
    (fun (d : Ir.declaration) ->
      match d with Struct_definition { name; _ } -> Value_types.once name [ d ] | d -> [ d ])
    v.foreign_records

(* Functions of C's own headers are not declared again, because C++ headers declare them with
   exception specifications that would not match. *)
let declared_by_math =
  String.split_on_char ' '
    "acos asin atan atan2 cos sin tan acosh asinh atanh cosh sinh tanh exp exp2 expm1 log log10 \
     log1p log2 logb pow sqrt cbrt hypot erf erfc tgamma lgamma ceil floor nearbyint rint round \
     trunc fmod remainder copysign nextafter fdim fmax fmin fma fabs"

let foreign_prototypes (v : Program_names.t) =
  let prototypes (f : Foreign_interface.t) =
    if List.mem f.symbol declared_by_math then [] else Foreign_interface.prototypes f
  in
  match List.concat_map prototypes v.imports with
  | [] -> []
  | all -> Ir.Text "/* Imported functions. */\n" :: List.map (fun p -> Ir.Prototype p) all

(* Variables whose addresses are placeholders for missing foreign values. *)
let absent (v : Program_names.t) =
  let add (f : Flow.Ir.foreign_type) name all = (name, f.c_type) :: all in
  let variables = Hashtbl.fold add v.absent [] in
  List.map
    (fun (name, c_type) -> Ir.Text (Printf.sprintf "static %s %s;\n" c_type name))
    (List.sort compare variables)

(* The named constants, in source order. *)
let constants (v : Program_names.t) =
  let order ((a : Named_constants.constant), _) ((b : Named_constants.constant), _) =
    Basis.Span.compare a.place b.place
  in
  let definition (constant, (name, x)) =
    Named_constants.definition ~program:v.program.name v.program.real constant ~name x
  in
  match List.sort order (List.of_seq (Hashtbl.to_seq v.constants)) with
  | [] -> []
  | all -> [ Ir.Text (String.concat "" (List.map definition all)) ]

let params (v : Program_names.t) text =
  List.map (fun params -> Ir.Text (text params v.program)) (Option.to_list v.params)

let includes headers = String.concat "" (List.map (Printf.sprintf "#include %s\n") headers)

(* The type declarations of the header, and the types that only the functions use. *)
type types = {
  types : Ir.declaration list;
  records : Ir.declaration list;
  prototypes : Ir.declaration list;
  states : Ir.declaration list;
  of_source : Ir.declaration list;
}

let types_of (v : Program_names.t) (functions : Ir.function_ list) =
  let records = foreign_records v @ own_records v in
  let prototypes = foreign_prototypes v in
  let states = states v in
  let interface = List.concat [ records; prototypes; states ] in
  let from = Mentioned.structs interface in
  let in_header, others = Value_types.reached (definitions v) ~from in
  let from = Mentioned.structs (List.map (fun f -> Ir.Function f) functions) in
  let in_source, _ = Value_types.reached others ~from in
  let types = Value_types.declarations in_header in
  { types; records; prototypes; states; of_source = Value_types.declarations in_source }

(* Separates the characters of comment delimiters, which file names may contain. *)
let without_marks text =
  let after c = function
    | '/' when c = '*' -> " /"
    | '*' when c = '/' -> " *"
    | d -> String.make 1 d
  in
  let text' = " " ^ text in
  String.concat "" (List.init (String.length text) (fun i -> after text'.[i] text.[i]))

(* Lines that continue a comment that is already open. *)
let comment_lines = function
  | [] -> ""
  | lines ->
      "\n *" ^ String.concat "" (List.map (fun line -> "\n * " ^ without_marks line) lines) ^ "\n"

let about_validity = function
  | None -> ""
  | Some is_valid ->
      Printf.sprintf
        "\n\
        \ * %s returns whether the numbers of the running modes are valid. If not, memory\n\
        \ * was damaged: set the outputs to rest, and reset before the next step."
        is_valid

let header (v : Program_names.t) { types; records; prototypes; states; of_source = _ }
    (functions : Ir.function_ list) ~is_valid ~banner ~(batch : Batch.t option) : Ir.file =
  let guard = String.uppercase_ascii v.name ^ "_H" in
  let root = v.nodes.(Array.length v.nodes - 1) in
  let robots = List.map Robot.included v.robots in
  List.concat
    [
      [
        Ir.Text
          (Printf.sprintf
             "/* %s.h -- generated by frobc.\n\
             \ *\n\
             \ * The caller owns the state and calls %s once, then at each instant one of\n\
             \ *   %s with the seconds since the previous instant, or\n\
             \ *   %s with the same time in nanoseconds and in seconds, which is faster;\n\
             \ *       both must be 0 in the first instant.%s%s */\n\
              #ifndef %s\n\
              #define %s\n"
             v.program.name root.reset v.in_seconds root.step (about_validity is_valid)
             (comment_lines banner) guard guard);
        Text (includes (robots @ [ "<stdbool.h>"; "<stdint.h>" ] @ foreign_headers v));
        Text "#ifdef __cplusplus\nextern \"C\" {\n#endif\n";
      ];
      foreign_structs v;
      types;
      records;
      (if V.has_modes v then [ Text overlaid ] else []);
      prototypes;
      params v Param_struct.definition;
      states;
      List.map (fun (f : Ir.function_) -> Ir.Prototype { f with comment = "" }) functions;
      List.map (fun (b : Batch.t) -> Ir.Text b.prototype) (Option.to_list batch);
      [ Text "#ifdef __cplusplus\n}\n#endif\n#endif\n" ];
    ]

(* The comment with the name of the definition appears only above its first function. *)
let named_once functions =
  let name last (f : Ir.function_) =
    if String.equal f.comment last then (last, { f with comment = "" })
    else ((if String.equal f.comment "" then last else f.comment), f)
  in
  snd (List.fold_left_map name "" functions)

let program ?own ?units ?named ?(batch = false) ?(banner = []) (program : M.program) =
  let v = V.of_program ?own ?units ?named program in
  let batch = if batch then Some (Batch.of_program v) else None in
  let root = Array.length program.nodes - 1 in
  (* A function, preceded by those of its helpers that are not defined yet. *)
  let made make =
    let functions = make () in
    V.take_pending v @ functions
  in
  let of_node k =
    match v.nodes.(k).foreign with
    | Some interface -> made (fun () -> [ Foreign_call.step v k interface ])
    | None ->
        let is_called = k = root || program.nodes.(k).reset.body <> [] in
        let reset = if is_called then made (fun () -> [ Function.reset v k ]) else [] in
        named_once (reset @ made (fun () -> Function.steps v k))
  in
  let validity = Validity.functions v in
  let functions = List.concat (List.init (root + 1) of_node) @ validity in
  let interface = List.filter (fun (f : Ir.function_) -> f.linkage = External) functions in
  let types = types_of v functions in
  let is_valid = match validity with [] -> None | _ :: _ -> Some v.is_valid in
  let source =
    List.concat
      [
        [
          Ir.Text
            (String.concat ""
               [
                 Printf.sprintf "/* %s.c -- generated by frobc.%s */\n#include \"%s.h\"\n"
                   program.name (comment_lines banner) program.name;
                 (match program.real with Double -> "" | Single -> "#define FROB_SINGLE\n");
                 Helpers.included;
               ]);
        ];
        types.of_source;
        constants v;
        absent v;
        params v Param_struct.values;
        List.map (fun f -> Ir.Function f) functions;
        List.map (fun (b : Batch.t) -> Ir.Text b.definition) (Option.to_list batch);
      ]
  in
  {
    name = v.name;
    header = header v types interface ~is_valid ~banner ~batch;
    source;
    input = v.input;
    output = v.output;
    params = v.params;
    sums = v.sums;
    machines = Machine_table.of_program v;
    is_valid;
  }
