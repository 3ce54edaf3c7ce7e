(* Those of ASCII, and those that UTF-8 writes as C2 80 to C2 9F. *)
let escaped ~keep text =
  let is_control k c =
    (c < ' ' && not (String.contains keep c))
    || c = '\127'
    || (c >= '\128' && c < '\160' && k > 0 && text.[k - 1] = '\194')
  in
  let shown = Buffer.create (String.length text) in
  String.iteri
    (fun k c ->
      if is_control k c then Buffer.add_string shown (Printf.sprintf "\\%03d" (Char.code c))
      else if c = '\194' && k + 1 < String.length text && is_control (k + 1) text.[k + 1] then ()
      else Buffer.add_char shown c)
    text;
  Buffer.contents shown

let name text = escaped ~keep:"" text
let text text = escaped ~keep:"\n\t" text
