let complete words ~subject ~(expected : Expected.t) (wanted, given) =
  let is_operand = match expected.because with Operand _ -> true | _ -> false in
  match Option.map (Bare_number.factor words) subject with
  | Some (_ :: _ as constants) when not (is_operand || Units.is_open wanted || Units.is_open given)
    ->
      let give d ((number : Bare_number.t), power) =
        let unit_ = Units.power (Units.divide wanted given) (Rational.of_int power) in
        Bare_number.give words number (Show.measure words unit_) d
      in
      Some (fun d -> List.fold_left give d constants)
  | Some _ | None -> None
