# Long runs: the energy ledger over time.
load plots.'/style.gp'
list_ = dir.'/'.name.'.ledger.csv'
load plots.'/methods.gp'
SCENES = 'ring disk_impact'
array SAYS[2] = ['Ring, N = 32, twenty periods', 'Disk, N = 48, to t = 20']
of(s, m, v) = strcol('problem') eq s && strcol('method') eq m && strcol('variant') eq v ? column('t') : NaN
ended(s, m) = value('ENDED_'.s.'_'.m) # the last instant of a run that was lost
do for [s in SCENES] { do for [m in seen_] {
    stats list_ using (of(s, m, 'usual')) nooutput
    eval sprintf('ENDED_%s_%s = %.9g', s, m, STATS_max < 0.95 * (s eq 'ring' ? 0.4 : 20) ? STATS_max : -1)
} }
set multiplot
set bmargin at screen 0.13
set tmargin at screen 0.9
set xzeroaxis ls 20
set xlabel 't [s]'
do for [k = 1:2] {
    set lmargin at screen (k == 1 ? 0.1 : 0.48)
    set rmargin at screen (k == 1 ? 0.41 : 0.79)
    set yrange [k == 1 ? -0.12 : -0.6 : k == 1 ? 0.22 : 0.4]
    set xrange [0 : k == 1 ? 0.4 : 20]
    if (k == 1) { set xtics 0.1 } else { set xtics 5 }
    if (k == 1) { set ylabel 'energy gained / largest energy' offset 1; unset key }
    if (k == 2) { unset ylabel; set key at screen 0.8, screen 0.9 left top samplen 1.6 }
    set label 1 heading(SAYS[k]) at graph 0, graph 1.05
    s = word(SCENES, k)
    plot for [m in seen_] list_ using (of(s, m, 'usual')):'ledger' with lines ls style(m) lw 2.4 title label(m), \
         for [m in 'wls wls2'] list_ using (of(s, m, 'spline')):'ledger' with lines ls style(m) lw 2.4 dt 2 \
         title label(m).', spline', \
         for [m in seen_] list_ using (abs(of(s, m, 'usual') - ended(s, m)) < 1e-6 ? column('t') : NaN):'ledger' \
         with points ls style(m) pt 2 ps 1.6 lw 2 notitle, \
         NaN with points pt 2 ps 1.2 lc rgb '#444444' title 'lost'
}
unset multiplot
