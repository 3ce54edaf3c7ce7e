type 'fact held = { fact : 'fact; diagnostic : Diagnostic.t option }

type 'fact t = {
  sink : Diagnostic.sink;
  advise : 'fact -> Diagnostic.t option;
  mutable held : 'fact held list option;  (** newest first; [None] if facts are passed on *)
}

let into sink advise = { sink; advise = (fun fact -> Some (advise fact)); held = None }
let ignored () = { sink = Diagnostic.sink (); advise = (fun _ -> None); held = None }

let pass_on t held =
  match t.held with
  | Some earlier -> t.held <- Some (held :: earlier)
  | None -> Option.iter (Diagnostic.emit t.sink) held.diagnostic

let report t fact = pass_on t { fact; diagnostic = t.advise fact }
let has_errors t = Diagnostic.has_errors t.sink

let hold t f =
  let outer = t.held in
  let stop () =
    let held = List.rev (Option.value t.held ~default:[]) in
    t.held <- outer;
    held
  in
  t.held <- Some [];
  match f () with
  | result -> (result, stop ())
  | exception e ->
      let backtrace = Printexc.get_raw_backtrace () in
      List.iter (pass_on t) (stop ());
      Printexc.raise_with_backtrace e backtrace

let fact held = held.fact

let diagnostic held =
  match held.diagnostic with
  | Some diagnostic -> diagnostic
  | None -> Diagnostic.bug ~stage:"Facts" "a fact without a diagnostic"
