# packages.sh: lists every Debian package that Nephoscope needs, and installs them.
# Sourced by run and test. docs/dependencies.md says what each package is for.

build_packages=(
  g++ cmake ninja-build pkg-config
  libglfw3-dev libimgui-dev libepoxy-dev libegl-dev libglm-dev
  libnetcdf-dev libdeflate-dev libeccodes-dev libproj-dev libudunits2-dev libopenexr-dev libpng-dev libcairo2-dev
  nlohmann-json3-dev libcli11-dev libfmt-dev
)
runtime_packages=(libgl1 libegl1 libgl1-mesa-dri fonts-roboto-unhinted fonts-dejavu-core)
test_packages=(doctest-dev clang-format xvfb xauth)
sanitizer_packages=(clang libclang-rt-dev llvm)  # llvm: function names and lines in reports

# Installs the packages given as arguments that are missing; silent and fast if none is.
install_packages() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] && return
  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null || {
      echo "error: these packages are missing, and installing them needs root: ${missing[*]}" >&2
      return 1
    }
    as_root=(sudo)
  fi
  echo "Installing with apt-get: ${missing[*]}" >&2
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}
