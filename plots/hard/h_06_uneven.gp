# Uneven particles: projection error against jitter. Few particles: error of two waves.
load plots.'/style.gp'
list_ = dir.'/'.name.'.points.csv'
load plots.'/methods.gp'
set multiplot
set bmargin at screen 0.13
set tmargin at screen 0.9
set logscale y
set format y '10^{%T}'
array SAYS[3] = ['H-6: linear field', 'H-7: bar', 'H-7: plane']
array SCENE[3] = ['patch', 'sine\_bar', 'axis\_mms']
do for [k = 1:3] {
    set lmargin at screen (k < 3 ? 0.1 + 0.29 * (k - 1) : 0.625)
    set rmargin at screen (k < 3 ? 0.31 + 0.29 * (k - 1) : 0.835)
    p = k == 1 ? 'patch' : k == 2 ? 'sine_bar' : 'axis_mms'
    if (k == 1) { set xrange [-0.02:0.52]; set xtics 0.2; set yrange [1e-17:1]; set ytics 1e-16, 1000; set xlabel 'jitter / spacing'; set ylabel 'largest error'; unset key }
    if (k > 1) { set xrange [0.4:2.1]; set xtics 0.5; set yrange [3e-4:30]; set ytics auto; set xlabel 'particles per axis' }
    if (k == 2) { unset ylabel }
    if (k == 3) { set format y ''; set key at screen 0.845, screen 0.9 left top samplen 1.6 }
    of(m) = strcol('problem') eq p && strcol('method') eq m && (p ne 'patch' || column('grading') == 1) ? column('x') : NaN
    lost(m) = strcol('status') eq 'ok' ? NaN : of(m)
    set label 1 heading(SAYS[k]) at graph 0, graph 1.05
    plot for [m in seen_] list_ using (of(m)):(strcol('status') eq 'ok' ? column('error') : NaN) with linespoints ls style(m) title label(m), \
         for [m in seen_] list_ using (lost(m)):(15) with points ls style(m) pt 2 notitle, \
         NaN with points pt 2 lc rgb '#444444' title 'lost'
}
unset multiplot
