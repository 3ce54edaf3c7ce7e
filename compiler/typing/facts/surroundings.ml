open Basis

type construct = Signature of string | Class of string | Instance of string
type owned = { by : construct; place : Span.t }
type enclosing = { expr : Resolve.Ir.expr; wanted : Type.t option }

type t = {
  environment : Environment.t;
  sources : Source.t;
  inputs : (string * Type.t) list;
  enclosing : enclosing list;
  needs_class : Type.t -> bool;
  definition : Resolve.Ir.Local.t -> Resolve.Ir.expr option;
  local : Resolve.Ir.Local.t -> Type.t option;
  unit_ : Resolve.Ir.unit_ -> Units.t option;
  fields : Type.t -> (string * string list) option;
  field_of : Type.t -> of_:Type.t -> string option;
  field_type : Type.t -> string -> Type.t option;
  choices : Type.t -> string list;
  declared : Resolve.Ir.Global.t -> Type.t option;
  named : string -> Type.t list;
  values : Type.t -> file:string -> string list;
  binding : Resolve.Ir.Global.t -> Resolve.Ir.binding option;
  local_function : Resolve.Ir.Local.t -> Resolve.Ir.binding option;
  parameter : Resolve.Ir.Local.t -> (Resolve.Ir.binding * int) option;
  unnamed_input : Span.t option;
  makers : Type.t -> of_:Type.t -> string list;
  owner : Ir.variable -> owned option;
}

let nowhere environment =
  {
    environment;
    named = (fun _ -> []);
    values = (fun _ ~file:_ -> []);
    sources = Source.create ();
    inputs = [];
    enclosing = [];
    needs_class = (fun _ -> false);
    definition = (fun _ -> None);
    local = (fun _ -> None);
    unit_ = (fun _ -> None);
    fields = (fun _ -> None);
    field_of = (fun _ ~of_:_ -> None);
    field_type = (fun _ _ -> None);
    choices = (fun _ -> []);
    declared = (fun _ -> None);
    binding = (fun _ -> None);
    local_function = (fun _ -> None);
    parameter = (fun _ -> None);
    unnamed_input = None;
    makers = (fun _ ~of_:_ -> []);
    owner = (fun _ -> None);
  }
