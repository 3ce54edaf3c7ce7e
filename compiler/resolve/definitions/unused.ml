open Basis

type kind = Equation | Variable of Span.t (* span of the whole pattern *)

(* A vertex of the dependency graph: a variable, or a destructuring binding. The variables of such a
   binding depend on it. *)
type vertex = { name : string; at : Span.t; kind : kind; needs : int list }

type found = {
  mutable vertices : vertex list; (* newest first *)
  mutable count : int;
  of_local : int Int_table.t;
  mutable told : int list; (* vertices whose values hosts report, so they count as used *)
  mutable reads : (int * int) list; (* pairs of a vertex and a local variable that it reads *)
  mutable parameters : Span.t list; (* the parameters of functions *)
  mutable zeros : (string list * Span.t) list;
      (* literal zeros in commands, each with the variable names usually found in its place *)
}

let names_of_speeds = [ "v"; "vel"; "speed"; "velocity"; "linear"; "forward" ]

let names_of_turns =
  [ "omega"; "w"; "turn"; "turning"; "turnRate"; "rotation"; "angular"; "steer"; "steering"; "yaw" ]

let is_zero (e : Ir.expr) =
  match e.desc with Number { digits; _ } -> float_of_string_opt digits = Some 0. | _ -> false

(* The literal zeros among the arguments of `setVelTR`, as in `setVelTR v 0`. *)
let zeros (e : Ir.expr) =
  match Walk.application e with
  | { desc = Global { name = "setVelTR"; _ }; _ }, [ v; omega ] ->
      List.filter
        (fun (_, (e : Ir.expr)) -> is_zero e)
        [ (names_of_speeds, v); (names_of_turns, omega) ]
      |> List.map (fun (names, (e : Ir.expr)) -> (names, e.span))
  | _ -> []

let zero_for found name =
  match List.filter (fun (names, _) -> List.mem name names) found.zeros with
  | [ (_, at) ] -> Some at
  | _ -> None

let add found vertex =
  let number = found.count in
  found.vertices <- vertex :: found.vertices;
  found.count <- number + 1;
  number

let add_local found kind needs (local : Ir.Local.t) =
  Int_table.replace found.of_local local.id
    (add found { name = local.name; at = local.span; kind; needs })

let add_pattern found needs (pattern : Ir.pattern) =
  List.iter (add_local found (Variable pattern.span) needs) (Patterns.variables pattern)

(* [reader]: the vertex that contains the expression. *)
let rec expr found reader (e : Ir.expr) =
  match e.desc with
  | Local local -> found.reads <- (reader, local.id) :: found.reads
  | _ ->
      found.zeros <- zeros e @ found.zeros;
      Walk.expr (visitor found reader) e

(* Is this an equation such as [error = meanOf x], whose value `frobc test` reports? *)
and is_measured (b : Ir.binding) =
  match b.body.guards with
  | [ { condition = None; value = { desc = Apply { head = { desc = Global g; _ }; _ }; _ } } ] ->
      Labels.is_measuring g
  | _ -> false

and binding found (b : Ir.binding) =
  let number = found.count in
  found.parameters <- List.map (fun (p : Ir.pattern) -> p.span) b.parameters @ found.parameters;
  (match b.name with
  | Top (g, at) -> ignore (add found { name = g.name; at; kind = Equation; needs = [] })
  | Inner local ->
      add_local found Equation [] local;
      if is_measured b || Labels.is_name local.name then found.told <- number :: found.told
  | Destructure p ->
      (* A pattern without variables is unused on purpose, so it is treated like the name `_`. *)
      let name = if Patterns.variables p = [] then "_" else "" in
      ignore (add found { name; at = p.span; kind = Equation; needs = [] });
      add_pattern found [ number ] p);
  Walk.binding (visitor found number) b

and visitor found reader : Walk.visitor =
  { expr = expr found reader; pattern = add_pattern found []; binding = binding found }

(* Reports the unread variables of one pattern: together if there are four or more, otherwise one by
   one. *)
let report_variables report found vertices =
  let variable { name; at; kind; _ } : Fact.variable =
    let is_parameter =
      match kind with
      | Variable whole -> List.exists (fun at -> Span.compare at whole = 0) found.parameters
      | Equation -> false
    in
    { name; at; is_parameter; zero = zero_for found name }
  in
  let variables = List.map variable vertices in
  match variables with
  | first :: (_ :: _ :: _ :: _ as others) -> report (Fact.Unused_variables (first, others))
  | few -> List.iter (fun variable -> report (Fact.Unused_variables (variable, []))) few

