let event_type ty : Core.Ir.ty = Data ({ module_ = "Prelude"; name = "Event" }, [ ty ])
let either_type a b : Core.Ir.ty = Data ({ module_ = "Prelude"; name = "Either" }, [ a; b ])

let keeps_nothing (proc : Core.Ir.proc) =
  List.for_all
    (fun (e : Core.Ir.equation) -> match e.rhs with Pure _ -> true | Run _ -> false)
    proc.equations

(* [Event] and [Right] are second constructors. *)
let second (c : Context.t) node ~span ty value =
  match Leaves.is_constructor c.types node Node.Unnamed ~span ty value 1 with
  | Bool true ->
      Some (Leaves.payload c.types node Unnamed ~span ty value ~constructor:1 ~field:0)
  | Bool false | Int _ | Float _ | Signal _ -> None

let result (c : Context.t) run node input (head : Task.head) =
  match (head, input) with
  | ( Runs
        {
          signal_function = Signal_function { code = Proc proc; _ } as signal_function;
          primitive;
          output;
          result;
        },
      Some input )
    when keeps_nothing proc ->
      let span = proc.output.span in
      let run result = run ~span ~result signal_function input in
      let ended =
        if primitive = Make_task then
          let event = event_type result in
          let both : Core.Ir.ty = Tuple [ output; event ] in
          second c node ~span event (Leaves.component (run both) 1)
        else
          let either = either_type output result in
          second c node ~span either (run either)
      in
      Option.map (fun value : Value.argument -> { value; ty = result }) ended
  | _, _ -> None
