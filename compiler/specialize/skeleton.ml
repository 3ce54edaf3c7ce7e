open Basis

let bug format = Diagnostic.bug ~stage:"Specialize.Skeleton" format

module Table = Variables.Table

module Steps = Hashtbl.Make (struct
  type t = int * int

  let equal (a, b) (c, d) = Int.equal a c && Int.equal b d
  let hash (a, b) = ((a * 65_599) + b) land max_int
end)

type table = {
  types : Types.table;
  fresh : unit -> int;
  steps : int Steps.t;  (* a key and one more number: the next key *)
  texts : (string, int) Hashtbl.t;
  closed : int option Table.t;
      (* by closure identity: the key of what it has captured if without holes *)
}

let table types ~fresh =
  {
    types;
    fresh;
    steps = Steps.create 1024;
    texts = Hashtbl.create 16;
    closed = Table.create 256;
  }

exception Needs_itself of Core.Ir.Local.t

let forced (entry : Value.entry) =
  match entry.contents with
  | Known value -> value
  | Suspended evaluate ->
      entry.contents <- Being_evaluated;
      let value = evaluate () in
      entry.contents <- Known value;
      value
  | Being_evaluated -> raise (Needs_itself entry.local)
  | Polymorphic _ -> bug "`%s` has no type arguments" entry.local.name

let code_id : Value.code -> int = function
  | Lambda (binder, _) | Generic (binder, _, _) -> binder.local.id
  | Proc proc -> proc.input.local.id

type hole = {
  atom : Flow.Ir.atom;
  local : Core.Ir.Local.t;
  path : string;
  ty : Flow.Ir.ty;
}

type walk = {
  table : table;
  node : Node.t;
  mutable state : int;
  mutable holes : hole list;  (* the last one first *)
  mutable seen : int Variables.t;  (* closures with holes, in the order met *)
  mutable seen_count : int;
}

let walk table node = { table; node; state = 0; holes = []; seen = Variables.empty; seen_count = 0 }

(* A trie of all sequences of numbers: its nodes are the keys. *)
let add_number w number =
  let step = (w.state, number) in
  match Steps.find_opt w.table.steps step with
  | Some next -> w.state <- next
  | None ->
      let next = Steps.length w.table.steps + 1 in
      Steps.add w.table.steps step next;
      w.state <- next

let key w = w.state

let text_number table text =
  match Hashtbl.find_opt table.texts text with
  | Some number -> number
  | None ->
      let number = Hashtbl.length table.texts in
      Hashtbl.add table.texts text number;
      number

(* The first number says what kind of value follows and, with the type, how
   many numbers belong to it; so no two values have the same sequence. *)
let tag_leaves = 0
and tag_text = 1
and tag_product = 2
and tag_constructed = 3
and tag_closed = 4
and tag_open = 5
and tag_again = 6
and tag_primitive = 7
and tag_choice = 8
and tag_program = 9
and tag_unspecified = 10

let type_id w ty = (Types.layout w.table.types ty).id

let type_of_atom (atom : Flow.Ir.atom) : Flow.Ir.ty =
  match atom with Signal s -> s.ty | Bool _ -> Bool | Int _ -> Int | Float _ -> Float

let rec add_at w local path ty (value : Value.t) =
  let layout = Types.layout w.table.types ty in
  if layout.first_order then add_leaves w local path ty layout value
  else
    match (value, layout.kind) with
    | Text text, _ ->
        add_number w tag_text;
        add_number w (text_number w.table text)
    | Product values, Product parts ->
        add_number w tag_product;
        List.iter2 (add_part w local path) parts values
    | Constructed { constructor; arguments }, Sum fields ->
        add_number w tag_constructed;
        add_number w constructor;
        List.iter2 (add_part w local path) fields.(constructor) arguments
    | (Function closure | Signal_function closure), _ -> add_closure w closure
    | Primitive { primitive; types; arguments }, _ ->
        add_number w tag_primitive;
        add_number w (text_number w.table (Core.Primitive.name primitive));
        add_number w (List.length types);
        List.iter (fun ty -> add_number w (type_id w ty)) types;
        add_number w (List.length arguments);
        List.iter (fun (a : Value.argument) -> add_at w local path a.ty a.value) arguments
    | Choice { condition; then_; else_ }, _ ->
        add_number w tag_choice;
        add_hole w local path condition (type_of_atom condition);
        add_at w local path ty then_;
        add_at w local path ty else_
    | Program signal_function, _ ->
        add_number w tag_program;
        add_at w local path ty signal_function
    | Unspecified, _ -> add_number w tag_unspecified
    | (Atom _ | Product _ | Constructed _), _ ->
        bug "a value that is not of type %s" (Types.to_string ty)

and add_part w local path (part : Types.part) value =
  add_at w local (Types.join path part.part) part.ty value

and add_hole w local path atom ty = w.holes <- { atom; local; path; ty } :: w.holes

