#!/usr/bin/env bash
# page.sh PROGRAM FOLDER [OUT]: opens the scoreboard in a real browser (chromium by chromedriver), wide and
# narrow, and checks that it loads without errors, that every image is there, that every claim has a verdict
# and that the filters filter. Makes a small page below FOLDER; OUT/index.html, if it exists, is checked too.
# Screenshots stay in FOLDER/page. Prints "N passed, N failed"; SKIPPED without the browser.
set -u
program=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
mkdir -p "$2"
work=$(realpath "$2")/page
out=${3:-}
for tool in chromedriver chromium curl; do
    command -v $tool >/dev/null || { echo "SKIPPED page.sh: no $tool"; exit 0; }
done
mkdir -p "$work"
driver='' session='' passed=0 failed=0
scratch=$(mktemp -d)
finish() {
    [ -n "$session" ] && curl -s -X DELETE "$session" >/dev/null
    [ -n "$driver" ] && kill "$driver" 2>/dev/null
    rm -rf "$scratch"
}
trap finish EXIT
trap 'exit 130' INT TERM

ok() { # NAME GOT WANTED
    if [ "$2" = "$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $1: got '$2', not '$3'" >&2
    fi
}
post() { curl -s -X POST -H 'Content-Type: application/json' -d "$2" "$session/$1"; }
# value JSON: the value of the answer if it is a number, a word or a text without quotes
value() { sed -E 's/^\{"value":"?([^"}]*)"?\}$/\1/'; }
js() { post execute/sync "{\"script\":\"return ($1)\",\"args\":[]}" | value; }

port=$((20000 + RANDOM % 20000))
chromedriver --port=$port --log-path="$scratch/driver.log" >/dev/null 2>&1 &
driver=$!
for ((k = 0; k < 100; k++)); do
    curl -s "http://127.0.0.1:$port/status" 2>/dev/null | grep -q '"ready":true' && break
    sleep 0.1
done

# open WIDTH: a session with a window that wide
open() {
    local device=
    [ "$1" -lt 500 ] && device=',"mobileEmulation":{"deviceMetrics":{"width":'$1',"height":844,"pixelRatio":2}}'
    [ -n "$session" ] && curl -s -X DELETE "$session" >/dev/null
    session=http://127.0.0.1:$port/session
    local id
    id=$(curl -s -X POST -H 'Content-Type: application/json' "$session" -d '{"capabilities":{"alwaysMatch":{
        "goog:loggingPrefs":{"browser":"ALL"},"goog:chromeOptions":{"args":["--headless","--no-sandbox",
        "--disable-gpu","--disable-quic","--no-first-run","--disable-background-networking",
        "--disable-component-update","--disable-sync","--hide-scrollbars","--window-size='"$1"',1000",
        "--user-data-dir='"$scratch/$1"'"]'"$device"'}}}}' | sed -E 's/.*"sessionId":"([^"]*)".*/\1/')
    session=$session/$id
}
shot() { curl -s "$session/screenshot" | sed -E 's/^\{"value":"([^"]*)"\}$/\1/' | base64 -d >"$1"; }

