type glyph = { shown : string; columns : int }

type t = {
  glyphs : glyph array;
  column_at : int array;  (** terminal column by byte offset, with one entry past the end *)
}

let replacement = "\xef\xbf\xbd"
let within code ranges = List.exists (fun (first, last) -> code >= first && code <= last) ranges

(* Combining marks and invisible characters. *)
let zero_width = [ (0x300, 0x36f); (0x200b, 0x200d); (0x20d0, 0x20ff); (0xfe00, 0xfe0f) ]

(* East Asian wide characters and most emoji. *)
let double_width =
  [
    (0x1100, 0x115f);
    (0x2e80, 0xa4cf);
    (0xac00, 0xd7a3);
    (0xf900, 0xfaff);
    (0xfe30, 0xfe6f);
    (0xff00, 0xff60);
    (0xffe0, 0xffe6);
    (0x1f300, 0x1f64f);
    (0x1f900, 0x1f9ff);
    (0x20000, 0x3fffd);
  ]

(* Bidirectional controls and other invisible characters, which could make one line look like
   another. *)
let disguise =
  [ (0x80, 0x9f); (0x200e, 0x200f); (0x202a, 0x202e); (0x2066, 0x2069); (0xfeff, 0xfeff) ]

let glyph text i =
  match Utf8.decode text i with
  | 1, 0x09 -> (1, { shown = "    "; columns = 4 })
  | 1, code when code < 0x20 || code = 0x7f -> (1, { shown = replacement; columns = 1 })
  | 0, _ -> (1, { shown = replacement; columns = 1 })
  | length, 0xfeff when i = 0 -> (length, { shown = ""; columns = 0 })
  | length, code when within code disguise -> (length, { shown = replacement; columns = 1 })
  | length, code ->
      let columns =
        if code < 0x300 then 1
        else if within code zero_width then 0
        else if within code double_width then 2
        else 1
      in
      (length, { shown = String.sub text i length; columns })

let of_line text =
  let n = String.length text in
  let column_at = Array.make (n + 1) 0 in
  let rec go i column glyphs =
    if i >= n then (
      column_at.(n) <- column;
      Array.of_list (List.rev glyphs))
    else
      let length, glyph = glyph text i in
      Array.fill column_at i length column;
      go (i + length) (column + glyph.columns) (glyph :: glyphs)
  in
  let glyphs = go 0 0 [] in
  { glyphs; column_at }

let width t = t.column_at.(Array.length t.column_at - 1)

let column t offset =
  let last = Array.length t.column_at - 1 in
  if offset <= last then t.column_at.(max 0 offset) else t.column_at.(last) + offset - last

let byte_order_mark = "\xef\xbb\xbf"
let is_marked text = String.length text >= 3 && String.equal (String.sub text 0 3) byte_order_mark

let characters_before text offset =
  let n = String.length text in
  let rec go i count =
    if i >= offset || i >= n then count + max 0 (offset - max i n)
    else go (i + max 1 (fst (Utf8.decode text i))) (count + 1)
  in
  if is_marked text then go 3 0 else go 0 0

let part t ~from ~width =
  let text = Buffer.create 80 in
  let column = ref 0 in
  Array.iter
    (fun glyph ->
      if !column >= from && !column + glyph.columns <= from + width then
        Buffer.add_string text glyph.shown;
      column := !column + glyph.columns)
    t.glyphs;
  Buffer.contents text
