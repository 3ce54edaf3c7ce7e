type t = {
  visible : Resolve.Visible.t;
  signals : Proc_signals.t list Lazy.t;
  c_declarations : Proc_signals.c_declaration list Lazy.t;
  in_capitals : string list Lazy.t;
  without_definition : string list Lazy.t;
}

let create (visible : Resolve.Visible.t) =
  let syntax = visible.syntax in
  {
    visible;
    signals = lazy (Proc_signals.of_module syntax);
    c_declarations = lazy (Proc_signals.c_declarations syntax);
    in_capitals = lazy (Proc_signals.in_capitals syntax);
    without_definition = lazy (Proc_signals.without_definition syntax);
  }
