(* Prints the hints in the corpus that say exactly what to write, although their diagnostics have
   no fix. *)

let says_what_to_write hint =
  let begins prefix = String.starts_with ~prefix hint in
  match String.split_on_char '`' hint with
  | _ :: text :: _ when begins "write `" || begins "it is `" || begins "it is written `" ->
      (* An ellipsis, which has these bytes, marks a part that is left open. *)
      not
        (List.mem "\xe2\x80\xa6"
           (List.init (String.length text) (fun i ->
                String.sub text i (min 3 (String.length text - i)))))
  | _ -> false

let () =
  let found = Hashtbl.create 100 in
  Corpus.each (fun ~path:_ ~text:_ _ _ d ->
      let note (hint : Basis.Diagnostic.hint) =
        let hint = Basis.Diagnostic.for_display hint.text in
        if says_what_to_write hint then Hashtbl.replace found (d.code, hint) ()
      in
      if d.fixes = [] then List.iter note d.hints);
  List.iter
    (fun (code, hint) -> Printf.printf "%s %s\n" code hint)
    (List.sort compare (List.of_seq (Hashtbl.to_seq_keys found)))
