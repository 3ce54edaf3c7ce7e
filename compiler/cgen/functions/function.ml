open Basis
module V = Vocabulary
open Context

(* Whether an array consists of literals, so that C can initialize it statically. *)
let is_literal : M.expr -> bool = function
  | Elements { elements; _ } ->
      let is_literal : M.expr -> bool = function
        | Bool _ | Int _ -> true
        | Float x -> not (V.is_negative_zero x)
        | _ -> false
      in
      List.for_all is_literal elements
  | _ -> false

let is_loop (s : Ir.statement) = match s.desc with Ir.For _ -> true | _ -> false

let place c : M.place -> Ir.expr = function
  | Local variable -> Name (Expression.variable c.names variable)
  | Own field -> Expression.field c.names field
  | Result _ -> Diagnostic.bug ~stage:"Cgen.Function" "a result cannot be read"

let rec statement c rest (s : M.statement) : Ir.statement list =
  (* [rest]: the preceding statements, in reverse order. *)
  match s with
  | Declare { variable; value; span } ->
      let value = Expression.unlimited c.names variable value in
      let literal = is_literal value in
      let value = Context.value c ~at:span value in
      let name = Expression.variable c.names variable and ty = V.ty c.v variable.ty in
      let desc = if literal then Ir.Table { ty; name; value } else Constant { ty; name; value } in
      { desc; comment = comment c span } :: rest
  | Assign { place = Result k; value; span } ->
      { (c.write k (Context.value c ~at:span value)) with comment = comment c span } :: rest
  | Assign { place = (Local _ | Own _) as target; value; span } ->
      let target' = place c target in
      let bounded = match target with Own f -> Expression.bounded c.names f value | _ -> None in
      let desc =
        match (bounded, value) with
        | Some bounded, _ -> bounded
        | None, Operation { operator = Add; ty = Float; arguments = [ first; amount ]; _ }
          when expression c first = target' ->
            Ir.Add_to (target', expression c amount)
        | None, value -> Assign (target', Context.value c ~at:span value)
      in
      { desc; comment = comment c span } :: rest
  | If { uninitialized = variables; condition; then_; else_; predicted; span } ->
      let declarations = uninitialized c variables in
      let condition = expression c condition in
      let condition =
        (* an [if] without [else] is compiled to a branch anyway *)
        if predicted && else_ <> [] then Ir.Call ("FROB_BRANCH", [ condition ]) else condition
      in
      let comment = comment c span in
      let then_ = statements c then_ in
      let else_ = statements c else_ in
      { desc = If { condition; then_; else_ }; comment } :: List.rev_append declarations rest
  | Step { node; state = Some state; arguments; results; on_trial = true; span } ->
      let ty = Ir.Struct c.v.nodes.(node).state in
      let name = Name.fresh (Expression.scope c.names) "trial" in
      let copy = plain (Ir.Variable { ty; name; value = Expression.field c.names state }) in
      step c (copy :: rest) ~node ~own:[ Ir.Unary (Address, Name name) ] arguments results span
  | Step { node; state; arguments; results; on_trial = _; span } ->
      step c rest ~node ~own:(own_state c state) arguments results span
  | Reset { node; state; arguments; span } ->
      let arguments = for_reset c node arguments in
      let call own = Ir.Do (Call (c.v.nodes.(node).reset, own :: arguments)) in
      let desc =
        match state.content with
        | States_of { count; _ } ->
            let index = Expression.index c.names 0 in
            let own = Ir.Subscript (Expression.field c.names state, Name index) in
            Ir.For { index; count; body = [ plain (call (Unary (Address, own))) ] }
        | State_of _ | Value _ | Running_mode | Modes _ | Component _ ->
            call (Expression.state c.names state)
      in
      { desc; comment = comment c span } :: rest
  | Loop l ->
      let own index =
        let of_round field =
          Ir.Unary (Address, Subscript (Expression.field c.names field, Name index))
        in
        Option.to_list (Option.map of_round l.state)
      in
      let call index = step_call c ~node:l.node ~own:(own index) in
      let statements = Loop.statements c.names l ~call in
      let comment = comment c l.span in
      let placed s = if is_loop s then { s with Ir.comment } else s in
      List.rev_append (List.map placed statements) rest
  | Enter { entry; span } -> List.rev_append (Modes.enter c entry span) rest
  | Run run -> List.rev_append (Modes.run c run) rest
  | Return { value; span } ->
      { desc = Return (Context.value c ~at:span value); comment = comment c span } :: rest

and step c rest ~node ~own arguments results span =
  let call = step_call c ~node ~own (for_step c node arguments) in
  let is_read (variable : M.variable) = Int_table.mem c.read variable.id in
  match results with
  | [] -> { desc = Do (call []); comment = comment c span } :: rest
  | [ variable ] when not (is_read variable) ->
      { desc = Do (call []); comment = comment c span } :: rest
  | [ variable ] ->
      let value = call [] in
      let name = Expression.variable c.names variable in
      let ty = V.ty c.v variable.ty in
      { desc = Constant { ty; name; value }; comment = comment c span } :: rest
  | variables ->
      let declarations = uninitialized c variables in
      let address variable = Expression.address (expression c (M.Variable variable)) in
      { desc = Do (call (List.map address variables)); comment = comment c span }
      :: List.rev_append declarations rest

and statements c body = List.rev (List.fold_left (statement c) [] body)

(* Chooses names for the programmer's variables before generated ones, so that the programmer's [t1]
   stays [t1]. *)
let name_variables names body =
  let named pass (variable : M.variable) =
    if Bool.equal pass (not (String.equal variable.name "")) then
      ignore (Expression.variable names variable)
  in
  let declared visit =
    Step.Walk.statements
      (function
        | M.Declare { variable; _ } -> visit variable
        | If { uninitialized; _ } -> List.iter visit uninitialized
        | Step { results; _ } | Loop { results; _ } -> List.iter visit results
        | Run { results; cases; _ } ->
            List.iter visit results;
            List.iter (fun (case : M.case) -> List.iter visit case.others) cases
        | Assign _ | Reset _ | Enter _ | Return _ -> ())
      body
  in
  declared (named true);
  declared (named false)

(* The variables that are read. A variable that is only passed on through the pointer to the input
   does not count. *)
let variables_read (v : Program_names.t) (node : M.node) body =
  let reads = Int_table.create 16 in
  let count n (variable : M.variable) =
    let before = Option.value (Int_table.find_opt reads variable.id) ~default:0 in
    Int_table.replace reads variable.id (before + n)
  in
  Step.Walk.expressions (function M.Variable variable -> count 1 variable | _ -> ()) body;
  List.iter (count (-1)) (Program_input.variables_by_pointer v.by_pointer v.program node body);
  let read = Int_table.create 16 in
  Int_table.fold (fun id n () -> if n > 0 then Int_table.replace read id ()) reads ();
  read

let self v k = (Ir.Pointer (Struct (V.state_struct v k)), "self")

(* The parameter that points to the program's parameters, if there are any and the function reads
   them. *)
let params (v : Program_names.t) is_read =
  match v.params with
  | Some params when is_read ->
      [ (Ir.Pointer_to_const (Struct (Param_struct.struct_name params)), "params") ]
  | Some _ | None -> []

let ignored name = plain (Ir.Do (Cast (Void, Name name)))

(* Marks the pointer to the state as unused if the body, which has already been generated, does not
   use it. *)
let unread names = if Expression.reaches_state names then [] else [ ignored "self" ]

let place_of (node : M.node) =
  Printf.sprintf "%s, %s:%d" node.origin
    (C_string.comment (Filename.basename node.file))
    (Span.line node.span.start)

let no_result _ _ = Diagnostic.bug ~stage:"Cgen.Function" "a reset function has no results"

let reset (v : Program_names.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k in
  let is_read = Step.Param_use.in_reset v.param_use k in
  let params = params v (is_read || V.is_root v k) in
  let parameters = (self v k :: params) @ Expression.parameters names node.reset.parameters in
  name_variables names node.reset.body;
  let read = variables_read v node node.reset.body in
  let c = { v; names; index = k; node; write = no_result; read; place = "" } in
  let body = statements c node.reset.body in
  let unread = unread names @ if params <> [] && not is_read then [ ignored "params" ] else [] in
  {
    linkage = (if V.is_root v k then External else Static);
    result = Void;
    name = v.nodes.(k).reset;
    parameters;
    body = unread @ body;
    comment = place_of node;
  }

(* Copies a member of the input with a generated name, such as [f1], to a variable with a name from
   the source, if there is such a name. Otherwise, reads the member wherever it is used. *)
let read_member (v : Program_names.t) names read (variable : M.variable) steps =
  let place = Access.path (Name "in") steps [] in
  if Interface.direct v.program.input || String.equal variable.name "" then (
    Expression.read_as names variable place;
    [])
  else if Int_table.mem read variable.id then
    let ty = V.ty v variable.ty and name = Expression.variable names variable in
    [ plain (Ir.Constant { ty; name; value = place }) ]
  else []

(* Reads an array of the input in place. The array is only read element by element. *)
let read_elements names variable steps =
  Expression.read_elements_as names variable (Access.path (Name "in") steps)

let input (v : Program_names.t) : Ir.ty = Pointer_to_const (Struct v.input.struct_name)

(* Limits the values of dt that callers pass to the root's step. *)
let limited_times (v : Program_names.t) k =
  let limit name function_ = [ plain (Ir.Assign (Name name, Call (function_, [ Name name ]))) ] in
  (if Step.Dt_limits.nanoseconds v.dt_limits k then limit "dt_ns" "frob_span" else [])
  @
  match Step.Dt_limits.seconds v.dt_limits k with
  | Unlimited | Where_used -> []
  | Both_ways -> limit "dt" (V.in_precision v "frob_dt")

(* Maximum number of operations in a function that is marked inline. *)
let inline_size = 12

let own_step (v : Program_names.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k ~body:node.step.body in
  let read = variables_read v node node.step.body in
  let by_value, by_pointer =
    List.partition_map
      (fun variable ->
        match Program_input.member v.by_pointer k variable with
        | Some steps -> Either.Right (variable, steps)
        | None -> Left variable)
      node.step.parameters
  in
  let given = Expression.parameters names by_value in
  let take (variable, steps) =
    if Interface.is_in_array steps then (
      read_elements names variable steps;
      [])
    else read_member v names read variable steps
  in
  let taken = List.concat_map take by_pointer in
  let input = if Program_input.is_given v.by_pointer k then [ (input v, "in") ] else [] in
  let single, results =
    match node.outputs with
    | [ (_, ty) ] -> (V.ty v ty, [])
    | _ ->
        let result (name, ty) =
          (* An output that has no name is called [out] or [out.x]. *)
          let is_out = List.hd (String.split_on_char '.' name) = "out" in
          let name = if is_out then name else "out_" ^ name in
          (Ir.Pointer (V.ty v ty), Name.fresh (Expression.scope names) name)
        in
        (Void, List.map result node.outputs)
  in
  let places = Array.of_list results in
  name_variables names node.step.body;
  let write k value = plain (Ir.Assign (Unary (Dereference, Name (snd places.(k))), value)) in
  let c = { v; names; index = k; node; write; read; place = "" } in
  let state = if V.has_state v k then [ self v k ] else [] in
  let params = params v (Step.Param_use.in_step v.param_use k) in
  let dt = if node.seconds then [ (V.real v, "dt") ] else [] in
  let dt_ns = if node.nanoseconds then [ (Ir.Int64, "dt_ns") ] else [] in
  let body = statements c node.step.body in
  let unread = if state = [] then [] else unread names in
  {
    linkage = (if node.operations <= inline_size then Static_inline else Static);
    result = single;
    name = v.nodes.(k).step;
    parameters = List.concat [ state; params; dt; dt_ns; input; given; results ];
    body = List.concat [ unread; limited_times v k; taken; body ];
    comment = place_of node;
  }

let inputs c (node : M.node) =
  let by_pointer =
    Program_input.variables_by_pointer c.v.by_pointer c.v.program node node.step.body
  in
  let take (variable : M.variable) members =
    if Interface.is_in_array members then
      if not (Int_table.mem c.read variable.id) then []
      else if Program_input.reads_only_elements node.step.body variable members ~by_pointer then (
        read_elements c.names variable members;
        [])
      else
        let name = Expression.variable c.names variable in
        [
          plain (Ir.Variables { ty = V.ty c.v variable.ty; names = [ name ] });
          Access.copy c.names members ~from_interface:true (Name "in") (Name name);
        ]
    else read_member c.v c.names c.read variable members
  in
  List.concat (List.rev (List.rev_map2 take node.step.parameters c.v.input.leaves))

let root_step (v : Program_names.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k ~body:node.step.body in
  let outputs = Array.of_list v.output.leaves in
  let write k value =
    if Interface.is_in_array outputs.(k) then
      Access.copy names outputs.(k) ~from_interface:false (Name "out") value
    else plain (Ir.Assign (Access.path (Name "out") outputs.(k) [], value))
  in
  let read = variables_read v node node.step.body in
  let c = { v; names; index = k; node; write; read; place = "" } in
  let inputs = inputs c node in
  name_variables names node.step.body;
  let body = statements c node.step.body in
  let clear steps = Access.clear names steps (Name "out") in
  let unused = List.concat_map clear v.output.unused in
  let reads_input =
    List.exists (fun (v : M.variable) -> Int_table.mem c.read v.id) node.step.parameters
    || Program_input.variables_by_pointer v.by_pointer v.program node node.step.body <> []
  in
  let params = params v true in
  let reads_params = params = [] || Step.Param_use.in_step v.param_use k in
  let ignore_unless read name = if read then [] else [ ignored name ] in
  {
    linkage = External;
    result = Void;
    name = v.nodes.(k).step;
    parameters =
      List.concat
        [
          [ self v k ];
          params;
          [ (Int64, "dt_ns"); (V.real v, "dt"); (input v, "in") ];
          [ (Pointer (Struct v.output.struct_name), "out") ];
        ];
    body =
      List.concat
        [
          unread names;
          ignore_unless reads_params "params";
          ignore_unless node.nanoseconds "dt_ns";
          ignore_unless node.seconds "dt";
          ignore_unless reads_input "in";
          limited_times v k;
          inputs;
          body;
          unused;
        ];
    comment = place_of node;
  }

let steps (v : Program_names.t) k =
  if not (V.is_root v k) then [ own_step v k ]
  else
    let step = root_step v k in
    [ step; Step_in_seconds.of_step v ~root:k step ]
