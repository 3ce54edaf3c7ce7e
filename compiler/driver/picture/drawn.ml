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

(* [probe.follow.seats[2].x] is a part of [probe.follow.seats.x]. *)
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
      let times = Array.map (fun row -> float_of_string row.(0)) rows in
      Ok (Plot.svg ~times columns)
