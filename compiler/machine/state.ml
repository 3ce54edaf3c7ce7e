module Flow_ir = Flow.Ir
open Flow_ir

type memory =
  | Delayed of Ir.field
  | Elapsed of Ir.field
  | Integrated of { value : Ir.field; input : Ir.field }
  | Differentiated of { value : Ir.field; input : Ir.field }
  | Kept of Ir.field

type t = {
  memories : (int, memory) Hashtbl.t;
  instances : (string, Ir.field) Hashtbl.t;
  static : (int, unit) Hashtbl.t;
  mutable fields : Ir.field list;  (** last first *)
  mutable count : int;
}

let new_field t ~name content ~purpose span =
  let field : Ir.field = { id = t.count; name; content; purpose; span } in
  t.count <- t.count + 1;
  t.fields <- field :: t.fields;
  field

let fields t = List.rev t.fields
let memory t (s : signal) = Hashtbl.find_opt t.memories s.id
let instance t (i : instance) = Hashtbl.find_opt t.instances i.name

let is_static t = function
  | Bool _ | Int _ | Float _ -> true
  | Signal s -> Hashtbl.mem t.static s.id

let atom_name = function Signal s -> s.name | Bool _ | Int _ | Float _ -> ""

(* A name for what an operation on [atom] remembers: the signal's own name, or
   one made of the operand's. *)
let derived (s : signal) atom ~suffix ~otherwise =
  match (s.name, atom_name atom) with
  | "", "" -> otherwise
  | "", operand -> operand ^ "_" ^ suffix
  | name, _ -> name

(* The name of an operation that is worth keeping the result of. *)
let costly_operator = function
  | Pow -> Some "pow"
  | Elementary e -> Some (Core.Primitive.name (Elementary e))
  | Add | Subtract | Multiply | Negate | Absolute | Signum | Equal | Less | Less_equal | Minimum
  | Maximum | Divide | Div | Mod | To_float | Round | Floor | Ceiling | Truncate | Not | And | Or ->
      None

let remember t (s : signal) memory = Hashtbl.replace t.memories s.id memory

let value (ty : ty) : Ir.content =
  match ty with
  | Bool -> Value Bool
  | Int -> Value Int
  | Float -> Value Float
  | Sum k -> Value (Sum k)

let keep t (s : signal) ~name span =
  let name = if String.equal s.name "" then name else s.name in
  remember t s (Kept (new_field t ~name (value s.ty) ~purpose:"known at the start" span))

let equation t ~keeps { defines = s; rhs; span } =
  let field ~name ~purpose = new_field t ~name (Value Float) ~purpose span in
  match rhs with
  | Delay { next; _ } ->
      let name = derived s next ~suffix:"prev" ~otherwise:"delay" in
      remember t s (Delayed (new_field t ~name (value s.ty) ~purpose:"delay" span))
  | Time ->
      let name = if String.equal s.name "" then "time" else s.name in
      remember t s (Elapsed (new_field t ~name (Value Nanoseconds) ~purpose:"time in ns" span))
  | Integral input ->
      let name = derived s input ~suffix:"integral" ~otherwise:"integral" in
      let value = field ~name ~purpose:"integral" in
      let input = field ~name:(name ^ "_input") ~purpose:"its last input" in
      remember t s (Integrated { value; input })
  | Derivative input ->
      let name = derived s input ~suffix:"derivative" ~otherwise:"derivative" in
      let value = field ~name ~purpose:"derivative" in
      let input = field ~name:(name ^ "_input") ~purpose:"its last input" in
      remember t s (Differentiated { value; input })
  | Copy _ | Op _ | If _ | Construct _ | Is_constructor _ | Payload _ ->
      if keeps && List.for_all (is_static t) (Flow.Operands.all rhs) then (
        Hashtbl.replace t.static s.id ();
        match rhs with
        | Op (operator, operands) ->
            let operand = match operands with first :: _ -> atom_name first | [] -> "" in
            let keep_as name =
              let operand = if String.equal operand "" then "value" else operand in
              keep t s ~name:(name ^ "_" ^ operand) span
            in
            Option.iter keep_as (costly_operator operator)
        | Copy _ | If _ | Construct _ | Is_constructor _ | Payload _ | Delay _ | Time | Integral _
        | Derivative _ ->
            ())

let add_instance t ~keeps ~stateful (i : instance) =
  if stateful i.node then
    Hashtbl.replace t.instances i.name
      (new_field t ~name:i.name (State_of i.node) ~purpose:"" i.span)
  else if keeps && List.for_all (is_static t) i.statics && List.for_all (is_static t) i.inputs then
    List.iter
      (fun (s : signal) ->
        Hashtbl.replace t.static s.id ();
        keep t s ~name:i.name i.span)
      i.outputs

let of_node ~stateful (node : node) items =
  let t =
    {
      memories = Hashtbl.create 16;
      instances = Hashtbl.create 16;
      static = Hashtbl.create 16;
      fields = [];
      count = 0;
    }
  in
  (* A function is called anew each time: it can keep nothing. *)
  let keeps = match node.kind with Function -> false | Signal_function -> true in
  List.iter (fun (s : signal) -> Hashtbl.replace t.static s.id ()) node.statics;
  List.iter
    (fun (item : Flow.Schedule.item) ->
      match item with
      | Equation eq -> equation t ~keeps eq
      | Instance i -> add_instance t ~keeps ~stateful i)
    items;
  t
