#!/usr/bin/env bash
# Builds Lua and Bullet once from the distribution's source packages and prints where they lie.
#
#   build.sh            builds what is missing, prints the prefix on standard output
#   build.sh --prefix   prints the prefix only; the folder exists once it is complete
#
# Our own builds, because no packaged one can go into a shared library that hides its Lua and Bullet
# from a host with its own. All clones of one user share them; a changed script or compiler makes new ones.
# TUMBLE_CACHE names another folder than ~/.cache/tumble.
set -euo pipefail
export LC_ALL=C

compiler=g++
say() { printf 'tumble: %s\n' "$*" >&2; }
fail() { say "$@"; exit 1; }

command -v $compiler >/dev/null || fail "dependencies: no C++ compiler '$compiler' found; ./tumble installs it, or run: apt-get install g++"
home=~
cache=${TUMBLE_CACHE:-${XDG_CACHE_HOME:-$home/.cache}/tumble}
key=$({ $compiler -dumpfullversion -dumpmachine; cat "${BASH_SOURCE[0]}"; } | sha256sum)
prefix=$cache/${key::16}

if [[ ${1-} == --prefix || -d $prefix ]]; then
  echo "$prefix"
  exit
fi

mkdir -p "$cache" 2>/dev/null && [[ -w $cache ]] ||
  fail "dependencies: cannot write to '$cache'; set TUMBLE_CACHE to a folder that you own"
exec 8>"$cache/lock"
flock 8
if [[ -d $prefix ]]; then  # somebody else built it while we waited
  echo "$prefix"
  exit
fi
rm -rf "$cache"/work.*  # left by a build that was killed; the lock says that none runs
work=$(mktemp -d "$cache/work.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"

# ---- sources: apt's own mirror, asked through a private list, so that neither deb-src lines nor rights are needed

# Every server that apt has configured for this release, whichever file format names it.
mirrors() {
  local release
  release=$(. /etc/os-release && echo "${VERSION_CODENAME:-sid}")
  apt-get update --print-uris 2>/dev/null |
    sed -nE "s#^'([^']+)/dists/($release|oldstable|stable|testing|unstable|sid)/(main|InRelease).*#\1 \2#p" | awk '!seen[$0]++'
}

download() {
  local mirror=$1 release=$2 keyring=/usr/share/keyrings/debian-archive-keyring.gpg options=
  [[ $mirror == */ubuntu* || ! -f $keyring ]] || options="[signed-by=$keyring] "
  rm -rf apt && mkdir -p apt/lists/partial apt/cache/archives/partial
  echo "deb-src $options$mirror $release main$([[ $mirror != */ubuntu* ]] || echo ' universe')" >apt/sources.list
  # The clear line drops hooks that would write to the system's folders.
  cat >apt/apt.conf <<CONF
#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
APT::Sandbox::User "root";
Acquire::Retries "3";
Dir::Etc::SourceList "$work/apt/sources.list";
Dir::Etc::SourceParts "/dev/null";
Dir::State::Lists "$work/apt/lists";
Dir::Cache "$work/apt/cache";
CONF
  apt-get -qq -c apt/apt.conf update && apt-get -qq -c apt/apt.conf source --download-only lua5.4 bullet
}

fetch() {
  command -v apt-get >/dev/null && command -v dpkg-source >/dev/null || return 1
  local mirror release
  mirrors >mirrors.list
  while read -r mirror release; do
    download "$mirror" "$release" </dev/null >>log 2>&1 && return
  done <mirrors.list
  tail -n 5 log >&2
  return 1
}

say "fetching the sources of Lua and Bullet (2 MB, once)"
fetch || fail "dependencies: the source packages lua5.4 and bullet could not be fetched with apt-get; check the network and run this again"
dpkg-source -x --no-check lua5.4_*.dsc lua >>log 2>&1
dpkg-source -x --no-check bullet_*.dsc bullet >>log 2>&1

# ---- what the sources need for us

# Lua is compiled as C++, with names mangled as C++: a host's own Lua in C cannot clash even in a static build.
# The packaged sources would declare extern "C", and search modules in folders of the machine.
luaconf=lua/src/luaconf.h
sed -i -e '/lua5.4-deb-multiarch.h/d' -e 's/^\(#define LUA_API[[:space:]]*\)extern "C"$/\1extern/' $luaconf
! grep -qE '^#define LUA_API.*"C"|multiarch\.h' $luaconf || fail "dependencies: this lua5.4 source package has another luaconf.h than build.sh knows"

# The methods of our objects lie in a table at __index, and a function behind that table answers for properties
# (docs/decisions/0010-methods-in-a-table.md). Lua would give that function the table; it is to get the object.
luavm=lua/src/lvm.c
sed -i -e '/^void luaV_finishget /,/^}/ {
  s|^  const TValue \*tm;.*|&\n  const TValue *object = NULL;  /* the last full userdata on the way */|
  s|^      tm = luaT_gettmbyobj(L, t, TM_INDEX);|&\n      if (ttisfulluserdata(t)) object = t;|
  s|luaT_callTMres(L, tm, t, key, val);|luaT_callTMres(L, tm, object ? object : t, key, val);|
}' $luavm
[[ $(grep -cE 'TValue \*object = NULL;|ttisfulluserdata\(t\)\) object = t;|tm, object \? object : t, key, val' $luavm) == 3 ]] ||
  fail "dependencies: this lua5.4 source package has another lvm.c than build.sh knows"

