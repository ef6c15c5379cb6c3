#!/usr/bin/env bash
# Installs a build into an empty prefix, compiles host.cpp against it as a stranger would, and runs it:
#
#   tests/embed/run.sh build/release
#
# Also: the library shows our names only, and needs no Lua or Bullet of the system. A line `ok` or `FAILED` for each.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
build=${1:?usage: run.sh BUILD_FOLDER}
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
fail() { printf 'FAILED embed: %s\n' "$*"; exit 1; }

for package in lua5.4 bullet; do
  pkg-config --exists "$package" || fail "the host's own '$package' is missing; install liblua5.4-dev and libbullet-dev"
done
cmake --install "$build" --prefix "$prefix" >"$prefix/install.log" 2>&1 || { cat "$prefix/install.log" >&2; fail "installing failed"; }
library=$(find "$prefix" -name 'libtumble.so*' | head -n 1)
[[ $library ]] || fail "no libtumble.so was installed"

# What a host could clash with: any dynamic symbol that is defined here and is not in our namespace.
foreign=$(nm -D --defined-only --demangle "$library" | grep -vE '^[0-9a-f]+ [A-Za-z] (vtable for |typeinfo for |typeinfo name for )?tumble::' || true)
[[ -z $foreign ]] || fail "libtumble.so shows names that are not ours:"$'\n'"$foreign"
needed=$(objdump -p "$library" | grep -E 'NEEDED.*(lua|Bullet|LinearMath)' || true)
[[ -z $needed ]] || fail "libtumble.so needs a Lua or Bullet of the system:"$'\n'"$needed"
echo "ok embed: libtumble.so shows our names only, and needs no other Lua or Bullet"

g++ -std=c++17 -Wall -Wextra -I"$prefix/include" $(pkg-config --cflags lua5.4 bullet | sed 's/-I/-isystem /g') "$here/host.cpp" \
  -o "$prefix/host" -L"${library%/*}" -ltumble -Wl,-rpath,"${library%/*}" $(pkg-config --libs lua5.4 bullet)
"$prefix/host" "$here/game"
