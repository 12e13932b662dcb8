# Maps: CFL x PPC x amplitude with the default integrator, a panel a method; and limits of all integrators.
tall = 2.15
load plots.'/style.gp'
map_ = dir.'/'.name.'.map.csv'
worst_ = dir.'/'.name.'.worst.csv'
array FONT[18]
do for [k = 11:18] { FONT[k] = sprintf(',%d', fmt eq 'png' ? k : int(k * 0.66 + 0.5)) }
F12 = FONT[12] # tics take no expression
F13 = FONT[13]
F14 = FONT[14]

STATUS = 'ok energy_growth inverted left_grid nan singular empty'
array SHADE[7] = ['#bfe3c3', '#f2d65c', '#d8694f', '#8c6bb1', '#555555', '#5a9bc4', '#cccccc']
array MEANING[7] = ['stable', 'finished, energy > 5 % above its start', 'particle inside out', 'left the grid', 'not a number', \
                    'singular', 'empty']
hex(s) = int('0x'.s[2:])
status_of(s) = sum [k = 1:words(STATUS)] (word(STATUS, k) eq s ? k : 0)
rgb(s) = hex(SHADE[status_of(s)])

# The methods of the table, in its order.
list_ = map_
load plots.'/methods.gp'
methods_ = words(seen_)
columns_ = 5
lines_ = int(ceil(methods_ / (1.0 * columns_)))

set multiplot
unset grid
set border 0
set tics scale 0
set style fill solid 1 noborder
unset key

# y of a cell: 1D on top, 2D below it
below = 16.2
y(d, r) = d == 1 ? r : below + r
top_ = 0.955
height_ = 0.46 / lines_
set yrange [22:-1]
set xrange [-0.6:9.6]
in(m) = strcol('method') eq m && column('default') == 1
do for [k = 1:methods_] {
    m = word(seen_, k)
    col = (k - 1) % columns_
    line = (k - 1) / columns_
    set lmargin at screen 0.095 + col * 0.18
    set rmargin at screen 0.095 + col * 0.18 + 0.167
    set tmargin at screen top_ - 0.018 - line * height_
    set bmargin at screen top_ - 0.018 - (line + 1) * height_ + 0.034
    unset label
    unset ytics
    if (col == 0) {
        set label 1 'A = 10^{−4}' at -1.0, 1.5 right font FONT[13]
        set label 2 '1D     0.01' at -1.0, 6.5 right font FONT[13]
        set label 3 '0.05' at -1.0, 11.5 right font FONT[13]
        set label 4 'A = 0.01' at -1.0, below + 0.5 right font FONT[13]
        set label 5 '2D     0.05' at -1.0, below + 3.5 right font FONT[13]
    }
    set label 6 heading(label(m)) at -0.5, graph 1.07 font FONT[15]
    set xtics ('.1' 0, '.2' 1, '.4' 2, '.6' 3, '.8' 4, '1' 5, '1.2' 6, '' 7, '1.6' 8, '2' 9) font F12 offset 0, 0.6
    plot map_ using (in(m) ? column('column') : NaN):(y(column('dim'), column('row'))):(0.47):(0.42):(rgb(strcol('status'))) \
         with boxxyerror lc rgb variable
}

# Legend and what the axes are
unset xtics
unset label
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen 1
set bmargin at screen 0
set xrange [0:1]
set yrange [0:1]
set label 1 heading('Ten periods with the default integrator: what each CFL number (across) ends in') \
    at 0, 0.985 font FONT[18]
set label 2 '1D: sine bar, h = 1/40, each amplitude with lines for PPC 1, 2, 2.5, 4; 2D: axis-aligned waves, h = 1/8, PPC 4, 9 (a mesh has none)' \
    at 0, 0.484 font FONT[14]
x_ = 0
do for [k = 1:5] {
    set object k rectangle from x_, 0.459 to x_ + 0.014, 0.469 fc rgb SHADE[k] fs solid 1 noborder
    set label 10 + k MEANING[k] at x_ + 0.019, 0.464 font FONT[14]
    x_ = x_ + 0.03 + 0.0088 * strlen(MEANING[k])
}
set label 3 heading('Largest stable CFL number at the worst PPC, by integrator; three amplitudes in 1D, two in 2D') at 0, 0.43 font FONT[18]
set label 4 'Not the default integrator: h = 1/32 in 1D; refused pairs at PPC 2 (2D: 4) only. 0: not even 0.1 (default integrators: 0.05); 2: the largest tried' at 0, 0.012 font FONT[14]
plot NaN
unset for [k = 1:5] object k

# The table: sub-columns of amplitudes in columns of integrators
array AT[20] = [0, 3.3, 6.6, 9.9, 13.2, 16.5, 19.8, 24, 24, 24, 26.3, 26.3, 26.3, 28.6, 0, 0, 0, 0, 0, 0]
at_(d, pair, place) = AT[(d == 1 ? 0 : 7) + int(pair) + 1] + place
unset label
set lmargin at screen 0.095
set rmargin at screen 0.985
set tmargin at screen 0.385
set bmargin at screen 0.03
set xrange [-0.6:30.2]
set yrange [methods_ - 0.5:-0.5]
set ytics ()
do for [k = 1:methods_] { set ytics add (label(word(seen_, k)) k - 1) }
set ytics font F14 scale 0 nomirror
set x2tics scale 0 nomirror
set x2tics ('cd' 1, 'usl' 4.3, 'musl' 7.6, 'uvf' 10.9, 'usf' 14.2, 'musl, fresh L' 17.5, 'uvf, fresh L' 20.8, 'cd' 24.5, \
            'uvf' 26.8, 'uvf, fresh L' 29.1) font F13
set x2range [-0.6:30.2]
set label 1 '1D' at -0.6, graph 1.075 left font FONT[14]
set label 2 '2D' at 23.5, graph 1.075 left font FONT[14]
line_of(m) = sum [k = 1:methods_] (word(seen_, k) eq m ? k - 1 : 0)
set palette defined (0 '#d8694f', 0.1 '#eda07c', 0.4 '#f6dfa0', 0.8 '#d9ecb8', 1.2 '#9fd3a6', 2 '#6dbb82')
set cbrange [0:2]
unset colorbox
text(x) = x >= 2 ? '2' : x <= 0 ? '0' : sprintf('%.2f', x)
plot worst_ using (at_(column('dim'), column('pair'), column('place'))):(line_of(strcol('method'))):(0.48):(0.44):'stable' \
         with boxxyerror lc palette, \
     worst_ using (at_(column('dim'), column('pair'), column('place'))):(line_of(strcol('method'))):(text(column('stable'))) \
         with labels font FONT[11]
unset multiplot
