module F = Flow.Ir
module M = Step.Ir
module V = Vocabulary

let plain desc : Ir.statement = { desc; comment = "" }
let bug format = Basis.Diagnostic.bug ~stage:"Cgen.Foreign_call" format
let address name = Ir.Unary (Address, Name name)

(* {1 Arguments} *)

(* Fills the struct [name]. [values] are the types and values of its leaves. *)
let fill names (i : Interface.t) name values =
  let leaf steps (ty, value) =
    Crossing.elements names To_c ty steps ~c:(Access.path (address name) steps) ~own:value
  in
  let clear steps = Access.clear names steps (address name) in
  plain (Ir.Variables { ty = Struct i.struct_name; names = [ name ] })
  :: List.concat (List.map2 leaf i.leaves values)
  @ List.concat_map clear i.unused

let size : M.ty -> int = function
  | Array (size, _) -> size
  | Bool | Int | Float | Sum _ | Nanoseconds | Foreign _ -> bug "expected an array type"

(* An element of a plain C array. *)
let bare name : Ir.expr list -> Ir.expr = function
  | [ index ] -> Subscript (Name name, index)
  | [] | _ :: _ :: _ -> bug "elements of elements"

(* The statements that prepare an argument, and the expression for the argument. *)
let argument names k (passing : Foreign_interface.passing) values =
  let own () = Name.fresh (Expression.scope names) (Printf.sprintf "argument%d" (k + 1)) in
  let variable ty name = plain (Ir.Variables { ty; names = [ name ] }) in
  match (passing, values) with
  | Nothing, _ -> ([], [])
  | Value _, [ (ty, value) ] -> ([], [ Crossing.number names To_c ty value ])
  | Address c_type, [ (ty, value) ] when Crossing.is_converted names ty ->
      let name = own () in
      let set = Crossing.assign names To_c ty ~to_:(Name name) ~from:value in
      (variable c_type name :: set, [ address name ])
  | Address _, [ (_, value) ] -> ([], [ Expression.address value ])
  | Elements element, [ (ty, value) ] when Crossing.is_converted names ty ->
      let name = own () and size = size ty in
      let set = Crossing.elements names To_c ty [ Element size ] ~c:(bare name) ~own:value in
      (variable (Array (element, size)) name :: set, [ Name name ])
  | Elements _, [ (_, Ir.Unary (Dereference, array)) ] -> ([], [ Ir.Arrow (array, "at") ])
  | Struct i, values ->
      let name = own () in
      (fill names i name values, [ address name ])
  | (Value _ | Address _ | Elements _), _ -> bug "unexpected leaves for an argument"

(* {1 Results} *)

