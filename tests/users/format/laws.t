Formatting keeps the meaning and the comments of each program of the project, including those in its
documentation, and formatting twice is the same as formatting once.

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
