let with_stops width text =
  let result = Buffer.create (String.length text + 64) in
  let column = ref 0 in
  let blank () =
    Buffer.add_char result ' ';
    incr column
  in
  String.iter
    (fun c ->
      if c = '\t' then (
        blank ();
        while !column mod width <> 0 do
          blank ()
        done)
      else (
        Buffer.add_char result c;
        if c = '\n' then column := 0 else if not (Basis.Utf8.is_continuation c) then incr column))
    text;
  Buffer.contents result

let parses text = Syntax.Parse.program (Basis.Facts.ignored ()) ~file:"" text <> None

(* Whether a string literal contains a tab. *)
let in_quotes text =
  let lexer = Syntax.Lexer.create ignore ~file:"" text in
  let rec go () =
    let token = Syntax.Lexer.next lexer in
    match token.token with
    | END -> false
    | STRING _ ->
        let start = token.start.pos_cnum in
        String.contains (String.sub text start (token.stop.pos_cnum - start)) '\t' || go ()
    | _ -> go ()
  in
  go ()

let expanded text =
  let four = with_stops 4 text and eight = with_stops 8 text in
  if
    (not (in_quotes text))
    && parses four && parses eight
    && Laws.broken (Reading.text four) (Reading.text eight) <> Some Laws.Tree
  then Some four
  else None
