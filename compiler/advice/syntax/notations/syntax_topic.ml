open Basis

type shared =
  | Own_operator
  | No_procedures
  | Function_by_equation
  | End_of_block
  | Waiting
  | No_effect
  | Record_declaration of string

type Diagnostic.topic +=
  | Shared of shared
  | Function_keyword
  | Block_in_braces
  | Changed_copy
  | Choice of string
  | Colon_of_a_block
  | Class_of_objects
  | Switch of string

let suggestion topic text = Diagnostic.suggestion ~topic:(Shared topic) "%s" text
let text text = Diagnostic.suggestion "%s" text
