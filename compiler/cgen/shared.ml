module M = Machine.Ir
module Modes = Set.Make (Int)

type t = bool array

let inline_size = 12

(* From where a node's step is called. *)
type paths =
  | Never
  | In of Modes.t
      (** once in each of these modes, the innermost ones around the calls; if there
          are none, once outside of modes *)
  | Together  (** more than once at an instant, as far as can be seen *)

let join a b =
  match (a, b) with
  | Never, paths | paths, Never -> paths
  | In a, In b when Modes.disjoint a b && not (Modes.is_empty a || Modes.is_empty b) ->
      In (Modes.union a b)
  | (In _ | Together), _ -> Together

let stepped (node : M.node) =
  let found = ref [] in
  Machine.Walk.statements
    (function
      | M.Step { node; _ } -> found := node :: !found
      (* Not worth a call in each round. *)
      | Loop { node; _ } -> found := node :: node :: !found
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Start _ | Begin _ | Await _ | Run _
      | Return _ -> ())
    node.step.body;
  !found

let is_several = function
  | In modes -> Modes.cardinal modes > 1
  | Never | Together -> false

let of_program (program : M.program) =
  let count = Array.length program.nodes in
  let paths = Array.make count Never in
  let shared = Array.make count false in
  if count > 0 then paths.(count - 1) <- In Modes.empty;
  (* Callers come after what they call. *)
  for k = count - 1 downto 0 do
    let node = program.nodes.(k) in
    shared.(k) <-
      is_several paths.(k) && Option.is_none node.foreign && node.operations > inline_size;
    (* What one function calls is called once. *)
    let around = if shared.(k) then In Modes.empty else paths.(k) in
    let call callee = paths.(callee) <- join paths.(callee) around in
    List.iter call (stepped node);
    (* The modes of a machine that is itself in several are in all of these. *)
    let mode (m : M.mode) =
      paths.(m.node) <-
        (match around with
        | In modes when Modes.cardinal modes <= 1 -> In (Modes.singleton m.node)
        | Never | In _ | Together -> around)
    in
    List.iter mode node.modes
  done;
  shared

let is_shared t k = t.(k)
