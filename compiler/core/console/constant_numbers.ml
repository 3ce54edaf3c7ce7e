open Ir
module Table = Hashtbl

type t = (int, unit) Table.t

let none = Table.create 1
let has t (local : Local.t) = Table.mem t local.id

(* The expressions that variables are bound to, if any. *)
type values = { globals : (Global.t, expr) Table.t; locals : (int, expr) Table.t }

let note_values values (e : expr) =
  match e.desc with
  | Let { binder; value; _ } -> Table.replace values.locals binder.local.id value
  | Proc proc ->
      List.iter
        (fun (eq : equation) ->
          match eq.rhs with
          | Pure value -> Table.replace values.locals eq.binder.local.id value
          | Run _ -> ())
        proc.equations
  | _ -> ()

let rec spine arguments (e : expr) =
  match e.desc with Apply (f, x) -> spine (x :: arguments) f | _ -> (e, arguments)

let rec parameters (e : expr) =
  match e.desc with Lambda (binder, body) -> binder :: parameters body | _ -> []

let of_program (program : program) =
  let wanted = Table.create 16 in
  let values = { globals = Table.create 64; locals = Table.create 64 } in
  let changed = ref false in
  let rec want (e : expr) = Term.visit want_variable e
  and want_variable (e : expr) =
    match e.desc with
    | Local local when not (Table.mem wanted local.id) ->
        Table.replace wanted local.id ();
        changed := true;
        Option.iter want (Table.find_opt values.locals local.id)
    | _ -> ()
  in
  let pass parameters arguments =
    List.iteri
      (fun k argument ->
        match List.nth_opt parameters k with
        | Some (binder : binder) when Table.mem wanted binder.local.id -> want argument
        | Some _ | None -> ())
      arguments
  in
  let visit (e : expr) =
    match spine [] e with
    | { desc = Primitive (Console Knob, _); _ }, _ :: least :: most :: first :: _ ->
        List.iter want [ least; most; first ]
    | { desc = Primitive (Console Toggle, _); _ }, _ :: first :: _ -> want first
    | { desc = Global (g, _); _ }, arguments ->
        let body = Table.find_opt values.globals g in
        pass (Option.fold body ~none:[] ~some:parameters) arguments
    | { desc = Local f; _ }, arguments ->
        let body = Table.find_opt values.locals f.id in
        pass (Option.fold body ~none:[] ~some:parameters) arguments
    | _ -> ()
  in
  if not (Console.asks program) then none
  else (
    List.iter
      (fun (d : definition) ->
        Table.replace values.globals d.name d.body;
        Term.visit (note_values values) d.body)
      program.definitions;
    let rec repeat () =
      changed := false;
      List.iter (fun (d : definition) -> Term.visit visit d.body) program.definitions;
      if !changed then repeat ()
    in
    repeat ();
    wanted)
