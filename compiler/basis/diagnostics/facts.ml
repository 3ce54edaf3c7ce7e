type 'fact held = { fact : 'fact; diagnostics : Diagnostic.t list }

type 'fact t = {
  sink : Diagnostic.sink;
  advise : 'fact -> Diagnostic.t list;
  mutable held : 'fact held list option;  (** newest first; [None] while facts are not held *)
}

let into_several sink advise = { sink; advise; held = None }
let into sink advise = into_several sink (fun fact -> [ advise fact ])
let map f t = { sink = t.sink; advise = (fun fact -> t.advise (f fact)); held = None }
let ignored () = into_several (Diagnostic.sink ()) (fun _ -> [])

let pass_on t held =
  match t.held with
  | Some earlier -> t.held <- Some (held :: earlier)
  | None -> List.iter (Diagnostic.emit t.sink) held.diagnostics

let report t fact = pass_on t { fact; diagnostics = t.advise fact }
let report_warning t fact = List.iter (Diagnostic.emit t.sink) (t.advise fact)
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

let is_within spans held =
  let is_in at (span : Span.t) =
    String.equal span.file at.Span.file && Span.compare (Span.merge at span) span = 0
  in
  let is_there (d : Diagnostic.t) = List.exists (is_in d.at) spans in
  held.diagnostics <> [] && List.for_all is_there held.diagnostics

let diagnostic held =
  match held.diagnostics with
  | [ diagnostic ] -> diagnostic
  | diagnostics -> Diagnostic.bug ~stage:"Facts" "%d diagnostics" (List.length diagnostics)
