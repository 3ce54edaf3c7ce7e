module F = Flow.Ir
open Basis
open Fragment
open Computation

type t = {
  copies : F.atom Int_table.t;
  leaves : Ir.expr Int_table.t;
  nanoseconds : unit Int_table.t;
  mutable items : item list;  (** newest first *)
  mutable states : (Ir.field * F.atom * F.signal option * Span.t) list;
}

let create () =
  {
    copies = Int_table.create 16;
    leaves = Int_table.create 16;
    nanoseconds = Int_table.create 4;
    items = [];
    states = [];
  }

let add draft item = draft.items <- item :: draft.items
let count_nanoseconds draft (s : F.signal) = Int_table.replace draft.nanoseconds s.id ()
let leaf draft (s : F.signal) e = Int_table.replace draft.leaves s.id e

let resolve draft (atom : F.atom) =
  match atom with
  | Signal s -> Option.value (Int_table.find_opt draft.copies s.id) ~default:atom
  | Bool _ | Int _ | Float _ -> atom

let add_computed draft (eq : F.equation) =
  match without_self_comparison (Flow.Operands.map (resolve draft) eq.rhs) with
  | Copy atom when String.equal eq.defines.name "" ->
      Int_table.replace draft.copies eq.defines.id atom
  | Param k -> leaf draft eq.defines (Param k)
  | rhs -> add draft (Computed (computed eq rhs))

let work ?(defines = []) ?(operands = []) ?(always = true) ?advances ?(weight = 0) span statements =
  Action { defines; operands; statements; always; advances; weight; span }

let keep_at_end draft field next ~leaf span =
  draft.states <- (field, next, leaf, span) :: draft.states

let fragment { leaves; nanoseconds; items; states; copies = _ } : Fragment.t =
  {
    leaves;
    nanoseconds;
    items = Array.of_list (List.rev items);
    states = List.rev states;
    results = [];
    returned = None;
    advances = [];
    ending = None;
  }
