# Tab completion in bash for the options of the programs: `rosrun collision_hulls decompose --<TAB>`, or with the program's path.
# Options and the values that they choose from are read from the program's own --help. setup.bash sources this file.

_collision_hulls_programs=$(realpath -m "$(dirname "${BASH_SOURCE[0]}")/../../lib/collision_hulls")

_collision_hulls_options() { # PROGRAM
  "$1" --help 2> /dev/null < /dev/null | sed -nE 's/^ +(-[A-Za-z]( [A-Z_]+)?, ?)?(--[a-z][a-z_-]*).*/\3/p'
}

_collision_hulls_values() { # PROGRAM OPTION: of an option that takes a NAME, which --help lists after a colon
  "$1" --help 2> /dev/null < /dev/null | awk -v option="$2" '
    /^ *-/ { wanted = index("," $1 ",", "," option ",") }
    !NF { wanted = 0 }
    wanted { text = text " " $0 }
    END { if (text ~ / NAME/) { sub(/.*: /, "", text); gsub(/,/, " ", text); print text } }'
}

_collision_hulls_complete() { # PROGRAM
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words=""
  if [[ $word == "=" ]]; then
    word="" # --option=<TAB>: bash takes the sign for a word of its own
  elif [[ $before == "=" ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case "$word/$before" in
    -*) words=$(_collision_hulls_options "$1") ;;
    */-*) words=$(_collision_hulls_values "$1" "$before") ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  [[ -n $words ]] || compopt -o default 2> /dev/null # files
}

# A program called by its path. Other programs of such a name are not ours to run.
_collision_hulls_program() {
  local program
  COMPREPLY=()
  program=$(realpath -e "$(type -P -- "${1/#\~/$HOME}")" 2> /dev/null)
  if [[ $program == "$_collision_hulls_programs"/* ]]; then
    _collision_hulls_complete "$program"
  else
    compopt -o default 2> /dev/null
  fi
}

_collision_hulls_rosrun() {
  local program=$_collision_hulls_programs/${COMP_WORDS[2]:-}
  if [[ ${COMP_WORDS[1]:-} == collision_hulls && $COMP_CWORD -gt 2 && -f $program && -x $program ]]; then
    _collision_hulls_complete "$program"
  elif [[ -n $_collision_hulls_rosrun_before ]]; then
    "$_collision_hulls_rosrun_before" "$@"
  fi
}

for _collision_hulls_program in "$_collision_hulls_programs"/*; do
  [[ -f $_collision_hulls_program && -x $_collision_hulls_program ]] && complete -F _collision_hulls_program "${_collision_hulls_program##*/}"
done
unset _collision_hulls_program

# What completes rosrun so far, which is rosbash's if that was sourced before.
_collision_hulls_found=$(complete -p rosrun 2> /dev/null | sed -n 's/.* -F \([^ ]*\) rosrun$/\1/p' || true) # safe under set -e -o pipefail
[[ $_collision_hulls_found == _collision_hulls_rosrun ]] || _collision_hulls_rosrun_before=$_collision_hulls_found
unset _collision_hulls_found
complete -F _collision_hulls_rosrun rosrun
