open Basis
module Ir = Flow.Ir
module T = Core.Ir

type position = Evaluator.position

let bug format = Diagnostic.bug ~stage:"Specialize.Arrays" format

(* The elements of array literals up to this length are treated as separate variables. *)
let short = 4

let size_and_element : T.ty -> int * T.ty = function
  | Array (Size n, element) -> (n, element)
  | ty -> bug "%s is not an array" (Types.to_string ty)

let is_first_order (p : position) ty = (Types.layout p.types ty).first_order

let is_written_out (a : Value.argument) =
  match a.value with
  | Elements elements -> List.length elements <= short
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Function _ | Signal_function _
  | Primitive _ | Choice _ | Program _ | Unspecified ->
      false

let elements (p : position) (a : Value.argument) : Value.argument list =
  let _, ty = size_and_element a.ty in
  let values = Leaves.elements p.types p.node ~span:p.span a.ty a.value in
  List.map (fun value : Value.argument -> { value; ty }) values

let number k : Value.argument = { value = Atom (Int (Int32.of_int k)); ty = Int }

(* The name of the node that computes one iteration, and the names of its arguments. *)
let name_of (f : Value.t) primitive =
  match f with
  | Function { name; _ } | Signal_function { name; _ } -> name
  | Primitive _ | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Choice _
  | Program _ | Unspecified ->
      primitive

let locals (p : position) (f : Value.t) count =
  let rec of_lambdas (body : T.expr) k : T.Local.t list =
    if k = 0 then []
    else
      match body.desc with
      | Lambda (binder, body) -> binder.local :: of_lambdas body (k - 1)
      | _ -> List.init k (fun _ : T.Local.t -> { id = 0; name = ""; span = p.span })
  in
  match f with
  | Function { code = Lambda (binder, body); _ } -> binder.local :: of_lambdas body (count - 1)
  | Signal_function { code = Proc proc; _ } -> [ proc.input.local ]
  | _ -> List.init count (fun _ : T.Local.t -> { id = 0; name = ""; span = p.span })

(* {1 Loops} *)

type source =
  | From of Value.argument  (** an accumulator, with its initial value *)
  | Each of Value.argument  (** the elements of an array *)
  | Number  (** the index of the element *)

let argument source local : Loop.argument =
  match source with
  | From { value; ty } -> { form = Accumulator; ty; value; local }
  | Each { value; ty } -> { form = Element; ty = snd (size_and_element ty); value; local }
  | Number -> { form = Counter; ty = Int; value = Atom (Int 0l); local }

(* In each iteration, [f] returns the next accumulator (if there is one) and the element of the
   resulting array (if there is one). *)
let loop (p : position) (evaluator : Evaluator.t) primitive target ~count (f : Value.argument)
    sources ~final ~elements =
  let arguments = List.map2 argument sources (locals p f.value (List.length sources)) in
  let results = final @ elements in
  let result = List.hd results in
  let kind : Ir.kind = if primitive = Core.Primitive.Map_sf then Signal_function else Function in
  let round p captured values =
    let given =
      List.map2
        (fun (a : Loop.argument) value : Value.argument -> { value; ty = a.ty })
        arguments values
    in
    let f = List.hd captured in
    let next =
      match kind with
      | Function -> evaluator.apply p ~result f given
      | Signal_function -> evaluator.run p ~result f (List.hd given)
    in
    List.map (fun _ -> next) results
  in
  let targets = List.rev (target :: List.map (fun _ -> Node.Unnamed) (List.tl results)) in
  let key = Core.Primitive_table.name primitive in
  Loop.run p targets
    { name = name_of f.value key; kind; count; key; captured = [ f ]; arguments; final; elements }
    round
  |> List.rev |> List.hd

let apply_here (p : position) (evaluator : Evaluator.t) ~result (f : Value.argument) given =
  evaluator.apply p ~result f.value given

(* Records that an array of functions or signal functions is expanded element by element. *)
let one_by_one (p : position) ~by count =
  let by = Core.Primitive_table.name by in
  { p with trail = Context.expanding p.context p.trail ~by ~elements:count ~span:p.span }

(* The array whose elements are the results of [f] for the corresponding elements of [arrays]. If
   [numbered], [f] also receives the index of the element. *)
let elementwise (p : position) evaluator target primitive ~result ~numbered f arrays =
  let count, element = size_and_element result in
  let all_first_order =
    is_first_order p element
    && List.for_all (fun (a : Value.argument) -> is_first_order p a.ty) arrays
  in
  if all_first_order && not (arrays <> [] && List.for_all is_written_out arrays) then
    let sources = (if numbered then [ Number ] else []) @ List.map (fun a -> Each a) arrays in
    loop p evaluator primitive target ~count f sources ~final:[] ~elements:[ element ]
  else
    let p = one_by_one p ~by:primitive count in
    let columns = List.map (fun a -> Stdlib.Array.of_list (elements p a)) arrays in
    let one k =
      let given = List.map (fun column -> column.(k)) columns in
      apply_here p evaluator ~result:element f (if numbered then number k :: given else given)
    in
    Value.Elements (List.init count one)

