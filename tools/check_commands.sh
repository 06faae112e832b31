#!/usr/bin/env bash
# Checks that the commands shown in README files exist: takes the fenced shell blocks apart and looks
# for each script, example, folder and option of ./sphsolid that a line names. Runs none of them.

set -uo pipefail
cd "$(dirname "$0")/.."

status=0 checked=0
declare file line

complain() {
  echo "$file: $1: $line"
  status=1
}

# check <word>...: one command with its arguments
check() {
  local word
  while [[ ${1:-} =~ ^[A-Za-z_]+=.* ]]; do shift; done    # VARIABLE=value before a command
  case ${1:-} in
    "" | cd | git | sudo | apt-get | export) return ;;
    ./sphsolid)
      ./sphsolid help | grep -qE "(^|[ ,])${2:-help}([ ,.]|$)" || complain "./sphsolid has no such command"
      if [[ ${2:-} == run ]]; then
        [[ ${3:-} == "<"* || -x examples/${3:-}/run ]] || complain "there is no such example"
      fi
      ;;
    ./* | */*)
      [[ $1 == build*/* || -x $1 || -x $(dirname "$file")/$1 ]] || complain "there is no $1"
      ;;
  esac
  for word in "${@:2}"; do    # files and folders of this repository among the arguments
    word=${word#*=}
    word=${word#*sphsolid/}
    case $word in
      examples/* | cmake/* | tools/* | bench/* | potentials/* | src/* | doc/* | unittest/*)
        [[ $word == *"<"* || $word == */output* || -e $word ]] || complain "there is no $word"
        ;;
    esac
  done
  checked=$((checked + 1))
}

shopt -s nullglob
for file in README.md examples/*/README.md doc/*.md bench/README.md; do
  [[ -e $file ]] || continue
  while IFS= read -r line; do
    line=${line%%  \#*}
    while read -ra words; do
      check "${words[@]:-}"
    done <<< "${line//&&/$'\n'}"
  done < <(awk '/^ *```/ { if (inside) { inside = 0 } else { inside = ($0 ~ /```(sh|bash|console|shell)$/) }; next }
                inside { sub(/^ *(\$ )?/, ""); sub(/\\$/, ""); print }' "$file")
done
echo "$checked commands checked"
exit $status
