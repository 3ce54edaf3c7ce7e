open Basis

(* The largest numbers of 32 bits, without and with a sign. The first one is one less, so that C
   compilers do not warn about comparisons that are always true. *)
let most = 0xFFFFFFFEL
let most_with_sign = 0x7FFFFFFFL

(* What a step does with a time. *)
type uses = {
  mutable bound : int64;  (** the largest constant that it is compared with *)
  mutable compared : int;  (** number of reads that are compared with constants *)
  mutable advanced : int;  (** number of reads that advance the time *)
  mutable is_soon : bool;  (** the time is advanced with a plain addition *)
  mutable all : int;  (** number of all reads *)
}

(* The uses of each field of a node, by id. *)
let uses_in real (node : Ir.node) =
  let found = Int_table.create 8 in
  let uses (f : Ir.field) =
    match Int_table.find_opt found f.id with
    | Some uses -> uses
    | None ->
        let uses = { bound = 0L; compared = 0; advanced = 0; is_soon = false; all = 0 } in
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
    | (Later (Field f, Dt_nanoseconds) | Soon (Field f, Dt_nanoseconds)) as e when f.id = time.id ->
        let uses = uses f in
        uses.advanced <- uses.advanced + 1;
        uses.is_soon <- (uses.is_soon || match e with Soon _ -> true | _ -> false)
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

let with_bounds ~keep_soon real (node : Ir.node) =
  let uses = uses_in real node in
  let field (f : Ir.field) =
    match uses f with
    | Some { bound; compared; advanced; is_soon; all }
      when 0L < bound && bound <= most && all = compared + advanced && not (keep_soon && is_soon) ->
        { f with bound = Some bound }
    | Some _ | None -> f
  in
  { node with state = List.map field node.state }

let is_dt_short (program : Ir.program) =
  let is_short (node : Ir.node) =
    let reads = ref 0 in
    Walk.expressions (function Ir.Dt_nanoseconds -> incr reads | _ -> ()) node.step.body;
    let uses = uses_in program.real node in
    let advances (f : Ir.field) =
      match (f.bound, uses f) with
      | Some bound, Some { advanced; _ } when bound <= most_with_sign -> advanced
      | _, _ -> 0
    in
    !reads = 0 || !reads = List.fold_left (fun n f -> n + advances f) 0 node.state
  in
  Array.for_all is_short program.nodes

let program (program : Ir.program) =
  let bounded ~keep_soon =
    { program with nodes = Array.map (with_bounds ~keep_soon program.real) program.nodes }
  in
  let all = bounded ~keep_soon:false in
  if is_dt_short all then all else bounded ~keep_soon:true