# ---- compile: one unit per Bullet library (its own "All" files), three times as fast as one per source file

common=(-O3 -DNDEBUG -fPIC -fvisibility=hidden -ffp-contract=off -ffunction-sections -fdata-sections -w)
bullet=(-DBT_USE_DOUBLE_PRECISION -Ibullet/src)
# A fixed seed, since the order of pairs() must not differ between two runs of a replay.
lua=(-x c++ -std=c++17 -DLUA_USE_POSIX '-DLUA_PATH_DEFAULT="./?.lua"' '-DLUA_CPATH_DEFAULT=""' '-Dluai_makeseed(L)=0x7475u')

mkdir -p objects stage/lib stage/include
jobs=()
for library in BulletCollision BulletDynamics LinearMath; do
  jobs+=("$compiler ${common[*]@Q} ${bullet[*]@Q} -c bullet/src/bt${library}All.cpp -o objects/$library.o")
done
for source in lua/src/*.c; do
  name=$(basename "$source" .c)
  [[ $name == lua || $name == luac ]] || jobs+=("$compiler ${common[*]@Q} ${lua[*]@Q} -c $source -o objects/lua_$name.o")
done
say "compiling Lua and Bullet (once, about half a minute)"
printf '%s\0' "${jobs[@]}" | xargs -0 -n 1 -P "$(nproc)" bash -c || fail "dependencies: compiling Lua and Bullet failed (see above)"

# ---- install: complete in one rename

for library in BulletCollision BulletDynamics LinearMath; do
  ar rcs stage/lib/lib$library.a objects/$library.o
done
ar rcs stage/lib/liblua.a objects/lua_*.o
mkdir -p stage/include/lua stage/include/bullet
cp lua/src/{lua,lauxlib,lualib,luaconf}.h stage/include/lua/
printf '%s\n' '// Lua is compiled as C++ here: no extern "C".' '#include "lua.h"' '#include "lualib.h"' '#include "lauxlib.h"' >stage/include/lua/lua.hpp
(cd bullet/src && find btBullet*Common.h BulletCollision BulletDynamics LinearMath -name '*.h' -exec cp --parents {} "$work/stage/include/bullet/" \;)
cp lua/debian/copyright stage/include/lua/copyright
cp bullet/LICENSE.txt stage/include/bullet/copyright
mv -T stage "$prefix"
say "Lua and Bullet are ready in $prefix"
echo "$prefix"
