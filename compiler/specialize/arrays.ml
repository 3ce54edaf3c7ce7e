open Basis
module Ir = Flow.Ir
module T = Core.Ir

type evaluator = {
  apply :
    Context.t ->
    Context.trail ->
    Node.t ->
    span:Span.t ->
    result:T.ty ->
    Value.t ->
    Value.argument list ->
    Value.t;
  run :
    Context.t ->
    Context.trail ->
    Node.t ->
    span:Span.t ->
    result:T.ty ->
    Value.t ->
    Value.argument ->
    Value.t;
}

type position = Comparison.position

let bug format = Diagnostic.bug ~stage:"Specialize.Arrays" format

(* Up to here an array that is written out is as good as so many variables. *)
let short = 4

let size_and_element : T.ty -> int * T.ty = function
  | Array (Size n, element) -> (n, element)
  | ty -> bug "%s is no array" (Types.to_string ty)

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

(* What a round is called after, and its arguments. *)
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
  | From of Value.argument  (** an accumulator, with the first value *)
  | Each of Value.argument  (** of an array *)
  | Number  (** of the element *)

let argument source local : Loop.argument =
  match source with
  | From { value; ty } -> { form = Accumulator; ty; value; local }
  | Each { value; ty } -> { form = Element; ty = snd (size_and_element ty); value; local }
  | Number -> { form = Counter; ty = Int; value = Atom (Int 0l); local }

(* [round] gets [f] and the arguments of one round. *)
let loop (p : position) primitive targets ~kind ~count (f : Value.argument) sources ~final ~elements
    round =
  let arguments = List.map2 argument sources (locals p f.value (List.length sources)) in
  Loop.run p.context p.trail p.node targets ~span:p.span
    {
      name = name_of f.value (Core.Primitive.name primitive);
      kind;
      count;
      key = Core.Primitive.name primitive;
      captured = [ f ];
      arguments;
      final;
      elements;
    }
    (fun trail node captured values ->
      match captured with
      | [ f ] ->
          let given =
            List.map2
              (fun (a : Loop.argument) value : Value.argument -> { value; ty = a.ty })
              arguments values
          in
          round trail node f given
      | [] | _ :: _ :: _ -> bug "a round without its function")

let apply_round (p : position) evaluator result trail node f given =
  evaluator.apply p.context trail node ~span:p.span ~result f given

let apply_here (p : position) evaluator ~result (f : Value.argument) given =
  evaluator.apply p.context p.trail p.node ~span:p.span ~result f.value given

(* The array of what [f] makes of each element of [arrays], and of its number
   where [numbered]. *)
let elementwise (p : position) evaluator target primitive ~result ~numbered f arrays =
  let count, element = size_and_element result in
  let all_first_order =
    is_first_order p element
    && List.for_all (fun (a : Value.argument) -> is_first_order p a.ty) arrays
  in
  if all_first_order && not (arrays <> [] && List.for_all is_written_out arrays) then
    let sources =
      (if numbered then [ Number ] else []) @ List.map (fun a -> Each a) arrays
    in
    match
      loop p primitive [ target ] ~kind:Function ~count f sources ~final:[] ~elements:[ element ]
        (fun trail node f given -> [ apply_round p evaluator element trail node f given ])
    with
    | [ array ] -> array
    | [] | _ :: _ :: _ -> bug "a loop with a wrong number of results"
  else
    let columns = List.map (fun a -> Stdlib.Array.of_list (elements p a)) arrays in
    let one k =
      let given = List.map (fun column -> column.(k)) columns in
      apply_here p evaluator ~result:element f (if numbered then number k :: given else given)
    in
    Value.Elements (List.init count one)

let foldl (p : position) evaluator target (f : Value.argument) (first : Value.argument)
    (array : Value.argument) =
  let count, _ = size_and_element array.ty in
  let ty = first.ty in
  if is_first_order p ty && is_first_order p array.ty && not (is_written_out array) then
    match
      loop p Foldl [ target ] ~kind:Function ~count f [ From first; Each array ] ~final:[ ty ]
        ~elements:[]
        (fun trail node f given -> [ apply_round p evaluator ty trail node f given ])
    with
    | [ last ] -> last
    | [] | _ :: _ :: _ -> bug "a loop with a wrong number of results"
  else
    List.fold_left
      (fun value element -> apply_here p evaluator ~result:ty f [ { first with value }; element ])
      first.value (elements p array)

let scanl (p : position) evaluator target (f : Value.argument) (first : Value.argument)
    (array : Value.argument) =
  let count, _ = size_and_element array.ty in
  let ty = first.ty in
  if is_first_order p ty && is_first_order p array.ty && not (is_written_out array) then
    match
      loop p Scanl [ Unnamed; target ] ~kind:Function ~count f [ From first; Each array ]
        ~final:[ ty ] ~elements:[ ty ]
        (fun trail node f given ->
          let next = apply_round p evaluator ty trail node f given in
          [ next; next ])
    with
    | [ _; array ] -> array
    | _ -> bug "a loop with a wrong number of results"
  else
    let next (value, reversed) element =
      let value = apply_here p evaluator ~result:ty f [ { first with value }; element ] in
      (value, value :: reversed)
    in
    Value.Elements (List.rev (snd (List.fold_left next (first.value, []) (elements p array))))

(* {1 Single elements} *)

(* Pairs the arrays that a value is made of with something for each. *)
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
  | Foldl, [ f; first; array ] -> foldl p evaluator target f first array
  | Scanl, [ f; first; array ] -> scanl p evaluator target f first array
  | _ -> bug "`%s` on %d arguments" (Core.Primitive.name primitive) (List.length arguments)

let map_sf (p : position) evaluator target ~result (signal_function : Value.argument)
    (array : Value.argument) =
  let count, element = size_and_element result in
  if is_first_order p element && is_first_order p array.ty then
    match
      loop p Map_sf [ target ] ~kind:Signal_function ~count signal_function [ Each array ] ~final:[]
        ~elements:[ element ]
        (fun trail node signal_function given ->
          let input = List.hd given in
          [ evaluator.run p.context trail node ~span:p.span ~result:element signal_function input ])
    with
    | [ array ] -> array
    | [] | _ :: _ :: _ -> bug "a loop with a wrong number of results"
  else
    let one input =
      evaluator.run p.context p.trail p.node ~span:p.span ~result:element signal_function.value input
    in
    Value.Elements (List.map one (elements p array))
