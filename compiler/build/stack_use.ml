open Basis

(* A definition starts in the first column; its other lines are indented. *)
let largest_definition sources file =
  match Source.text sources file with
  | None -> None
  | Some text ->
      let largest = ref (0, 0, 0) and first = ref (0, 1) in
      let close offset =
        let start, line = !first and size, _, _ = !largest in
        if offset - start > size then largest := (offset - start, start, line)
      in
      let line = ref 1 in
      String.iteri
        (fun i c ->
          if c = '\n' then (
            incr line;
            let begins =
              i + 1 < String.length text
              && match text.[i + 1] with ' ' | '\n' | '\r' | '-' -> false | _ -> true
            in
            if begins then (
              close (i + 1);
              first := (i + 1, !line))))
        text;
      close (String.length text);
      let size, start, line = !largest in
      let stop = Option.value (String.index_from_opt text start '\n') ~default:start in
      let start_position = Span.position ~line ~column:1 in
      let stop = Span.position ~line ~column:(1 + min 40 (stop - start)) in
      Some (size, Span.make ~file ~start:start_position ~stop)

let report sink sources file =
  let at, size =
    match largest_definition sources file with
    | Some (size, at) -> (at, size)
    | None -> (Span.start_of_file file, 0)
  in
  Diagnostic.error ~code:"E0106" ~at
    "the program is too large, or nested too deeply, for the stack of frobc"
  |> Diagnostic.note "this is its largest definition, with %d characters" size
  |> Diagnostic.hint "split it into several definitions"
  |> Diagnostic.hint "or run `ulimit -s unlimited` to allow a larger stack"
  |> Diagnostic.emit sink

let guarded sink sources (r : Request.t) ~otherwise f =
  try f ()
  with Stack_overflow ->
    report sink sources r.file;
    otherwise
