open Basis

type member = {
  path : string list;
  node : int;
  field : Ir.field;
  block : Block.t;
  modes : (int * member list) list;
}

type t = { homes : int array; structs : member list array }

let home t = Array.get t.homes
let members t = Array.get t.structs

(* Maximum nesting of machines in a struct. C compilers need not support deeply nested structs, and
   paths should stay readable. *)
let deepest = 6

(* The nodes whose state occurs more than once, or belongs to a component in the user's C code. *)
let apart (program : Ir.program) =
  let count = Array.make (Array.length program.nodes) 0 in
  let add n k = count.(k) <- count.(k) + n in
  let field (f : Ir.field) =
    match f.content with
    | State_of k -> add 1 k
    | States_of { node = k; _ } -> add 2 k
    | Value _ | Running_mode | Modes _ | Component _ -> ()
  in
  let trial : Ir.statement -> unit = function
    | Step { node; on_trial = true; _ } -> add 2 node
    | _ -> ()
  in
  Array.iteri
    (fun k (node : Ir.node) ->
      if Option.is_some node.foreign then add 2 k;
      List.iter field (node.state @ List.concat_map State.fields_of_mode node.modes);
      Walk.statements trial node.step.body)
    program.nodes;
  fun k -> count.(k) <> 1

let homes (program : Ir.program) =
  let count = Array.length program.nodes in
  let is_apart = apart program in
  let homes = Array.init count Fun.id and depths = Array.make count 0 in
  let place k ~within depth =
    if depth <= deepest && not (is_apart k) then (
      homes.(k) <- homes.(within);
      depths.(k) <- depth)
  in
  (* Callers come after callees. *)
  for k = count - 1 downto 0 do
    let field ~depth (f : Ir.field) =
      match f.content with
      | State_of inner -> place inner ~within:k depth
      | States_of _ | Value _ | Running_mode | Modes _ | Component _ -> ()
    in
    let node = program.nodes.(k) in
    List.iter (field ~depth:depths.(k)) node.state;
    List.iter
      (fun mode -> List.iter (field ~depth:(depths.(k) + 1)) (State.fields_of_mode mode))
      node.modes
  done;
  homes

let alignment members = List.fold_left (fun most m -> max most m.block.Block.alignment) 1 members
let whole members = snd (Block.of_members (List.map (fun m -> m.block) members))

let in_order members =
  let is_time m = match m.field.content with Value Nanoseconds -> true | _ -> false in
  let compare a b = compare (b.block.Block.alignment, is_time a) (a.block.alignment, is_time b) in
  List.stable_sort compare members

(* Splits members into those that fit into this number of bytes, and the rest. *)
let fitting most members =
  let fit (bytes, within, others) member =
    let { Block.bytes = own; alignment } = member.block in
    let end_ = Saturating_int.add (Saturating_int.round_up bytes ~alignment) own in
    if end_ <= most then (end_, member :: within, others) else (bytes, within, member :: others)
  in
  let _, within, others = List.fold_left fit (0, [], []) members in
  (List.rev within, List.rev others)

(* The unions in which the members of the modes share memory. [union] builds a union from its
   members. *)
let rec unions ~union (modes : (int * member list) list) =
  match List.filter (fun (_, members) -> members <> []) modes with
  | [] -> []
  | modes ->
      let largest = alignment (List.concat_map snd modes) in
      let is_large m = m.block.Block.alignment = largest in
      let size (_, members) = (whole (List.filter is_large members)).bytes in
      let most = List.fold_left (fun most mode -> max most (size mode)) 0 modes in
      let split (number, members) =
        let large, small = List.partition is_large members in
        let within, others = fitting most (large @ small) in
        ((number, within), (number, others))
      in
      let within, others = List.split (List.map split modes) in
      union (List.filter (fun (_, members) -> members <> []) within) :: unions ~union others

let running_mode (node : Ir.node) : Block.t =
  let bytes = if List.compare_length_with node.modes 256 <= 0 then 1 else 4 in
  { bytes; alignment = bytes }

let of_program (program : Ir.program) =
  let homes = homes program in
  let blocks = Array.map (fun _ -> { Block.bytes = 0; alignment = 1 }) program.nodes in
  let rec of_field k ~within (field : Ir.field) =
    let member ?(modes = []) block =
      { path = List.rev (field.name :: within); node = k; field; block; modes }
    in
    match field.content with
    | Value _ when Option.is_some field.bound -> [ member { Block.bytes = 4; alignment = 4 } ]
    | Value ty -> [ member (Block.of_value program.real program.sums ty) ]
    | Running_mode -> [ member (running_mode program.nodes.(k)) ]
    | Component _ -> [ member Block.foreign ]
    | States_of { node; count } -> [ member (Block.run count blocks.(node)) ]
    | State_of inner when homes.(inner) = inner -> [ member blocks.(inner) ]
    | State_of inner -> of_fields inner ~within:(field.name :: within) program.nodes.(inner).state
    | Modes modes ->
        let union modes =
          member ~modes (Block.of_alternatives (List.map (fun (_, m) -> whole m) modes))
        in
        unions ~union (List.mapi (fun number mode -> (number, of_mode k mode)) modes)
  and of_fields k ~within fields = List.concat (List.rev (List.rev_map (of_field k ~within) fields))
  (* The state of a mode does not need a name, because the mode's struct contains only this state
     and the parameters. *)
  and of_mode k (mode : Ir.mode) =
    let parameters = of_fields k ~within:[] (List.map snd mode.parameters) in
    let state =
      match mode.state with
      | Some { content = State_of inner; _ } when homes.(inner) <> inner ->
          of_fields inner ~within:[] program.nodes.(inner).state
      | Some field -> of_field k ~within:[] field
      | None -> []
    in
    in_order (parameters @ state)
  in
  let structs =
    Array.mapi
      (fun k (node : Ir.node) ->
        if homes.(k) <> k then []
        else
          let members = in_order (of_fields k ~within:[] node.state) in
          blocks.(k) <- whole members;
          members)
      program.nodes
  in
  { homes; structs }
