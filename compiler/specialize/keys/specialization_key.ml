open Basis

let bug format = Diagnostic.bug ~stage:"Specialize.Specialization_key" format

module Table = Variables.Table

type table = {
  types : Types.table;
  fresh : unit -> int;
  keys : Keys.t;
  closed : int option Table.t;
      (* maps the identity of a closure to the key of its captured variables, if these have no holes
         *)
  closed_with_numbers : int option Table.t;
      (* the same for walks in which numbers are part of the key *)
  numbers : Numbers.table;
  constants : Core.Constant_numbers.t;
  visiting : unit Table.t; (* closures whose captured variables are being visited *)
}

(* A node with more arguments than this is slower and harder to read than separate nodes. *)
let few = 32

let table types ~constants ~fresh =
  {
    types;
    fresh;
    keys = Keys.create ();
    closed = Table.create 256;
    closed_with_numbers = Table.create 16;
    numbers = Numbers.table types ~limit:few;
    constants;
    visiting = Table.create 16;
  }

type hole = { atom : Flow.Ir.atom; local : Core.Ir.Local.t; path : string; ty : Flow.Ir.ty }
type numbers = Holes | In_key

let closed_keys table = function Holes -> table.closed | In_key -> table.closed_with_numbers

type walk = {
  table : table;
  node : Node.t;
  numbers : numbers;
  mutable key : int;
  mutable holes : hole list; (* newest first *)
  mutable seen : int Variables.t;
      (* closures with holes, numbered in the order in which they were first visited *)
  mutable seen_count : int;
  mutable inside : int; (* the number of enclosing functions that are captured or passed *)
  mutable constant : bool;
      (* whether the walk is inside a variable whose numbers must be known at compile time *)
}

let walk table node numbers : walk =
  {
    table;
    node;
    numbers;
    key = Keys.empty;
    holes = [];
    seen = Variables.empty;
    seen_count = 0;
    inside = 0;
    constant = false;
  }

let add_number w number = w.key <- Keys.add w.table.keys w.key number
let key w = w.key
let text_number table text = Keys.text table.keys text
let add_text w text = add_number w (text_number w.table text)

(* The first number identifies the kind of the value. Together with the type, it determines how many
   numbers follow, so that different values have different sequences. *)
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
and tag_numbers = 11
and tag_elements = 12

let type_id w ty = (Types.layout w.table.types ty).id
let types holes = List.map (fun hole -> hole.ty) holes

let numbers_of (table : table) closure =
  if Numbers.are_many table.numbers closure then In_key else Holes

(* The text of each leaf that is a known number or truth value. *)
let constants table ty value =
  let text (atom : Flow.Ir.atom) =
    match atom with
    | Signal _ -> None
    | Bool b -> Some (string_of_bool b)
    | Int n -> Some (Int32.to_string n)
    | Float x -> Some (Printf.sprintf "%h" x)
  in
  List.map (fun atom -> Option.bind atom text) (Leaves.known table.types ty value)

let deepest_nest = 10_000

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
        List.iter2 (add_part w local path) parts (Array.to_list values)
    | Constructed { constructor; arguments }, Sum fields ->
        add_number w tag_constructed;
        add_number w constructor;
        List.iter2 (add_part w local path) fields.(constructor) arguments
    | Elements values, Array (_, element) ->
        add_number w tag_elements;
        List.iter (add_at w local path element) values
    | (Function closure | Signal_function closure), _ -> add_closure w closure
    | Primitive { primitive; types; arguments; owner = _; at = _ }, _ ->
        add_number w tag_primitive;
        add_number w (text_number w.table (Core.Primitive_table.key primitive));
        add_number w (List.length types);
        List.iter (fun ty -> add_number w (type_id w ty)) types;
        add_number w (List.length arguments);
        inside w (fun () ->
            List.iter (fun (a : Value.argument) -> add_at w local path a.ty a.value) arguments)
    | Choice { condition; then_; else_ }, _ ->
        add_number w tag_choice;
        add_hole w local path condition (Flow.Operands.ty condition);
        add_at w local path ty then_;
        add_at w local path ty else_
    | Program signal_function, _ ->
        add_number w tag_program;
        add_at w local path ty signal_function
    | Unspecified, _ -> add_number w tag_unspecified
    | (Atom _ | Product _ | Constructed _ | Array _ | Elements _), _ ->
        bug "a value that is not of type %s" (Types.to_string ty)

and add_part w local path (part : Types.part) value =
  add_at w local (Types.join path part.part) part.ty value

and inside w visit =
  w.inside <- w.inside + 1;
  visit ();
  w.inside <- w.inside - 1

and add_hole w local path atom ty = w.holes <- { atom; local; path; ty } :: w.holes

and add_leaves (w : walk) local path ty layout value =
  let in_key = w.constant || (w.numbers = In_key && w.inside > 0) in
  add_number w (if in_key then tag_numbers else tag_leaves);
  add_number w layout.id;
  let add_leaf ((leaf : Types.leaf), constant) atom =
    match constant with
    | Some number when in_key -> add_number w (1 + text_number w.table number)
    | Some _ | None ->
        if in_key then add_number w 0;
        add_hole w local (Types.join path (Types.path_name leaf)) atom leaf.leaf
  in
  List.iter2 add_leaf
    (List.combine layout.leaves (constants w.table ty value))
    (Leaves.atoms w.table.types w.node ~span:local.span ty value)

and add_closure w closure =
  match closed_key w closure with
  | Some key ->
      add_number w tag_closed;
      add_number w (Closure.code_id closure.code);
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
          add_number w (Closure.code_id closure.code);
          inside w (fun () -> add_captured w closure))

