# Sourced by ./run and ./test: the Debian/Ubuntu packages Windloom is built and tested with, and their
# installation.

build_packages="g++ cmake ninja-build ccache pkg-config git
  libglm-dev nlohmann-json3-dev libcli11-dev libpng-dev libssl-dev libdeflate-dev libzstd-dev libstb-dev libtinygltf-dev libhwy-dev libepoxy-dev
  libglfw3-dev libimgui-dev fonts-inter fonts-fork-awesome
  libopenvdb-dev libboost-dev
  libegl1 libgl1 libgl1-mesa-dri"

test_packages="libgtest-dev libbenchmark-dev xvfb xdotool x11-utils imagemagick clang libclang-rt-dev
  openexr zstd valgrind libc6-dbg python3 python3-numpy python3-jsonschema python3-openvdb python3-xlib glslang-tools spirv-cross
  man-db groff-base zsh desktop-file-utils shared-mime-info appstream libglib2.0-bin xdg-utils dpkg-dev file debootstrap"

# ensure_packages NAME...: installs what is missing, as root or through sudo; quiet and quick when
# nothing is.
ensure_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    if [ "${WINDLOOM_SKIP_PACKAGES:-0}" = 1 ]; then return 0; fi
    {
      echo "This script installs packages with apt, which this system doesn't have. Please install what stands for"
      echo "these Debian packages with your own package manager, then run it again with WINDLOOM_SKIP_PACKAGES=1:"
      echo "  $(echo "$@" | tr -s ' \n' ' ')"
    } >&2
    exit 3
  fi
  local missing="" package
  for package in "$@"; do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
      missing="$missing $package"
    fi
  done
  if [ -z "$missing" ]; then return 0; fi

  local as_root=""
  if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing and there is no sudo here to install them; as root: apt-get install$missing" >&2
      exit 3
    fi
    as_root="sudo"
  fi
  echo "Installing:$missing"
  # The package lists may be absent or stale on a fresh machine; another apt may be running.
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq -o DPkg::Lock::Timeout=300 || true
  # shellcheck disable=SC2086
  if ! $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
      -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 $missing >"${TMPDIR:-/tmp}/windloom-apt.log" 2>&1; then
    tail -n 20 "${TMPDIR:-/tmp}/windloom-apt.log" >&2
    echo "The packages above could not be installed." >&2
    exit 3
  fi
}
