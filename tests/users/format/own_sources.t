The project's own programs are formatted. Not so those that are about how programs are
written: the mistakes that people make, the paper's listings as it prints them, and those
that test layout and the parser.

  $ top=../../..
  $ find $top/stdlib $top/examples $top/compiler $top/tests -name '*.frob' \
  >   | grep -v -e users/messages/mistakes -e meaning/paper -e stages/syntax -e frontend/found > own
  $ wc -l < own | grep -qE '^[0-9]{3,}$' || echo "there are hardly any programs"
  $ ./of_files.exe --formatted $(cat own)
