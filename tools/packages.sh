# Installs Debian packages that are missing; used by run.sh and test.sh. With everything installed it asks nothing of the
# network and takes no time.

BUILD_PACKAGES="g++ cmake ninja-build python3 libfmt-dev libcli11-dev nlohmann-json3-dev libtomlplusplus-dev libsqlite3-dev libzip-dev libedit-dev
  libasmjit-dev libboost1.81-dev libssl-dev libgtest-dev librapidcheck-dev"
# The page of the workbench; only where there is no Node.js from somewhere else.
command -v node >/dev/null && command -v npm >/dev/null || BUILD_PACKAGES="$BUILD_PACKAGES nodejs npm libnode-dev"
CHECK_PACKAGES="clang-format openssl tshark libbenchmark-dev"
FUZZ_PACKAGES="clang libclang-rt-14-dev"
# The browser that the page is tested in: Chromium without its own windows takes a fifth less of the processor.
CHECK_PACKAGES="$CHECK_PACKAGES chromium-headless-shell fonts-dejavu-core"

installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

need_packages() {
  local package missing=()
  for package in "$@"; do
    installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "installing: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "missing packages, and neither root nor sudo: ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -q &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}
