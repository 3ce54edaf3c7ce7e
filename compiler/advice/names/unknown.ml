open Basis
open Resolve

type t = {
  module_ : Module_syntax.t;
  namespace : Interface.namespace;
  name : Syntax.Ir.name;
  names : string list Lazy.t;
  locals : string list Lazy.t;
  signals : Proc_signals.t list Lazy.t;
  is_in : Interface.names -> bool;
}

let create (module_ : Module_syntax.t) (Interface.Any space) (name : Syntax.Ir.name) ~locals ~around
    =
  {
    module_;
    namespace = space.namespace;
    name;
    names = lazy (Visible.names module_.visible space locals);
    locals;
    signals = lazy (Proc_signals.of_surroundings around);
    is_in = (fun names -> String_table.mem (space.table names) name.text);
  }

let text t = t.module_.visible.text
let is_unit t = Visible.is_known t.module_.visible Interface.units

let diagnostic t =
  Diagnostic.error ~code:(Namespace.unknown t.namespace) ~at:t.name.span "unknown %s `%s`"
    (Namespace.noun t.namespace) t.name.text

let c_declaration t =
  let is_it (d : Proc_signals.c_declaration) = String.equal d.declared.text t.name.text in
  List.find_opt is_it (Lazy.force t.module_.c_declarations)
