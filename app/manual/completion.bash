# SPDX-License-Identifier: GPL-3.0-or-later
# bash completion of pellucid; made by `pellucid --completion bash`
# A word of a table may be followed by :key=value, which is left to the user. Where no word fits, files do.
_pellucid() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} candidates= options= first=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W '@commands@ @options@' -- "$current"))
    return
  fi
  case $before in
@after_options@  esac
  case ${COMP_WORDS[1]} in
@of_commands@  esac
  [ "$COMP_CWORD" -eq 2 ] && [ -z "$candidates" ] && candidates=$first
  case $current in -*) candidates=$options ;; esac
  [ -n "$candidates" ] && COMPREPLY=($(compgen -W "$candidates" -- "$current"))
}
complete -o default -F _pellucid pellucid
