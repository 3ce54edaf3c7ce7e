open Basis

type kind = Equation | Variable of Span.t (* the whole pattern *)

(* A variable, or a binding that takes a pattern apart, whose variables depend on it. *)
type vertex = { name : string; at : Span.t; kind : kind; needs : int list }

type found = {
  mutable vertices : vertex list; (* the last one first *)
  mutable count : int;
  of_local : int Int_table.t;
  mutable told : int list; (* vertices that hosts tell of, whoever reads them *)
  mutable reads : (int * int) list; (* who reads which local variable *)
}

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

(* [reader]: the vertex that what is looked at belongs to. *)
let rec expr found reader (e : Ir.expr) =
  match e.desc with
  | Local local -> found.reads <- (reader, local.id) :: found.reads
  | _ -> Walk.expr (visitor found reader) e

(* [error = meanOf x], whose value a test tells. *)
and is_measured (b : Ir.binding) =
  match b.body.guards with
  | [ { condition = None; value = { desc = Apply { head = { desc = Global g; _ }; _ }; _ } } ] ->
      Labels.is_measuring g
  | _ -> false

and binding found (b : Ir.binding) =
  let number = found.count in
  (match b.name with
  | Top (g, at) -> ignore (add found { name = g.name; at; kind = Equation; needs = [] })
  | Inner local ->
      add_local found Equation [] local;
      if is_measured b || Labels.is_name local.name then found.told <- number :: found.told
  | Destructure p ->
      (* A pattern without variables is there for nobody to use. *)
      let name = if Patterns.variables p = [] then "_" else "" in
      ignore (add found { name; at = p.span; kind = Equation; needs = [] });
      add_pattern found [ number ] p);
  Walk.binding (visitor found number) b

and visitor found reader : Walk.visitor =
  { expr = expr found reader; pattern = add_pattern found []; binding = binding found }

(* [circle]: the names that depend on each other, if it is one. *)
let report_equation sink ~circle at name =
  Diagnostic.warning ~code:"W0304" ~at "%s here, and nothing uses %s"
    (if name = "" then "these are defined" else Printf.sprintf "`%s` is defined" name)
    (if name = "" then "them" else "it")
  |> (match circle with
     | [] -> Fun.id
     | [ _ ] -> Diagnostic.note "only its own equation reads it"
     | names -> Diagnostic.note (Enumeration.all names ^ " use only each other"))
  |> Diagnostic.hint
       (if name = "" then "use one of them in what comes out, or take the equation out"
        else
          Printf.sprintf "use it in what comes out, or take it out; `_%s` says that this is meant"
            name)
  |> (if name = "" || name.[0] < 'a' then Fun.id
      else Diagnostic.fix (Printf.sprintf "call it `_%s`" name) [ (at, "_" ^ name) ])
  |> Diagnostic.emit sink

let report_variable sink v =
  Diagnostic.warning ~code:"W0305" ~at:v.at "nothing reads `%s`" v.name
  |> Diagnostic.hint (Printf.sprintf "write `_` in its place, or `_%s`" v.name)
  |> Diagnostic.fix ~safe:true (Printf.sprintf "write `_%s`" v.name) [ (v.at, "_" ^ v.name) ]
  |> Diagnostic.emit sink

(* Of one pattern; many are told at once. *)
let report_variables sink = function
  | a :: b :: c :: (_ :: _ as others) ->
      let told = List.map (fun v -> Printf.sprintf "`%s`" v.name) [ a; b; c ] in
      Diagnostic.warning ~code:"W0305" ~at:a.at "nothing reads %s"
        (Enumeration.some told ~more:(List.length others))
      |> Diagnostic.hint (Printf.sprintf "write `_` in their places, or names such as `_%s`" a.name)
      |> Diagnostic.fix ~safe:true
           (Printf.sprintf "write `_%s` and likewise the others" a.name)
           (List.map (fun v -> (v.at, "_" ^ v.name)) (a :: b :: c :: others))
      |> Diagnostic.emit sink
  | few -> List.iter (report_variable sink) few

(* A definition's own: each vertex with what it needs, and what the definition needs itself. *)
let of_definition sink ~is_labelled (b : Ir.binding) =
  let found = { vertices = []; count = 0; of_local = Int_table.create 16; told = []; reads = [] } in
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
  (* Components come after what leads to them. What an unused variable of a pattern needs is not
     used by that, so that a pattern of which nothing is used is told as one. *)
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
  let report members =
    let number = List.hd members in
    let v = vertices.(number) in
    if unused.(number) && not (List.exists (fun whole -> unused.(whole)) v.needs) then
      match v.kind with
      | Equation when String.starts_with ~prefix:"_" v.name -> ()
      | Equation ->
          let name v =
            if vertices.(v).name = "" then None else Some (Printf.sprintf "`%s`" vertices.(v).name)
          in
          let circle = if Graph.is_cyclic graph members then List.filter_map name members else [] in
          report_equation sink ~circle v.at v.name
      | Variable _ -> if not (is_labelled v.at) then unread := number :: !unread
  in
  List.iter report components;
  (* The variables of a pattern stand beside each other. *)
  let by_pattern patterns number =
    let v = vertices.(number) in
    match patterns with
    | (w :: _ as variables) :: others when w.kind = v.kind -> (v :: variables) :: others
    | _ -> [ v ] :: patterns
  in
  List.sort (fun a b -> Int.compare b a) !unread
  |> List.fold_left by_pattern []
  |> List.iter (report_variables sink)

let report_import sink (idle : Ir.idle) =
  (match idle.listed with
  | Some name ->
      Diagnostic.warning ~code:"W0306" ~at:idle.at "`%s` is imported, and nothing uses it" name
  | None ->
      Diagnostic.warning ~code:"W0306" ~at:idle.at "nothing of `%s` is used here" idle.of_module)
  |> Diagnostic.hint "take it out"
  |> Diagnostic.fix ~safe:true "take it out" [ (idle.whole, "") ]
  |> Diagnostic.emit sink

(* A module may be imported for its instances; a user's own for those of what it imports. *)
let imports sink (program : Ir.program) =
  let own = Walk.own_modules program in
  let gives_instances (m : Ir.module_) =
    List.exists (fun (i : Ir.instance) -> String.equal i.span.file m.file) program.instances
  in
  let may_be_for_instances name =
    match List.find_opt (fun (m : Ir.module_) -> String.equal m.name name) program.modules with
    | Some ({ library = true; _ } as m) -> gives_instances m
    | Some _ | None -> List.exists gives_instances own
  in
  let told (idle : Ir.idle) = idle.listed <> None || not (may_be_for_instances idle.of_module) in
  let report (m : Ir.module_) = List.iter (report_import sink) (List.filter told m.idle_imports) in
  List.iter report own

let warn sink program =
  imports sink program;
  (* Another warning may have the reason: `stop` where `Stop` was meant. *)
  let labels = List.concat_map (fun (d : Diagnostic.t) -> d.labels) (Diagnostic.all sink) in
  let is_labelled at = List.exists (fun (l : Diagnostic.label) -> l.at = at) labels in
  List.iter (of_definition sink ~is_labelled) (Walk.own program)