and add_captured w (closure : Value.closure) =
  Variables.iter (fun _ ty -> add_number w (type_id w ty)) closure.types;
  let before = w.constant in
  Variables.iter
    (fun _ (entry : Value.entry) ->
      w.constant <- Core.Constant_numbers.has w.table.constants entry.local;
      (* a closure does not have a name, so report the variable that contains it *)
      try add_at w entry.local "" entry.local_ty (Closure.forced entry)
      with Closure.Needs_itself { id = 0; _ } -> raise (Closure.Needs_itself entry.local))
    closure.captured;
  w.constant <- before

(* Functions nested deeper than [deepest_nest] are rejected in the same way as a stack overflow,
   which the system may detect too late. *)
and closed_key (w : walk) closure =
  Work.step ();
  let table = closed_keys w.table w.numbers in
  match Table.find_opt table closure.identity with
  | Some known -> known
  | None when Table.mem w.table.visiting closure.identity ->
      raise (Closure.Needs_itself { id = 0; name = closure.name; span = closure.span })
  | None when Table.length w.table.visiting >= deepest_nest -> raise Stack_overflow
  | None ->
      Table.replace w.table.visiting closure.identity ();
      Fun.protect ~finally:(fun () -> Table.remove w.table.visiting closure.identity) @@ fun () ->
      let key =
        if Variables.for_all (fun _ entry -> may_be_closed w entry) closure.captured then (
          let own = walk w.table w.node w.numbers in
          own.inside <- 1;
          add_captured own closure;
          if own.holes = [] then Some own.key else None)
        else None
      in
      Table.replace table closure.identity key;
      key

(* A quick test: can this captured variable be free of holes? *)
and may_be_closed (w : walk) (entry : Value.entry) =
  match ((Types.layout w.table.types entry.local_ty).leaves, w.numbers) with
  | _ :: _, Holes -> Core.Constant_numbers.has w.table.constants entry.local
  | _ :: _, In_key -> true
  | [], _ -> (
      match Closure.forced entry with
      | Function closure | Signal_function closure -> closed_key w closure <> None
      | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Primitive _ | Choice _
      | Program _ | Unspecified ->
          true)

let add w local ty value = add_at w local "" ty value

let take_holes w =
  let holes = List.rev w.holes in
  w.holes <- [];
  holes

type copy = {
  sources : table;
  in_key : bool;
  closed_already : int option Table.t;
  mutable atoms : Flow.Ir.atom list;
  mutable copied : Value.closure Variables.t;
}

let copy table numbers atoms =
  {
    sources = table;
    in_key = numbers = In_key;
    closed_already = closed_keys table numbers;
    atoms;
    copied = Variables.empty;
  }

let next_atom c =
  match c.atoms with
  | atom :: others ->
      c.atoms <- others;
      atom
  | [] -> bug "more holes than atoms"

(* [inside] and [constant] have the same meaning as in {!walk}. *)
let rec value_at c ~inside ~constant ty (original : Value.t) : Value.t =
  Work.step ();
  let layout = Types.layout c.sources.types ty in
  let value = value_at c ~inside ~constant in
  if layout.first_order then
    let filled (known : Flow.Ir.atom option) =
      match known with
      | Some ((Bool _ | Int _ | Float _) as number) when constant || (inside && c.in_key) -> number
      | Some _ | None -> next_atom c
    in
    Leaves.value c.sources.types ty (List.map filled (Leaves.known c.sources.types ty original))
  else
    match (original, layout.kind) with
    | (Text _ | Unspecified), _ -> original
    | Product values, Product parts ->
        let part (part : Types.part) v = value part.ty v in
        Product (Array.of_list (List.map2 part parts (Array.to_list values)))
    | Constructed { constructor; arguments }, Sum fields ->
        let argument (part : Types.part) v = value part.ty v in
        Constructed { constructor; arguments = List.map2 argument fields.(constructor) arguments }
    | Elements values, Array (_, element) -> Elements (List.map (value element) values)
    | Function closure, _ -> Function (copy_closure c closure)
    | Signal_function closure, _ -> Signal_function (copy_closure c closure)
    | Primitive { primitive; types; arguments; owner; at }, _ ->
        let argument (a : Value.argument) =
          { a with value = value_at c ~inside:true ~constant a.ty a.value }
        in
        Primitive { primitive; types; arguments = List.map argument arguments; owner; at }
    | Choice { then_; else_; condition = _ }, _ ->
        let condition = next_atom c in
        let then_ = value ty then_ in
        Choice { condition; then_; else_ = value ty else_ }
    | Program signal_function, _ -> Program (value ty signal_function)
    | (Atom _ | Product _ | Constructed _ | Array _ | Elements _), _ ->
        bug "a value that is not of type %s" (Types.to_string ty)

and copy_closure c (closure : Value.closure) : Value.closure =
  match Table.find_opt c.closed_already closure.identity with
  | Some (Some _) -> closure
  | Some None | None -> (
      match Variables.find_opt closure.identity c.copied with
      | Some copied -> copied
      | None ->
          let captured = captured_at c ~inside:true closure in
          let copied = { closure with identity = c.sources.fresh (); captured } in
          c.copied <- Variables.add closure.identity copied c.copied;
          copied)

and captured_at c ~inside (closure : Value.closure) =
  Variables.map
    (fun (entry : Value.entry) : Value.entry ->
      let constant = Core.Constant_numbers.has c.sources.constants entry.local in
      let value = value_at c ~inside ~constant entry.local_ty (Closure.forced entry) in
      { entry with contents = Known value })
    closure.captured

let value c ty original = value_at c ~inside:false ~constant:false ty original
let captured c closure = captured_at c ~inside:false closure
