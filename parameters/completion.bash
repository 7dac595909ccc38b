# SPDX-License-Identifier: LGPL-2.1-or-later
# Completes the command line of contact in bash: options, parameter files, and
# behind --set the entries, which the program itself lists. Installed with it;
# to try it: . parameters/completion.bash

# Every entry as Section/Name=
_contact_entries() {
  "$1" --parameters 2>/dev/null | sed -n '
    /^subsection /{ s///; h; }
    /^  set /{ s///; s/ =.*/=/; G; s/\(.*\)\n\(.*\)/\2\/\1/p; }'
}

_contact() {
  local word=$2 typed=${COMP_WORDS[COMP_CWORD]} entry
  COMPREPLY=()
  if [ "$3" = --set ]; then
    # The program takes a second to start: asked once in a shell.
    [ -n "${_contact_known-}" ] || _contact_known=$(_contact_entries "$1")
    compopt -o nospace
    while IFS= read -r entry; do
      # Names have blanks, which the user's quotes protect, or we do.
      [[ $typed == [\"\']* ]] || printf -v entry %q "$entry"
      [[ $entry == "$word"* ]] && COMPREPLY+=("$entry")
    done <<<"$_contact_known"
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W \
      "--set --quiet --verbose --restart --parameters --version --help" -- "$word")
  else
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -X '!*.prm' -- "$word"
                             compgen -f -X '!*.json' -- "$word"
                             compgen -d -- "$word")
  fi
}

complete -F _contact contact