(* Reports the unused names in one definition. *)
let of_definition report ~is_mentioned (b : Ir.binding) =
  let found =
    {
      vertices = [];
      count = 0;
      of_local = Int_table.create 16;
      told = [];
      reads = [];
      parameters = [];
      zeros = [];
    }
  in
  binding found b;
  let vertices = Array.of_list (List.rev found.vertices) in
  let graph = Array.map (fun v -> v.needs) vertices in
  let read (reader, local) =
    let vertex = Int_table.find found.of_local local in
    graph.(reader) <- vertex :: graph.(reader)
  in
  List.iter read found.reads;
  let used = Array.make found.count false in
  let unused = Array.make found.count false in
  used.(0) <- true;
  List.iter (fun k -> used.(k) <- true) found.told;
  let is_silent v = v.kind <> Equation && String.starts_with ~prefix:"_" v.name in
  (* Visits users before the definitions they use. An unused pattern variable does not mark its
     pattern as used. Therefore a pattern without used variables is reported only once, as a
     whole. *)
  let component members =
    let first = vertices.(List.hd members) in
    let is_used = is_silent first || List.exists (fun v -> used.(v)) members in
    let mark v = if not (List.mem v members) then used.(v) <- true in
    if is_used || first.kind = Equation then List.iter (fun v -> List.iter mark graph.(v)) members;
    if not is_used then unused.(List.hd members) <- true
  in
  let components = List.rev (Graph.components graph) in
  List.iter component components;
  let unread = ref [] in
  let report_component members =
    let number = List.hd members in
    let v = vertices.(number) in
    if unused.(number) && not (List.exists (fun whole -> unused.(whole)) v.needs) then
      match v.kind with
      | Equation when String.starts_with ~prefix:"_" v.name -> ()
      | Equation ->
          let name v = if v.name = "" then None else Some v.name in
          let name_of number = name vertices.(number) in
          let circle =
            if Graph.is_cyclic graph members then List.filter_map name_of members else []
          in
          report
            (Fact.Unused_equation { at = v.at; name = name v; circle; zero = zero_for found v.name })
      | Variable _ -> if not (is_mentioned v.at) then unread := number :: !unread
  in
  List.iter report_component components;
  (* Groups the variables by pattern. The variables of a pattern have consecutive numbers. *)
  let by_pattern patterns number =
    let v = vertices.(number) in
    match patterns with
    | (w :: _ as variables) :: others when w.kind = v.kind -> (v :: variables) :: others
    | _ -> [ v ] :: patterns
  in
  List.sort (fun a b -> Int.compare b a) !unread
  |> List.fold_left by_pattern []
  |> List.iter (report_variables report found)

(* The modules that these modules import, directly or indirectly, including themselves. *)
let reached by_name names =
  let found = String_table.create 16 in
  let rec visit name =
    if not (String_table.mem found name) then (
      String_table.replace found name ();
      Option.iter
        (fun (m : Ir.module_) -> List.iter visit m.imports)
        (String_table.find_opt by_name name))
  in
  List.iter visit names;
  found

(* Does only this import of the module provide instances of classes that the program's other imports
   provide? For example, only `import Robot` makes the robot `ros` an instance of the class of
   `import Lidar`. *)
let only_source_of_instances by_name (program : Ir.program) ~own (importer : Ir.module_) name =
  let others (m : Ir.module_) =
    if m == importer then List.filter (fun other -> other <> name) m.imports else m.imports
  in
  let without = reached by_name (List.concat_map others own) and with_ = reached by_name [ name ] in
  let is_lost (m : Ir.module_) =
    String_table.mem with_ m.name && not (String_table.mem without m.name)
  in
  let lost_files = String_table.create 16 in
  List.iter
    (fun (m : Ir.module_) -> if is_lost m then String_table.replace lost_files m.file ())
    program.modules;
  List.exists
    (fun (i : Ir.instance) ->
      String_table.mem lost_files i.span.file && String_table.mem without i.class_.module_)
    program.instances

(* An import may be needed only for the module's instances or those of the modules that it
   imports. *)
let imports report (program : Ir.program) =
  let own = Walk.own_modules program in
  let with_instances = String_table.create 16 and by_name = String_table.create 16 in
  List.iter
    (fun (i : Ir.instance) -> String_table.replace with_instances i.span.file ())
    program.instances;
  List.iter (fun (m : Ir.module_) -> String_table.replace by_name m.name m) program.modules;
  let gives_instances (m : Ir.module_) = String_table.mem with_instances m.file in
  let own_give_instances = List.exists gives_instances own in
  let may_be_for_instances importer name =
    match String_table.find_opt by_name name with
    | Some ({ library = true; _ } as m) ->
        gives_instances m || only_source_of_instances by_name program ~own importer name
    | Some _ | None -> own_give_instances
  in
  let of_module (m : Ir.module_) =
    let told (idle : Ir.idle) =
      idle.listed <> None || not (may_be_for_instances m idle.of_module)
    in
    List.iter (fun idle -> report (Fact.Unused_import idle)) (List.filter told m.idle_imports)
  in
  List.iter of_module own

let warn facts ~is_mentioned program =
  let report warning = Facts.report facts (Fact.Warning warning) in
  imports report program;
  List.iter (of_definition report ~is_mentioned) (Walk.own program)
