exception Needs_itself of Core.Ir.Local.t

let forced (entry : Value.entry) =
  match entry.contents with
  | Known value -> value
  | Suspended evaluate ->
      entry.contents <- Being_evaluated;
      let value = evaluate () in
      entry.contents <- Known value;
      value
  | Being_evaluated -> raise (Needs_itself entry.local)

let code_id : Value.code -> int = function
  | Lambda (binder, _) -> binder.local.id
  | Proc proc -> proc.input.local.id
