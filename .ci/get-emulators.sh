#!/usr/bin/env bash
# get-emulators.sh [arm|riscv32|gba] finds an emulator and prints its path. It is qemu-system-arm,
# qemu-system-riscv32, or mGBA as a libretro core. If the system has a usable one, fetches nothing.
# Otherwise unpacks one under target/emulators, without installing a package.
# Exit 0: the path is on standard output. Exit 3: no emulator is available; standard error has the
# reason.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
arch=${1:-arm}
# Some systems package QEMU once for all rarer machines. That package has RISC-V.
case $arch in
arm) boards=(microbit mps2-an385 mps2-an386 lm3s6965evb) packages=(qemu-system-arm) ;;
riscv32) boards=(virt) packages=(qemu-system-riscv qemu-system-misc) ;;
gba) boards=() packages=(libretro-mgba) ;;
*)
    echo "get-emulators.sh: there is no emulator for $arch" >&2
    exit 2
    ;;
esac
program=qemu-system-$arch
dir=$root/target/emulators/$arch
wrapper=$dir/bin/$program

missing() {
    printf 'no emulator: %s\n' "$*" >&2
    if [[ $arch == gba ]]; then
        printf 'install mGBA as a libretro core (package libretro-mgba), and run this again\n' >&2
    else
        printf 'install QEMU 7.2 or later so that %s is on PATH, and run this again\n' "$program" >&2
    fi
    exit 3
}

# The core, with the libraries unpacked beside it. A core of the system finds the system's.
core_of() {
    local core
    for core in "$1"/usr/lib/*-linux-gnu*/libretro/mgba_libretro.so "$1"/usr/lib/libretro/mgba_libretro.so; do
        [[ -f $core ]] && echo "$core" && return
    done
    return 1
}
core_usable() {
    local libs
    libs=$(ldd "$1" 2>/dev/null) || return 1
    awk -v at="$(dirname "$1")/.." '/not found/ && system("test -e " at "/" $1) { exit 1 }' <<<"$libs"
}

# An emulator counts only if it starts and has all boards.
usable() {
    local has board
    has=$("$1" -machine help 2>/dev/null) || return 1
    for board in "${boards[@]}"; do
        grep -q "^$board " <<<"$has" || return 1
    done
}

if [[ $arch == gba ]]; then
    for place in '' "$dir"; do
        if found=$(core_of "$place") && core_usable "$found"; then
            echo "$found"
            exit 0
        fi
    done
else
    if found=$(command -v "$program") && usable "$found"; then
        echo "$found"
        exit 0
    fi
    if [[ -x $wrapper ]] && usable "$wrapper"; then
        echo "$wrapper"
        exit 0
    fi
fi

for tool in apt-get dpkg; do
    command -v "$tool" >/dev/null || missing "$program is missing, and so is $tool to fetch it with"
done
rm -rf "$dir"
mkdir -p "$dir/debs"

# Lists the packages that apt would add for QEMU on this system: apt knows which libraries are here.
# The trailing minus keeps qemu-utils out, which collides with a newer one on some images. The
# boards do not use the boot ROMs and firmware in qemu-system-data.
wanted() {
    local package=$1
    # The core's package depends on a whole front end. Some systems lack one of its libraries.
    if [[ $arch == gba ]]; then
        echo "$package libinih1"
        return
    fi
    apt-get "${@:2}" install --simulate --no-install-recommends -y "$package" qemu-utils- 2>>"$dir/log" |
        awk '$1 == "Inst" && $2 != "qemu-system-data" { print $2 }'
}
download() {
    local list package
    for package in "${packages[@]}"; do
        list=$(wanted "$package" "$@") || continue
        [[ $list == *"$package"* ]] || continue
        # shellcheck disable=SC2086 # one word per package
        (cd "$dir/debs" && apt-get "$@" download $list) >>"$dir/log" 2>&1 && return
    done
    return 1
}

# Fetches missing or stale package lists into a private folder. That needs no rights and changes
# nothing else.
private=(-o "Dir::State::Lists=$dir/lists" -o "Dir::Cache=$dir/cache" -o Debug::NoLocking=1)
if ! download; then
    mkdir -p "$dir/lists/partial" "$dir/cache/archives/partial"
    apt-get "${private[@]}" update >>"$dir/log" 2>&1 || missing "cannot fetch the package lists (see target/emulators/$arch/log)"
    download "${private[@]}" || missing "cannot fetch the packages of $program (see target/emulators/$arch/log)"
fi
for deb in "$dir"/debs/*.deb; do
    dpkg -x "$deb" "$dir"
done
rm -rf "$dir/debs" "$dir/lists" "$dir/cache"

if [[ $arch == gba ]]; then
    found=$(core_of "$dir") && core_usable "$found" || missing 'the unpacked core lacks a library'
    echo "$found"
    exit 0
fi

mkdir -p "$dir/bin"
cat >"$wrapper" <<'T'
#!/usr/bin/env bash
# Starts the unpacked emulator of this name with the libraries unpacked beside it.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
libs=$(printf '%s:' "$root"/usr/lib/*-linux-gnu* "$root"/lib/*-linux-gnu*)
LD_LIBRARY_PATH=${libs%:} exec "$root/usr/bin/$(basename "$0")" -L "$root/usr/share/qemu" "$@"
T
chmod +x "$wrapper"
if ! usable "$wrapper"; then
    "$wrapper" --version >&2 || true
    missing "the unpacked $program does not start"
fi
echo "$wrapper"
