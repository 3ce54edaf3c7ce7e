open Basis

type origin = Derived | Bound_signal_function | Parameter | Input

type node = {
  depth : int;
  origin : origin;
  mutable level : Ir.level;
  mutable cause : cause;  (** why the node is a signal *)
  mutable dependents : dependent list;
}

and cause =
  | None_known
  | From_input
  | Runs of Span.t
  | Mentions of { variable : Ir.Local.t; node : node; at : Span.t }

and dependent =
  | Mentioned of { within : node; variable : Ir.Local.t; at : Span.t; inside_proc : bool }
  | Contained of node

type t = {
  variables : node Int_table.t;
  signals : node Queue.t;  (** nodes from which to propagate *)
  statics : node Queue.t;
}

let create () =
  { variables = Int_table.create 16; signals = Queue.create (); statics = Queue.create () }

let node t ~depth origin =
  let make level cause = { depth; origin; level; cause; dependents = [] } in
  match origin with
  | Derived | Bound_signal_function -> make Ir.Constant None_known
  | Parameter ->
      let n = make Ir.Static None_known in
      Queue.add n t.statics;
      n
  | Input ->
      let n = make Ir.Signal From_input in
      Queue.add n t.signals;
      n

let name t (x : Ir.Local.t) node = Int_table.replace t.variables x.id node
let find t (x : Ir.Local.t) = Int_table.find_opt t.variables x.id
let depth node = node.depth
let level node = node.level
let origin node = node.origin

let mention variable ~at node ~within ~inside_proc =
  node.dependents <- Mentioned { within; variable; at; inside_proc } :: node.dependents

let contain node ~within = node.dependents <- Contained within :: node.dependents

let signal t node cause =
  match node.level with
  | Ir.Signal -> ()
  | Constant | Static ->
      node.level <- Signal;
      node.cause <- cause;
      Queue.add node t.signals

let runs t node ~at = signal t node (Runs at)

let static t node =
  match node.level with
  | Ir.Constant ->
      node.level <- Static;
      Queue.add node t.statics
  | Static | Signal -> ()

let drain queue visit =
  while not (Queue.is_empty queue) do
    let node = Queue.pop queue in
    List.iter (visit node) (List.rev node.dependents)
  done

(* Breadth-first, so that the chain that explains a signal is short. All signals are propagated
   first, because a node queued as static may still become a signal. *)
let solve t =
  drain t.signals (fun node -> function
    | Mentioned { within; variable; at; inside_proc = false } ->
        signal t within (Mentions { variable; node; at })
    | Mentioned { within; inside_proc = true; _ } -> static t within
    | Contained within -> signal t within node.cause);
  drain t.statics (fun _ -> function
    | Mentioned { within; _ } | Contained within -> static t within)

(* Maximum length of the chain. *)
let longest_chain = 8

let reasons variable node : Level_fact.reason list =
  let rec go hops variable node : Level_fact.reason list =
    match node.cause with
    | None_known -> []
    | From_input -> [ { variable; why = Input } ]
    | Runs at -> [ { variable; why = Runs_at at } ]
    | Mentions { variable = other; node; at } ->
        { variable; why = Depends_on (other, at) }
        :: (if hops = longest_chain then [] else go (hops + 1) other node)
  in
  go 1 variable node