# look NAME INDEX WIDTH
look() {
    local name=$1 index=$2 width=$3 rows
    open "$width"
    post url "{\"url\":\"file://$index\"}" >/dev/null
    ok "$name at $width: width" "$(js innerWidth)" "$width"
    ok "$name at $width: not wider than the window" "$(js 'document.documentElement.scrollWidth <= innerWidth')" true
    ok "$name at $width: nothing loaded" "$(js 'performance.getEntriesByType(\"resource\").filter(e => !e.name.startsWith(\"data:\")).length')" 0
    ok "$name at $width: every image is there" \
        "$(js 'Array.from(document.images).filter(i => !i.complete || !i.naturalWidth).length')" 0
    ok "$name at $width: a figure has its image" \
        "$(js 'Array.from(document.querySelectorAll(\"article\")).filter(a => !a.querySelector(\"img\")).length')" 0
    ok "$name at $width: a problem has its exact solution and scale" \
        "$(js 'Array.from(document.querySelectorAll(\"#problems + .grid .card\")).filter(c => c.querySelectorAll(\"dd\").length !== 3).length')" 0
    ok "$name at $width: figures come before the claims" \
        "$(js 'document.getElementById(\"figures\").offsetTop < document.getElementById(\"claims\").offsetTop')" true
    ok "$name at $width: every sentence has claims or a reason" \
        "$(js 'Array.from(document.querySelectorAll(\"details table.sort tbody tr\")).filter(r => !r.cells[2].textContent.trim()).length')" 0
    ok "$name at $width: each paper's sentences are counted" \
        "$(js '(document.body.textContent.match(/[0-9]+ sentences that can be measured, claims test [0-9]+/g) || []).length')" 2
    ok "$name at $width: a column sorts" "$(js '(t => { const h = t.tHead.rows[0].cells[1]; h.click(); const c = Array.from(t.tBodies[0].rows).map(r => r.cells[1].textContent); h.click(); return c.length > 2 && c.every((s, k) => k === 0 || c[k - 1] <= s); })(document.querySelector(\"details table.sort\"))')" true
    ok "$name at $width: ids are unique" \
        "$(js '(l => l.length - new Set(l).size)(Array.from(document.querySelectorAll(\"[id]\")).map(e => e.id))')" 0
    ok "$name at $width: links within the page lead somewhere" \
        "$(js 'Array.from(document.querySelectorAll(\"a[href^=\\\"#\\\"]\")).filter(a => !document.getElementById(a.hash.slice(1)) && !a.closest(\"tr[data-verdict=NOT_RUN]\")).length')" 0
    ok "$name at $width: stability: a row per method, with marks" \
        "$(js '(t => t.length > 8 && t.every(r => r.cells.length === 5 && r.querySelectorAll(\"a.m.ok,a.m.weak,a.m.lost\").length > 0 && r.cells[2].textContent))(Array.from(document.querySelectorAll(\"#hard tbody tr\")))')" true
    ok "$name at $width: stability: a method breaks where it is said to" \
        "$(js '(r => r.cells[2].textContent.startsWith(r.querySelector(\"a.m.lost\").textContent.split(\" \")[0]))(Array.from(document.querySelectorAll(\"#hard tbody tr\")).find(r => r.querySelector(\"a.m.lost\")))')" true
    rows=$(js 'rows.length')
    ok "$name at $width: claims" "$(js 'rows.length > 0')" true
    ok "$name at $width: every claim has a verdict" \
        "$(js 'rows.filter(r => [\"PASS\",\"FAIL\",\"DIFFERS\",\"NOT_RUN\"].includes(r.cells[0].textContent)).length')" "$rows"
    ok "$name at $width: the counts add up" "$(js 'buttons.reduce((n, b) => n + Number(b.textContent.split(\" \")[1]), 0)')" "$rows"
    shot "$work/$name-$width.png"
    ok "$name at $width: one verdict switched off" \
        "$(js '(b => { b.click(); return rows.filter(r => !r.hidden && r.dataset.verdict === \"PASS\").length; })(buttons[0])')" 0
    ok "$name at $width: and on" "$(js '(b => { b.click(); return rows.filter(r => !r.hidden).length; })(buttons[0])')" "$rows"
    ok "$name at $width: one figure" "$(js '(() => { figure.selectedIndex = 1; figure.dispatchEvent(new Event(\"change\")); const shown = rows.filter(r => !r.hidden); return shown.length > 0 && shown.every(r => r.dataset.figure === figure.value); })()')" true
    ok "$name at $width: a word that is nowhere" "$(js '(() => { figure.value = \"\"; text.value = \"xyzzy\"; text.dispatchEvent(new Event(\"input\")); return rows.filter(r => !r.hidden).length; })()')" 0
    ok "$name at $width: a word that is somewhere" "$(js '(() => { text.value = rows[0].cells[1].textContent; text.dispatchEvent(new Event(\"input\")); return !rows[0].hidden; })()')" true
    ok "$name at $width: what the filter says" "$(js 'document.getElementById(\"shown\").textContent === rows.filter(r => !r.hidden).length + \" of \" + rows.length')" true
    ok "$name at $width: errors" "$(post se/log '{"type":"browser"}' | grep -o '"level":"SEVERE"[^}]*' | head -n 1)" ""
}

# drawings FOLDER: texts of its figures lie on the canvas and beside each other
drawings() {
    if [ ! -x /usr/bin/python3 ] || [ ! -e /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf ]; then
        echo "SKIPPED texts of figures: no python3 or DejaVu fonts"
        return
    fi
    /usr/bin/python3 "$here/svg_text.py" --symbol "$1"/*.svg >"$scratch/texts"
    ok "texts of the figures in $1: $(head -n 3 "$scratch/texts")" $? 0
}

for study in w07_03_degenerate w07_13_sine_bar t_06_norms h_03_stretch h_14_fall; do
    "$program" study $study --out "$work/out" >/dev/null || exit 1
done
"$program" claims --out "$work/out" >/dev/null
drawings "$work/out"
look small "$work/out/index.html" 1400
look small "$work/out/index.html" 390
if [ -n "$out" ] && [ -e "$out/index.html" ]; then
    ok "under 4 MB" "$(($(stat -c %s "$out/index.html") < 4000000))" 1
    drawings "$out"
    look whole "$(realpath "$out/index.html")" 1400
    look whole "$(realpath "$out/index.html")" 390
fi
echo "page: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
