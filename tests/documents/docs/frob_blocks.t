The compiler accepts every block of Frob code in the documentation. blocks.awk
describes how a block states its kind.

  $ top=../../..
  $ for page in $top/README.md $top/docs/*.md $top/docs/*/*.md $top/examples/*/README.md; do
  >   awk -f blocks.awk $page > blocks
  >   while read kind file; do
  >     case $kind in
  >       module) frobc check --lint $file ;;
  >       later) frobc check $file 2>&1 | grep -q E0112 ;;
  >     esac || echo "$file is not as it should be"
  >     echo "$kind" >> kinds
  >   done < blocks
  > done

There are such blocks, and none with an unknown word on its fence:

  $ test $(grep -c module kinds) -ge 5
  $ grep -n '^ *```frob' $top/README.md $top/docs/*.md $top/docs/*/*.md $top/examples/*/README.md |
  >   grep -v -e '```frob$' -e '```frob later$' -e '```frob title="[^"]*"$'
  [1]
