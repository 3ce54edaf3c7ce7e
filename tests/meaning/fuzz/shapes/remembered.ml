open Choice

let f = Printf.sprintf

let event (values : Scope.t) condition =
  let random = values.random in
  let now = Scope.fresh values "q" in
  let before = f "delay %s %s" (one_of random [ "False"; "False"; "True" ]) now in
  let either text = one_of random [ text; f "not (%s)" text ] in
  let a, b = (either now, either before) in
  let a, b = if chance random 4 then (b, a) else (a, b) in
  f "let %s = (%s :: Bool) in when (%s %s %s)" now (condition ()) a
    (one_of random [ "&&"; "||"; "&&"; "||"; "/=" ])
    b
