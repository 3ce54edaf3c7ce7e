The pages of the site are put together, and each of their links leads to a page, a file or a
folder of the repository:

  $ top=../../..
  $ python3 -B $top/docs/site/build.py $top $(command -v frobc) pages
  $ ls pages/docs/tutorial/first-drive.md pages/docs/reference pages/stdlib/Capability.frob.md
  pages/docs/tutorial/first-drive.md
  pages/stdlib/Capability.frob.md
  
  pages/docs/reference:
  commands.md
  library.md
  messages.md

Each page of docs/ is in the site's menu:

  $ (cd $top && find docs -name '*.md') | sort > pages.there
  $ grep -o 'docs/[a-z/-]*\.md' $top/docs/site/mkdocs.yml | grep -v '^docs/reference/' | sort > pages.listed
  $ diff pages.there pages.listed

A link that leads nowhere is told:

  $ mkdir -p broken/docs && echo '[x](nowhere.md)' > broken/README.md
  $ python3 -B $top/docs/site/build.py broken $(command -v frobc) pages
  README.md: there is no nowhere.md
  [1]
