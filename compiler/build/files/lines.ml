exception Too_long

let longest = Interp.Csv.longest

type t = { channel : in_channel; block : bytes; mutable from : int; mutable until : int }

let of_channel channel = { channel; block = Bytes.create 65536; from = 0; until = 0 }

let fill t =
  if t.from = t.until then (
    t.from <- 0;
    t.until <- input t.channel t.block 0 (Bytes.length t.block));
  t.until > t.from

let next t =
  let line = Buffer.create 256 in
  let take stop =
    Buffer.add_subbytes line t.block t.from (stop - t.from);
    if Buffer.length line > longest then raise Too_long
  in
  let rec go ~is_begun =
    if not (fill t) then if is_begun then Some (Buffer.contents line) else None
    else
      match Bytes.index_from_opt t.block t.from '\n' with
      | Some stop when stop < t.until ->
          take stop;
          t.from <- stop + 1;
          Some (Buffer.contents line)
      | Some _ | None ->
          take t.until;
          t.from <- t.until;
          go ~is_begun:true
  in
  go ~is_begun:false
