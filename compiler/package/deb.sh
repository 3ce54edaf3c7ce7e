#!/bin/sh
# deb.sh IMAGE FOLDER: builds the Debian packages frobc_VERSION_ARCHITECTURE.deb and
# frobc-doc_VERSION_all.deb in FOLDER from the documentation and the files that `dune build @install`
# has put into IMAGE, and prints the packages' paths. Equal images result in equal packages, byte for
# byte. DEBFULLNAME and DEBEMAIL name the maintainer. Requires
# dpkg-dev and binutils.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
image=$(cd "$1" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)
umask 022
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/root
version=$("$image/bin/frobc" --version)
architecture=$(dpkg --print-architecture)
maintainer="${DEBFULLNAME:-The Frob developers} <${DEBEMAIL:-frob@packages.invalid}>"
named() { sed "s|@MAINTAINER@|$maintainer|; s|@VERSION@|$version|" "$here/$1"; }

# Copy all files except the metadata of OCaml's package managers.
mkdir -p "$root/usr/bin" "$root/usr/lib" "$root/usr/share/man" "$root/DEBIAN"
cp -RL "$image/bin/frobc" "$root/usr/bin/"
cp -RL "$image/lib/frobc" "$root/usr/lib/"
cp -RL "$image/share/frobc" "$root/usr/share/"
cp -RL "$image/man/man1" "$root/usr/share/man/"
rm -f "$root/usr/lib/frobc/META" "$root/usr/lib/frobc/dune-package" "$root/usr/lib/frobc/opam"
doc=$work/doc
mkdir -p "$doc/usr/share/doc" "$doc/DEBIAN"
sh "$here/documents.sh" "$doc/usr/share/doc/frobc"
for package in frobc:"$root" frobc-doc:"$doc"; do
    documents=${package#*:}/usr/share/doc/${package%%:*}
    mkdir -p "$documents"
    cp "$here/copyright" "$documents/copyright"
    named changelog | gzip -9n > "$documents/changelog.gz"
done
gzip -9n "$root/usr/share/man/man1/"*
mkdir -p "$root/usr/share/lintian/overrides"
cp "$here/overrides" "$root/usr/share/lintian/overrides/frobc"

# Set the permissions that Debian's policy requires, and remove debugging symbols.
chmod -R u=rwX,go=rX "$root" "$doc"
find "$root/usr" "$doc/usr" -type f -exec chmod 644 {} +
programs="$root/usr/bin/frobc $(find "$root/usr/lib/frobc" -name 'frob-*')"
chmod 755 $programs
strip --strip-unneeded --remove-section=.comment --remove-section=.note $programs
strip --strip-debug --remove-section=.comment --enable-deterministic-archives "$root/usr/lib/frobc/"*.a

# Determine the dependencies from the libraries that the programs are linked with.
mkdir "$work/debian"
named control > "$work/debian/control"
libraries=$(cd "$work" && dpkg-shlibdeps -O $programs 2> shlibdeps.log) || {
    cat "$work/shlibdeps.log" >&2
    exit 1
}
libraries=${libraries#shlibs:Depends=}
# Writes the control file and the checksums of a package. The paragraph of a package in debian/control
# ends at the next empty line.
describe() { # NAME, ROOT, ARCHITECTURE
    size=$(du -k -s --apparent-size "$2/usr" | cut -f 1)
    {
        named control | sed -n "1,/^\$/ { /^Priority\|^Maintainer/p; }"
        named control | sed -n "/^Package: $1\$/,/^\$/ { /^\$/d
            s|\${shlibs:Depends}|$libraries|
            s|^Architecture: .*|Version: $version\nArchitecture: $3\nInstalled-Size: $size|
            p; }"
    } > "$2/DEBIAN/control"
    (cd "$2" && find usr -type f -print0 | sort -z | xargs -0 md5sum) > "$2/DEBIAN/md5sums"
}
describe frobc "$root" "$architecture"
describe frobc-doc "$doc" all

SOURCE_DATE_EPOCH=$(date -d "$(named changelog | sed -n 's/^ -- .*>  //p')" +%s)
export SOURCE_DATE_EPOCH
for package in "frobc_${version}_$architecture $root" "frobc-doc_${version}_all $doc"; do
    dpkg-deb --root-owner-group --build "${package#* }" "$out/${package%% *}.deb" > /dev/null
    echo "$out/${package%% *}.deb"
done
