open Basis

let diagnostic sources (fact : Flow.Fact.t) =
  match fact with
  | Loop loop -> Loop_mistake.diagnostic sources loop
  | Too_large { entry; measure; amount; limit; largest } ->
      Extent_mistake.diagnostic ~entry measure ~amount ~limit largest
  | Endless { at; entry; program; steps; limit } ->
      Endless_mistake.diagnostic ~at ~entry program steps ~limit

let into ?(sources = Source.create ()) sink = Facts.into sink (diagnostic sources)
