module Ir = Core.Ir
module Global_table = Resolve.Global_table

type t = {
  at_once : Ir.definition list;
  ever : Ir.definition list;
  by_methods : Ir.definition list;
}

type walk = {
  numbers : int Global_table.t;  (* of the definitions, in their order *)
  leads_to_method : bool array;  (* not known yet counts as yes *)
  (* Of the present definition: *)
  mutable last_at_once : int;  (* the last definition it uses *)
  mutable last_later : int;  (* in continuations *)
  mutable uses_method : bool;
}

let uses_global w ~later name =
  match Global_table.find_opt w.numbers name with
  | None -> ()
  | Some number ->
      if later then w.last_later <- Int.max w.last_later number
      else begin
        w.last_at_once <- Int.max w.last_at_once number;
        if w.leads_to_method.(number) then w.uses_method <- true
      end

let rec visit w ~later (e : Ir.expr) =
  match e.desc with
  | Global (name, _) -> uses_global w ~later name
  | Method _ -> if not later then w.uses_method <- true
  | Local _ | Primitive _ | Number _ | Boolean _ | String _ -> ()
  | Lambda (_, e) | Component (e, _) | Index (e, _) | Is_constructor (e, _) | Payload { value = e; _ } ->
      visit w ~later e
  | Apply (f, argument) ->
      visit w ~later f;
      visit w ~later:(later || Cycle.is_continuation argument.ty) argument
  | Tuple parts | Array parts | Construct { arguments = parts; _ } -> List.iter (visit w ~later) parts
  | If (condition, then_, else_) ->
      visit w ~later condition;
      visit w ~later then_;
      visit w ~later else_
  | Let { value; body; binder = _ } ->
      visit w ~later value;
      visit w ~later body
  | Proc proc ->
      let right (eq : Ir.equation) =
        match eq.rhs with
        | Pure e -> visit w ~later e
        | Run { signal_function; input } ->
            visit w ~later signal_function;
            visit w ~later input
      in
      List.iter right proc.equations;
      visit w ~later proc.output

(* A circle has to come back up to its last definition: what no use from at or before it
   to at or after it spans is in none. [last]: the last definition that those so far use. *)
let spanned ~last number = last >= number

let of_program (program : Ir.program) =
  let count = List.length program.definitions in
  let w =
    {
      numbers = Global_table.create count;
      leads_to_method = Array.make count true;
      last_at_once = -1;
      last_later = -1;
      uses_method = false;
    }
  in
  List.iteri (fun i (d : Ir.definition) -> Global_table.replace w.numbers d.name i) program.definitions;
  let add found (d : Ir.definition) = function true -> d :: found | false -> found in
  let definition (number, found) (d : Ir.definition) =
    w.uses_method <- false;
    visit w ~later:false d.body;
    w.leads_to_method.(number) <- w.uses_method;
    let found =
      {
        at_once = add found.at_once d (spanned ~last:w.last_at_once number);
        ever = add found.ever d (spanned ~last:(Int.max w.last_at_once w.last_later) number);
        by_methods = add found.by_methods d w.uses_method;
      }
    in
    (number + 1, found)
  in
  let _, found =
    List.fold_left definition (0, { at_once = []; ever = []; by_methods = [] }) program.definitions
  in
  {
    at_once = List.rev found.at_once;
    ever = List.rev found.ever;
    by_methods = List.rev found.by_methods;
  }
