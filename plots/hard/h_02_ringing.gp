# What is left of particle velocities in the null space, against steps.
load plots.'/style.gp'
list_ = dir.'/'.name.'.kept.csv'
load plots.'/methods.gp'
last(m, d) = value('LAST_'.m.'_'.d) # the last step written of a run
do for [m in seen_] { do for [d = 1:2] {
    stats list_ using (strcol('method') eq m && strcol('variant') eq 'usual' && column('dim') == d ? column('step') : NaN) nooutput
    eval sprintf('LAST_%s_%d = %d', m, d, STATS_records > 0 ? STATS_max : -1)
} }
set multiplot
set lmargin at screen 0.09
set rmargin at screen 0.44
set bmargin at screen 0.13
set tmargin at screen 0.9
set logscale xy
set xrange [0.9:1600]
set yrange [1e-4:1000]
set format y '10^{%T}'
set xlabel 'steps'
set ylabel 'left, (K / K_0)^{1/2}' offset 1
do for [d = 1:2] {
    if (d == 2) {
        set lmargin at screen 0.46
        set rmargin at screen 0.79
        unset ylabel
        set format y ''
        set key at screen 0.8, screen 0.9 left top samplen 1.6
    } else { unset key }
    set label 1 heading(d == 1 ? 'Bar, 2 per cell' : 'Plane, 4 per cell') at graph 0, graph 1.05
    of(m, v) = strcol('method') eq m && strcol('variant') eq v && column('dim') == d ? column('step') : NaN
    plot for [m in seen_] list_ using (of(m, 'usual')):'kept' with linespoints ls style(m) ps 0.6 title label(m), \
         for [m in 'wls wls2'] list_ using (of(m, 'return=spline')):'kept' with lines ls style(m) dt 2 \
         title label(m).', spline', \
         list_ using (of('xpic', 'order=1')):'kept' with lines ls style('xpic') dt 2 title 'PIC', \
         for [m in seen_] list_ using (strcol('status') ne 'ok' && column('step') == last(m, d) ? of(m, 'usual') : NaN):'kept' \
         with points ls style(m) pt 2 ps 1.6 lw 2 notitle, \
         NaN with points pt 2 ps 1.2 lc rgb '#444444' title 'lost'
}
unset multiplot
