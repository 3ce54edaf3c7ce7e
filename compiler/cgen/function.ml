open Basis
module M = Machine.Ir
module V = Vocabulary

type context = {
  v : V.t;
  names : Expression.names;
  node : M.node;
  result : int -> Ir.expr;  (** where an output goes *)
  read : (int, unit) Hashtbl.t;  (** variables that anything reads *)
  mutable place : string;  (** the source line last mentioned *)
}

let plain desc : Ir.statement = { desc; comment = "" }

(* Mentions the source line of a statement unless the one before did. *)
let comment c (span : Span.t) =
  let line = span.start.line in
  let place =
    if String.equal span.file c.node.file then Printf.sprintf "line %d" line
    else Printf.sprintf "%s:%d" (Filename.basename span.file) line
  in
  if String.equal place c.place then ""
  else (
    c.place <- place;
    place)

let expression c = Expression.of_machine c.names
let expressions c = List.map (expression c)

let place c : M.place -> Ir.expr = function
  | Local variable -> Name (Expression.variable c.names variable)
  | Own field -> Expression.field c.names field
  | Result k -> c.result k

(* Declarations without values, one for each run of equal types. *)
let uninitialized c variables =
  let declare groups (variable : M.variable) =
    let ty = V.ty c.v variable.ty and name = Expression.variable c.names variable in
    match groups with
    | (last, names) :: groups when last = ty -> (last, name :: names) :: groups
    | groups -> (ty, [ name ]) :: groups
  in
  List.rev_map
    (fun (ty, names) -> plain (Ir.Variables { ty; names = List.rev names }))
    (List.fold_left declare [] variables)

let step_call c ~node ~state arguments results =
  let callee = c.v.program.nodes.(node) in
  let own =
    match state with Some field -> [ Ir.Unary (Address, Expression.field c.names field) ] | None -> []
  in
  let dt = if callee.seconds then [ Ir.Name "dt" ] else [] in
  let dt_ns = if callee.nanoseconds then [ Ir.Name "dt_ns" ] else [] in
  Ir.Call (c.v.nodes.(node).step, List.concat [ own; dt; dt_ns; arguments; results ])