and add_leaves w local path ty layout value =
  add_number w tag_leaves;
  add_number w layout.id;
  List.iter2
    (fun (leaf : Types.leaf) atom -> add_hole w local (Types.join path leaf.path) atom leaf.leaf)
    layout.leaves
    (Leaves.atoms w.table.types w.node ~span:local.span ty value)

and add_closure w closure =
  match closed_key w closure with
  | Some key ->
      add_number w tag_closed;
      add_number w (code_id closure.code);
      add_number w key
  | None -> (
      match Variables.find_opt closure.identity w.seen with
      | Some order ->
          add_number w tag_again;
          add_number w order
      | None ->
          w.seen <- Variables.add closure.identity w.seen_count w.seen;
          w.seen_count <- w.seen_count + 1;
          add_number w tag_open;
          add_number w (code_id closure.code);
          add_captured w closure)

and add_captured w (closure : Value.closure) =
  Variables.iter (fun _ ty -> add_number w (type_id w ty)) closure.types;
  Variables.iter
    (fun _ (entry : Value.entry) ->
      match entry.contents with
      | Polymorphic generic -> add_closure w generic
      | Known _ | Suspended _ | Being_evaluated ->
          add_at w entry.local "" entry.local_ty (forced entry))
    closure.captured

and closed_key w closure =
  match Table.find_opt w.table.closed closure.identity with
  | Some known -> known
  | None ->
      let key =
        if Variables.for_all (fun _ entry -> is_closed w entry) closure.captured then (
          let own = walk w.table w.node in
          add_captured own closure;
          if own.holes = [] then Some own.state else None)
        else None
      in
      Table.add w.table.closed closure.identity key;
      key

(* Quickly no, or perhaps. *)
and is_closed w (entry : Value.entry) =
  match entry.contents with
  | Polymorphic generic -> closed_key w generic <> None
  | Known _ | Suspended _ | Being_evaluated -> (
      match (Types.layout w.table.types entry.local_ty).leaves with
      | _ :: _ -> false
      | [] -> (
          match forced entry with
          | Function closure | Signal_function closure -> closed_key w closure <> None
          | Atom _ | Text _ | Product _ | Constructed _ | Primitive _ | Choice _ | Program _
          | Unspecified ->
              true))

let add w local ty value = add_at w local "" ty value

let take_holes w =
  let holes = List.rev w.holes in
  w.holes <- [];
  holes

type copy = {
  keys : table;
  mutable atoms : Flow.Ir.atom list;
  mutable copied : Value.closure Variables.t;
}

let copy keys atoms = { keys; atoms; copied = Variables.empty }

let next_atom c =
  match c.atoms with
  | atom :: others ->
      c.atoms <- others;
      atom
  | [] -> bug "more holes than atoms"

let rec value c ty (original : Value.t) : Value.t =
  let layout = Types.layout c.keys.types ty in
  if layout.first_order then
    Leaves.value c.keys.types ty (List.map (fun _ -> next_atom c) layout.leaves)
  else
    match (original, layout.kind) with
    | (Text _ | Unspecified), _ -> original
    | Product values, Product parts ->
        Product (List.map2 (fun (part : Types.part) v -> value c part.ty v) parts values)
    | Constructed { constructor; arguments }, Sum fields ->
        let argument (part : Types.part) v = value c part.ty v in
        Constructed
          { constructor; arguments = List.map2 argument fields.(constructor) arguments }
    | Function closure, _ -> Function (copy_closure c closure)
    | Signal_function closure, _ -> Signal_function (copy_closure c closure)
    | Primitive { primitive; types; arguments }, _ ->
        let argument (a : Value.argument) = { a with value = value c a.ty a.value } in
        Primitive { primitive; types; arguments = List.map argument arguments }
    | Choice { then_; else_; condition = _ }, _ ->
        let condition = next_atom c in
        let then_ = value c ty then_ in
        Choice { condition; then_; else_ = value c ty else_ }
    | Program signal_function, _ -> Program (value c ty signal_function)
    | (Atom _ | Product _ | Constructed _), _ ->
        bug "a value that is not of type %s" (Types.to_string ty)

and copy_closure c (closure : Value.closure) : Value.closure =
  match Table.find_opt c.keys.closed closure.identity with
  | Some (Some _) -> closure
  | Some None | None -> (
      match Variables.find_opt closure.identity c.copied with
      | Some copied -> copied
      | None ->
          let captured = captured c closure in
          let copied = { closure with identity = c.keys.fresh (); captured } in
          c.copied <- Variables.add closure.identity copied c.copied;
          copied)

and captured c (closure : Value.closure) =
  Variables.map
    (fun (entry : Value.entry) : Value.entry ->
      match entry.contents with
      | Polymorphic generic -> { entry with contents = Polymorphic (copy_closure c generic) }
      | Known _ | Suspended _ | Being_evaluated ->
          { entry with contents = Known (value c entry.local_ty (forced entry)) })
    closure.captured
