let rows path =
  Packed.with_input path (fun channel ->
      let read () = match input_char channel with c -> Some c | exception End_of_file -> None in
      let csv = Interp.Csv.reader read in
      let rec all found =
        match Interp.Csv.next csv with
        | Ok (Some row) ->
            all (Array.of_list (List.map (fun (c : Interp.Csv.cell) -> c.text) row.cells) :: found)
        | Ok None | Error _ -> List.rev found
      in
      Ok (all []))

(* Removes indices: [probe.follow.seats[2].x] becomes [probe.follow.seats.x]. *)
let without_numbers name =
  let buffer = Buffer.create (String.length name) and inside = ref false in
  String.iter
    (fun c ->
      if c = '[' then inside := true;
      if not !inside then Buffer.add_char buffer c;
      if c = ']' then inside := false)
    name;
  Buffer.contents buffer

let picture ~units path =
  match rows path with
  | Error reasons -> Error (String.concat "\n" reasons)
  | Ok [] -> Error (path ^ " is empty")
  | Ok (header :: rows) ->
      let rows = Array.of_list (List.filter (fun r -> Array.length r = Array.length header) rows) in
      let column k name =
        {
          Plot.name;
          unit_ = units (without_numbers name);
          cells = Array.map (fun row -> row.(k)) rows;
        }
      in
      let columns = List.tl (Array.to_list (Array.mapi column header)) in
      let ns row = Option.value (Interp.Trace.nanoseconds row.(0)) ~default:0 in
      let first = if Array.length rows = 0 then 0 else ns rows.(0) in
      (* If the clock began long before the run, count times from the first instant. *)
      let origin = if abs first >= 1_000_000_000_000_000_000 then first else 0 in
      let times = Array.map (fun row -> float_of_int (ns row - origin) /. 1e9) rows in
      Ok (Plot.svg ~times columns)
