#!/usr/bin/env bash
# Puts qemu-system-arm under target/emulators without installing a package, and prints its path.
# A qemu-system-arm on PATH that knows the two boards is preferred and nothing is fetched.
# Exit 0: the path is on standard output. Exit 3: no emulator can be had here; the reason is on standard error.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
dir=$root/target/emulators
wrapper=$dir/bin/qemu-system-arm

missing() {
    printf 'no emulator: %s\n' "$*" >&2
    printf 'install QEMU 7.2 or later so that qemu-system-arm is on PATH, and run this again\n' >&2
    exit 3
}

# An emulator counts only when it starts and has both boards.
usable() {
    local boards
    boards=$("$1" -machine help 2>/dev/null) || return 1
    grep -q '^microbit ' <<<"$boards" && grep -q '^mps2-an385 ' <<<"$boards"
}

if found=$(command -v qemu-system-arm) && usable "$found"; then
    echo "$found"
    exit 0
fi
if [[ -x $wrapper ]] && usable "$wrapper"; then
    echo "$wrapper"
    exit 0
fi

for tool in apt-get dpkg; do
    command -v "$tool" >/dev/null || missing "there is no qemu-system-arm and no $tool to fetch it with"
done
rm -rf "$dir"
mkdir -p "$dir/debs"

# The packages apt would add for QEMU on this very system: it knows which libraries are here already.
# The trailing minus keeps qemu-utils out, which collides with a newer one on some images.
# qemu-system-data holds boot ROMs and firmware that the two boards do not use.
wanted() {
    apt-get "$@" install --simulate --no-install-recommends -y qemu-system-arm qemu-utils- 2>>"$dir/log" |
        awk '$1 == "Inst" && $2 != "qemu-system-data" { print $2 }'
}
download() {
    local list
    list=$(wanted "$@") || return 1
    [[ $list == *qemu-system-arm* ]] || return 1
    # shellcheck disable=SC2086 # one word a package
    (cd "$dir/debs" && apt-get "$@" download $list) >>"$dir/log" 2>&1
}

# Package lists that are missing or stale are renewed in a private folder: that needs no rights and changes nothing here.
private=(-o "Dir::State::Lists=$dir/lists" -o "Dir::Cache=$dir/cache" -o Debug::NoLocking=1)
if ! download; then
    mkdir -p "$dir/lists/partial" "$dir/cache/archives/partial"
    apt-get "${private[@]}" update >>"$dir/log" 2>&1 || missing "the package lists cannot be fetched (see target/emulators/log)"
    download "${private[@]}" || missing "the packages of qemu-system-arm cannot be fetched (see target/emulators/log)"
fi
for deb in "$dir"/debs/*.deb; do
    dpkg -x "$deb" "$dir"
done
rm -rf "$dir/debs" "$dir/lists" "$dir/cache"

mkdir -p "$dir/bin"
cat >"$wrapper" <<'T'
#!/usr/bin/env bash
# Starts the unpacked emulator with the libraries unpacked beside it.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
libs=$(printf '%s:' "$root"/usr/lib/*-linux-gnu* "$root"/lib/*-linux-gnu*)
LD_LIBRARY_PATH=${libs%:} exec "$root/usr/bin/qemu-system-arm" -L "$root/usr/share/qemu" "$@"
T
chmod +x "$wrapper"
if ! usable "$wrapper"; then
    "$wrapper" --version >&2 || true
    missing "the unpacked qemu-system-arm does not start"
fi
echo "$wrapper"
