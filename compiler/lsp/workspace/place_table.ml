open Basis

include Hashtbl.Make (struct
  type t = Span.position * Span.position

  let equal ((a, b) : t) ((c, d) : t) =
    Int.equal (a :> int) (c :> int) && Int.equal (b :> int) (d :> int)

  let hash ((a, b) : t) = ((a :> int) * 65599) + (b :> int)
end)

let place (s : Span.t) : key = (s.start, s.stop)
