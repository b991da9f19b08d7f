# SPDX-License-Identifier: Apache-2.0
# Bash completion of gonio. It asks the program's own --help, so that nothing is said twice.
_gonio()
{
    local word=${COMP_WORDS[COMP_CWORD]} verb='' help
    [ "$COMP_CWORD" -gt 1 ] && verb=${COMP_WORDS[1]}
    help=$("${COMP_WORDS[0]}" $verb --help 2>/dev/null) || return 0
    case $word in
    -*) help=$(grep -oE -- '(^ +|,)--?[a-zA-Z][-a-zA-Z_]*' <<<"$help" | tr -d ' ,') ;;
    *) [ -z "$verb" ] || return 0
       help=$(sed -n '/^Subcommands:/,/^$/s/^ \+\([a-z_]\+\).*/\1/p' <<<"$help") ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$help" -- "$word")
}
complete -o default -F _gonio gonio
