open Basis

external columns : unit -> int = "frob_terminal_columns"

let seen = lazy (Unix.isatty Unix.stderr)
let is_seen () = Lazy.force seen

(* The traditional width, used for terminals that do not report theirs. *)
let usual = 80
let width text = Display.width (Display.of_line text)
let cut text room = Display.part (Display.of_line text) ~from:0 ~width:(max 0 room)

let show ~head ~tail =
  if is_seen () then
    (* Leave the last column empty, because some terminals wrap there. *)
    let room = (match columns () with n when n > 0 -> n | _ -> usual) - 1 in
    let tail = ": " ^ tail in
    let left = room - width tail in
    let head =
      if width head <= left then head else if left < 2 then "" else cut head (left - 1) ^ "…"
    in
    Printf.eprintf "\r\027[K%s%!" (cut (head ^ tail) room)

let clear () = if is_seen () then Printf.eprintf "\r\027[K%!"
