type t = { mutable newest_first : Ir.equation list }

let create () = { newest_first = [] }
let add t binder rhs span = t.newest_first <- { Ir.binder; rhs; span } :: t.newest_first
let pure t binder value span = add t binder (Ir.Pure value) span

let run t binder ~signal_function ~input span =
  add t binder (Ir.Run { signal_function; input }) span

let parts t pattern ~root span =
  List.iter (fun (binder, value) -> pure t binder value span) (Matching.variables pattern ~root)

let all t = List.rev t.newest_first
