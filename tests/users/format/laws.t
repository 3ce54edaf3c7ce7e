Each program of the project, and each in its documentation, stays the same program when it
is formatted, with the same comments, and once formatted it stays as it is.

  $ top=../../..
  $ for page in $top/README.md $top/docs/*.md $top/docs/*/*.md $top/examples/*/README.md; do
  >   awk -f $top/tests/documents/docs/blocks.awk $page > /dev/null
  > done
  $ ls *.frob | wc -l | grep -qE '^[0-9]{2,}$' || echo "the documentation has no programs"
  $ for page in $top/docs/*/*.md; do
  >   awk -v name=$(basename $page .md) '
  >     /^```frob title=/ { file = sprintf("course_%s_%d.frob", name, FNR); next }
  >     /^```$/ { file = "" }
  >     file != "" { print > file }' $page
  > done
  $ ls course_*.frob | wc -l | grep -qE '^[0-9]{2,}$' || echo "the course has no programs"
  $ ./of_files.exe *.frob $(find $top/stdlib $top/examples $top/compiler $top/tests -name '*.frob')
