The site's pages are generated, and each of their links leads to a page, a file or a folder of the
repository:

  $ top=../../..
  $ python3 -B $top/docs/site/build.py $top $(command -v frobc) pages
  $ ls pages/docs/tutorial/first-drive.md pages/docs/reference pages/stdlib/Capability.frob.md
  pages/docs/tutorial/first-drive.md
  pages/stdlib/Capability.frob.md
  
  pages/docs/reference:
  commands.md
  library.md
  messages.md

The site's menu lists each page of docs/ except the decisions, which have an index of their own:

  $ (cd $top && find docs -name '*.md') | grep -v '^docs/decisions/[0-9]' | sort > pages.there
  $ grep -o 'docs/[A-Za-z/-]*\.md' $top/docs/site/mkdocs.yml | grep -v '^docs/reference/' | sort > pages.listed
  $ diff pages.there pages.listed

The index of the decisions lists each page once, with its number and title, in order:

  $ cd $top/docs/decisions
  $ for page in [0-9]*.md; do
  >   title=$(sed -n '1s/^# //p' $page)
  >   echo "- [$title]($page)"
  >   case $page in "$(printf '%04d' "${title%%.*}")"-*) ;; *) echo "$page has the title $title" ;; esac
  >   grep '^## ' $page | tr -d '\n' | grep -vx '## Context## Decision## Consequences' | sed "s/^/$page: /"
  > done > listed
  $ grep '^- ' README.md | diff - listed
  $ cd $OLDPWD

The map of the sources, the decisions and CONTRIBUTING.md only name existing source files:

  $ (cd $top && find -L compiler docs runtime sim stdlib -type f | sed 's|^|/|') > files
  $ grep -oh '`[A-Za-z0-9_./-]*[a-z0-9]\.\(cc\|c\|frob\|h\|messages\|mli\|ml\|py\|txt\|S\)`' $top/docs/architecture.md $top/docs/decisions/*.md $top/CONTRIBUTING.md | tr -d '`' | grep -v '^NAME\.' | sort -u > named
  $ wc -l < named | grep -cE '^[0-9]{2,}$'
  1
  $ while read -r name; do grep -q "/$name\$" files || echo "there is no $name"; done < named

A broken link is reported:

  $ mkdir -p broken/docs && echo '[x](nowhere.md)' > broken/README.md
  $ python3 -B $top/docs/site/build.py broken $(command -v frobc) pages
  README.md: the file nowhere.md does not exist
  [1]
