open Basis

let diagnostics syntax suggestions (fact : Resolve.Fact.t) =
  match fact with
  | Syntax fact -> Of_syntax.diagnostics syntax fact
  | In_modules fact -> [ Import_mistake.diagnostic fact ]
  | Setting { name; at; problem } -> [ Setting_mistake.diagnostic ~name ~at problem ]
  | Unresolved { visible; names } -> Unresolved.diagnostics suggestions visible names
  | In_definitions fact -> [ Naming_mistake.diagnostic suggestions fact ]
  | In_types fact -> [ Declaration_mistake.diagnostic suggestions fact ]
  | In_records fact -> [ Construction_mistake.diagnostic suggestions fact ]
  | In_foreign_code fact -> [ Foreign_declaration_mistake.diagnostic fact ]
  | Warning fact -> [ Name_warning.diagnostic fact ]

let into sink = Facts.into_several sink (diagnostics (Of_syntax.create ()) (Suggestion.create ()))
