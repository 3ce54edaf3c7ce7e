open Basis

(* One less than the largest unsigned 32-bit number, so that C compilers do not warn about
   comparisons that are always true. *)
let most = 0xFFFFFFFEL

(* How a step uses a time. *)
type uses = {
  mutable bound : int64;  (** the largest constant that the time is compared with *)
  mutable compared : int;  (** number of reads that compare it with constants *)
  mutable advanced : int;  (** number of reads that advance the time *)
  mutable all : int;  (** total number of reads *)
}

(* The uses of each field of a node, by the field's id. *)
let uses_in real (node : Ir.node) =
  let found = Int_table.create 8 in
  let uses (f : Ir.field) =
    match Int_table.find_opt found f.id with
    | Some uses -> uses
    | None ->
        let uses = { bound = 0L; compared = 0; advanced = 0; all = 0 } in
        Int_table.replace found f.id uses;
        uses
  in
  let read : Ir.expr -> unit = function
    | Operation
        { operator = Less_equal; ty = Float; arguments = [ Float x; In_nanoseconds (Field f) ]; _ }
      ->
        let reach bound =
          let uses = uses f in
          uses.bound <- max uses.bound bound;
          uses.compared <- uses.compared + 1
        in
        Option.iter reach (Flow.Clock.reaches real x)
    | Field f -> (uses f).all <- (uses f).all + 1
    | _ -> ()
  in
  let rec advance (time : Ir.field) : Ir.expr -> unit = function
    | (Later (Field f, Dt_nanoseconds) | Soon (Field f, Dt_nanoseconds)) when f.id = time.id ->
        let uses = uses f in
        uses.advanced <- uses.advanced + 1
    | Select { then_; else_; _ } ->
        advance time then_;
        advance time else_
    | _ -> ()
  in
  Walk.expressions read node.step.body;
  Walk.statements
    (function
      | Assign { place = Own ({ content = Value Nanoseconds; _ } as time); value; _ } ->
          advance time value
      | _ -> ())
    node.step.body;
  fun (f : Ir.field) ->
    match f.content with Value Nanoseconds -> Int_table.find_opt found f.id | _ -> None

(* Whether the field is written only to advance or restart it. *)
let is_written_simply (node : Ir.node) (field : Ir.field) =
  let is_advance : Ir.expr -> bool = function
    | Later (Field f, Dt_nanoseconds) | Soon (Field f, Dt_nanoseconds) -> f.id = field.id
    | _ -> false
  in
  let is_simple : Ir.expr -> bool = function
    | Zero_time -> true
    | Select { then_ = Zero_time; else_ = advance; _ } -> is_advance advance
    | Select { then_ = advance; else_ = Zero_time; _ } -> is_advance advance
    | advance -> is_advance advance
  in
  let all = ref true in
  let statement : Ir.statement -> unit = function
    | Assign { place = Own f; value; _ } when f.id = field.id ->
        if not (is_simple value) then all := false
    | _ -> ()
  in
  List.iter (Walk.statements statement) [ node.reset.body; node.step.body ];
  !all

let with_bounds real (node : Ir.node) =
  let uses = uses_in real node in
  let field (f : Ir.field) =
    match uses f with
    | Some { bound; compared; advanced; all }
      when 0L < bound && bound <= most && all = compared + advanced && is_written_simply node f ->
        { f with bound = Some bound }
    | Some _ | None -> f
  in
  { node with state = List.map field node.state }

let reached real (node : Ir.node) =
  let is_compared (time : Ir.field) statements =
    let any = ref false in
    let read : Ir.expr -> unit = function
      | Operation
          {
            operator = Less_equal;
            ty = Float;
            arguments = [ Float x; In_nanoseconds (Field f) ];
            _;
          } ->
          if f.id = time.id && Flow.Clock.reaches real x = time.bound then any := true
      | _ -> ()
    in
    Walk.expressions read statements;
    !any
  in
  let rec from found : Ir.statement list -> Ir.field list = function
    | Assign { place = Own ({ content = Value Nanoseconds; _ } as time); _ } :: rest ->
        let is_reached (f : Ir.field) =
          f.id = time.id && Option.is_some f.bound && is_compared f rest
        in
        from (List.find_all is_reached node.state @ found) rest
    | _ :: rest -> from found rest
    | [] -> found
  in
  from [] node.step.body

let only_advances (program : Ir.program) (node : Ir.node) =
  let reads = ref 0 in
  Walk.expressions (function Ir.Dt_nanoseconds -> incr reads | _ -> ()) node.step.body;
  let uses = uses_in program.real node in
  let advances (f : Ir.field) =
    match (f.bound, uses f) with Some _, Some { advanced; _ } -> advanced | _, _ -> 0
  in
  !reads = List.fold_left (fun n f -> n + advances f) 0 node.state

let program (program : Ir.program) =
  { program with nodes = Array.map (with_bounds program.real) program.nodes }
