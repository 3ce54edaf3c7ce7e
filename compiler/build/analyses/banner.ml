open Basis

let options (r : Request.t) =
  let all =
    (if r.entry = "main" then [] else [ "--entry"; r.entry ])
    @ Common_options.to_repeat r.options ~sources:[]
    @ (if r.batch then [ "--batch" ] else [])
    @
    match r.options.asserts with
    | Off -> []
    | Count -> [ "--asserts=count" ]
    | Stop -> [ "--asserts=stop" ]
    | Margin -> [ "--asserts=margin" ]
  in
  match all with [] -> "no options" | all -> String.concat " " all

let sum text = Digest.to_hex (Digest.string text)

(* Omits the folder of the module, so that the lines are the same on all machines. *)
let own_line (file, text) =
  Printf.sprintf "  %s  %s" (sum text) (Printable.name (Filename.basename file))

let library_line = function
  | [] -> []
  | modules ->
      let named (file, text) = Filename.basename file ^ "\000" ^ text in
      let all = List.sort String.compare (List.map named modules) in
      [
        Printf.sprintf "  %s  (library, %d modules)"
          (sum (String.concat "\000" all))
          (List.length all);
      ]

let lines (r : Request.t) sources =
  (* The file names of library modules do not contain their folder, so this function recognizes a
     library module by its text. *)
  let is_library (file, text) =
    r.files.read (Filename.concat r.library (Filename.basename file)) = Ok text
  in
  let library, own = List.partition is_library (Source.all sources) in
  let by_name (a, _) (b, _) = String.compare (Filename.basename a) (Filename.basename b) in
  Printf.sprintf "frobc %s, %s" Version.number (options r)
  :: "md5sum of the sources:"
  :: (List.map own_line (List.stable_sort by_name own) @ library_line library)
