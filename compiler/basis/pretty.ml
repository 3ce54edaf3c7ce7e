type 'a t = { out : Format.formatter; names : Unique_names.t; own : 'a }

let create out own = { out; names = Unique_names.create (); own }
let put t text = Format.pp_print_string t.out text
let cut t = Format.pp_print_cut t.out ()
let space t = Format.pp_print_space t.out ()

let between t opening closing f =
  put t opening;
  f ();
  put t closing

let parenthesized t yes f = if yes then between t "(" ")" f else f ()

let box open_box t ?(parentheses = false) indent f =
  parenthesized t parentheses (fun () ->
      open_box t.out indent;
      f ();
      Format.pp_close_box t.out ())

let hov t = box Format.pp_open_hovbox t
let hv t = box Format.pp_open_hvbox t
let vertical t = box Format.pp_open_vbox t

let words t f parts =
  List.iter
    (fun part ->
      put t " ";
      f part)
    parts

let breakable_words t f parts =
  List.iter
    (fun part ->
      space t;
      f part)
    parts

let lines t f parts =
  List.iter
    (fun part ->
      cut t;
      f part)
    parts

let separated t f parts =
  List.iteri
    (fun i part ->
      if i > 0 then (
        put t ",";
        space t);
      f part)
    parts

let enclosed t opening closing f parts =
  hv t 1 (fun () -> between t opening closing (fun () -> separated t f parts))

let tuple t = enclosed t "(" ")"
let array t = enclosed t "[" "]"

let operator text =
  match text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> text | _ -> "(" ^ text ^ ")"

let is_infix text = operator text <> text

let number n =
  let exact = Exact.to_string n in
  if String.length exact <= 20 then exact else Printf.sprintf "%.17g" (Exact.to_float n)
