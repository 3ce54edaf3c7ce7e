type value = { unit_ : string; part : string -> value }

type t = {
  input : value;
  output : value;
  record : Flow.Ir.product -> value;
  field : Step.Ir.field -> string;
}

let rec unknown = { unit_ = ""; part = (fun _ -> unknown) }
let none = { input = unknown; output = unknown; record = (fun _ -> unknown); field = (fun _ -> "") }
