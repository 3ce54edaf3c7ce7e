module F = Flow.Ir
open Printf

(* Tables are written bottom up and numbered; a table's number is its name. *)
type context = {
  out : Buffer.t;
  sums : F.sum array;
  struct_name : string;  (** that offsets count from *)
  prefix : string;  (** of the tables' names *)
  mutable count : int;
}

(* Where a leaf lies, as paths of members. *)
type location =
  | Scalar of string
  | Sum of { tag : string; base : string; first : Machine.Layout.slots }
  | Array of (int -> location)  (** of each element *)

let c_string text = "\"" ^ String.escaped text ^ "\""
let name_or_null text = if String.equal text "" then "NULL" else c_string text

let next c =
  c.count <- c.count + 1;
  c.count

let table c kind name rows =
  match rows with
  | [] -> "NULL"
  | rows ->
      bprintf c.out "static const struct frob_%s %s[] = {\n" kind name;
      List.iter (fun row -> bprintf c.out "    {%s},\n" row) rows;
      bprintf c.out "};\n";
      name

let offset c path = sprintf "offsetof(struct %s, %s)" c.struct_name path

(* Writes a value's table and returns its name. *)
let value c ~kind ~offset ~is_event ~count constructors =
  let name = sprintf "%s_value_%d" c.prefix (next c) in
  bprintf c.out "static const struct frob_value %s = {\n    %s, %s, %d, %d, %s\n};\n" name kind
    offset
    (if is_event then 1 else 0)
    count constructors;
  name

let take locations =
  match !locations with
  | [] -> Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "fewer places than leaves"
  | location :: rest ->
      locations := rest;
      location

let foreign () = Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "a host that knows a foreign type"

(* Of a leaf that lies in one piece. *)
let rec value_at path (ty : F.ty) =
  match ty with
  | Bool | Int | Float -> Scalar path
  | Sum _ -> Sum { tag = path ^ ".tag"; base = path ^ "."; first = Machine.Layout.none }
  | Array (_, element) -> Array (fun i -> value_at (sprintf "%s.at[%d]" path i) element)
  | Foreign _ -> foreign ()

let element_of i = function
  | Array location -> location i
  | Scalar _ | Sum _ ->
      Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "an element of what is no array"

let rec shape c locations (whole : F.shape) =
  match whole with
  | Leaf ty -> leaf c ty (take locations)
  | Product product ->
      let row =
        constructor c locations ~name:product.constructor ~record:product.record product.parts
      in
      let constructors = table c "constructor" (sprintf "%s_constructors_%d" c.prefix (next c)) [ row ] in
      value c ~kind:"FROB_PRODUCT" ~offset:"0" ~is_event:false ~count:1 constructors
  | Repeated (n, element) ->
      (* As a product of its elements. *)
      let arrays = List.map (fun _ -> take locations) (Machine.Layout.shape_leaves element) in
      let row i =
        let locations = ref (List.map (element_of i) arrays) in
        sprintf "NULL, &%s" (shape c locations element)
      in
      let rows = List.rev (List.fold_left (fun rows i -> row i :: rows) [] (List.init n Fun.id)) in
      let fields = table c "field" (sprintf "%s_fields_%d" c.prefix (next c)) rows in
      let row = sprintf "NULL, 0, %d, %s" n fields in
      let constructors = table c "constructor" (sprintf "%s_constructors_%d" c.prefix (next c)) [ row ] in
      value c ~kind:"FROB_ARRAY" ~offset:"0" ~is_event:false ~count:1 constructors

and constructor c locations ~name ~record parts =
  let field (name, part) =
    let value = shape c locations part in
    sprintf "%s, &%s" (name_or_null name) value
  in
  (* From the first to the last: the locations are in that order. *)
  let fields = List.rev (List.fold_left (fun rows part -> field part :: rows) [] parts) in
  let fields = table c "field" (sprintf "%s_fields_%d" c.prefix (next c)) fields in
  sprintf "%s, %d, %d, %s" (name_or_null name) (if record then 1 else 0) (List.length parts) fields

and leaf c (ty : F.ty) location =
  let scalar kind path = value c ~kind ~offset:(offset c path) ~is_event:false ~count:0 "NULL" in
  match (ty, location) with
  | Bool, Scalar path -> scalar "FROB_BOOL" path
  | Int, Scalar path -> scalar "FROB_INT" path
  | Float, Scalar path -> scalar "FROB_FLOAT" path
  | Sum k, Sum { tag; base; first } -> sum c k ~tag ~base ~first
  | Foreign _, _ -> foreign ()
  | (Bool | Int | Float | Sum _ | Array _), (Scalar _ | Sum _ | Array _) ->
      Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "a leaf and its place do not match"

and sum c k ~tag ~base ~first =
  let sum = c.sums.(k) in
  let locate (slot : Sum_type.slot) ty =
    match slot with
    | Scalar member -> value_at (base ^ member) ty
    | Inner { sum = _; tag; first } -> Sum { tag = base ^ tag; base; first }
  in
  let row (ctor : F.sum_constructor) =
    let slots = Sum_type.payload c.sums ~first ctor in
    let locations = ref (List.map2 locate slots (Machine.Layout.leaves ctor)) in
    let record = List.exists (fun (name, _) -> not (String.equal name "")) ctor.fields in
    constructor c locations ~name:ctor.constructor ~record ctor.fields
  in
  let rows = List.rev (List.fold_left (fun rows ctor -> row ctor :: rows) [] sum.constructors) in
  let constructors = table c "constructor" (sprintf "%s_constructors_%d" c.prefix (next c)) rows in
  let is_event =
    String.equal sum.module_ "Prelude"
    && match String.split_on_char ' ' sum.name with "Event" :: _ -> true | _ -> false
  in
  value c ~kind:"FROB_SUM" ~offset:(offset c tag) ~is_event ~count:(List.length rows) constructors

(* Of each leaf. *)
let locations (i : Interface.t) whole =
  let rec locate path (steps : Interface.step list) (ty : F.ty) =
    match (steps, ty) with
    | [], _ -> value_at path ty
    | Member name :: rest, _ -> locate (if path = "" then name else path ^ "." ^ name) rest ty
    | Element _ :: rest, Array (_, element) ->
        Array (fun i -> locate (sprintf "%s[%d]" path i) rest element)
    | Element _ :: _, (Bool | Int | Float | Sum _ | Foreign _) ->
        Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "an array of a leaf that is none"
  in
  List.rev (List.rev_map2 (locate "") i.leaves (Machine.Layout.shape_leaves whole))

let interface out sums ~prefix (i : Interface.t) whole =
  let c = { out; sums; struct_name = i.struct_name; prefix; count = 0 } in
  shape c (ref (locations i whole)) whole

(* The output's last leaf once more, by itself. *)
let result out (program : Machine.Ir.program) (i : Interface.t) =
  let c =
    { out; sums = program.sums; struct_name = i.struct_name; prefix = "result"; count = 0 }
  in
  match (snd (Interface.apart program.output), List.rev (locations i program.output)) with
  | Some ended, last :: _ -> "&" ^ shape c (ref [ last ]) ended
  | _, _ -> Basis.Diagnostic.bug ~stage:"Cgen.Host_table" "a program that ends without a result"

(* The table of machines, and how many rows it has. *)
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
  let c = { out; sums = [||]; struct_name = state; prefix = ""; count = 0 } in
  (table c "machine" "machines" rows, List.length rows)

let text (program : Machine.Ir.program) (files : Of_machine.t) =
  let out = Buffer.create 4096 in
  let name = files.name in
  bprintf out "/* %s_host.c -- generated by frobc: the table for hosts. */\n" program.name;
  bprintf out "#include \"%s.h\"\n#include <frob/arithmetic.h>\n#include <frob/program.h>\n#include <stddef.h>\n\n" program.name;
  let input = interface out program.sums ~prefix:"in" files.input program.input in
  let output = interface out program.sums ~prefix:"out" files.output program.output in
  let result = if program.ends then result out program files.output else "NULL" in
  let machines, machine_count = machines out ~state:(name ^ "_state") files.machines in
  let robot =
    match (Robot.of_shape program.input, Robot.of_shape program.output) with
    | Some robot, _ | None, Some robot -> robot.name
    | None, None -> ""
  in
  bprintf out
    {|
static void reset(void *state)
{
    %s_reset((struct %s_state *)state);
}

static void step(void *state, double dt, const void *in, void *out)
{
    %s_step((struct %s_state *)state, dt, (const struct %s *)in, (struct %s *)out);
}

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
    frob_arithmetic_faults,
    %s,
    %s,
    %d,
};
|}
    name name name name files.input.struct_name files.output.struct_name (c_string program.name)
    (c_string robot) name files.input.struct_name files.output.struct_name input output
    result machines machine_count;
  Buffer.contents out
