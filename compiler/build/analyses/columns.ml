module Ir = Typing.Ir

type t = {
  name : string;
  unit_ : string;
  is_event : bool;
  instance : string;
  own : string;
  file : string;
  line : int;
}

(* {1 Inputs and outputs} *)

let is_of (product : Flow.Ir.product) (d : Ir.data) =
  String.equal d.tycon.name product.product_name
  && String.equal d.tycon.module_ product.product_module
  && d.unit_parameters = [] && d.type_parameters = []

let declared (typed : Ir.program) product =
  let ty (data : Ir.data) = Ir.Data { tycon = data.tycon; units = []; arguments = [] } in
  Option.map ty (List.find_opt (is_of product) typed.data)

(* Looks up the type of a record by the record's name. For a tuple, returns [around]. *)
let type_of typed product ~around =
  match declared typed product with Some ty -> Some ty | None -> around

(* Names the columns as in a trace. *)
let rec with_units typed written ~console name around (shape : Flow.Ir.shape) =
  let row name unit_ =
    { name; unit_; is_event = false; instance = ""; own = ""; file = ""; line = 0 }
  in
  let with_units = with_units typed written ~console in
  match shape with
  | Product { product_module; product_name; _ }
    when Core.Console.has_name ~module_:product_module product_name ->
      List.filter_map
        (fun (c : Core.Ir.control) ->
          if c.unit_ = "" then None else Some (row (name ^ "." ^ c.label) c.unit_))
        console
  | Product ({ constructor; record; parts; _ } as product) when constructor = "" || record ->
      let around = type_of typed product ~around in
      let part k (field, shape) =
        let word = if field = "" then string_of_int (k + 1) else field in
        let ty = Option.bind around (fun ty -> Probe.Signal_types.part written ty [ word ]) in
        with_units (name ^ "." ^ word) ty shape
      in
      List.concat (List.mapi part parts)
  | Product _ | Leaf _ | Repeated _ -> (
      match Option.bind around Probe.Signal_types.unit_ with
      | Some unit_ -> [ row name unit_ ]
      | None -> [])

(* The robot's command: the program's output or, if the program can end, the output without the
   program's result. *)
let command (program : Flow.Ir.program) =
  match program.output with
  | Product { constructor = ""; parts = [ (_, command); _ ]; _ } when program.ends -> command
  | output -> output

let sides typed (entry : Ir.definition) (program : Flow.Ir.program) =
  let written = Probe.Signal_types.of_program typed in
  let input, output =
    match entry.scheme.ty with
    | Signal_function (input, output) -> (Some input, Some output)
    | _ -> (None, None)
  in
  let with_units = with_units typed written ~console:program.console in
  with_units "in" input program.input @ with_units "out" output (command program)

(* {1 Probes} *)

let rec is_written_event (ty : Ir.ty) =
  match ty with
  | Data { tycon = { name = "Array"; _ }; arguments = [ _; element ]; _ } ->
      is_written_event element
  | Data { tycon = { name = "Event"; _ }; _ } -> true
  | _ -> false

let rec is_event (program : Flow.Ir.program) (ty : Flow.Ir.ty) =
  match ty with
  | Sum k -> String.starts_with ~prefix:"Event " program.sums.(k).name
  | Array (_, element) -> is_event program element
  | Bool | Int | Float | Foreign _ -> false

let instance (p : Probe.Catalogue.probe) =
  let own = "." ^ p.signal in
  if String.ends_with ~suffix:own p.name then
    String.sub p.name 0 (String.length p.name - String.length own)
  else String.concat "." p.whole

let probe types program (p : Probe.Catalogue.probe) =
  let ty = Probe.Instance_types.type_of types p in
  {
    name = "probe." ^ p.name;
    unit_ = Option.value (Option.bind ty Probe.Signal_types.unit_) ~default:"";
    is_event =
      (match (ty, p.ty) with
      | Some ty, _ -> is_written_event ty
      | None, Some ty -> is_event program ty
      | None, None -> false);
    instance = instance p;
    own = p.signal;
    file = Filename.basename p.span.file;
    line = Basis.Span.line p.span.start;
  }

let of_program typed entry program probes =
  let types = Probe.Instance_types.of_program typed program in
  sides typed entry program @ List.map (probe types program) probes

(* {1 The table} *)

let text all =
  let quoted = Basis.C_string.literal in
  let row c =
    Printf.sprintf "    {%s, %s, %d, %s, %s, %s, %d},\n" (quoted c.name) (quoted c.unit_)
      (Bool.to_int c.is_event) (quoted c.instance) (quoted c.own) (quoted c.file) c.line
  in
  "#include <frob/columns.h>\n#include <stddef.h>\n\nconst struct frob_column frob_columns[] = {\n"
  ^ String.concat "" (List.map row all)
  ^ "    {NULL, NULL, 0, NULL, NULL, NULL, 0},\n};\n"
