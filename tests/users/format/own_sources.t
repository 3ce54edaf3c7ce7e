The project's own programs are formatted, except those that test how programs are written: mistakes
that people make, the paper's listings as printed, and tests of layout and the parser.

  $ top=../../..
  $ find $top/stdlib $top/examples $top/compiler $top/tests -name '*.frob' \
  >   | grep -v -e users/messages/mistakes -e meaning/paper -e stages/syntax -e frontend/found > own
  $ wc -l < own | grep -qE '^[0-9]{3,}$' || echo "there are hardly any programs"
  $ ./of_files.exe --formatted $(cat own)
