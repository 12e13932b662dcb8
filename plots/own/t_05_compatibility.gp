# A grid: method x integrator, what becomes of the energy in ten periods, 1D and 2D.
tall = 1.7
load plots.'/style.gp'

grid_ = dir.'/'.name.'.grid.csv'
array SHADE[6] = [0xd7ecd9, 0xd6e6f4, 0xa9cbe6, 0xc9c9c9, 0xf8dcc4, 0xf0b08a]
array MEANING[6] = ['within 0.1 %', '5 % less', 'less', 'lost after so many T', '5 % more', 'more']
array SCENE[2] = ['1D: sine bar, h = 1/40', '2D: axis-aligned waves, h = 1/8']
stats grid_ using 'line' nooutput
lines_ = STATS_max + 1
array NAMES[lines_]
stats grid_ using (NAMES[int(column('line')) + 1] = strcol('method'), 1) nooutput
set multiplot
set xrange [-0.5:6.5]
set yrange [lines_ - 0.5:-0.5]
unset grid
set border 0
set tics scale 0
set x2tics ('cd' 0, 'usl' 1, 'musl' 2, 'uvf' 3, 'usf' 4, 'musl, fresh L' 5, 'uvf, fresh L' 6)
unset xtics
set x2range [-0.5:6.5]
set ytics ()
do for [k = 1:lines_] { set ytics add (label(NAMES[k]) k - 1) }
set lmargin at screen 0.11
set rmargin at screen 0.98
set style fill solid 1 border rgb '#ffffff'
font_ = sprintf(',%d', fmt eq 'png' ? 14 : 10)
of(d) = column('dim') == d ? column('column') : NaN
do for [d = 1:2] {
    set tmargin at screen d == 1 ? 0.905 : 0.465
    set bmargin at screen d == 1 ? 0.525 : 0.06
    unset label
    if (d == 1) { set label 2 heading('Ten periods, CFL 0.1, A = 0.01: energy over its start, E/E_0, by method and integrator') at screen 0.02, screen 0.975 }
    set label 1 SCENE[d] at graph 0, graph 1.11
    if (d == 1) { set key off } else { set key at screen 0.99, screen 0.045 right top maxrows 2 samplen 0.5 width -1 font font_ }
    plot grid_ using (of(d)):'line':(0.49):(0.47):(SHADE[int(column('shade')) + 1]) with boxxyerror lc rgb variable notitle, \
         grid_ using (of(d)):'line':(strcol('text')) with labels noenhanced font font_ notitle, \
         for [k in "1 2 3 5 6 4"] NaN with points pt 5 ps 2.5 lc rgb SHADE[int(k)] title MEANING[int(k)]
}
unset multiplot
