open Basis

let inference words (fact : Typing.Inference_fact.t) =
  match fact with
  | Mismatch mismatch -> Mistake.mismatch words mismatch
  | Exchanged_pair { at; expected; first; second } ->
      Mistake.exchanged_pair words ~at expected first second
  | Not_a_function { head; position; argument; ty } ->
      Head_mistake.not_a_function words ~head ~position ~argument ty
  | Negative_argument { minus; operand; function_; ty } ->
      Head_mistake.negative_argument words ~minus ~operand function_ ty
  | Not_a_signal_function { head; ty } -> Head_mistake.not_a_signal_function words ~head ty
  | Too_many_parameters { name; at; parameters; expected; result; allowed } ->
      Parameter_mistake.too_many words ~name ~at ~parameters expected ~result allowed
  | Parameters_in_a_tuple { name; at; parts; expected } ->
      Parameter_mistake.in_a_tuple words ~name ~at parts expected
  | Lacking_types { name; at; expected; lacking } ->
      Parameter_mistake.lacking_types words ~name ~at expected lacking
  | Matched_twice { constructor; first; second; missing } ->
      Pattern_mistake.matched_twice constructor ~first ~second ~missing
  | Parameters_in_other_order { head; name; first; second } ->
      Application_mistake.parameters_in_other_order words ~head ~name first second
  | Mapped_range { at; head; arguments } ->
      Application_mistake.mapped_range words ~at ~head arguments
  | Missing_field { field; record; ty; known } ->
      Missing_field_mistake.of_record words field ~record ty known
  | Unknown_field { field; record } -> Missing_field_mistake.of_no_type words field ~record
  | Ambiguous_field { field; record; types } ->
      Missing_field_mistake.of_several_types field ~record types
  | Field_of_argument { at; field; record; function_ } ->
      Missing_field_mistake.of_argument words ~at field ~record function_
  | Variable_like_a_type { at; variable; type_ } ->
      Signature_mistake.variable_like_a_type words ~at variable type_
  | Idle_constraint { at; variable; ty } -> Signature_mistake.idle_constraint ~at variable ~ty
  | Constraint_on_type { at; ty } -> Signature_mistake.constraint_on_type words ~at ty
  | Unknown_size { at; of_; variable } -> Signature_mistake.unknown_size ~at ~of_ ~variable
  | Polymorphic_value { name; at; signature; ty } ->
      Signature_mistake.polymorphic_value words ~name ~at ~signature ty
  | Over_a_turn e -> Degrees_warning.over_a_turn e
  | In_degrees { angle; factors; beside } ->
      Degrees_warning.in_degrees words ~angle ~factors ~beside
  | Idle_return { statement; is_choice; next } ->
      Statement_warning.idle_return statement ~is_choice ~next
  | Unreachable_statement { at; endless } -> Statement_warning.unreachable ~at endless
  | Long_array { at; length; longest } -> Literal_mistake.long_array ~at ~length ~longest
  | Empty_array at -> Literal_mistake.empty_array at
  | Int_out_of_range { at; number; same_bits } ->
      Literal_mistake.int_out_of_range ~at number ~same_bits
  | Number_out_of_range { at; number; real } -> Literal_mistake.out_of_range ~at number real

let wording = Wording.of_surroundings

let diagnostic sources (fact : Typing.Fact.t) =
  match fact with
  | Pattern fact -> Pattern_mistake.diagnostic sources fact
  | Level fact -> Level_mistake.diagnostic sources fact
  | Warning fact -> Typing_warning.diagnostic sources fact
  | Declaration { around; fact } -> Typed_declaration_mistake.diagnostic (wording around) fact
  | Inference { around; fact } -> inference (wording around) fact
  | Instance { around; fact } -> Instance_mistake.diagnostic (wording around) fact
  | Misapplied { around; call; mistake } ->
      Application_mistake.explain (wording around) call mistake
  | Called_as_method { around; call; mistake } ->
      Missing_field_mistake.called_as_method (wording around) call (Facts.diagnostic mistake)
  | Refutable_input { pattern; input; mistake } ->
      Parameter_mistake.refutable_input ~pattern input (Facts.diagnostic mistake)
  | Exchanged_signature { around; fact; mistakes } ->
      Exchanged_signature_mistake.diagnostic (wording around) fact mistakes
  | Scaled_power { at; unit_; exponent } -> Annotation_mistake.scaled_power ~at unit_ exponent
  | Scaled_unit_in_type { environment; places; measure } ->
      Annotation_mistake.scaled_unit environment places measure
  | Array_size { at; size; largest } -> Annotation_mistake.array_size ~at size ~largest
  | Wrong_kind { environment; at; wanted; found } ->
      Annotation_mistake.wrong_kind sources environment ~at wanted found
  | Too_many_updates { at; record; updates; most_fields } ->
      Mistake.too_many_updates ~at record ~updates ~most_fields
  | Entry fact -> Entry_point_mistake.diagnostic fact
  | Too_large { at; construct } -> Mistake.too_large ~at construct
  | Exponent_too_large at -> Mistake.exponent_too_large ~at

let into ?(sources = Source.create ()) sink = Facts.into sink (diagnostic sources)
