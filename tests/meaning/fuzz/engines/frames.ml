external write_files : string -> (int * int64 * int64) array = "frames_write"

let written : (string * Kernels.image array) option ref = ref None

let load frames (number, size, hash) =
  match Kernels.frame frames ~number ~size ~hash with
  | Ok image -> image
  | Error expected -> failwith ("a frame is not read back: expected " ^ expected)

let write ~folder =
  match !written with
  | Some (known, _) when String.equal known folder -> ()
  | _ ->
      let record = Filename.concat folder "in.csv" in
      let names = write_files record in
      written := Some (folder, Array.map (load (Kernels.frames ~record)) names)

let any random =
  match !written with
  | Some (_, images) -> images.(Random.State.int random (Array.length images))
  | None -> failwith "there are no frames yet"
