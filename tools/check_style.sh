#!/usr/bin/env bash
# Checks how the sources are written: layout by clang-format, no tabs, no space at the end of a line,
# no path that exists on one machine only. With --fix, clang-format mends the layout first.

set -uo pipefail
cd "$(dirname "$0")/.."

status=0
complain() {
  echo "$1"
  status=1
}

mapfile -t files < <(
  git ls-files --cached --others --exclude-standard 2> /dev/null |
    grep -E '\.(cpp|h|py|sh|cmake|md|rst|yml|yaml|sphsolid)$|CMakeLists\.txt$|^sphsolid$|^\.ci/|/in\.[^/]*$|/run$' |
    grep -v '/reference/')
if [[ ${#files[@]} == 0 ]]; then
  echo "not a git checkout: nothing to check"
  exit 0
fi

found=$(grep -nP '\t' -- "${files[@]}" /dev/null) && complain "Tabs:"$'\n'"$found"
found=$(grep -nE ' +$' -- "${files[@]}" /dev/null) && complain "Spaces at the end of a line:"$'\n'"$found"
found=$(grep -nE '(^|[^[:alnum:]_.$}~-])/(home|root|work|mnt|scratch|Users)/[[:alnum:]]' -- "${files[@]}" /dev/null) &&
  complain "Paths of one machine:"$'\n'"$found"

formatter=$(command -v clang-format-14 || command -v clang-format)
if [[ -n $formatter ]]; then
  mapfile -t sources < <(printf '%s\n' "${files[@]}" | grep -E '^(src|unittest)/.*\.(cpp|h)$')
  if [[ ${1:-} == --fix && ${#sources[@]} -gt 0 ]]; then
    "$formatter" --style=file -i -- "${sources[@]}"
  fi
  if [[ ${#sources[@]} -gt 0 ]] && ! found=$("$formatter" --style=file --dry-run -Werror -- "${sources[@]}" 2>&1); then
    complain "Not as .clang-format wants it (tools/check_style.sh --fix mends it):"
    grep ': error: ' <<< "$found" | sort -u | head -n 40
  fi
else
  echo "clang-format is not installed: layout not checked"
fi

[[ $status == 0 ]] && echo "${#files[@]} files checked"
exit $status
