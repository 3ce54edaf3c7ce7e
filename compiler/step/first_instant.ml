module F = Flow.Ir

let shows state (eq : F.equation) =
  match State.memory state eq.defines with
  | None -> eq.rhs = Step_time
  | Some (Elapsed _ | Ticked _ | Differentiated _) -> true
  | Some (Integrated { input = Field _; _ } | Delayed _ | Kept _) -> false
  | Some (Integrated _) -> true

let shows_in state statics = List.exists (shows state) (Statics.equations_in_step statics)

(* A delay of the programmer's that is false in the first instant, then true. *)
let delayed state statics =
  List.find_map
    (fun (eq : F.equation) ->
      match (eq.rhs, State.memory state eq.defines) with
      | Delay { init = Bool false; next = Bool true }, Some (Delayed field) -> Some field
      | _, _ -> None)
    (Statics.equations_in_step statics)

let mark state statics span : Ir.mark * Ir.statement list =
  match delayed state statics with
  | Some field -> ({ field; own = false }, [])
  | None ->
      let name = "started" and purpose = State.past_first in
      let field = State.new_field state ~name (Value Bool) ~purpose span in
      ({ field; own = true }, [ Assign { place = Own field; value = Bool false; span } ])
