#compdef pellucid
# SPDX-License-Identifier: GPL-3.0-or-later
# zsh completion of pellucid; made by `pellucid --completion zsh`
# A word of a table may be followed by :key=value, which is left to the user.
_pellucid() {
  local current=${words[CURRENT]} before=${words[CURRENT-1]} command=${words[2]} candidates= options= first=
  if (( CURRENT == 2 )); then
    compadd -- @commands@ @options@
    return
  fi
  case $before in
@after_options@  esac
  case $command in
@of_commands@  esac
  (( CURRENT == 3 )) && [[ -z $candidates ]] && candidates=$first
  [[ $current == -* ]] && candidates=$options
  [[ -n $candidates ]] && compadd -- ${=candidates}
  [[ $current == -* ]] || _files
}
# Read by the shell's completion it is called at once; sourced, it says whose it is.
if [[ $funcstack[1] == _pellucid ]]; then _pellucid "$@"; else compdef _pellucid pellucid; fi
