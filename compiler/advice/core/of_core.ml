open Basis

let into sink = Facts.into sink Recursion_mistake.diagnostic
