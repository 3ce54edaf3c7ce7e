open Basis

let diagnostic sources (fact : Typing.Fact.t) =
  match fact with Pattern fact -> Pattern_mistake.diagnostic sources fact

let into ?(sources = Source.create ()) sink = Facts.into sink (diagnostic sources)
