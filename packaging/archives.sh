# How archives and Debian packages are written; sourced by packaging/build and packaging/gl-packages, at the root of a clone.
# The same files make the same archives: times are those of the commit, owners and order are fixed.

version="$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)"
SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}"
export SOURCE_DATE_EPOCH

# tarball FOLDER FILE: packs what is in a folder.
tarball() {
    (cd "$1" && tar --sort=name --owner=0 --group=0 --numeric-owner --mode=u+w,go-w --mtime="@$SOURCE_DATE_EPOCH" \
        -cf - -- * | gzip -9n) >"$2"
}

# glibc_of FILE...: the greatest version of glibc that binaries need.
glibc_of() {
    readelf -W --dyn-syms "$@" | grep -o '@GLIBC_[0-9.]*' | sed 's/@GLIBC_//' | sort -uV | tail -n 1
}

# debian NAME ROOT FILE CHANGES HOLDER CONTROL: makes a package of the files below ROOT, with changelog and copyright.
# CHANGES says where changes are listed, HOLDER what NOTICES.md.gz is about; CONTROL has what differs: Section, Depends,
# Description and others.
debian() {
    local name="$1" root="$2" file="$3" changes="$4" holder="$5" control="$6"
    local documents="$root/usr/share/doc/$name" maintainer="The luxel developers <luxel@users.noreply.github.com>"
    mkdir -p "$documents" "$root/DEBIAN"
    printf '%s (%s) unstable; urgency=medium\n\n  * %s lists the changes.\n\n -- %s  %s\n' "$name" "$version" "$changes" \
        "$maintainer" "$(LC_ALL=C date -uRd "@$SOURCE_DATE_EPOCH")" | gzip -9n >"$documents/changelog.gz"
    {
        cat <<END
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: luxel
Source: https://github.com/luxel-project/luxel
Comment: /usr/share/doc/$name/NOTICES.md.gz lists the libraries in $holder and their licences.

Files: *
Copyright: 2026 The luxel developers
License: Expat or Apache-2.0

License: Apache-2.0
 /usr/share/common-licenses/Apache-2.0 has the text of this licence on Debian systems.

License: Expat
END
        sed -n '/^Permission/,$p' LICENSE-MIT | sed 's/^$/./; s/^/ /'
    } >"$documents/copyright"
    find "$root" -type d -exec chmod 755 {} +
    cat >"$root/DEBIAN/control" <<END
Package: $name
Version: $version
Architecture: amd64
Priority: optional
Maintainer: $maintainer
Homepage: https://github.com/luxel-project/luxel
Installed-Size: $(du -sk --apparent-size --exclude=DEBIAN "$root" | cut -f 1)
$control
END
    (cd "$root" && find usr -type f -exec md5sum {} + | LC_ALL=C sort -k 2 >DEBIAN/md5sums)
    chmod 644 "$documents"/* "$root"/DEBIAN/*
    find "$root" -exec touch -hd "@$SOURCE_DATE_EPOCH" {} +
    dpkg-deb --root-owner-group -Zxz --build "$root" "$file" >/dev/null
}
