module F = Flow.Ir
open Printf

(* Tables are written bottom-up, and their names are numbered. *)
type context = {
  out : Buffer.t;
  sums : F.sum array;
  struct_name : string;  (** the struct to which offsets refer *)
  prefix : string;  (** prefix of the tables' names *)
  mutable count : int;
  mutable console : string list;  (** names of the console's values, for the table of controls *)
  enumerations : Node_table.enumeration list ref;  (** the types whose constructors have no fields *)
}

(* A leaf's access path and its Float representation. *)
type location =
  | Scalar of { path : string; number : string }
  | Sum of { tag : string; base : string; first : Step.Layout.slots; number : string }
  | Array of (int -> location)  (** location of each element *)

let c_string = Basis.C_string.literal
let name_or_null text = if String.equal text "" then "NULL" else c_string text

let next c =
  c.count <- c.count + 1;
  c.count

let table out kind name rows =
  match rows with
  | [] -> "NULL"
  | rows ->
      bprintf out "static const struct frob_%s %s[] = {\n" kind name;
      List.iter (fun row -> bprintf out "    {%s},\n" row) rows;
      bprintf out "};\n";
      name

let numbered_table c kind = table c.out kind (sprintf "%s_%ss_%d" c.prefix kind (next c))
let offset c path = sprintf "offsetof(struct %s, %s)" c.struct_name path

(* Writes the table of a value and returns its name. *)
let value c ~kind ~offset ~is_event ~count constructors =
  let name = sprintf "%s_value_%d" c.prefix (next c) in
  bprintf c.out "static const struct frob_value %s = {\n    %s, %s, %d, %d, %s\n};\n" name kind
    offset
    (if is_event then 1 else 0)
    count constructors;
  name

let take locations =
  match !locations with
  | [] -> Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "fewer locations than leaves"
  | location :: rest ->
      locations := rest;
      location

(* The file and the line of a place: "wall_follow.frob:12". *)
let line_of ({ file; start; _ } : Basis.Span.t) =
  sprintf "%s:%d" (Filename.basename file) (Basis.Span.line start)

let foreign () =
  Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "the table for hosts cannot describe a foreign type"

let is_image = Flow.Shape.is_image

(* The location of a leaf that is a single member. *)
let rec value_at number path (ty : F.ty) =
  match ty with
  | Bool | Int | Float -> Scalar { path; number }
  | Sum _ -> Sum { tag = path ^ ".tag"; base = path ^ "."; first = Step.Layout.none; number }
  | Array (_, element) -> Array (fun i -> value_at number (sprintf "%s.at[%d]" path i) element)
  | Foreign f when is_image f -> Scalar { path; number }
  | Foreign _ -> foreign ()

let element_of i = function
  | Array location -> location i
  | Scalar _ | Sum _ ->
      Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "expected an array for an element"

let note_enumeration c constructors ~module_ type_ =
  c.enumerations := { Node_table.constructors; module_; type_ } :: !(c.enumerations)

let rec shape c locations (whole : F.shape) =
  match whole with
  | Leaf ty -> leaf c ty (take locations)
  | Product product ->
      let note value =
        if Core.Console.has_name ~module_:product.product_module product.product_name then
          c.console <- c.console @ [ value ]
      in
      let row =
        constructor c locations ~note ~name:product.constructor ~record:product.record product.parts
      in
      let constructors = numbered_table c "constructor" [ row ] in
      if product.parts = [] then
        note_enumeration c constructors ~module_:product.product_module product.product_name;
      value c ~kind:"FROB_PRODUCT" ~offset:"0" ~is_event:false ~count:1 constructors
  | Repeated (n, element) ->
      (* An array is described as a product of its elements. *)
      let arrays = List.map (fun _ -> take locations) (Flow.Shape.leaves element) in
      let row i =
        let locations = ref (List.map (element_of i) arrays) in
        sprintf "NULL, &%s" (shape c locations element)
      in
      let fields = numbered_table c "field" (Basis.Long_list.map row (List.init n Fun.id)) in
      let row = sprintf "NULL, 0, %d, %s" n fields in
      let constructors = numbered_table c "constructor" [ row ] in
      value c ~kind:"FROB_ARRAY" ~offset:"0" ~is_event:false ~count:1 constructors

and constructor ?(note = ignore) c locations ~name ~record parts =
  let field (name, part) =
    let value = shape c locations part in
    note value;
    sprintf "%s, &%s" (name_or_null name) value
  in
  (* Locations are consumed in order, so fields must be processed from first to last. *)
  let fields = numbered_table c "field" (Basis.Long_list.map field parts) in
  sprintf "%s, %d, %d, %s" (name_or_null name) (if record then 1 else 0) (List.length parts) fields

and leaf c (ty : F.ty) location =
  let scalar kind path = value c ~kind ~offset:(offset c path) ~is_event:false ~count:0 "NULL" in
  match (ty, location) with
  | Bool, Scalar { path; _ } -> scalar "FROB_BOOL" path
  | Int, Scalar { path; _ } -> scalar "FROB_INT" path
  | Float, Scalar { path; number } -> scalar number path
  | Sum k, Sum { tag; base; first; number } -> sum c k ~tag ~base ~first ~number
  | Foreign f, Scalar { path; _ } when is_image f -> scalar "FROB_IMAGE" path
  | Foreign _, _ -> foreign ()
  | (Bool | Int | Float | Sum _ | Array _), (Scalar _ | Sum _ | Array _) ->
      Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "the location does not match the leaf's type"

and sum c k ~tag ~base ~first ~number =
  let sum = c.sums.(k) in
  let locate (slot : Sum_type.slot) ty =
    match slot with
    | Scalar member -> value_at number (base ^ member) ty
    | Inner { sum = _; tag; first } -> Sum { tag = base ^ tag; base; first; number }
  in
  let row (ctor : F.sum_constructor) =
    let slots = Sum_type.payload c.sums ~first ctor in
    let locations = ref (List.map2 locate slots (Flow.Shape.payload ctor)) in
    let record = List.exists (fun (name, _) -> not (String.equal name "")) ctor.fields in
    constructor c locations ~name:ctor.constructor ~record ctor.fields
  in
  let rows = Basis.Long_list.map row sum.constructors in
  let constructors = numbered_table c "constructor" rows in
  if List.for_all (fun (ctor : F.sum_constructor) -> ctor.fields = []) sum.constructors then
    note_enumeration c constructors ~module_:sum.module_ sum.name;
  let is_event =
    String.equal sum.module_ "Prelude"
    && match String.split_on_char ' ' sum.name with "Event" :: _ -> true | _ -> false
  in
  value c ~kind:"FROB_SUM" ~offset:(offset c tag) ~is_event ~count:(List.length rows) constructors

(* The representation of Floats in a leaf. *)
let number (program : Step.Ir.program) (side : Border.side) steps =
  match (program.real, side.robot) with
  | Double, _ -> "FROB_FLOAT"
  | Single, Some _ when not (Border.is_own side steps) -> "FROB_ROUNDED"
  | Single, (Some _ | None) -> "FROB_SINGLE"

(* The locations of all leaves. *)
let locations (program : Step.Ir.program) (side : Border.side) whole =
  let rec locate number path (steps : Interface.step list) (ty : F.ty) =
    match (steps, ty) with
    | [], _ -> value_at number path ty
    | Member name :: rest, _ ->
        locate number (if path = "" then name else path ^ "." ^ name) rest ty
    | Element _ :: rest, Array (_, element) ->
        Array (fun i -> locate number (sprintf "%s[%d]" path i) rest element)
    | Element _ :: _, (Bool | Int | Float | Sum _ | Foreign _) ->
        Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "expected an array type for an element"
  in
  let leaf steps = locate (number program side steps) "" steps in
  List.rev (List.rev_map2 leaf side.host.leaves (Flow.Shape.leaves whole))

let table_of ?(enumerations = ref []) out (program : Step.Ir.program) ~prefix (side : Border.side)
    locations whole =
  let c =
    {
      out;
      sums = program.sums;
      struct_name = side.host.struct_name;
      prefix;
      count = 0;
      console = [];
      enumerations;
    }
  in
  let value = shape c (ref locations) whole in
  (value, c.console)

let input ~enumerations out (program : Step.Ir.program) (side : Border.side) =
  let locations = locations program side program.input in
  table_of ~enumerations out program ~prefix:"in" side locations program.input

(* The table of the console's controls, with the input values that they set. *)
let controls out (program : Step.Ir.program) values =
  let bounds (kind : Core.Ir.control_kind) =
    match kind with
    | Button -> ("FROB_BUTTON", 0., 0., 0.)
    | Hold -> ("FROB_HOLD", 0., 1., 0.)
    | Knob { least; most; first } -> ("FROB_KNOB", least, most, first)
    | Toggle { first } -> ("FROB_TOGGLE", 0., 1., if first then 1. else 0.)
    | Map -> ("FROB_MAP", 0., 0., 0.)
    | Camera -> ("FROB_CAMERA", 0., 0., 0.)
    | Tags -> ("FROB_TAGS", 0., 0., 0.)
    | Lidar _ -> ("FROB_LIDAR", 0., 0., 0.)
    | Imu -> ("FROB_IMU", 0., 0., 0.)
  in
  let row (c : Core.Ir.control) value =
    let kind, least, most, first = bounds c.kind in
    sprintf "%s, %s, %s, %.17g, %.17g, %.17g, &%s, %s" kind (c_string c.label) (c_string c.unit_)
      least most first value
      (c_string (line_of c.span))
  in
  (* If the input contains several consoles, they have the same controls; hosts use the first. *)
  let values, _ = Basis.Long_list.split_at (List.length program.console) values in
  let rows = if values = [] then [] else List.map2 row program.console values in
  (table out "control" "controls" rows, List.length rows)

(* If margins are enabled, exports the margin formulas of assertions as [frob_margins], which tools
   look up by name. *)
let margins out (program : Step.Ir.program) =
  let text (claim : F.claim) = Option.fold ~none:"NULL" ~some:c_string claim.margin in
  if List.exists (fun (claim : F.claim) -> Option.is_some claim.margin) program.claims then
    bprintf out
      "extern const char *const frob_margins[];\nconst char *const frob_margins[] = {%s};\n"
      (String.concat ", " (List.map text program.claims))

(* The tables for the output, the visible probes and the assertion verdicts. If the last leaf of the
   output is the program's result, it has its own table. *)
let outputs ~enumerations out (program : Step.Ir.program) (side : Border.side) =
  let probes = Interface.record_of program.probes in
  let all =
    let pair = Interface.record_of [ ("", program.output); ("", probes) ] in
    locations program side pair
  in
  let count = List.length (Flow.Shape.leaves program.output) in
  let own, others = Basis.Long_list.split_at count all in
  let output, _ = table_of ~enumerations out program ~prefix:"out" side own program.output in
  let result =
    if not program.ends then "NULL"
    else
      match (snd (Interface.apart program.output), List.rev own) with
      | Some ended, last :: _ ->
          "&" ^ fst (table_of out program ~prefix:"result" side [ last ] ended)
      | _, _ ->
          Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "the program can end but has no result"
  in
  let claim_of name = List.find_opt (fun (c : F.claim) -> c.column = name) program.claims in
  let shapes = List.map snd program.probes in
  let placed = List.combine program.probes (Flow.Shape.split shapes others) in
  let is_shown ((name, _), _) =
    match claim_of name with Some claim -> claim.shown | None -> true
  in
  let probes =
    match List.filter is_shown placed with
    | [] -> "NULL"
    | shown ->
        let record = Interface.record_of (List.map fst shown) in
        "&" ^ fst (table_of out program ~prefix:"probe" side (List.concat_map snd shown) record)
  in
  let claim k ((name, shape), own) =
    let row (claim : F.claim) =
      let prefix = sprintf "claim_%d" k in
      let place = line_of claim.claimed_at in
      sprintf "%s, %s, %s, %d, &%s" (c_string claim.label) (c_string name) (c_string place)
        (if claim.is_assumption then 1 else 0)
        (fst (table_of out program ~prefix side own shape))
    in
    Option.map row (claim_of name)
  in
  margins out program;
  let claims = List.filter_map Fun.id (List.mapi claim placed) in
  let claims = sprintf "%s, %d" (table out "claim" "claims" claims) (List.length claims) in
  (output, result, probes, claims)

(* The table of machines, and its number of rows. *)
let machines out ~state (list : Machine_table.t list) =
  let names number (m : Machine_table.t) =
    let name = sprintf "modes_%d" number in
    bprintf out "static const char *const %s[] = {%s};\n" name
      (String.concat ", " (List.map c_string m.modes));
    name
  in
  let row number (m : Machine_table.t) =
    let within, mode =
      match m.within with Some (machine, mode) -> (machine + 1, mode) | None -> (0, 0)
    in
    sprintf "%s, offsetof(struct %s, %s), %d, %d, %s, %d, %d" (c_string m.name) state m.path
      (if m.wide then 4 else 1)
      (List.length m.modes) (names number m) within mode
  in
  let rows = List.mapi row list in
  (table out "machine" "machines" rows, List.length rows)

let robot ?own (program : Step.Ir.program) =
  List.find_map (Robot.of_shape ?own) [ program.input; program.output ]

(* The table of parameters, each with its offset in the parameter struct. *)
let params out (program : Step.Ir.program) params =
  match params with
  | None -> "NULL, 0, NULL, 0"
  | Some t ->
      let name = Param_struct.struct_name t in
      let c =
        {
          out;
          sums = [||];
          struct_name = name;
          prefix = "param";
          count = 0;
          console = [];
          enumerations = ref [];
        }
      in
      let row k (p : F.param) =
        let kind =
          match (p.param_ty, program.real) with
          | Bool, _ -> "FROB_BOOL"
          | Int, _ -> "FROB_INT"
          | _, Double -> "FROB_FLOAT"
          | _, Single -> "FROB_SINGLE"
        in
        let offset = offset c (Param_struct.member t k) in
        let value = value c ~kind ~offset ~is_event:false ~count:0 "NULL" in
        sprintf "%s, %s, &%s" (c_string p.label) (c_string p.unit_) value
      in
      let rows = List.mapi row program.params in
      let rows = table out "param" "param_rows" rows in
      sprintf "&%s, sizeof(struct %s), %s, %d" (Param_struct.defaults t) name rows
        (List.length program.params)

(* The body of the table's function [is_valid]. *)
let validity (files : Of_step.t) =
  match files.is_valid with
  | None -> "    (void)state;\n    return true;\n"
  | Some is_valid -> sprintf "    return %s((const struct %s_state *)state);\n" is_valid files.name

let text ?own ?node (program : Step.Ir.program) (files : Of_step.t) =
  let out = Buffer.create 4096 in
  let name = files.name in
  let input_side = Border.input ?own_robot:own program files.input in
  let output_side = Border.output ?own_robot:own program files.output in
  bprintf out "/* %s_host.c -- generated by frobc: the table for hosts. */\n" program.name;
  let rounds_dt = match program.real with Double -> "" | Single -> "#include <frob/step.h>\n" in
  bprintf out
    "#include \"%s.h\"\n\
     %s#include <frob/arithmetic.h>\n\
     #include <frob/program.h>\n\
     %s#include <stdbool.h>\n\
     #include <stddef.h>\n\n"
    program.name
    (Border.includes [ input_side; output_side ])
    rounds_dt;
  List.iter
    (fun side -> bprintf out "%s" (Border.definitions program side))
    [ input_side; output_side ];
  let enumerations = ref [] in
  let input, values = input ~enumerations out program input_side in
  let controls, control_count = controls out program values in
  let output, result, probes, claims = outputs ~enumerations out program output_side in
  let machines, machine_count = machines out ~state:(name ^ "_state") files.machines in
  let unread, passed = Border.passed files.params in
  let params = params out program files.params in
  let node = Node_table.write out ~enumerations:(List.rev !enumerations) node in
  let robot = Option.fold (robot ?own program) ~none:"" ~some:(fun (r : Robot.t) -> r.name) in
  bprintf out
    {|
static void reset(void *state, const void *params)
{
%s    %s_reset((struct %s_state *)state%s);
}

static bool is_valid(const void *state)
{
%s}
%s
extern const struct frob_program frob_program;
const struct frob_program frob_program = {
    FROB_PROGRAM_ABI,
    %s,
    %s,
    sizeof(struct %s_state),
    sizeof(struct %s),
    sizeof(struct %s),
    &%s,
    &%s,
    reset,
    step,
    is_valid,
    %s,
    %s,
    %s,
    %d,
    %s,
    %s,
    %d,
    %s,
    %s,
    %s,
};
|}
    unread name name passed (validity files)
    (Border.step ~params:files.params program files.sums ~name ~input:input_side ~output:output_side)
    (c_string program.name) (c_string robot) name input_side.host.struct_name
    output_side.host.struct_name input output
    (match program.real with Double -> "frob_arithmetic_faults" | Single -> "arithmetic")
    result machines machine_count probes controls control_count params claims node;
  Buffer.contents out
