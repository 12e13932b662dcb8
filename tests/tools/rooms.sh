#!/usr/bin/env bash
# rooms.sh [OBJECTS]: the house rules that need no compiler: rooms include only what rooms.txt allows, no file
# includes itself by way of others, and at most 4 levels of includes lie inside one room. With a folder of compiled
# objects: public names begin with the name of a file or header of their room. Prints what is wrong; status 1.
set -u
export LC_ALL=C
table=$(dirname "$0")/rooms.txt
wrong=0
complain() {
    echo "rooms: $*"
    wrong=1
}
mapfile -t rooms < <(sed -n 's/^\([a-z_0-9/]*\):.*/\1/p' "$table")
[ ${#rooms[@]} -gt 0 ] || complain "$table: no room"
for room in "${rooms[@]}"; do
    compgen -G "$room/*.[ch]" >/dev/null || complain "$room: no C file"
    files=$(find "$room" -maxdepth 1 -type f | wc -l)
    [ "$files" -le 45 ] || complain "$room: $files files, at most 45"
done
find common methods problems fem_ref studies -name '*.[ch]' -printf '%h\n' | sort -u |
    grep -vxF "$(printf '%s\n' "${rooms[@]}")" | sed 's/^/rooms: not in rooms.txt: /' | grep . && wrong=1

# FILE TARGET, one line per include; a name without a folder lies beside the file.
includes() {
    grep -rE '^#include "' --include='*.[ch]' "${rooms[@]%%/*}" | sort -u |
        sed -nE 's/^([^:]*):#include "([^"]*)".*/\1 \2/p' |
        awk '$2 == "facts.h" { next } $2 !~ /\// { at = $1; sub(/[^\/]*$/, "", at); $2 = at $2 } { print $1, $2 }'
}
edges=$(includes)
awk -v table="$table" '
    function room(path) { sub(/\/[^\/]*$/, "", path); return path }
    BEGIN { while ((getline line < table) > 0) if (line !~ /^#/) {
                n = split(line, word, " "); sub(/:$/, "", word[1])
                for (k = 2; k <= n; k++) allowed[word[1], word[k]] = 1 } }
    room($1) != room($2) && !((room($1), room($2)) in allowed) && !((room($1), $2) in allowed) {
        print "rooms: " $1 " may not include " $2; wrong = 1 }
    END { exit wrong }' <<<"$edges" || wrong=1
tsort <<<"$edges" >/dev/null 2>&1 || complain "a circle of includes: $(tsort <<<"$edges" 2>&1 >/dev/null | sed 's/^tsort: *//' | tr '\n' ' ')"
# Levels inside a room: the longest chain of includes whose files all lie in it.
{ tsort <<<"$edges" 2>/dev/null | tac | sed 's/^/order /'; sed 's/^/edge /' <<<"$edges"; } | sort -s -k1,1 | awk '
    function room(path) { sub(/\/[^\/]*$/, "", path); return path }
    $1 == "edge" { if (room($2) == room($3)) next_of[$2] = next_of[$2] " " $3; next }
    $1 == "order" { order[++n] = $2 }
    END { for (k = 1; k <= n; k++) { f = order[k]; level[f] = 1; m = split(next_of[f], t, " ")
              for (j = 1; j <= m; j++) if (level[t[j]] + 1 > level[f]) level[f] = level[t[j]] + 1
              if (level[f] > 4) { print "rooms: " f ": " level[f] " levels of includes in its room, at most 4"; wrong = 1 } }
          exit wrong }' || wrong=1

# Public names: STEM_..., with or without its plural s, of the file or of a header in its room or the room above;
# registered data are KIND_NAME, their lists KINDs.
check_names() { # OBJECTS
    local object source room stems
    while read -r object; do
        source=${object#"$1"/} && source=${source#d[123]/} && source=${source%.o}.c
        [ -f "$source" ] || continue
        room=$(dirname "$source")
        stems=$({ echo "$source"; ls "$room"/*.h "$(dirname "$room")"/*.h 2>/dev/null; } |
            sed 's/.*\///; s/\.[ch]$//; p; s/s$//' | sort -u | tr '\n' ' ')
        nm --defined-only --extern-only "$object" | awk -v stems="$stems" -v source="$source" '
            { n = split(stems, stem, " "); ok = $3 ~ /^(method|problem|solver|study)_|_command$|^engine_[123]d$|^main$|^(methods|problems|solvers)$/
              for (k = 1; k <= n; k++) ok = ok || $3 == stem[k] || index($3, stem[k] "_") == 1
              if (!ok) { print "rooms: " source ": public name " $3 " begins with none of: " stems; wrong = 1 } }
            END { exit wrong }' || wrong=1
    done < <(find "$1" -name '*.o' ! -path '*/d[123]/engine.o' ! -path '*/tests/*' ! -path '*/d3/*' | sort)
}
# Every public function is called somewhere in the program; only ..._is_valid may be for tests alone.
check_calls() { # OBJECTS
    local name
    while read -r name; do
        [ "$(grep -rwh "$name" common methods problems fem_ref studies --include='*.c' | wc -l)" -gt 1 ] && continue
        echo "rooms: the program does not call $name" && wrong=1
    done < <(find "$1" -name '*.o' ! -path '*/d[123]/engine.o' ! -path '*/tests/*' -exec nm {} + | awk '
        $2 == "T" { made[$3] } $1 == "U" { used[$2] }
        END { for (name in made) if (!(name in used) && name !~ /_is_valid$/) print name }')
}
[ $# -eq 0 ] || { check_names "$1"; check_calls "$1"; }
exit $wrong