let rec statement c rest (s : M.statement) : Ir.statement list =
  (* Statements so far, last first. *)
  match s with
  | Declare { variable; value; span } ->
      let value = expression c value in
      let name = Expression.variable c.names variable in
      { desc = Constant { ty = V.ty c.v variable.ty; name; value }; comment = comment c span } :: rest
  | Assign { place = target; value; span } ->
      let target' = place c target in
      let desc =
        match value with
        | Operation { operator = Add; ty = Float; arguments = [ first; amount ] }
          when expression c first = target' ->
            Ir.Add_to (target', expression c amount)
        | value -> Assign (target', expression c value)
      in
      { desc; comment = comment c span } :: rest
  | If { uninitialized = variables; condition; then_; else_; predicted; span } ->
      let declarations = uninitialized c variables in
      let condition = expression c condition in
      let condition =
        (* an update without an alternative stays a branch in any case *)
        if predicted && else_ <> [] then Ir.Call (V.helper c.v Branch, [ condition ])
        else condition
      in
      let comment = comment c span in
      let then_ = statements c then_ in
      let else_ = statements c else_ in
      { desc = If { condition; then_; else_ }; comment } :: List.rev_append declarations rest
  | Step { node; state; arguments; results; span } -> (
      let arguments = expressions c arguments in
      let is_read (variable : M.variable) = Hashtbl.mem c.read variable.id in
      match results with
      | [] -> { desc = Do (step_call c ~node ~state arguments []); comment = comment c span } :: rest
      | [ variable ] when not (is_read variable) ->
          { desc = Do (step_call c ~node ~state arguments []); comment = comment c span } :: rest
      | [ variable ] ->
          let value = step_call c ~node ~state arguments [] in
          let name = Expression.variable c.names variable in
          let ty = V.ty c.v variable.ty in
          { desc = Constant { ty; name; value }; comment = comment c span } :: rest
      | variables ->
          let declarations = uninitialized c variables in
          let address variable =
            Ir.Unary (Address, Name (Expression.variable c.names variable))
          in
          let call = step_call c ~node ~state arguments (List.map address variables) in
          { desc = Do call; comment = comment c span } :: List.rev_append declarations rest)
  | Reset { node; state; arguments; span } ->
      let own = Ir.Unary (Address, Expression.field c.names state) in
      let call = Ir.Call (c.v.nodes.(node).reset, own :: expressions c arguments) in
      { desc = Do call; comment = comment c span } :: rest
  | Return { value; span } ->
      { desc = Return (expression c value); comment = comment c span } :: rest

and statements c body = List.rev (List.fold_left (statement c) [] body)

(* The programmer's names come before the compiler's: [t1] stays [t1]. *)
let name_variables names body =
  let named pass (variable : M.variable) =
    if Bool.equal pass (not (String.equal variable.name "")) then
      ignore (Expression.variable names variable)
  in
  let declared visit =
    Machine.Walk.statements
      (function
        | M.Declare { variable; _ } -> visit variable
        | If { uninitialized; _ } -> List.iter visit uninitialized
        | Step { results; _ } -> List.iter visit results
        | Assign _ | Reset _ | Return _ -> ())
      body
  in
  declared (named true);
  declared (named false)

let variables_read body =
  let read = Hashtbl.create 16 in
  Machine.Walk.expressions
    (function M.Variable v -> Hashtbl.replace read v.id () | _ -> ())
    body;
  read

let reads_state body =
  let found = ref false in
  Machine.Walk.expressions
    (function M.Field _ -> found := true | _ -> ())
    body;
  Machine.Walk.statements
    (function
      | Assign { place = Own _; _ } | Step { state = Some _; _ } | Reset _ -> found := true
      | Declare _ | Assign _ | If _ | Step _ | Return _ -> ())
    body;
  !found

let self v k = (Ir.Pointer (Struct v.V.nodes.(k).state), "self")
let ignored name = plain (Ir.Do (Cast (Void, Name name)))

let place_of (node : M.node) =
  Printf.sprintf "%s, %s:%d" node.origin (Filename.basename node.file) node.span.start.line

let no_result _ = Diagnostic.bug ~stage:"Cgen.Function" "a result where there is none"

let parameters (v : V.t) names variables =
  List.map
    (fun (variable : M.variable) ->
      let name = Expression.variable names variable in
      (V.ty v variable.ty, name))
    variables

let reset (v : V.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k in
  let parameters = self v k :: parameters v names node.reset.parameters in
  name_variables names node.reset.body;
  let c = { v; names; node; result = no_result; read = variables_read node.reset.body; place = "" } in
  let body = statements c node.reset.body in
  let unread = if reads_state node.reset.body then [] else [ ignored "self" ] in
  {
    linkage = (if V.is_root v k then External else Static);
    result = Void;
    name = v.nodes.(k).reset;
    parameters;
    body = List.rev_append (List.rev unread) body;
    comment = "";
  }

(* Few operations: worth a copy at every call. *)
let inline_size = 12

let own_step (v : V.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k in
  let given = parameters v names node.step.parameters in
  name_variables names node.step.body;
  let single, results =
    match node.outputs with
    | [ (_, ty) ] -> (V.ty v ty, [])
    | outputs ->
        let result (name, ty) =
          (Ir.Pointer (V.ty v ty), Name.fresh (Expression.scope names) ("out_" ^ name))
        in
        (Void, List.map result outputs)
  in
  let places = Array.of_list results in
  let result k = Ir.Unary (Dereference, Name (snd places.(k))) in
  let c = { v; names; node; result; read = variables_read node.step.body; place = "" } in
  let state = if V.has_state v k then [ self v k ] else [] in
  let dt = if node.seconds then [ (Ir.Real, "dt") ] else [] in
  let dt_ns = if node.nanoseconds then [ (Ir.Int64, "dt_ns") ] else [] in
  let unread =
    if V.has_state v k && not (reads_state node.step.body) then [ ignored "self" ] else []
  in
  {
    linkage = (if node.operations <= inline_size then Static_inline else Static);
    result = single;
    name = v.nodes.(k).step;
    parameters = List.concat [ state; dt; dt_ns; given; results ];
    body = List.rev_append (List.rev unread) (statements c node.step.body);
    comment = place_of node;
  }

let path from = function
  | [] -> no_result ()
  | first :: rest -> List.fold_left (fun e member -> Ir.Member (e, member)) (Ir.Arrow (from, first)) rest

(* dt becomes whole nanoseconds, and 0 where the step cannot know it. *)
let clock c (node : M.node) =
  let rounded () = Ir.Call (V.helper c.v Whole_nanoseconds, [ Name "dt" ]) in
  let at_first zero value =
    match c.v.program.first_instant with
    | Unseen -> value
    | Marked_by field -> Ir.Conditional (Expression.field c.names field, value, zero)
  in
  let seconds_of ns = Ir.Call (V.helper c.v Seconds, [ ns; Name "dt" ]) in
  let times =
    match (node.nanoseconds, node.seconds) with
    | false, false -> []
    | false, true ->
        [ plain (Ir.Assign (Name "dt", at_first (Float 0.) (seconds_of (rounded ())))) ]
    | true, seconds ->
        let value = at_first (Ir.Integer 0l) (Cast (Int64, rounded ())) in
        let ns = plain (Ir.Constant { ty = Int64; name = "dt_ns"; value }) in
        let dt () = plain (Ir.Assign (Name "dt", seconds_of (Cast (Real, Name "dt_ns")))) in
        ns :: (if seconds then [ dt () ] else [])
  in
  let mark =
    match c.v.program.first_instant with
    | Unseen -> []
    | Marked_by field ->
        [ plain (Ir.Assign (Expression.field c.names field, Boolean true)) ]
  in
  times @ mark

(* Inputs are read where they are used if their member has a name of its own;
   what is only [f1] there gets the programmer's name first. *)
let inputs c (node : M.node) =
  let direct = Interface.direct c.v.program.input in
  let take (variable : M.variable) members =
    let read = path (Name "in") members in
    if direct || String.equal variable.name "" then (
      Expression.read_as c.names variable read;
      None)
    else if Hashtbl.mem c.read variable.id then
      let ty = V.ty c.v variable.ty in
      let name = Expression.variable c.names variable in
      Some (plain (Ir.Constant { ty; name; value = read }))
    else None
  in
  List.filter_map Fun.id (List.rev (List.rev_map2 take node.step.parameters c.v.input.leaves))

let root_step (v : V.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k in
  let outputs = Array.of_list v.output.leaves in
  let result k = path (Name "out") outputs.(k) in
  let c = { v; names; node; result; read = variables_read node.step.body; place = "" } in
  let inputs = inputs c node in
  name_variables names node.step.body;
  let clock = clock c node in
  let body = statements c node.step.body in
  let unused = List.map (fun members -> plain (Ir.Assign (path (Name "out") members, Integer 0l))) v.output.unused in
  let reads_self =
    reads_state node.step.body
    || match v.program.first_instant with Marked_by _ -> true | Unseen -> false
  in
  let reads_input =
    List.exists (fun (v : M.variable) -> Hashtbl.mem c.read v.id) node.step.parameters
  in
  let ignore_unless read name = if read then [] else [ ignored name ] in
  {
    linkage = External;
    result = Void;
    name = v.nodes.(k).step;
    parameters =
      [
        self v k;
        (Real, "dt");
        (Pointer_to_const (Struct v.input.struct_name), "in");
        (Pointer (Struct v.output.struct_name), "out");
      ];
    body =
      List.concat
        [
          ignore_unless reads_self "self";
          ignore_unless (node.seconds || node.nanoseconds) "dt";
          ignore_unless reads_input "in";
          clock;
          inputs;
          body;
          unused;
        ];
    comment = place_of node;
  }

let step v k = if V.is_root v k then root_step v k else own_step v k