(* The place of the C function's result. *)
type results =
  | Whole of Ir.expr  (** a single leaf *)
  | Bare of string  (** a single array, stored in a variable that is a plain C array *)
  | Inside of Ir.expr * Interface.t  (** a pointer to a struct *)

type output = {
  ty : M.ty;
  leaf : int;
  pointer : string;  (** [""] if the function returns the output *)
}

(* Converts a result for the program. Returns an expression, or a function that generates statements
   that copy the result. *)
let result names results { ty; leaf; _ } =
  let copy steps c = `Copy (fun target -> Crossing.elements names From_c ty steps ~c ~own:target) in
  let in_one_piece (e : Ir.expr) =
    match ty with
    | Sum _ when Crossing.is_converted names ty -> copy [] (fun _ -> e)
    | ty -> `Value (Crossing.number names From_c ty e)
  in
  match results with
  | Whole e -> in_one_piece e
  | Bare name -> copy [ Element (size ty) ] (bare name)
  | Inside (from, i) ->
      let steps = List.nth i.Interface.leaves leaf in
      if Interface.is_in_array steps then copy steps (Access.path from steps)
      else in_one_piece (Access.path from steps [])

(* For an output of the node, the index of the corresponding leaf of the result. Some leaves may be
   unused. *)
let leaf_number (foreign : F.foreign) name =
  let rec find k = function
    | (s : F.signal) :: _ when String.equal s.name name -> k
    | _ :: others -> find (k + 1) others
    | [] -> bug "the output is not a result of the foreign function"
  in
  find 0 foreign.results

let outputs names (node : M.node) foreign =
  match node.outputs with
  | [ (name, ty) ] -> [ { ty; leaf = leaf_number foreign name; pointer = "" } ]
  | several ->
      List.map
        (fun (name, ty) ->
          let own = if name = "out" then "result" else name in
          let pointer = Name.fresh (Expression.scope names) own in
          { ty; leaf = leaf_number foreign name; pointer })
        several

let give output value =
  plain
    (if String.equal output.pointer "" then Ir.Return value
     else Assign (Unary (Dereference, Name output.pointer), value))

(* Declares, for each output, a variable that holds the C function's result until the output is
   assigned. *)
let through_variables v names ~initial outputs results call =
  let own output =
    let name = Name.fresh (Expression.scope names) "value" in
    let ty = V.ty v output.ty in
    let declared =
      if initial then Ir.Variable { ty; name; value = V.zero v output.ty }
      else Variables { ty; names = [ name ] }
    in
    let set =
      match result names results output with
      | `Value e -> [ plain (Ir.Assign (Name name, e)) ]
      | `Copy copy -> copy (Ir.Name name)
    in
    (plain declared, set, give output (Name name))
  in
  let all = List.map own outputs in
  ( List.map (fun (declared, _, _) -> declared) all,
    call @ List.concat_map (fun (_, set, _) -> set) all,
    List.map (fun (_, _, give) -> give) all )

let body v names outputs results ~call ~present =
  let direct output =
    match result names results output with `Value e -> Some (give output e) | `Copy _ -> None
  in
  let given = List.filter_map direct outputs in
  if present = [] && List.compare_lengths given outputs = 0 then call @ given
  else
    let initial = present <> [] in
    let declared, work, given = through_variables v names ~initial outputs results call in
    match present with
    | [] -> declared @ work @ given
    | first :: others ->
        let condition = List.fold_left (fun all e -> Ir.Binary (And, all, e)) first others in
        declared @ [ plain (Ir.If { condition; then_ = work; else_ = [] }) ] @ given

(* {1 The call} *)

(* For each argument that may be a null pointer, the condition that it is not null. *)
let present names parameters =
  List.filter_map
    (fun (p : M.variable) ->
      match p.ty with
      | Foreign { copyable = false; _ } ->
          Some (Ir.Binary (Not_equal, Expression.of_step names (Variable p), Integer 0l))
      | Foreign _ | Bool | Int | Float | Sum _ | Nanoseconds | Array _ -> None)
    parameters

(* The statements that call the function, and the place of its result. If the result is returned
   directly, the place is the call itself. *)
let call_function v names (node : M.node) symbol arguments (passing : Foreign_interface.passing) =
  let variable ty =
    let name = Name.fresh (Expression.scope names) "result" in
    (name, plain (Ir.Variables { ty; names = [ name ] }))
  in
  let into (name, declared) pointer results =
    ([ declared; plain (Ir.Do (Call (symbol, arguments @ [ pointer name ]))) ], results name)
  in
  match (passing, node.outputs) with
  | Nothing, _ -> ([ plain (Ir.Do (Call (symbol, arguments))) ], Whole (Integer 0l))
  | Value _, _ -> ([], Whole (Call (symbol, arguments)))
  | Address ty, _ -> into (variable ty) address (fun name -> Whole (Name name))
  | Struct i, _ ->
      into (variable (Struct i.struct_name)) address (fun name -> Inside (address name, i))
  | Elements element, [ (_, ty) ] when Crossing.is_converted names ty ->
      into (variable (Array (element, size ty))) (fun name -> Name name) (fun name -> Bare name)
  | Elements _, [ (_, ty) ] ->
      let pointer name = Ir.Member (Name name, "at") in
      into (variable (V.ty v ty)) pointer (fun name -> Whole (Name name))
  | Elements _, _ -> bug "expected an array with a single leaf"

let step (v : Program_names.t) k (interface : Foreign_interface.t) : Ir.function_ =
  let node = v.program.nodes.(k) in
  let foreign =
    match node.foreign with
    | Some foreign -> foreign
    | None -> bug "expected a node that calls a foreign function"
  in
  let names = Expression.names v ~node:k in
  let given = Expression.parameters names node.step.parameters in
  let values =
    Flow.Shape.split foreign.import.arguments
      (List.map
         (fun (p : M.variable) -> (p.ty, Expression.of_step names (Variable p)))
         node.step.parameters)
  in
  let outputs = outputs names node foreign in
  let own, call, results =
    match interface.form with
    | Function { arguments; result } ->
        let ready_one k (passing, values) = argument names k passing values in
        let ready = List.mapi ready_one (List.combine arguments values) in
        let prepared = List.concat_map fst ready and passed = List.concat_map snd ready in
        let call, results = call_function v names node interface.symbol passed result in
        ([], prepared @ call, results)
    | Component { input; output } ->
        let fill = fill names input "in" (List.concat values) in
        let declared = plain (Ir.Variables { ty = Struct output.struct_name; names = [ "out" ] }) in
        let dt = Crossing.number names To_c Float (Name "dt") in
        let passed = [ Ir.Name "self"; dt; address "in"; address "out" ] in
        let call = plain (Ir.Do (Call (Foreign_interface.step interface.symbol, passed))) in
        let state = Ir.Struct (Foreign_interface.state interface.symbol) in
        ( [ (Ir.Pointer state, "self"); (V.real v, "dt") ],
          fill @ [ declared; call ],
          Inside (address "out", output) )
  in
  let pointers =
    List.filter_map
      (fun o -> if o.pointer = "" then None else Some (Ir.Pointer (V.ty v o.ty), o.pointer))
      outputs
  in
  {
    linkage = Static_inline;
    result = (match outputs with [ { ty; pointer = ""; _ } ] -> V.ty v ty | _ -> Void);
    name = v.nodes.(k).step;
    parameters = own @ given @ pointers;
    body = body v names outputs results ~call ~present:(present names node.step.parameters);
    comment = Printf.sprintf "%s: `%s` in the user's C" node.origin interface.symbol;
  }
