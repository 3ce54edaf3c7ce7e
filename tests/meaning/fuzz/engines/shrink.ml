type failing = { text : string; outcome : Engines.outcome; recordings : Recording.t list }

let first_line text = List.hd (String.split_on_char '\n' text)

(* The code of the first error among the diagnostics, such as [error\[E0301\]]. *)
let first_code text =
  let lines = String.split_on_char '\n' text in
  match List.find_opt (String.starts_with ~prefix:"error") lines with
  | Some line -> List.hd (String.split_on_char ':' line)
  | None -> ""

(* Whether two failures may have the same cause. *)
let alike (a : Engines.outcome) (b : Engines.outcome) =
  match (a, b) with
  | Differ _, Differ _ -> true
  | Rejected a, Rejected b -> String.equal (first_code a) (first_code b)
  | Failed a, Failed b ->
      (* tcc's messages start with a place in the file. *)
      let reason text =
        match String.index_opt text ':' with
        | Some i when text.[0] = '/' -> "C" ^ string_of_int (min i 0)
        | _ -> first_line text
      in
      String.equal (reason a) (reason b)
  | (Agree | Rejected _ | Failed _ | Differ _), _ -> false

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

let outcome (tools : Engines.tools) engines recordings text : Engines.outcome =
  let file = Filename.concat tools.folder "program.frob" in
  write file text;
  match Engines.load tools ~entry:"main" file with
  | Error outcome -> outcome
  | Ok subject ->
      (* A smaller program may have fewer input columns. *)
      if List.for_all (Engines.fits subject) recordings then
        Engines.judge tools engines subject recordings
      else Agree

(* If the engines differ, one recording up to the first difference is enough to show it. *)
let enough (outcome : Engines.outcome) recordings =
  match outcome with
  | Differ { recording; row; _ } -> [ Recording.first_rows (row + 1) recording ]
  | Agree | Rejected _ | Failed _ -> recordings

let program tools engines ~seconds ~first failing =
  let last = Unix.gettimeofday () +. seconds in
  let in_time () = Unix.gettimeofday () < last in
  let best = ref { failing with recordings = enough failing.outcome failing.recordings } in
  let accept text recordings =
    in_time ()
    &&
    let found = outcome tools engines recordings text in
    alike failing.outcome found
    &&
    (best := { text; outcome = found; recordings = enough found recordings };
     true)
  in
  let good text = (not (String.equal text !best.text)) && accept text !best.recordings in
  let parts split separator =
    ignore (Reduction.without_some ~separator (split !best.text) good : string list)
  in
  let rec groups i =
    if in_time () then
      match Reduction.at !best.text i with
      | None -> ()
      | Some (place, candidates) ->
          if List.exists good candidates then groups place else groups (place + 1)
  in
  let rec rows k =
    match !best.recordings with
    | [ recording ] when k >= 0 ->
        if List.length (Recording.rows recording) > 1 then
          ignore (accept !best.text [ Recording.without k recording ] : bool);
        rows (min (k - 1) (List.length (Recording.rows recording) - 2))
    | _ -> ()
  in
  let rec rounds () =
    let before = !best.text in
    parts Reduction.paragraphs "\n\n";
    parts Reduction.lines "\n";
    groups 0;
    if in_time () && not (String.equal before !best.text) then rounds ()
  in
  ignore (List.exists (fun text -> accept text !best.recordings) first : bool);
  rounds ();
  (match !best.recordings with
  | [ recording ] -> rows (List.length (Recording.rows recording) - 1)
  | _ -> ());
  !best
