# Reads a run's summary and checks bounds, `within NAME LOW HIGH`...: prints the values out of
# bounds and returns status 1; otherwise prints nothing. A value that is not a number must equal
# LOW.
within () {
  awk -F ': ' -v bounds="$*" '
    { value[$1] = $2 + 0; text[$1] = $2; seen[$1] = 1 }
    END {
      n = split(bounds, b, " ")
      for (i = 1; i + 2 <= n; i += 3) {
        name = b[i]; gsub(/_/, " ", name)
        if (!(name in seen)) { print "no line `" name "`"; bad = 1 }
        else if (b[i + 1] !~ /^[-+.0-9]/) {
          if (text[name] != b[i + 1]) { print name ": " text[name] " is not " b[i + 1]; bad = 1 }
        }
        else if (value[name] < b[i + 1] + 0 || value[name] > b[i + 2] + 0) {
          print name ": " value[name] " is not from " b[i + 1] " to " b[i + 2]; bad = 1
        }
      }
      exit bad
    }'
}