(* Translates [foldl] and [scanl]; only [scanl] keeps the intermediate results. *)
let fold (p : position) evaluator primitive target (f : Value.argument) (first : Value.argument)
    (array : Value.argument) =
  let count, _ = size_and_element array.ty and ty = first.ty in
  if is_first_order p ty && is_first_order p array.ty && not (is_written_out array) then
    loop p evaluator primitive target ~count f [ From first; Each array ] ~final:[ ty ]
      ~elements:(if primitive = Core.Primitive.Scanl then [ ty ] else [])
  else
    let p = one_by_one p ~by:primitive count in
    let next reversed element =
      let value = List.hd reversed in
      apply_here p evaluator ~result:ty f [ { first with value }; element ] :: reversed
    in
    let reversed = List.fold_left next [ first.value ] (elements p array) in
    if primitive = Scanl then Value.Elements (List.tl (List.rev reversed)) else List.hd reversed

(* {1 Single elements} *)

(* Calls [make] for each leaf, with its target and its array, and builds the value from the
   results. *)
let for_leaves (p : position) target ty (array : Value.argument) make =
  let leaves = (Types.layout p.types ty).leaves in
  let arrays = Leaves.atoms p.types p.node ~span:p.span array.ty array.value in
  let targets = List.combine (Node.leaves target leaves) leaves in
  List.map2 make targets arrays |> Leaves.value p.types ty

let is_element (p : position) index k : Ir.atom =
  match (index : Ir.atom) with
  | Int n -> Bool (Int32.to_int n = k)
  | Signal _ | Bool _ | Float _ ->
      Node.define p.node Unnamed ~span:p.span Bool (Op (Equal, [ index; Int (Int32.of_int k) ]))

let choose (p : position) target ty (condition : Ir.atom) then_ else_ =
  match condition with
  | Bool true -> then_
  | Bool false -> else_
  | Signal _ | Int _ | Float _ ->
      Leaves.select p.types p.node target ~span:p.span ty condition then_ else_

let at (p : position) target ~index (default : Value.argument) (array : Value.argument) =
  let count, ty = size_and_element array.ty in
  match (index : Ir.atom) with
  | Int k ->
      let k = Int32.to_int k in
      if k < 0 || k >= count then default.value
      else Leaves.element p.types p.node target ~span:p.span array.ty array.value k
  | Signal _ | Bool _ | Float _ ->
      if is_first_order p ty then
        let defaults =
          Stdlib.Array.of_list (Leaves.atoms p.types p.node ~span:p.span ty default.value)
        in
        let next = ref 0 in
        for_leaves p target ty array (fun (target, leaf) array ->
            let default = defaults.(!next) in
            incr next;
            Node.define p.node target ~span:p.span leaf.leaf (At { array; index; default }))
      else
        let add (k, value) (element : Value.argument) =
          (k + 1, choose p Node.Unnamed ty (is_element p index k) element.value value)
        in
        snd (List.fold_left add (0, default.value) (elements p array))

let replace (p : position) target ~index (by : Value.argument) (array : Value.argument) : Value.t =
  let _, ty = size_and_element array.ty in
  if is_first_order p ty && not (is_written_out array) then
    let values = Stdlib.Array.of_list (Leaves.atoms p.types p.node ~span:p.span ty by.value) in
    let next = ref 0 in
    for_leaves p target array.ty array (fun (target, leaf) array ->
        let value = values.(!next) in
        incr next;
        Node.define p.node target ~span:p.span leaf.leaf (Replace { array; index; value }))
  else
    Elements
      (List.mapi
         (fun k (element : Value.argument) ->
           choose p Node.Unnamed ty (is_element p index k) by.value element.value)
         (elements p array))

let apply (p : position) evaluator target (primitive : Core.Primitive.t) ~result arguments =
  let atom (a : Value.argument) = Leaves.atom p.types p.node ~span:p.span a.ty a.value in
  let elementwise = elementwise p evaluator target primitive ~result in
  match (primitive, arguments) with
  | Length, [ (a : Value.argument) ] ->
      Value.Atom (Int (Int32.of_int (fst (size_and_element a.ty))))
  | At, [ index; default; array ] -> at p target ~index:(atom index) default array
  | Replace, [ index; by; array ] -> replace p target ~index:(atom index) by array
  | Generate, [ f ] -> elementwise ~numbered:true f []
  | Map, [ f; array ] -> elementwise ~numbered:false f [ array ]
  | Imap, [ f; array ] -> elementwise ~numbered:true f [ array ]
  | Zip_with, [ f; a; b ] -> elementwise ~numbered:false f [ a; b ]
  | (Foldl | Scanl), [ f; first; array ] -> fold p evaluator primitive target f first array
  | _ ->
      bug "`%s` applied to %d arguments"
        (Core.Primitive_table.name primitive)
        (List.length arguments)

let parallel (p : position) (evaluator : Evaluator.t) ~result signal_functions array =
  let count, element = size_and_element result in
  let p = one_by_one p ~by:Parallel count in
  let one (f : Value.argument) input = evaluator.run p ~result:element f.value input in
  Value.Elements (Long_list.map2 one (elements p signal_functions) (elements p array))

let map_sf (p : position) (evaluator : Evaluator.t) target ~result (f : Value.argument)
    (array : Value.argument) =
  let count, element = size_and_element result in
  if is_first_order p element && is_first_order p array.ty then
    loop p evaluator Map_sf target ~count f [ Each array ] ~final:[] ~elements:[ element ]
  else
    let p = one_by_one p ~by:Map_sf count in
    Value.Elements (Long_list.map (evaluator.run p ~result:element f.value) (elements p array))
